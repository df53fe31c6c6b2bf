#include "picture.h"

MIRRORBALL_HARNESS(webp) { return mirrorball::fuzz::readPicture(data, size); }
