#include "mirrorball/light_edit/lamp_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/metric/picture/lettering.h"

namespace mirrorball {
namespace {

using MarkColor = glm::vec<3, std::uint8_t>;

constexpr int kLeastRows = 256;
constexpr int kMostRows = 1024;
constexpr float kBeside_px = 4.0f;  // between a lamp and its outline
const MarkColor kMark{60, 255, 60};
const MarkColor kCasing{0, 0, 0};

/// The picture's pixel in a direction.
glm::ivec2 pixelTowards(const Image8& picture, glm::vec3 direction) {
  const glm::vec2 extent(picture.width(), picture.height());
  return glm::ivec2(positionOf(Projection::equirect, direction).uv * extent);
}

/// A square dot; what lies over the left or right border comes in again at the other one.
void drawDot(Image8& picture, glm::ivec2 middle, int reach, MarkColor color) {
  for (int y = std::max(middle.y - reach, 0); y <= std::min(middle.y + reach, picture.height() - 1); ++y)
    for (int x = middle.x - reach; x <= middle.x + reach; ++x)
      std::copy_n(&color.x, 3, picture.texel((x + picture.width()) % picture.width(), y));
}

/// A corner of an outline, moved away from the lamp's middle.
glm::vec3 movedOut(const MapLamp& lamp, glm::vec3 corner, float by_rad) {
  const auto angle = static_cast<float>(angleBetween(lamp.direction, corner));
  const glm::vec3 across = corner - lamp.direction * glm::dot(corner, lamp.direction);
  const float length = glm::length(across);
  if (length == 0.0f) return corner;
  return lamp.direction * std::cos(angle + by_rad) + across / length * std::sin(angle + by_rad);
}

void drawOutline(const MapLamp& lamp, int reach, MarkColor color, Image8& picture) {
  const float pixels_per_rad = texelDensity(Projection::equirect, picture.height());
  for (std::size_t i = 0; i < lamp.outline.size(); ++i) {
    const glm::vec3 from = movedOut(lamp, lamp.outline[i], kBeside_px / pixels_per_rad);
    const glm::vec3 to = movedOut(lamp, lamp.outline[(i + 1) % lamp.outline.size()], kBeside_px / pixels_per_rad);
    // Dots closer than pixels, more of them near the poles, where a panorama's rows are long.
    const float stretch = 1.0f / std::max(std::min(std::hypot(from.x, from.z), std::hypot(to.x, to.z)), 0.05f);
    const int dots = 2 + static_cast<int>(2.0f * stretch * glm::length(to - from) * pixels_per_rad);
    for (int dot = 0; dot < dots; ++dot) {
      const float share = static_cast<float>(dot) / static_cast<float>(dots);
      drawDot(picture, pixelTowards(picture, glm::normalize(glm::mix(from, to, share))), reach, color);
    }
  }
}

/// In the middle of a lamp, or beside the outline of one that is too small for it, with a dark edge.
void drawNumber(const MapLamp& lamp, std::size_t number, Image8& picture) {
  const int scale = picture.height() > kMostRows / 2 ? 2 : 1;
  const std::string text = std::to_string(number);
  const float pixels_per_rad = texelDensity(Projection::equirect, picture.height());
  const int reach = static_cast<int>(lamp.reach_rad() * pixels_per_rad + 2.0f * kBeside_px);
  const glm::ivec2 size(textWidth(text, scale), lineHeight(scale));
  const int to_right = reach > 3 * size.x ? -size.x / 2 : reach;
  glm::ivec2 corner = pixelTowards(picture, lamp.direction) + glm::ivec2(to_right, -size.y / 2);
  corner = glm::clamp(corner, glm::ivec2(1), glm::ivec2(picture.width(), picture.height()) - size - 1);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) drawText(picture, corner + glm::ivec2(x, y) * scale, scale, kCasing, text);
  drawText(picture, corner, scale, kMark, text);
}

}  // namespace

Result<Image8> lampPicture(const Environment& map, std::span<const MapLamp> lamps, const Display& display,
                           const ProgressFunction& progress) {
  const int rows = std::clamp(map.naturalSize(Projection::equirect), kLeastRows, kMostRows);
  MIRRORBALL_TRY(panorama, convert(map, Projection::equirect, rows, {}, progress));
  Image light = std::move(panorama.face(0));
  showOn(display, light);
  Image8 picture = pictureFromLinear(light, 3);
  for (const MapLamp& lamp : lamps) drawOutline(lamp, 1, kCasing, picture);
  for (const MapLamp& lamp : lamps) drawOutline(lamp, 0, kMark, picture);
  for (std::size_t i = 0; i < lamps.size(); ++i) drawNumber(lamps[i], i + 1, picture);
  return picture;
}

}  // namespace mirrorball
