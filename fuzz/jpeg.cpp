#include "picture.h"

MIRRORBALL_HARNESS(jpeg) { return mirrorball::fuzz::readPicture(data, size); }
