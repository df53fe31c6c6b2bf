#pragma once

#include <algorithm>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// A map each of whose texels is `radiance(face, texel)`: for what is no conversion between projections, and needs no
/// mean over a texel's area because source and target are of one size. Three channels; bit-identical for any number of
/// threads.
///
/// projection  one without a disc
template <typename Radiance>
EnvironmentMap mapByTexel(Projection projection, int size, const Radiance& radiance) {
  constexpr std::size_t kRowsPerPiece = 16;
  const glm::ivec2 extent = imageSize(projection, size);
  ImageSet images(1, faceCount(projection));
  for (int face = 0; face < images.faces(); ++face) {
    Image& image = images.at(0, face) = Image::withoutValues(extent.x, extent.y, 3);
    parallelFor(static_cast<std::size_t>(extent.y), kRowsPerPiece, [&](std::size_t begin, std::size_t end) {
      for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
        for (int x = 0; x < extent.x; ++x) {
          const glm::vec3 light = radiance(face, glm::ivec2(x, y));
          std::copy_n(&light.x, 3, image.texel(x, y));
        }
    });
  }
  return EnvironmentMap(projection, std::move(images));
}

}  // namespace mirrorball
