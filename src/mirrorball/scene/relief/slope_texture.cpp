#include "mirrorball/scene/relief/slope_texture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "formula/surface.h"
#include "mirrorball/image/neutral_code.h"

namespace mirrorball {

Result<Image> slopesOfPicture(const Image& numbers, bool is_encoded) {
  constexpr float kSteepest = 1e4f;
  if (numbers.channels() < 3)
    return fail(ErrorCode::bad_shape,
                "is grey, where a map of slopes has red and blue; `surface --to derivative` makes one of heights");
  const bool is_neutral_at_128 = is_encoded && isNeutralAt128(numbers, {.first = 0, .second = 2});
  const float zero = !is_encoded ? 0.0f : is_neutral_at_128 ? 128.0f : 127.5f;
  Image slopes(numbers.width(), numbers.height(), 3);
  for (int y = 0; y < slopes.height(); ++y)
    for (int x = 0; x < slopes.width(); ++x)
      for (int channel = 0; channel < 3; channel += 2) {
        const float number = numbers.texel(x, y)[channel];
        if (!std::isfinite(number))
          return fail(ErrorCode::non_finite,
                      "the slope at (" + std::to_string(x) + ", " + std::to_string(y) + ") is no number");
        slopes.texel(x, y)[channel] =
            std::clamp(formula::decodedNormal(glm::vec3(number), zero).x, -kSteepest, kSteepest);
      }
  return slopes;
}

}  // namespace mirrorball
