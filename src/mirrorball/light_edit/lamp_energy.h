#pragma once

#include <vector>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/light_edit/lamp_split.h"

namespace mirrorball {

/// By how much a surface is lit otherwise by a lamp than by its light as it lay in the map.
struct LampError {
  /// Of the irradiance, at the normal where it is most, of the map's irradiance there: where the lamp is a disc of its
  /// size, and where it shines from one direction. That one is most where a surface just turns away from the lamp: some
  /// 0.11 times its size in radians of its own irradiance, which is much where little else lights the surface.
  float irradiance = 0.0f;
  float irradiance_of_point = 0.0f;
  /// Of a rough sphere lit from one direction, at the place where it is most, of the brightest light on the sphere.
  float rough_sphere = 0.0f;

  /// The perceptual roughness of that sphere; rougher ones differ less.
  static constexpr float kRoughness = 0.4f;
};

/// The error of each lamp that was taken out of a map, in their order.
///
/// split    by splitLamps
/// returns  the largest of the three channels' differences, of the largest of the channels before, at 2000 normals and
///          at 192 more around each lamp, of which most are square to it; of the sphere, what it reflects by GGX's lobe
///          towards an eye that looks along its normal
/// errors   too_large; interrupted (when `progress` says so)
/// cost     that of converting the rest to 512 rows and of the irradiance and reflections of those, one map more of
///          memory, and 10 ns for each normal and texel of a lamp; bit-identical for any number of threads
Result<std::vector<LampError>> lampErrors(const SplitMap& split, const ProgressFunction& progress = {});

}  // namespace mirrorball
