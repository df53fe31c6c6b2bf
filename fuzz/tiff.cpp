#include "picture.h"

MIRRORBALL_HARNESS(tiff) { return mirrorball::fuzz::readPicture(data, size); }
