#include "mirrorball/render/surface/brdf_texture.h"

#include <algorithm>
#include <utility>

#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/bake/brdf/sheen_albedo.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball {
namespace {

/// The BRDF table in the form of formula::environmentBrdf, with zeros where the sheen will be. What is missing to 1
/// lights a surface with all the light around it, and from rounded shares it would come out as some 2e-4 of that where
/// it is nothing: of a sun more than of a room.
Result<Image> missingAndTilted() {
  MIRRORBALL_TRY(table, brdfTable({.axes = BrdfAxes::warped, .has_tilt = true}));
  Image shares(table.width(), table.height(), 4);
  for (int y = 0; y < table.height(); ++y)
    for (int x = 0; x < table.width(); ++x) {
      const float* texel = table.texel(x, y);
      const DirectionalAlbedo albedo{.scale = texel[0], .bias = texel[1], .tilt = texel[2]};
      float* share = shares.texel(x, y);
      // A mirror, row 0, has no facets that light could go to and fro between.
      share[0] = y == 0 ? 0.0f : std::max(1.0f - albedo.total(), 0.0f);
      share[1] = albedo.grazing();
      share[3] = albedo.meanTilt();
    }
  return shares;
}

/// The same with the sheen's albedo in its third channel, on the same axes.
Result<Image> withCloth(const Result<Image>& table) {
  if (!table) return table;
  Image shares = *table;
  const auto place = [&](int index) { return static_cast<float>(index) / static_cast<float>(shares.width() - 1); };
  for (int y = 0; y < shares.height(); ++y)
    for (int x = 0; x < shares.width(); ++x)
      shares.texel(x, y)[2] = sheenAlbedo(place(y), cosineOfWarpedColumn(place(x), place(y)));
  return shares;
}

void copyInto(Image& target, int left, const Image& source) {
  for (int y = 0; y < source.height(); ++y)
    for (int x = 0; x < source.width(); ++x)
      std::copy_n(source.texel(x, y), source.channels(), target.texel(left + x, y));
}

}  // namespace

// Both are made once, since they are the same for every renderer and all their inputs stand here.
Result<Image> surfaceBrdfTable() {
  static const Result<Image> table = missingAndTilted();
  return table;
}

Result<Image> surfaceBrdfTableWithCloth() {
  static const Result<Image> table = withCloth(surfaceBrdfTable());
  return table;
}

Result<gl::Texture> brdfTexture(const Image& table) {
  MIRRORBALL_TRY(rows, lobeRowTable());
  Image both(table.width() + rows.width(), table.height(), 4);
  copyInto(both, 0, table);
  copyInto(both, table.width(), rows);
  MIRRORBALL_TRY(texture, gl::Texture::fromImages(gl::Format::rgba16f, ImageSet(std::move(both))));
  texture.setSampling({.filter = gl::Sampling::Filter::linear});
  return texture;
}

}  // namespace mirrorball
