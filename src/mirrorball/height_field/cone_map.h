#pragma once

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What a cone promises to a ray that is inside of it.
enum class ConeKind {
  conservative,  ///< there is no surface in the cone (Dummer)
  relaxed,       ///< a ray that came from straight above the cone's tip enters the surface at most once in the cone, so
                 ///< that a search between two points finds where (Policarpo and Oliveira)
};

/// For each texel the widest cone that stands on the surface at the texel's centre and opens upwards. The surface is
/// the one that bilinear filtering shows; rays for relaxed cones begin at the height of its highest texel.
///
/// returns  1 channel: √ratio, where ratio is the cone's radius in texture widths at a height of 1 above its tip, at
///          most 1. With a scale S the radius grows by ratio / S a unit of height, both in texture widths.
/// errors   non_finite (the first bad texel is named); too_large; interrupted
/// cost     a search in a maximum pyramid for each texel: 1024² in 2 s (conservative) or 20 s (relaxed) on two cores
/// from     Dummer 2006, "Cone step mapping"; Policarpo and Oliveira 2007, "Relaxed cone stepping for relief mapping",
///          GPU Gems 3, chapter 18
Result<Image> coneMap(const Image& heights, ConeKind kind, MapEdges edges = MapEdges::tiled,
                      const ProgressFunction& progress = {});

}  // namespace mirrorball
