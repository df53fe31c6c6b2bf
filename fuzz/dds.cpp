#include "fuzz.h"
#include "mirrorball/codec/texture/texture_file.h"

MIRRORBALL_HARNESS(dds) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}));
  return 0;
}
