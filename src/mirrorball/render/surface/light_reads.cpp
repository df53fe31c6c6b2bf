#include "mirrorball/render/surface/light_reads.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/render/surface/wavelength_sets.h"

namespace mirrorball {
namespace {

/// A sampler of a formula that counts how often it is read.
struct CountingCube {
  int& reads;
};

glm::vec4 sampleLod(const CountingCube& cube, glm::vec3, float) {
  ++cube.reads;
  return glm::vec4(1.0f);
}

/// How many directions transmitted light is read from: those of transmission_single.glsl once for each kind of light
/// that goes its own way, those of transmission_image_space.glsl twice, and those of transmission_traced.glsl where it
/// leaves at each surface.
///
/// some_disperse  of the scene's bodies, through which light of all others may go
int transmittedRays(const Material& material, const FrameSettings& settings, bool some_disperse) {
  if (material.transmission == 0.0f) return 0;
  if (!isBody(material)) return 1;
  const int kinds = lightKindsOf(settings);
  if (settings.refraction == RefractionKind::traced) return (some_disperse ? kinds : 1) * (settings.inner_bounces + 1);
  const int ways = settings.refraction == RefractionKind::image_space ? 2 : 1;
  return ways * (material.dispersion == 0.0f ? 1 : kinds);
}

/// How many lobes make up a rough reflection.
int lobesOfReflection(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  return readsLobeRow(material, settings, coordinates) ? lobesOf(settings) : 1;
}

/// How many directions reflected light is read from at most.
int readsOfReflection(const Material& material, const FrameSettings& settings, const CoordinateChoice& coordinates) {
  if (stretchesLobes(material, settings, coordinates)) return formula::kTapsOfStretchedLobe;
  if (readsStrata(material, settings, coordinates)) return formula::kStrata;
  return lobesOfReflection(material, settings, coordinates);
}

LightReads readsOf(const Material& material, const formula::Blur& blur, const FrameSettings& settings,
                   const CoordinateChoice& coordinates, bool some_disperse) {
  LightReads reads{.irradiance = 1};
  const int refracted = transmittedRays(material, settings, some_disperse);
  const int coats = material.clearcoat > 0.0f ? 1 : 0;
  const int lobes = readsOfReflection(material, settings, coordinates);
  const bool has_sheen = material.sheen_color != glm::vec3(0.0f);
  const int on_cloth = has_sheen ? formula::kSheenRings * formula::kSheenSpokes : 0;
  const int reflected = coordinates.is_sphere_map ? 0 : lobes;
  reads.sphere_map = coordinates.is_sphere_map ? 1 + coats : 0;
  reads.irradiance += coats;
  const auto read = [&](int times, float perceptual_roughness) {
    const glm::vec3 anywhere(0.0f, 0.0f, 1.0f);
    for (int i = 0; i < times; ++i)
      formula::blurredLight(blur, CountingCube{reads.environment}, CountingCube{reads.prefiltered}, anywhere,
                            perceptual_roughness, 0.0f);
  };
  read(reflected + refracted, material.perceptual_roughness);
  read(on_cloth, formula::kSheenTapRoughness);
  const int of_coat = hasSmoothCoat(material) ? 1 : lobesOfReflection(material, settings, coordinates);
  read(coordinates.is_sphere_map ? 0 : coats * of_coat, material.clearcoat_roughness);
  return reads;
}

}  // namespace

int blurKindOfFormula(BlurKind blur) {
  switch (blur) {
    case BlurKind::mip:
      return 1;
    case BlurKind::cone:
      return 2;
    default:
      return 0;
  }
}

formula::Blur blurOf(const FrameSettings& settings, const gl::Texture& cube, const PrefilteredChain& chain) {
  return {.kind = blurKindOfFormula(settings.blur),
          .first_level = static_cast<float>(chain.first_level),
          .last_level = static_cast<float>(chain.lastLevel()),
          .texels_per_radian = texelDensity(Projection::cube, cube.width())};
}

LightReads lightReads(const Scene& scene, const formula::Blur& blur, const FrameSettings& settings) {
  const CoordinateChoice coordinates = coordinateChoice(scene, settings);
  const bool some_disperse = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
    return isBody(material) && material.dispersion > 0.0f;
  });
  LightReads most;
  for (const Mesh& mesh : scene.meshes) {
    FrameSettings decided = settings;
    decided.refraction = refractionOf(scene, mesh.material, settings.refraction);
    const LightReads reads =
        readsOf(scene.materials[std::size_t(mesh.material)], blur, decided, coordinates, some_disperse);
    most = {.environment = std::max(most.environment, reads.environment),
            .prefiltered = std::max(most.prefiltered, reads.prefiltered),
            .irradiance = std::max(most.irradiance, reads.irradiance),
            .sphere_map = std::max(most.sphere_map, reads.sphere_map)};
  }
  return most;
}

}  // namespace mirrorball
