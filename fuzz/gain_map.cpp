// What says how a gain map is meant, and the container that it stands in: the bytes as XMP, as ISO 21496-1's numbers
// and as a file. What is accepted lifts every picture to finite light.

#include "mirrorball/codec/ldr/gain_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/ldr/ultra_hdr.h"

namespace {

using namespace mirrorball;

void checkLight(const Result<GainMap>& read) {
  fuzz::checkError(read);
  if (!read) return;
  Image picture(2, 2, 3);
  std::fill_n(picture.samples().begin(), 6, 1.0f);
  Image8 codes(1, 2, 1);
  codes.samples()[1] = 255;
  const Image light = lightByGainMap(picture, codes, *read);
  for (const float sample : light.samples())
    fuzz::check(std::isfinite(sample) && sample >= 0.0f, "light is finite and not negative");
}

}  // namespace

MIRRORBALL_HARNESS(gain_map) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static_cast<void>(speaksOfGainMap(text));
  checkLight(readGainMapXmp(text));
  checkLight(readGainMapIso({data, size}));
  fuzz::check(jpegHeader({data, size}).end <= size && endOfJpeg({data, size}) <= size, "segments lie within the bytes");
  const auto part = findGainMap({data, size});
  fuzz::checkError(part);
  if (part && *part) {
    checkLight((*part)->map);
    fuzz::check((*part)->jpeg.size() < size, "the map stands behind the picture");
  }
  return 0;
}
