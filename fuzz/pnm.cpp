#include "picture.h"

MIRRORBALL_HARNESS(pnm) { return mirrorball::fuzz::readPicture(data, size); }
