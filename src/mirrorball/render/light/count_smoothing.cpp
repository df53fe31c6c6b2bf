#include "mirrorball/render/light/count_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/glm.hpp>

#include "formula/constants.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kWidths = 5;
constexpr float kEnough = 48.0f;  // rays: each texel is within 15 % of what many would bring

glm::vec4 texelNear(const Image& picture, int x, int y) {
  const float* texel = picture.texel(std::clamp(x, 0, picture.width() - 1), std::clamp(y, 0, picture.height() - 1));
  return {texel[0], texel[1], texel[2], texel[3]};
}

/// One direction of a blur by the binomial 1 4 6 4 1, with holes (Holschneider et al. 1989, the algorithme à trous).
Image blurredAlong(const Image& picture, glm::ivec2 step) {
  constexpr std::array<float, 3> kWeights{6.0f / 16.0f, 4.0f / 16.0f, 1.0f / 16.0f};
  Image blurred(picture.width(), picture.height(), 4);
  parallelFor(std::size_t(picture.height()), 16, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        glm::vec4 sum = kWeights[0] * texelNear(picture, x, y);
        for (int i = 1; i <= 2; ++i)
          sum += kWeights[std::size_t(i)] * (texelNear(picture, x + i * step.x, y + i * step.y) +
                                             texelNear(picture, x - i * step.x, y - i * step.y));
        for (int channel = 0; channel < 4; ++channel) blurred.texel(x, y)[channel] = sum[channel];
      }
    }
  });
  return blurred;
}

}  // namespace

void smoothByCount(Image& picture) {
  Image narrow = picture;
  Image smooth = picture;
  // How many rays each width has in it, of which the last with too few and the first with enough share a texel.
  float variance = 1.0f / 6.0f;  // of the tent that rays were added by, in texels²
  for (int width = 0; width < kWidths; ++width) {
    const int step = 1 << width;
    const Image wide = blurredAlong(blurredAlong(narrow, {step, 0}), {0, step});
    const float rays_of_narrow = 4.0f * formula::kPi * variance;
    variance += float(step * step);
    const float rays_of_wide = 4.0f * formula::kPi * variance;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const float in_narrow = rays_of_narrow * narrow.texel(x, y)[3];
        const float in_wide = rays_of_wide * wide.texel(x, y)[3];
        if (in_narrow >= kEnough) continue;
        const float share = in_wide <= kEnough ? 1.0f : (kEnough - in_narrow) / std::max(in_wide - in_narrow, 1e-6f);
        for (int channel = 0; channel < 3; ++channel)
          smooth.texel(x, y)[channel] = glm::mix(narrow.texel(x, y)[channel], wide.texel(x, y)[channel], share);
      }
    }
    narrow = wide;
  }
  picture = std::move(smooth);
}

}  // namespace mirrorball
