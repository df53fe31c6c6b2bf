#include "mirrorball/render/surface/height_buffers.h"

#include <algorithm>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/height_field/slope_moments.h"
#include "mirrorball/render/surface/map_sampling.h"

namespace mirrorball {
namespace {

/// The picture of heights with cones in the second channel.
Image withCones(const HeightTexture& texture) {
  Image both(texture.picture.width(), texture.picture.height(), 2);
  for (int y = 0; y < both.height(); ++y)
    for (int x = 0; x < both.width(); ++x) both.texel(x, y)[0] = texture.picture.texel(x, y)[0];
  for (int y = 0; y < texture.cones.height(); ++y)
    for (int x = 0; x < texture.cones.width(); ++x) both.texel(x, y)[1] = texture.cones.texel(x, y)[0];
  return both;
}

Result<gl::Texture> makeHorizons(const ImageSet& slopes, MapEdges edges) {
  const Image& largest = slopes.at(0, 0);
  MIRRORBALL_TRY(array, gl::Texture::makeArray(gl::Format::rgba16f, largest.width(), largest.height(), slopes.layers(),
                                               slopes.levels()));
  for (int level = 0; level < slopes.levels(); ++level)
    for (int layer = 0; layer < slopes.layers(); ++layer) array.upload(level, layer, slopes.at(level, 0, layer));
  array.setSampling(samplingOf(wrapOf(edges), TextureFilter::trilinear, 1.0f));
  return Result<gl::Texture>(std::move(array));
}

/// For searches, which read single texels.
Result<gl::Texture> makeSearched(const HeightTexture& texture) {
  const Image& picture = texture.picture;
  const gl::Format format = texture.cones.empty() ? gl::Format::r32f : gl::Format::rg32f;
  MIRRORBALL_TRY(made, gl::Texture::make2d(format, picture.width(), picture.height()));
  if (texture.cones.empty())
    made.upload(0, 0, picture);
  else
    made.upload(0, 0, withCones(texture));
  return Result<gl::Texture>(std::move(made));
}

/// A texture for slopes, empty yet, and how many of their finest levels it has no place for.
struct RoomForSlopes {
  gl::Texture texture;
  int finest;
};

/// Room for the slopes of a map of that size. What the driver does not take is left to the lobes, which its variance
/// widens: so a surface looks the same until a texel of the map is nearly as large as a pixel.
///
/// errors   too_large
Result<RoomForSlopes> roomForSlopes(glm::ivec2 size) {
  for (int finest = 0;; ++finest) {
    const glm::ivec2 sides(levelSide(size.x, finest), levelSide(size.y, finest));
    auto texture = gl::Texture::make2d(gl::Format::rgba16f, sides.x, sides.y, gl::Texture::kAllLevels);
    if (!texture && (texture.error().code != ErrorCode::too_large || std::max(sides.x, sides.y) == 1))
      return fail(std::move(texture));
    if (!texture) continue;
    return RoomForSlopes{std::move(*texture), finest};
  }
}

}  // namespace

Result<HeightBuffers> HeightBuffers::make(const HeightTexture& texture) {
  std::optional<HeightBuffers::Searched> searched;
  if (!texture.horizons.slopes.empty()) {
    MIRRORBALL_TRY(heights, makeSearched(texture));
    MIRRORBALL_TRY(horizons, makeHorizons(texture.horizons.slopes, texture.edges));
    searched.emplace(Searched{std::move(heights), std::move(horizons)});
  }
  MIRRORBALL_TRY(room, roomForSlopes({texture.heights.width(), texture.heights.height()}));
  MIRRORBALL_TRY(moments, slopeMoments(texture.heights, texture.edges, room.finest));
  room.texture.upload(moments.levels);
  return HeightBuffers{std::move(room.texture), moments.unit, std::move(searched)};
}

Result<SlopeBuffer> SlopeBuffer::make(const Image& slopes) {
  MIRRORBALL_TRY(room, roomForSlopes({slopes.width(), slopes.height()}));
  MIRRORBALL_TRY(moments, momentsOfSlopes(slopes, room.finest));
  room.texture.upload(moments.levels);
  return SlopeBuffer{std::move(room.texture), moments.unit};
}

}  // namespace mirrorball
