#include "mirrorball/photo/outline_picture.h"

#include <algorithm>
#include <array>

#include "mirrorball/codec/color/srgb.h"

namespace mirrorball {
namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color kLine{60, 255, 60};
constexpr Color kCasing{0, 0, 0};

void mix(Image8& picture, int x, int y, const Color& color, double share) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint8_t& code = picture.texel(x, y)[c];
    code = static_cast<std::uint8_t>(std::lround(code + share * (color[c] - code)));
  }
}

/// Draws a line of that width where `distance` [px] is zero, with a dark casing so that it shows on any picture.
template <typename Distance>
void draw(Image8& picture, double width_px, const Distance& distance) {
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const double away = std::abs(distance(glm::dvec2(x, y) + 0.5));
      mix(picture, x, y, kCasing, 0.6 * std::clamp(1.2 * width_px - away + 0.5, 0.0, 1.0));
      mix(picture, x, y, kLine, std::clamp(width_px / 2.0 - away + 0.5, 0.0, 1.0));
    }
}

}  // namespace

Image8 outlinePicture(const Image& light, const BallView& view) {
  Image rgb(light.width(), light.height(), 3);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const glm::vec3 color = rgbAt(light, x, y);
      for (int c = 0; c < 3; ++c) rgb.texel(x, y)[c] = color[c];
    }
  Image8 picture = pictureFromLinear(rgb, 3);
  // Thin enough to see the rim beside it, wide enough to be seen when a large picture is shown small.
  const double width = std::max(1.0, std::max(light.width(), light.height()) / 1000.0);
  draw(picture, width, [&](glm::dvec2 position) { return view.fromRim_px(position); });
  const glm::dvec2 center = view.pinhole().pictureFromPlane(view.rim().center_px);
  const double arm = 0.04 * view.rim().radius_px;
  draw(picture, width, [&](glm::dvec2 position) {
    const glm::dvec2 away = glm::abs(position - center);
    return std::max(std::min(away.x, away.y), std::max(away.x, away.y) - arm);
  });
  return picture;
}

}  // namespace mirrorball
