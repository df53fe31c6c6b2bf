#include "picture.h"

MIRRORBALL_HARNESS(pfm) { return mirrorball::fuzz::readPicture(data, size); }
