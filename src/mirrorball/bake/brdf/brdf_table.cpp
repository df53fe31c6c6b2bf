#include "mirrorball/bake/brdf/brdf_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// What the first row of warped axes holds instead of roughness 0, which its left half would have no answer for: as
/// sharp a lobe as any picture can tell from a mirror, with grazing angles of 10⁻⁸ rad still resolved.
constexpr float kMinRoughness = 1e-4f;

void fillRow(const BrdfTableOptions& options, int y, Image& table) {
  const bool is_warped = options.axes == BrdfAxes::warped;
  const auto place = [&](int index) {
    if (is_warped) return static_cast<float>(index) / static_cast<float>(options.size - 1);
    return (static_cast<float>(index) + 0.5f) / static_cast<float>(options.size);
  };
  const float perceptual_roughness = is_warped ? std::max(place(y), kMinRoughness) : place(y);
  const float mean = options.channels == 3 ? averageAlbedo(options.distribution, perceptual_roughness) : 0.0f;
  for (int x = 0; x < options.size; ++x) {
    const float cosine = is_warped ? cosineOfWarpedColumn(place(x), perceptual_roughness) : place(x);
    const DirectionalAlbedo share = directionalAlbedo(options.distribution, perceptual_roughness, cosine);
    float* texel = table.texel(x, y);
    texel[0] = share.scale;
    texel[1] = share.bias;
    if (options.channels == 3) texel[2] = mean;
    if (options.has_tilt) texel[options.channels] = share.tilt;
  }
}

}  // namespace

// By bisection.
float cosineOfWarpedColumn(float column, float perceptual_roughness) {
  const float row = std::max(perceptual_roughness, kMinRoughness);
  if (column <= 0.0f) return 0.0f;
  if (column >= 1.0f) return 1.0f;
  // Halving the logarithm: small angles have as many digits as large ones.
  float low = -60.0f;
  float high = 0.0f;
  for (int step = 0; step < 40; ++step) {
    const float middle = (low + high) / 2.0f;
    (formula::brdfTableColumn(row, std::exp2(middle)) < column ? low : high) = middle;
  }
  return std::min(std::exp2((low + high) / 2.0f), 1.0f);
}

Result<Image> brdfTable(const BrdfTableOptions& options, const ProgressFunction& progress) {
  assert(options.channels == 2 || options.channels == 3);
  if (options.size < 2 || options.size > kLargestBrdfTable)
    return fail(ErrorCode::usage, "a BRDF table has 2 to " + std::to_string(kLargestBrdfTable) +
                                      " texels a side, not " + std::to_string(options.size));
  if (options.axes == BrdfAxes::warped && options.distribution == Distribution::charlie)
    return fail(ErrorCode::usage, "charlie's share grows without bound towards smooth grazing cloth: linear axes only");
  Image table = Image::withoutValues(options.size, options.size, options.channels + (options.has_tilt ? 1 : 0));
  ProgressCounter rows(progress, std::size_t(options.size));
  parallelFor(std::size_t(options.size), 1, [&](std::size_t y, std::size_t) {
    if (rows.stopped()) return;
    fillRow(options, static_cast<int>(y), table);
    rows.advance();
  });
  MIRRORBALL_TRY_VOID(rows.result());
  return table;
}

}  // namespace mirrorball
