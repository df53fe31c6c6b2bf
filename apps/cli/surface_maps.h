#pragma once

#include <string>
#include <vector>

#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball::cli {

/// The maps that `surface` makes, in the order of --to's choices.
enum class SurfaceMap { normal, derivative, height, cone, pyramid, occlusion, bent_normal };

/// What `surface` is told beside its files.
struct SurfaceOptions {
  SurfaceMap to = SurfaceMap::normal;
  HeightFieldSettings field{.scale = 0.05f};
  bool has_scale = false;  ///< the user gave one
  bool directx = false;
  ConeKind cones = ConeKind::conservative;
  int azimuths = 2;  ///< 8 << azimuths
  std::string max_memory = {};
};

/// A map as its numbers are.
struct MadeMap {
  ImageSet images;         ///< levels only of a pyramid; 1 or 3 channels
  bool is_signed = false;  ///< of a picture, ½ + ½ n stands for it
  float scale = 0.0f;      ///< of heights that were given the range 0 to 1: the scale with which they are right; else 0
};

/// Reads heights, or normals for --to height, and makes the map. What there is to say of the input is said.
///
/// errors   as readFile's, decodeNumbers' and the maps'; with the input's name
Result<MadeMap> makeSurfaceMap(const std::string& input, const SurfaceOptions& options);

}  // namespace mirrorball::cli
