#include "fuzz.h"
#include "mirrorball/codec/texture/texture_file.h"

MIRRORBALL_HARNESS(dds) {
  mirrorball::fuzz::checkError(mirrorball::decodeImageSet({data, size}, "a.dds"), "a.dds");
  return 0;
}
