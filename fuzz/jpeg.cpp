#include "fuzz.h"
#include "mirrorball/codec/codec.h"

/// Both ways to read it: to light, and to samples as stored.
MIRRORBALL_HARNESS(jpeg) {
  mirrorball::fuzz::checkError(mirrorball::decodeImage({data, size}, "a.jpeg"), "a.jpeg");
  mirrorball::fuzz::checkError(mirrorball::decodeTexture({data, size}, "a.jpeg"), "a.jpeg");
  return 0;
}
