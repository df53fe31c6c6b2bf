#include "mirrorball/environment/convert.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/footprint.h"
#include "mirrorball/environment/point_batch.h"
#include "mirrorball/environment/sample_batch.h"

namespace mirrorball {
namespace {

/// Small enough that the footprint of a texel hardly changes within one, and that its texels lie near each other.
constexpr int kTileWidth = 32;
constexpr int kTileHeight = 16;

/// A rectangle of a target's texels that is filled as one piece of work.
struct Tile {
  int face;
  glm::ivec2 begin;
  glm::ivec2 end;
};

/// One conversion: what every tile of it needs to know.
class Conversion {
 public:
  Conversion(const Environment& source, Projection to, glm::ivec2 extent, const Resampling& resampling)
      : source_(source), to_(to), extent_(extent), resampling_(resampling) {}

  void fill(const Tile& tile, Image& image) const;

 private:
  /// Where the points of one row of texels go: batch → texel.
  struct Row {
    PointBatch batch;
    LightBatch light;
    std::array<int, PointBatch::kCapacity> texel;  ///< of each point, counted from the tile's left side
    std::array<glm::vec4, kTileWidth> sum;         ///< light, and in w how many points
  };

  bool coversTexel(int x, int y) const { return covers(to_, (glm::vec2(x, y) + 0.5f) / glm::vec2(extent_)); }
  void addPoint(Row& row, int face, int texel, glm::vec2 uv, Interpolation interpolation) const;
  void gather(Row& row, Interpolation interpolation) const;

  const Environment& source_;
  Projection to_;
  glm::ivec2 extent_;
  const Resampling& resampling_;
};

/// Looks up what the batch has collected, adds it to the texels' sums, and empties the batch.
void Conversion::gather(Row& row, Interpolation interpolation) const {
  PointBatch& batch = row.batch;
  if (batch.count == 0) return;
  directionsAt(to_, batch);
  if (resampling_.source_from_target != glm::mat3(1.0f)) turn(resampling_.source_from_target, batch);
  if (const EnvironmentMap* map = source_.map()) {
    positionsOf(map->projection(), batch);
    sampleBatch(*map, interpolation, batch, row.light);
  } else {
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
      row.light[i] = glm::vec4(source_.radiance({batch.x[i], batch.y[i], batch.z[i]}), 1.0f);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
    row.sum[static_cast<std::size_t>(row.texel[i])] += glm::vec4(glm::vec3(row.light[i]), 1.0f);
  batch.count = 0;
}

void Conversion::addPoint(Row& row, int face, int texel, glm::vec2 uv, Interpolation interpolation) const {
  if (!covers(to_, uv)) return;
  PointBatch& batch = row.batch;
  const auto index = static_cast<std::size_t>(batch.count);
  batch.face[index] = face;
  batch.u[index] = uv.x;
  batch.v[index] = uv.y;
  row.texel[index] = texel;
  if (++batch.count == PointBatch::kCapacity) gather(row, interpolation);
}

void Conversion::fill(const Tile& tile, Image& image) const {
  const glm::ivec2 points =
      pointsPerTexel(source_, to_, extent_, tile.face, tile.begin, tile.end, resampling_.source_from_target);
  const bool is_single = points == glm::ivec2(1);
  const Interpolation interpolation = is_single ? resampling_.interpolation : Interpolation::bilinear;
  Row row;
  for (int y = tile.begin.y; y < tile.end.y; ++y) {
    row.sum.fill(glm::vec4(0.0f));
    for (int x = tile.begin.x; x < tile.end.x; ++x) {
      if (!coversTexel(x, y)) continue;
      for (int j = 0; j < points.y; ++j)
        for (int i = 0; i < points.x; ++i) {
          const glm::vec2 inside = (glm::vec2(i, j) + 0.5f) / glm::vec2(points);
          addPoint(row, tile.face, x - tile.begin.x, (glm::vec2(x, y) + inside) / glm::vec2(extent_), interpolation);
        }
    }
    gather(row, interpolation);
    for (int x = tile.begin.x; x < tile.end.x; ++x) {
      const glm::vec4 sum = row.sum[static_cast<std::size_t>(x - tile.begin.x)];
      if (sum.w == 0.0f) continue;
      const glm::vec4 mean = sum / sum.w;
      std::copy_n(&mean.x, image.channels(), image.texel(x, y));
    }
  }
}

/// The tiles of a map, in the order of their memory.
class Tiling {
 public:
  Tiling(glm::ivec2 extent, int faces)
      : extent_(extent),
        columns_((extent.x + kTileWidth - 1) / kTileWidth),
        rows_((extent.y + kTileHeight - 1) / kTileHeight),
        faces_(faces) {}

  std::size_t count() const { return std::size_t(columns_) * std::size_t(rows_) * std::size_t(faces_); }
  std::size_t columns() const { return std::size_t(columns_); }

  Tile at(std::size_t index) const {
    const std::size_t row = index / columns();
    const glm::ivec2 begin(static_cast<int>(index % columns()) * kTileWidth,
                           static_cast<int>(row % std::size_t(rows_)) * kTileHeight);
    return {static_cast<int>(row / std::size_t(rows_)), begin,
            glm::min(begin + glm::ivec2(kTileWidth, kTileHeight), extent_)};
  }

 private:
  glm::ivec2 extent_;
  int columns_;
  int rows_;
  int faces_;
};

}  // namespace

Result<EnvironmentMap> convert(const Environment& source, Projection to, int size, const Resampling& resampling,
                               const ProgressFunction& progress) {
  const glm::ivec2 extent = imageSize(to, size);
  MIRRORBALL_TRY_VOID(checkDimensions("the converted map", extent.x, extent.y));
  ImageSet images(1, faceCount(to));
  for (int face = 0; face < images.faces(); ++face)
    images.at(0, face) = hasDisc(to) ? Image(extent.x, extent.y, 4) : Image::withoutValues(extent.x, extent.y, 3);

  const Conversion conversion(source, to, extent, resampling);
  const Tiling tiling(extent, images.faces());
  std::atomic<std::size_t> tiles_done = 0;
  std::atomic<bool> stopped = false;
  parallelFor(tiling.count(), tiling.columns(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end && !stopped; ++index) {
      const Tile tile = tiling.at(index);
      conversion.fill(tile, images.at(0, tile.face));
    }
    const std::size_t done = tiles_done += end - begin;
    if (progress && !progress(done, tiling.count())) stopped = true;
  });
  if (stopped) return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  return EnvironmentMap(to, std::move(images));
}

}  // namespace mirrorball
