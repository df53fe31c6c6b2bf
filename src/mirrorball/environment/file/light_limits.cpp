#include "mirrorball/environment/file/light_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

float brightest(glm::vec3 light) { return std::max({light.x, light.y, light.z}); }

bool isFinite(glm::vec3 light) { return std::isfinite(light.x) && std::isfinite(light.y) && std::isfinite(light.z); }

/// Light no brighter than `max`, with the hue that it had.
glm::vec3 limited(glm::vec3 light, float max) {
  const float now = brightest(light);
  return now > max && isFinite(light) ? glm::min(light * (max / now), max) : light;
}

void setRgb(Image& image, int x, int y, glm::vec3 light) {
  const int colors = std::min(image.channels(), 3);
  std::copy_n(&light.x, colors, image.texel(x, y));
}

void scale(Image& image, float factor) {
  const auto channels = static_cast<std::size_t>(image.channels());
  const std::size_t colors = std::min<std::size_t>(channels, 3);
  parallelFor(static_cast<std::size_t>(image.height()), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      const std::span<float> row = image.row(static_cast<int>(y));
      for (std::size_t texel = 0; texel < row.size(); texel += channels)
        for (float& sample : row.subspan(texel, colors)) sample *= factor;
    }
  });
}

/// Limits a rectangle of texels, each of which weighs 1.
LostLight limitBlock(glm::ivec2 first, glm::ivec2 end, float max, Image& texels) {
  LostLight light;
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      const glm::vec3 before = rgbAt(texels, x, y);
      const glm::vec3 after = limited(before, max);
      if (!isFinite(before)) continue;
      light.kept += double(formula::luminance(after));
      if (after == before) continue;
      setRgb(texels, x, y, after);
      light.lost += double(formula::luminance(before)) - double(formula::luminance(after));
    }
  return light;
}

}  // namespace

LostLight limitLight(Projection projection, glm::ivec2 extent, glm::ivec2 begin, float max, Image& texels) {
  // A block's texels have nearly one solid angle, which costs more than all else here.
  constexpr int kBlocks = 128;
  const int step = std::max(1, std::min(extent.x, extent.y) / kBlocks);
  const glm::ivec2 size(texels.width(), texels.height());
  LostLight light;
  for (int top = 0; top < size.y; top += step)
    for (int left = 0; left < size.x; left += step) {
      const glm::ivec2 first(left, top);
      const glm::ivec2 end = glm::min(first + step, size);
      const auto weight = double(texelSolidAngle(projection, extent, begin + (first + end) / 2));
      const LostLight here = limitBlock(first, end, max, texels);
      light.add({weight * here.lost, weight * here.kept});
    }
  return light;
}

LostLight limitLight(Projection projection, const LightLimits& limits, Image& image) {
  if (limits.scale != 1.0f) scale(image, limits.scale);
  if (!std::isfinite(limits.max)) return {};
  return limitLight(projection, {image.width(), image.height()}, {0, 0}, limits.max, image);
}

LostLight limitLight(EnvironmentMap& map, const LightLimits& limits) {
  LostLight light;
  for (int face = 0; face < map.faces(); ++face) light.add(limitLight(map.projection(), limits, map.face(face)));
  return light;
}

LostLight limitLight(Environment& environment, const LightLimits& limits) {
  if (limits.areNone()) return {};
  if (EnvironmentMap* map = environment.map()) return limitLight(*map, limits);
  const Environment whole = environment;
  environment = Environment(
      [whole, limits](glm::vec3 direction) { return limited(whole.radiance(direction) * limits.scale, limits.max); },
      whole.naturalSize(Projection::equirect));
  return {};
}

std::string percentOf(const LostLight& light) {
  const double percent = 100.0 * light.share();
  if (percent < 0.01) return "less than 0.01 %";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), percent < 10.0 ? "%.2g %%" : "%.0f %%", percent);
  return text.data();
}

void tellLimited(const std::string& name, const LostLight& light, const Observer& observer) {
  if (light.lost > 0.0)
    observer.tell(RemarkKind::light_limited, name + ": the limit takes " + percentOf(light) + " of the light");
}

}  // namespace mirrorball
