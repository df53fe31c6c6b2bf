#include "picture.h"

MIRRORBALL_HARNESS(jxl) { return mirrorball::fuzz::readPicture(data, size); }
