// Height maps of odd sizes with any numbers in them, through all that is made of heights; the same numbers as normals
// and as slopes.

#include "fuzz.h"
#include "made_input.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/heights_from_normals.h"
#include "mirrorball/height_field/occlusion.h"
#include "mirrorball/height_field/slopes.h"
#include "mirrorball/scene/relief/height_texture.h"
#include "mirrorball/scene/relief/slope_texture.h"

namespace mirrorball::fuzz {
namespace {

Image madeImage(MadeInput& input, int width, int height, int channels, float unit) {
  Image image(width, height, channels);
  for (float& sample : image.samples()) sample = input.number() * unit;
  return image;
}

void checkShares(const Image& map) {
  for (const float share : map.samples()) check(share >= 0.0f && share <= 1.0f, "shares are from 0 to 1");
}

void checkDirections(const Image& map) {
  for (std::size_t i = 0; i < map.texelCount(); ++i) {
    const float* n = map.samples().data() + 3 * i;
    check(std::abs(std::hypot(n[0], n[1], n[2]) - 1.0f) < 1e-3f, "normals are unit vectors");
  }
}

/// What a map of any numbers becomes, or why it does not.
void makeMaps(const Image& heights, const HeightFieldSettings& settings, ConeKind kind) {
  const auto normals = normalsFromHeights(heights, settings);
  checkError(normals);
  if (normals) checkDirections(*normals);
  const auto slopes = derivativesFromHeights(heights, settings);
  checkError(slopes);
  if (slopes) checkFinite(slopes->samples(), "slopes are finite");
  const auto cones = coneMap(heights, kind, settings.edges);
  checkError(cones);
  if (cones) checkShares(*cones);
  const auto seen = occlusionOf(heights, settings, 8);
  checkError(seen);
  if (seen) checkShares(seen->visible);
  if (seen) checkDirections(seen->bent_normals);
}

/// What a material's heights become, once they are brought to [0, 1].
void makeTexture(Image heights, MapEdges edges) {
  for (float& height : heights.samples()) height = std::clamp(height, 0.0f, 1.0f);
  auto texture = heightTexture(std::move(heights), edges);
  checkError(texture);
  if (!texture) return;
  checkFinite(texture->picture.samples(), "maxima are finite");
  checkError(makeCones(*texture));
  checkError(makeHorizons(*texture));
  if (!texture->cones.empty()) checkShares(texture->cones);
  for (int level = 0; level < texture->horizons.slopes.levels(); ++level)
    for (int layer = 0; layer < texture->horizons.slopes.layers(); ++layer)
      checkFinite(texture->horizons.slopes.at(level, 0, layer).samples(), "horizons are finite");
}

}  // namespace
}  // namespace mirrorball::fuzz

MIRRORBALL_HARNESS(heights) {
  using namespace mirrorball;
  using namespace mirrorball::fuzz;
  MadeInput input(data, size);
  const int width = 1 + input.upTo(10);
  const int height = 1 + input.upTo(10);
  const int flags = input.byte();
  const HeightFieldSettings settings{
      .difference = HeightDifference(flags & 3),
      .edges = (flags & 4) != 0 ? MapEdges::clamped : MapEdges::tiled,
      .scale = std::clamp(input.finite() * input.powerOfTwo(), -1e30f, 1e30f),
  };
  const float unit = input.powerOfTwo();
  const ConeKind kind = (flags & 8) != 0 ? ConeKind::relaxed : ConeKind::conservative;
  if ((flags & 16) == 0) {
    const Image heights = madeImage(input, width, height, 1, unit);
    makeMaps(heights, settings, kind);
    makeTexture(heights, settings.edges);
    return 0;
  }
  const Image vectors = madeImage(input, width, height, 3, unit);
  const auto heights = heightsFromNormals(vectors, settings);
  checkError(heights);
  if (heights) makeMaps(*heights, settings, kind);
  const auto slopes = slopesOfPicture(vectors, (flags & 32) != 0);
  checkError(slopes);
  if (slopes) checkFinite(slopes->samples(), "slopes are finite");
  return 0;
}
