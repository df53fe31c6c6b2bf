#include "picture.h"

MIRRORBALL_HARNESS(bmp) { return mirrorball::fuzz::readPicture(data, size); }
