#include "mirrorball/height_field/occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "formula/relief.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/horizon_sweep.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

/// Adds what a texel sees above a horizon.
void add(const HorizonSlice& slice, const Image& normals, Occlusion& sum) {
  const float* normal = normals.texel(slice.texel.x, slice.texel.y);
  const glm::vec2 away = slice.away;
  const glm::vec3 seen =
      slice.width * formula::visibleSlice(normal[0] * away.x + normal[1] * away.y, normal[2], slice.slope);
  float* mean = sum.bent_normals.texel(slice.texel.x, slice.texel.y);
  mean[0] += seen.x * away.x;
  mean[1] += seen.x * away.y;
  mean[2] += seen.y;
  sum.visible.texel(slice.texel.x, slice.texel.y)[0] += seen.z;
}

/// Sums become a share and a direction. Rounding may take a share a little beyond 1; a texel that sees nothing keeps
/// its normal.
void finish(const Image& normals, Occlusion& sum) {
  constexpr std::size_t kTexelsPerPiece = 1 << 14;
  parallelFor(sum.visible.texelCount(), kTexelsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float& visible = sum.visible.samples()[i];
      visible = std::clamp(visible / std::numbers::pi_v<float>, 0.0f, 1.0f);
      float* mean = &sum.bent_normals.samples()[3 * i];
      const float length = std::sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
      for (std::size_t c = 0; c < 3; ++c) mean[c] = length > 1e-12f ? mean[c] / length : normals.samples()[3 * i + c];
    }
  });
}

}  // namespace

Result<Occlusion> occlusionOf(const Image& heights, const HeightFieldSettings& settings, int azimuths,
                              const ProgressFunction& progress) {
  MIRRORBALL_TRY(normals, normalsFromHeights(heights, settings));
  MIRRORBALL_TRY_VOID(checkRange(heights));
  constexpr std::uint64_t kFloatsPerTexel = 7;
  MIRRORBALL_TRY_VOID(checkMemory(heights.texelCount() * kFloatsPerTexel * sizeof(float)));
  Occlusion sum{Image(heights.width(), heights.height(), 1), Image(heights.width(), heights.height(), 3)};
  MIRRORBALL_TRY_VOID(sweepHorizons(heights, settings, azimuths, progress,
                                    [&](const HorizonSlice& slice) { add(slice, normals, sum); }));
  finish(normals, sum);
  return sum;
}

}  // namespace mirrorball
