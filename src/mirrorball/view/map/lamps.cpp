#include "mirrorball/view/map/lamps.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "formula/color.h"
#include "mirrorball/bake/prefilter/bright_lights.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

constexpr float kLeastShare = 1e-3f;

struct CubeTexel {
  int face;
  glm::ivec2 place;
};

/// The texel beside another, over an edge of the cube too.
CubeTexel texelBeside(const CubeTexel& texel, glm::ivec2 step, int side) {
  const glm::ivec2 place = texel.place + step;
  if (std::min(place.x, place.y) >= 0 && std::max(place.x, place.y) < side) return {texel.face, place};
  const glm::vec2 st = (glm::vec2(place) + 0.5f) / static_cast<float>(side);
  const MapPosition found = positionOf(Projection::cube, directionAt(Projection::cube, {texel.face, st}));
  return {found.face, glm::clamp(glm::ivec2(found.uv * static_cast<float>(side)), glm::ivec2(0), glm::ivec2(side - 1))};
}

/// Which texels are bright and belong to no lamp yet.
class BrightTexels {
 public:
  explicit BrightTexels(const EnvironmentMap& cube)
      : side_(cube.size()), left_(6 * std::size_t(side_) * std::size_t(side_), false) {
    for (const Excess& excess : brightLights(cube, std::numeric_limits<int>::max()).texels) {
      texels_.push_back({excess.face, excess.texel});
      left_[indexOf(texels_.back())] = true;
    }
  }

  const std::vector<CubeTexel>& texels() const { return texels_; }

  /// Takes a texel with all that are connected with it; none if it is taken already.
  std::vector<CubeTexel> takeRegion(const CubeTexel& first) {
    std::vector<CubeTexel> region;
    take(first, region);
    for (std::size_t next = 0; next < region.size(); ++next)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) take(texelBeside(region[next], {x, y}, side_), region);
    return region;
  }

 private:
  std::size_t indexOf(const CubeTexel& texel) const {
    return (std::size_t(texel.face) * std::size_t(side_) + std::size_t(texel.place.y)) * std::size_t(side_) +
           std::size_t(texel.place.x);
  }
  void take(const CubeTexel& texel, std::vector<CubeTexel>& region) {
    const std::size_t index = indexOf(texel);
    if (!left_[index]) return;
    left_[index] = false;
    region.push_back(texel);
  }

  int side_;
  std::vector<bool> left_;
  std::vector<CubeTexel> texels_;
};

Lamp lampOf(const EnvironmentMap& cube, const std::vector<CubeTexel>& region) {
  const auto radianceAt = [&](const CubeTexel& texel) {
    return rgbAt(cube.face(texel.face), texel.place.x, texel.place.y);
  };
  float brightest = 0.0f;
  for (const CubeTexel& texel : region) brightest = std::max(brightest, formula::luminance(radianceAt(texel)));
  glm::dvec3 towards(0.0);
  glm::dvec3 all(0.0);
  glm::dvec3 of_core(0.0);
  double solid_angle = 0.0;
  for (const CubeTexel& texel : region) {
    const glm::vec3 radiance = radianceAt(texel);
    const auto angle = double(texelSolidAngle(Projection::cube, cube.extent(), texel.place));
    const glm::vec2 st = (glm::vec2(texel.place) + 0.5f) / static_cast<float>(cube.size());
    const glm::dvec3 flux = glm::dvec3(radiance) * angle;
    const float luminance = formula::luminance(radiance);
    towards += glm::dvec3(directionAt(Projection::cube, {texel.face, st})) * (double(luminance) * angle);
    all += flux;
    if (2.0f * luminance < brightest) continue;
    of_core += flux;
    solid_angle += angle;
  }
  // What lies evenly all around has no middle.
  const double length = glm::length(towards);
  const glm::dvec3 middle = length > 0.0 ? towards / length : glm::dvec3(0.0, 0.0, 1.0);
  return {.direction = glm::vec3(middle),
          .solid_angle_sr = static_cast<float>(solid_angle),
          .radiance = glm::vec3(of_core / solid_angle),
          .irradiance = glm::vec3(all)};
}

}  // namespace

float Lamp::angularRadius() const {
  // Ω = 2π (1 − cos r) = 4π sin²(r/2), which keeps its digits where r is small.
  return 2.0f * std::asin(std::min(std::sqrt(solid_angle_sr / (4.0f * std::numbers::pi_v<float>)), 1.0f));
}

std::vector<Lamp> lampsOf(const EnvironmentMap& cube, glm::vec3 all, std::size_t max) {
  assert(cube.projection() == Projection::cube);
  BrightTexels bright(cube);
  std::vector<Lamp> lamps;
  for (const CubeTexel& texel : bright.texels()) {
    const std::vector<CubeTexel> region = bright.takeRegion(texel);
    if (!region.empty()) lamps.push_back(lampOf(cube, region));
  }
  for (Lamp& lamp : lamps) lamp.share = std::min(formula::luminance(lamp.irradiance) / formula::luminance(all), 1.0f);
  std::erase_if(lamps, [](const Lamp& lamp) { return !(lamp.share >= kLeastShare); });
  std::stable_sort(lamps.begin(), lamps.end(), [](const Lamp& a, const Lamp& b) {
    return formula::luminance(a.irradiance) > formula::luminance(b.irradiance);
  });
  lamps.resize(std::min(lamps.size(), max));
  return lamps;
}

}  // namespace mirrorball
