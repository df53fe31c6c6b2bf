#include "mirrorball/environment/convert/conversion.h"

#include <algorithm>
#include <array>

#include "mirrorball/environment/convert/point_batch.h"
#include "mirrorball/environment/convert/sample_batch.h"
#include "mirrorball/environment/convert/supersampling.h"

namespace mirrorball {
namespace {

/// Small enough that the footprint of a texel hardly changes within one, and that its texels lie near each other.
constexpr int kTileWidth = 32;
constexpr int kTileHeight = 16;

/// A piece has a row of tiles and, in the formats of a GPU, up to 256 KiB: it stays in a core's cache until it is
/// written.
constexpr int kPieceWidth = 1024;

}  // namespace

std::vector<Piece> Conversion::pieces() const {
  std::vector<Piece> pieces;
  for (int face = 0; face < faceCount(to_); ++face)
    for (int y = 0; y < extent_.y; y += kTileHeight)
      for (int x = 0; x < extent_.x; x += kPieceWidth)
        pieces.push_back({face, {x, y}, glm::min(glm::ivec2(x + kPieceWidth, y + kTileHeight), extent_)});
  return pieces;
}

/// Where the points of one row of a tile's texels go: batch → texel.
struct Conversion::Row {
  PointBatch batch;
  LightBatch light;
  std::array<int, PointBatch::kCapacity> texel;  ///< of each point, counted from the tile's left side
  std::array<glm::vec4, kTileWidth> sum;         ///< light, and in w how many points
};

struct Conversion::Tile {
  int face;
  glm::ivec2 begin;
  glm::ivec2 end;
};

/// The light at every point of the target that a batch has.
void Conversion::lookUp(const Environment& source, Interpolation interpolation, PointBatch& batch,
                        LightBatch& light) const {
  directionsAt(to_, batch);
  if (sourceFromTarget() != glm::mat3(1.0f)) turn(sourceFromTarget(), batch);
  if (const EnvironmentMap* map = source.map()) {
    positionsOf(map->projection(), batch);
    sampleBatch(*map, interpolation, batch, light);
  } else {
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
      light[i] = glm::vec4(source.radiance({batch.x[i], batch.y[i], batch.z[i]}), 1.0f);
  }
}

/// Looks up what the batch has collected, adds it to the texels' sums, and empties the batch.
void Conversion::gather(const Environment& source, Row& row, Interpolation interpolation) const {
  PointBatch& batch = row.batch;
  if (batch.count == 0) return;
  lookUp(source, interpolation, batch, row.light);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
    row.sum[static_cast<std::size_t>(row.texel[i])] += glm::vec4(glm::vec3(row.light[i]), 1.0f);
  batch.count = 0;
}

void Conversion::addPoint(const Environment& source, Row& row, int face, int texel, glm::vec2 uv,
                          Interpolation interpolation) const {
  if (has_disc_ && !covers(to_, uv)) return;
  PointBatch& batch = row.batch;
  const auto index = static_cast<std::size_t>(batch.count);
  batch.face[index] = face;
  batch.u[index] = uv.x;
  batch.v[index] = uv.y;
  row.texel[index] = texel;
  if (++batch.count == PointBatch::kCapacity) gather(source, row, interpolation);
}

/// One look-up at the centre of every texel of a target without a disc: nothing has to be summed or left out.
void Conversion::fillCentres(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const {
  constexpr int kRowsPerBatch = PointBatch::kCapacity / kTileWidth;
  PointBatch batch;
  LightBatch light;
  const int width = tile.end.x - tile.begin.x;
  for (int top = tile.begin.y; top < tile.end.y; top += kRowsPerBatch) {
    const int bottom = std::min(top + kRowsPerBatch, tile.end.y);
    std::size_t index = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = 0; x < width; ++x, ++index) {
        const glm::vec2 uv = (glm::vec2(tile.begin.x + x, y) + 0.5f) / glm::vec2(extent_);
        batch.face[index] = tile.face;
        batch.u[index] = uv.x;
        batch.v[index] = uv.y;
      }
    batch.count = static_cast<int>(index);
    lookUp(source, resampling_.interpolation, batch, light);
    index = 0;
    for (int y = top; y < bottom; ++y) {
      float* texel = texels.texel(tile.begin.x - origin.x, y - origin.y);
      for (int x = 0; x < width; ++x, ++index, texel += 3) std::copy_n(&light[index].x, 3, texel);
    }
  }
}

void Conversion::fillTile(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const {
  const glm::ivec2 points = pointsPerTexel(source, to_, extent_, tile.face, tile.begin, tile.end, sourceFromTarget());
  const bool is_single = points == glm::ivec2(1);
  if (is_single && !has_disc_) return fillCentres(source, tile, origin, texels);
  const Interpolation interpolation = is_single ? resampling_.interpolation : Interpolation::bilinear;
  Row row;
  for (int y = tile.begin.y; y < tile.end.y; ++y) {
    row.sum.fill(glm::vec4(0.0f));
    for (int x = tile.begin.x; x < tile.end.x; ++x) {
      if (has_disc_ && !covers(to_, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent_))) continue;
      for (int j = 0; j < points.y; ++j)
        for (int i = 0; i < points.x; ++i) {
          const glm::vec2 inside = (glm::vec2(i, j) + 0.5f) / glm::vec2(points);
          addPoint(source, row, tile.face, x - tile.begin.x, (glm::vec2(x, y) + inside) / glm::vec2(extent_),
                   interpolation);
        }
    }
    gather(source, row, interpolation);
    for (int x = tile.begin.x; x < tile.end.x; ++x) {
      const glm::vec4 sum = row.sum[static_cast<std::size_t>(x - tile.begin.x)];
      const glm::vec4 mean = sum.w == 0.0f ? glm::vec4(0.0f) : sum / sum.w;
      std::copy_n(&mean.x, texels.channels(), texels.texel(x - origin.x, y - origin.y));
    }
  }
}

void Conversion::fill(const Environment& source, const Piece& piece, Image& texels) const {
  for (int x = piece.begin.x; x < piece.end.x; x += kTileWidth)
    fillTile(source, {piece.face, {x, piece.begin.y}, {std::min(x + kTileWidth, piece.end.x), piece.end.y}},
             piece.begin, texels);
}

}  // namespace mirrorball
