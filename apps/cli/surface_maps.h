#pragma once

#include <string>

#include "cli/number_maps.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/height_field.h"

namespace mirrorball::cli {

/// The maps that `surface` makes, in the order of --to's choices.
enum class SurfaceMap {
  normal,
  derivative,
  height,
  cone,
  pyramid,
  occlusion,
  bent_normal,
  object_normal,
  tangent_normal
};

/// Whether a map is made of a normal map, not of heights.
inline bool isOfNormals(SurfaceMap map) {
  return map == SurfaceMap::height || map == SurfaceMap::object_normal || map == SurfaceMap::tangent_normal;
}

/// What `surface` is told beside its files.
struct SurfaceOptions {
  SurfaceMap to = SurfaceMap::normal;
  HeightFieldSettings field{.scale = 0.05f};
  bool has_scale = false;  ///< the user gave one
  bool directx = false;
  ConeKind cones = ConeKind::conservative;
  int azimuths = 2;        ///< 8 << azimuths
  std::string model = {};  ///< whose normals they are, of object_normal and tangent_normal
  bool inside_only = false;
  std::string layer = {};  ///< of a file of several pictures
};

/// Reads heights or normals, and makes the map. What there is to say of the input is said.
///
/// errors   as readImageFile's, decodeNumbers', loadModel's and the maps'; with the input's name
Result<MadeMap> makeSurfaceMap(const std::string& input, const SurfaceOptions& options);

}  // namespace mirrorball::cli
