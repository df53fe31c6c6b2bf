#pragma once

#include "mirrorball/bake/prefilter/lobe.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What the columns and rows of a table stand for.
enum class BrdfAxes {
  linear,  ///< n·v = (i + ½) / size to the right, perceptual roughness = (j + ½) / size downwards: as engines expect
  warped,  ///< formula::brdfTableCoordinates: bilinear look-ups are accurate everywhere, for ggx, phong and blinn
};

struct BrdfTableOptions {
  int size = 128;    ///< texels a side, 2 to kLargestBrdfTable
  int channels = 2;  ///< 2, or 3 with the mean share
  Distribution distribution = Distribution::ggx;
  BrdfAxes axes = BrdfAxes::linear;
  bool has_tilt = false;  ///< in one channel more: DirectionalAlbedo::tilt
};

inline constexpr int kLargestBrdfTable = 4096;

/// The BRDF table of the split sum: how much of a white environment's light a rough surface reflects.
///
/// returns  size × size: scale and bias of f0 (directionalAlbedo), and as the third channel averageAlbedo, the same
///          in a whole row. Row 0 is the smoothest
/// errors   usage: the size; warped axes for charlie, whose share grows without bound towards one corner;
///          interrupted (when `progress` says so)
/// cost     that of directionalAlbedo per texel, on all cores; bit-identical for any number of threads
/// from     Karis 2013, "Real shading in Unreal Engine 4"
Result<Image> brdfTable(const BrdfTableOptions& options, const ProgressFunction& progress = {});

/// The n·v of a column of warped axes: formula::brdfTableColumn turned round.
///
/// column                0, the first, to 1, the last
/// perceptual_roughness  of the row; that of row 0 counts as 10⁻⁴
float cosineOfWarpedColumn(float column, float perceptual_roughness);

}  // namespace mirrorball
