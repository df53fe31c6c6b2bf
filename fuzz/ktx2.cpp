#include "fuzz.h"
#include "mirrorball/codec/texture/texture_file.h"

MIRRORBALL_HARNESS(ktx2) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}, "a.ktx2"), "a.ktx2");
  return 0;
}
