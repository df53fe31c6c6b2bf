#include "blur_methods.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "formula/bsdf.h"
#include "formula/constants.h"
#include "formula/prefilter.h"
#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball::bench {
namespace {

/// A cube whose texels are `light` at their centres.
template <typename Light>
EnvironmentMap cubeThatShows(int size, const Light& light) {
  ImageSet faces = *imagesFor(Projection::cube, size);
  const auto side = static_cast<std::size_t>(size);
  parallelFor(6 * side, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int face = static_cast<int>(row / side);
      const int y = static_cast<int>(row % side);
      for (int x = 0; x < size; ++x) {
        const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(size),
                           (static_cast<float>(y) + 0.5f) / static_cast<float>(size));
        const glm::vec3 value = light(directionAt(Projection::cube, {face, uv}));
        for (int c = 0; c < 3; ++c) faces.at(0, face).texel(x, y)[c] = value[c];
      }
    }
  });
  return EnvironmentMap(Projection::cube, std::move(faces));
}

Blur prepareExact(const EnvironmentMap& panorama, const std::vector<BlurTarget>& targets) {
  std::vector<Lobe> lobes;
  for (const BlurTarget& target : targets) lobes.push_back(target.lobe);
  const auto light = std::make_shared<LightHarmonics>(*LightHarmonics::make(Environment(panorama), lobes));
  return [light](const BlurTarget& target) { return *cubeOf(*light, target.lobe, target.size); };
}

/// A cube with its mip levels, which a GPU would look up.
class CubeTexture {
 public:
  /// with_mips   otherwise it has one level
  CubeTexture(const EnvironmentMap& panorama, bool with_mips) {
    const int size = equivalentSize(Projection::equirect, panorama.size(), Projection::cube);
    EnvironmentMap cube = *convert(Environment(panorama), Projection::cube, size);
    if (!with_mips) {
      levels_.push_back(std::move(cube));
      return;
    }
    const ImageSet chain = mipChain(cube);
    for (int level = 0; level < chain.levels(); ++level) {
      ImageSet faces(1, 6);
      for (int face = 0; face < 6; ++face) faces.at(0, face) = chain.at(level, face);
      levels_.emplace_back(Projection::cube, std::move(faces));
    }
  }

  int size() const { return levels_.front().size(); }

  /// Bilinear in a level, linear between two.
  glm::vec3 sample(glm::vec3 direction, float lod) const {
    const auto last = static_cast<float>(levels_.size() - 1);
    const float within = std::clamp(lod, 0.0f, last);
    const auto finer = static_cast<std::size_t>(within);
    const glm::vec3 light = levels_[finer].radiance(direction);
    const float share = within - std::floor(within);
    if (share == 0.0f) return light;
    return glm::mix(light, levels_[finer + 1].radiance(direction), share);
  }

  /// Of level 0, in the middle of a face.
  float texelsPerRadian() const { return texelDensity(Projection::cube, size()); }

 private:
  std::vector<EnvironmentMap> levels_;
};

/// A light direction around +Z, what it counts and the mip level that it reads.
struct LobeSample {
  glm::vec3 direction;
  float weight;
  float lod;
};

/// The i-th of `count` points of Hammersley's set in [0, 1)².
glm::vec2 hammersley(unsigned i, unsigned count) {
  float radical = 0.0f;
  float digit = 0.5f;
  for (unsigned rest = i; rest > 0; rest /= 2, digit /= 2) radical += static_cast<float>(rest % 2) * digit;
  return {(static_cast<float>(i) + 0.5f) / static_cast<float>(count), radical};
}

/// Half vectors by D(h) n·h, each light direction counting n·l (Karis 2013); of irradiance, directions by their cosine.
LobeSample lobeSample(const BlurTarget& target, glm::vec2 u) {
  const float phi = formula::kTwoPi * u.x;
  const auto around = [phi](float cosine) {
    const float sine = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
    return glm::vec3(sine * std::cos(phi), sine * std::sin(phi), cosine);
  };
  if (target.is_irradiance) return {around(std::sqrt(1.0f - u.y)), 1.0f, 0.0f};
  const float alpha2 = std::pow(target.perceptual_roughness, 4.0f);
  const glm::vec3 half = around(std::sqrt((1.0f - u.y) / (1.0f + (alpha2 - 1.0f) * u.y)));
  const glm::vec3 light = 2.0f * half.z * half - glm::vec3(0.0f, 0.0f, 1.0f);
  return {light, std::max(light.z, 0.0f), 0.0f};
}

