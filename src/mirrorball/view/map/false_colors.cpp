#include "mirrorball/view/map/false_colors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/metric/picture/color_ramp.h"

namespace mirrorball {

float stopsOf(glm::vec3 radiance, float exposure_ev) {
  return std::log2(std::max(formula::luminance(radiance), 0.0f)) + exposure_ev;
}

glm::vec<4, std::uint8_t> falseColor(float stops, float range) {
  const glm::vec3 color = sequentialColor(0.5f + 0.5f * stops / range);
  return {glm::vec<3, std::uint8_t>(color * 255.0f + 0.5f), std::uint8_t(255)};
}

Image8 falseColors(const Image& light, float exposure_ev, float range, glm::vec<4, std::uint8_t> paper) {
  constexpr std::size_t kRowsPerPiece = 16;
  Image8 picture = Image8::withoutValues(light.width(), light.height(), 4);
  parallelFor(std::size_t(light.height()), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      for (int x = 0; x < light.width(); ++x) {
        const glm::vec4 texel = rgbaAt(light, x, y);
        const auto color = texel.w < 0.5f ? paper : falseColor(stopsOf(glm::vec3(texel) / texel.w, exposure_ev), range);
        std::copy_n(&color.x, 4, picture.texel(x, y));
      }
  });
  return picture;
}

void drawLegend(const PixelRectangle& place, float range, Image8& picture) {
  constexpr glm::vec<4, std::uint8_t> kLine{128, 128, 128, 255};
  const auto stopsAt = [&](int x) {
    return range * (2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(place.extent.x) - 1.0f);
  };
  for (int x = 0; x < place.extent.x; ++x) {
    const auto color = falseColor(stopsAt(x), range);
    const bool is_whole = x > 0 && std::floor(stopsAt(x)) != std::floor(stopsAt(x - 1));
    for (int y = 0; y < place.extent.y; ++y) {
      const bool is_line = is_whole && 4 * y >= 3 * place.extent.y;
      std::copy_n(is_line ? &kLine.x : &color.x, 4, picture.texel(place.corner.x + x, place.corner.y + y));
    }
  }
}

}  // namespace mirrorball
