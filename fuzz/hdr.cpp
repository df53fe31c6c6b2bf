#include "fuzz.h"
#include "mirrorball/codec/image_file.h"

MIRRORBALL_HARNESS(hdr) {
  mirrorball::fuzz::checkError(mirrorball::decodeImage({data, size}));
  return 0;
}
