#include "fuzz.h"
#include "mirrorball/codec/texture/texture_file.h"

MIRRORBALL_HARNESS(ktx1) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}));
  return 0;
}