/// The density [1/sr] with which lobeSample takes a direction: D(h) / 4, since v·h = n·h.
float densityOf(const BlurTarget& target, const LobeSample& sample) {
  if (target.is_irradiance) return sample.direction.z / formula::kPi;
  const float alpha2 = std::pow(target.perceptual_roughness, 4.0f);
  const float half_cosine2 = (1.0f + sample.direction.z) / 2.0f;
  const float q = half_cosine2 * (alpha2 - 1.0f) + 1.0f;
  return alpha2 / (4.0f * formula::kPi * q * q);
}

/// lod   ½ log₂(solid angle of a sample / that of a texel) + 1 (Křivánek & Colbert 2008, "Real-time shading with
///       filtered importance sampling", sec. 4)
std::vector<LobeSample> lobeSamples(const BlurTarget& target, unsigned count, int cube_size) {
  const float texel = 4.0f * formula::kPi / (6.0f * static_cast<float>(cube_size) * static_cast<float>(cube_size));
  std::vector<LobeSample> samples;
  for (unsigned i = 0; i < count; ++i) {
    LobeSample sample = lobeSample(target, hammersley(i, count));
    if (sample.weight <= 0.0f) continue;
    const float solid_angle = 1.0f / (static_cast<float>(count) * std::max(densityOf(target, sample), 1e-6f));
    sample.lod = std::max(0.5f * std::log2(solid_angle / texel) + 1.0f, 0.0f);
    samples.push_back(sample);
  }
  return samples;
}

BlurMethod importanceSampling(unsigned count, bool of_mips) {
  const auto prepare = [count, of_mips](const EnvironmentMap& panorama, const std::vector<BlurTarget>&) -> Blur {
    const auto texture = std::make_shared<CubeTexture>(panorama, of_mips);
    return [texture, count](const BlurTarget& target) {
      const std::vector<LobeSample> samples = lobeSamples(target, count, texture->size());
      return cubeThatShows(target.size, [&](glm::vec3 normal) {
        const glm::vec3 up = std::abs(normal.z) < 0.999f ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
        const glm::vec3 right = glm::normalize(glm::cross(up, normal));
        const glm::mat3 world_from_lobe(right, glm::cross(normal, right), normal);
        glm::vec3 sum(0.0f);
        float weights = 0.0f;
        for (const LobeSample& sample : samples) {
          sum += sample.weight * texture->sample(world_from_lobe * sample.direction, sample.lod);
          weights += sample.weight;
        }
        return sum / weights;
      });
    };
  };
  const std::string family = of_mips ? "samples of mip levels" : "samples of the map";
  return {std::to_string(count) + " " + family, family, true, true, prepare};
}

/// What the renderer does with `--blur mip`.
Blur prepareMipLevel(const EnvironmentMap& panorama, const std::vector<BlurTarget>&) {
  const auto texture = std::make_shared<CubeTexture>(panorama, true);
  return [texture](const BlurTarget& target) {
    return cubeThatShows(target.size, [&](glm::vec3 direction) {
      return texture->sample(direction,
                             formula::lodOfLobe(target.perceptual_roughness, texture->texelsPerRadian(), direction));
    });
  };
}

/// What engines evaluate for irradiance (Ramamoorthi & Hanrahan 2001).
Blur prepareNineHarmonics(const EnvironmentMap& panorama, const std::vector<BlurTarget>&) {
  const Harmonics coefficients =
      irradianceOf(radianceHarmonics(*LightHarmonics::make(Environment(panorama), {Lobe::cosine()}), 2));
  return [coefficients](const BlurTarget& target) {
    return cubeThatShows(target.size, [&](glm::vec3 direction) {
      glm::vec3 irradiance(0.0f);
      for (int i = 0; i < 9; ++i) irradiance += coefficients[std::size_t(i)] * formula::harmonic(i, direction);
      return glm::max(irradiance, 0.0f) / formula::kPi;
    });
  };
}

}  // namespace

std::vector<BlurTarget> blurTargets(int size) {
  std::vector<BlurTarget> targets;
  const std::vector<PrefilterLevel> levels = prefilterLevels({.size = size});
  for (std::size_t i = 1; i < levels.size(); ++i)
    if (levels[i].lobe)
      targets.push_back(
          {"level " + std::to_string(i), levels[i].size, levels[i].perceptual_roughness, false, *levels[i].lobe});
  targets.push_back({"irradiance", 64, 1.0f, true, Lobe::cosine()});
  return targets;
}

std::vector<BlurMethod> blurMethods() {
  std::vector<BlurMethod> methods{{"mirrorball bake", "mirrorball bake", true, true, prepareExact}};
  for (const bool of_mips : {false, true})
    for (const unsigned count : {32u, 128u, 1024u}) methods.push_back(importanceSampling(count, of_mips));
  methods.push_back({"one mip level", "one mip level", true, false, prepareMipLevel});
  methods.push_back({"nine harmonics", "nine harmonics", false, true, prepareNineHarmonics});
  return methods;
}

}  // namespace mirrorball::bench
