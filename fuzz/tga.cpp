#include "picture.h"

MIRRORBALL_HARNESS(tga) { return mirrorball::fuzz::readPicture(data, size); }
