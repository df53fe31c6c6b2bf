#include "fuzz.h"
#include "mirrorball/codec/codec.h"

/// Both ways to read it: to light, and to samples as stored.
MIRRORBALL_HARNESS(png) {
  mirrorball::fuzz::checkError(mirrorball::decodeImage({data, size}, "a.png"), "a.png");
  mirrorball::fuzz::checkError(mirrorball::decodeTexture({data, size}, "a.png"), "a.png");
  return 0;
}
