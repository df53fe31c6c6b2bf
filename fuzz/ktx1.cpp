#include "fuzz.h"
#include "mirrorball/codec/texture/texture_file.h"

MIRRORBALL_HARNESS(ktx1) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}, "a.ktx1"), "a.ktx1");
  return 0;
}
