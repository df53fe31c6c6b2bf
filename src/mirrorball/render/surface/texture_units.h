#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mirrorball/gl/texture.h"
#include "mirrorball/render/surface/surface_variant.h"

namespace mirrorball {

/// What surfaces read beside their materials' maps. All programs have the first four, which are bound once a frame or a
/// light.
enum class FrameTexture : std::uint8_t {
  environment,
  prefiltered,
  irradiance,
  brdf_table,
  proxy,            ///< its triangles, or the shadow on the ground
  nearness,         ///< of a probe
  sphere_map,       ///< which shows what is infinitely far away
  bodies,           ///< that are traced
  back_faces,       ///< of bodies
  scene_triangles,  ///< that are reflected
  opaque_picture,   ///< what is seen through glass
  relief_hits,
  prisms,
  heights,  ///< of the material, to be searched
  horizons,
  slopes,       ///< of heights, or a map of slopes
  sun_shadows,  ///< what hides suns; last, since surfaces do without where no unit is left
};
constexpr std::size_t kFrameTextures = 17;

/// Units of a material's own maps, heights and slopes: those that the frame leaves to it in OpenGL ES.
constexpr int kUnitsOfMaterial = 9;

/// Those that no program of surfaces expects to stay as they are: for programs that draw something else between them.
constexpr int kFreeUnit = 4;
constexpr int kNextFreeUnit = 5;

/// The texture units of a variant's program, handed out one after the other to what it reads: no two share one.
class TextureUnits {
 public:
  explicit TextureUnits(const SurfaceVariant& variant);

  /// Whether there are units enough.
  static bool suffice(const SurfaceVariant& variant);

  bool reads(FrameTexture texture) const { return units_[static_cast<std::size_t>(texture)] >= 0; }
  /// Of what is read.
  int of(FrameTexture texture) const { return units_[static_cast<std::size_t>(texture)]; }
  /// Of the material's maps: MapSource::unit counts from there.
  int firstOfMaps() const { return first_of_maps_; }

 private:
  std::array<int, kFrameTextures> units_;
  int first_of_maps_;
  int count_;
};

/// The sampler by which a variant's shaders read it; empty: they do not.
std::string_view samplerOf(FrameTexture texture, const SurfaceVariant& variant);

}  // namespace mirrorball
