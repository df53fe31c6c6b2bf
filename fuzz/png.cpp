#include "picture.h"

MIRRORBALL_HARNESS(png) { return mirrorball::fuzz::readPicture(data, size); }
