#include "picture.h"

MIRRORBALL_HARNESS(avif) { return mirrorball::fuzz::readPicture(data, size); }
