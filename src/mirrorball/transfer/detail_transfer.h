#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/transfer/mapped_surface.h"

namespace mirrorball {

struct TransferSettings {
  glm::ivec2 size{1024};                     ///< of the maps, in texels
  int samples_side = 2;                      ///< side² samples a texel, in rows and columns; at least 1
  NormalSpace space = NormalSpace::tangent;  ///< of normals and bent normals
  /// In radii of the light model. 0: rays go both ways from the surface along its interpolated normals, and the nearest
  /// place of the dense one counts. Else they begin that far outside, along means of normals that go on over sharp
  /// edges, and end as far inside; the outermost place counts.
  float cage = 0.0f;
  int padding = 8;  ///< texels beside the surface's edges that are filled; at least 0
  bool wants_heights = false;
  bool wants_occlusion = false;
  int occlusion_rays = 64;  ///< a texel, of occlusion and bent normals; at least 1
};

/// Maps of a light model, and how well they were filled.
struct TransferredDetail {
  Image normals;  ///< 3 channels, unit, signed; y up
  Image heights;  ///< 1 channel: how far the dense surface lies outside, in units of the world; empty unless wanted
  Image visible;  ///< 1 channel in [0, 1]: share of an even sky's irradiance that the dense model leaves; or empty
  Image bent_normals;        ///< 3 channels, unit: where that light comes from; or empty
  double covered = 0.0;      ///< share of the map's texels that a triangle touches
  double missed = 0.0;       ///< share of samples whose rays met nothing; others of the texel count, or it is flat
  double overlapping = 0.0;  ///< share of samples that several triangles claim, as mirrored halves do
};

/// Finds the detail of a dense model for the texels of a light one at the same place: normals, with what normal maps
/// the dense one has, and where they are wanted heights and occlusion.
///
/// high     any models of triangles, with the origin of the light one (moveOrigin); surfaces that face away from a
///          ray's outside are passed
/// low      with texture coordinates, of which the first are meant; all its instances share the map
/// errors   bad_shape (a model without triangles or texture coordinates; no ray met anything); out_of_range (texture
///          coordinates); too_large; interrupted
/// cost     0.5 µs a sample on one core with 33,000 triangles, and 0.25 µs a ray of occlusion; bit-identical for any
///          number of threads
/// from     Cignoni et al. 1998, "A general method for preserving attribute values on simplified meshes"; Cohen et al.
///          1998, "Appearance-preserving simplification"
Result<TransferredDetail> transferDetail(const Scene& high, const Scene& low, const TransferSettings& settings = {},
                                         const ProgressFunction& progress = {});

}  // namespace mirrorball
