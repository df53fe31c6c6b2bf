#include "mirrorball/codec/color/output_primaries.h"

#include <array>
#include <cmath>

#include <glm/matrix.hpp>

#include "mirrorball/codec/color/primaries.h"

namespace mirrorball {

const Primaries& chromaticitiesOf(OutputPrimaries primaries) {
  static constexpr std::array<Primaries, 4> kAll{kRec709, kDisplayP3, kRec2020, kAcesAp1};
  return kAll[static_cast<std::size_t>(primaries)];
}

glm::mat3 primariesFromRec709(OutputPrimaries primaries) {
  if (primaries == OutputPrimaries::rec709) return glm::mat3(1.0f);
  glm::dmat3 matrix = glm::inverse(rec709Matrix(chromaticitiesOf(primaries)));
  // Rec.709's blue is P3's: what should be 0 there is rounding, which would make light of one colour negative.
  constexpr double kRounding = 1e-12;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (std::abs(matrix[c][r]) < kRounding) matrix[c][r] = 0.0;
  return glm::mat3(matrix);
}

void convertFromRec709(Image& image, OutputPrimaries primaries) {
  if (primaries == OutputPrimaries::rec709 || image.channels() < 3) return;
  // Pure colours of a file in these primaries, which were brought to Rec.709, come back with single floats' errors.
  constexpr float kRounding = 1e-6f;
  transformColors(image, primariesFromRec709(primaries), kRounding);
}

}  // namespace mirrorball
