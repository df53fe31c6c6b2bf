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
constexpr std::size_t kTileTexels = std::size_t{kTileWidth} * kTileHeight;

/// A strip has a row of tiles and, in the formats of a GPU, up to 256 KiB: it stays in a core's cache until it is
/// written.
constexpr int kStripWidth = 1024;

}  // namespace

std::vector<Strip> Conversion::strips() const {
  std::vector<Strip> strips;
  for (int face = 0; face < faceCount(to_); ++face)
    for (int y = 0; y < extent_.y; y += kTileHeight)
      for (int x = 0; x < extent_.x; x += kStripWidth)
        strips.push_back({face, {x, y}, glm::min(glm::ivec2(x + kStripWidth, y + kTileHeight), extent_)});
  return strips;
}

struct Conversion::Tile {
  int face;
  glm::ivec2 begin;
  glm::ivec2 end;

  glm::ivec2 size() const { return end - begin; }
  int count() const { return size().x * size().y; }
  /// Of the texel with that number, row by row.
  glm::ivec2 texel(int index) const { return begin + glm::ivec2(index % size().x, index / size().x); }
  int index(glm::ivec2 texel) const { return (texel.y - begin.y) * size().x + texel.x - begin.x; }
};

float Conversion::brightness(const glm::vec4& light) { return light.x + light.y + light.z; }

/// Of each texel of a tile, row by row.
struct Conversion::TileLight {
  std::array<glm::vec4, kTileTexels> radiance;  ///< and in w 1, or 0 beside a disc
  std::array<float, kTileTexels> smoothness;    ///< as LightBatch has it
  float least_smoothness = 1.0f;

  void set(std::size_t index, glm::vec4 texel, float smooth) {
    radiance[index] = texel;
    smoothness[index] = smooth;
    least_smoothness = std::min(least_smoothness, smooth);
  }
};

struct Conversion::Border {
  float highest = 0.0f;  ///< brightness
  float smoothness = 1.0f;
};

/// Points of texels, looked up a batch at a time: the sums of their light.
class Conversion::PointSums {
 public:
  PointSums(const Conversion& conversion, const Environment& source, const Tile& tile, Interpolation interpolation)
      : conversion_(conversion), source_(source), tile_(tile), interpolation_(interpolation) {
    sums_.fill(glm::vec4(0.0f));
    smoothness_.fill(1.0f);
  }

  /// Adds points that are spread evenly over a texel; on a disc, those that it covers.
  void addTexel(int index, glm::ivec2 points) {
    const glm::vec2 corner(tile_.texel(index));
    for (int j = 0; j < points.y; ++j)
      for (int i = 0; i < points.x; ++i)
        addPoint(index, (corner + (glm::vec2(i, j) + 0.5f) / glm::vec2(points)) / glm::vec2(conversion_.extent_));
  }

  /// Looks up what has been added. To be called before the results are asked for.
  void finish() {
    if (batch_.count == 0) return;
    conversion_.lookUp(source_, interpolation_, batch_, light_);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
      const auto index = static_cast<std::size_t>(texel_[i]);
      sums_[index] += glm::vec4(glm::vec3(light_[i]), 1.0f);
      smoothness_[index] = std::min(smoothness_[index], light_[i].w);
    }
    batch_.count = 0;
  }

  bool hasPoints(std::size_t index) const { return sums_[index].w > 0.0f; }
  /// The mean of a texel's points and 1, or 0 if it has none.
  glm::vec4 mean(std::size_t index) const { return sums_[index] / std::max(sums_[index].w, 1.0f); }
  float smoothness(std::size_t index) const { return smoothness_[index]; }

 private:
  void addPoint(int index, glm::vec2 uv) {
    texel_[static_cast<std::size_t>(batch_.count)] = index;
    if (conversion_.append(tile_.face, uv, batch_)) finish();
  }

  const Conversion& conversion_;
  const Environment& source_;
  const Tile& tile_;
  Interpolation interpolation_;
  PointBatch batch_;
  LightBatch light_;
  std::array<int, PointBatch::kCapacity> texel_;  ///< of each point
  std::array<glm::vec4, kTileTexels> sums_;       ///< light, and in w how many points
  std::array<float, kTileTexels> smoothness_;     ///< the least of its points'
};

/// Whether each texel of the target is one of the source's.
bool Conversion::isOnSameGrid(const Environment& source) const {
  const EnvironmentMap* map = source.map();
  return map && map->projection() == to_ && map->extent() == extent_ && sourceFromTarget() == glm::mat3(1.0f);
}

/// Adds a point to a batch, on a disc only if the disc covers it.
///
/// returns  whether the batch is full
bool Conversion::append(int face, glm::vec2 uv, PointBatch& batch) const {
  if (has_disc_ && !covers(to_, uv)) return false;
  const auto index = static_cast<std::size_t>(batch.count);
  batch.face[index] = face;
  batch.u[index] = uv.x;
  batch.v[index] = uv.y;
  return ++batch.count == PointBatch::kCapacity;
}

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

/// One look-up at the centre of every texel of a target without a disc: nothing has to be summed or left out.
void Conversion::lookUpCentres(const Environment& source, const Tile& tile, TileLight& light) const {
  constexpr int kRowsPerBatch = PointBatch::kCapacity / kTileWidth;
  const auto width = static_cast<std::size_t>(tile.size().x);
  std::array<float, kTileWidth> across;
  for (std::size_t x = 0; x < width; ++x)
    across[x] = (static_cast<float>(tile.begin.x + static_cast<int>(x)) + 0.5f) / static_cast<float>(extent_.x);
  PointBatch batch;
  LightBatch answers;
  std::size_t first = 0;
  for (int top = tile.begin.y; top < tile.end.y; top += kRowsPerBatch) {
    std::size_t count = 0;
    for (int y = top; y < std::min(top + kRowsPerBatch, tile.end.y); ++y, count += width) {
      std::copy_n(across.begin(), width, batch.u.begin() + count);
      std::fill_n(batch.v.begin() + count, width, (static_cast<float>(y) + 0.5f) / static_cast<float>(extent_.y));
    }
    std::fill_n(batch.face.begin(), count, tile.face);
    batch.count = static_cast<int>(count);
    lookUp(source, resampling_.interpolation, batch, answers);
    for (std::size_t i = 0; i < count; ++i) light.set(first + i, glm::vec4(glm::vec3(answers[i]), 1.0f), answers[i].w);
    first += count;
  }
}

/// The mean over each texel of the target; nothing beside a disc.
void Conversion::lookUpMeans(const Environment& source, const Tile& tile, glm::ivec2 points,
                             Interpolation interpolation, TileLight& light) const {
  PointSums sums(*this, source, tile, interpolation);
  for (int index = 0; index < tile.count(); ++index)
    if (!has_disc_ || covers(to_, (glm::vec2(tile.texel(index)) + 0.5f) / glm::vec2(extent_)))
      sums.addTexel(index, points);
  sums.finish();
  for (std::size_t index = 0; index < static_cast<std::size_t>(tile.count()); ++index)
    light.set(index, sums.mean(index), sums.smoothness(index));
}

/// What is at a tile's border, half a texel outside of its outer centres, by so many points that they see what the
/// means of its texels see of what is outside.
Conversion::Border Conversion::lookUpBorder(const Environment& source, const Tile& tile,
                                            const PointsPerTexel& points) const {
  Border border;
  PointBatch batch;
  LightBatch light;
  const auto finish = [&] {
    if (batch.count > 0) lookUp(source, Interpolation::bilinear, batch, light);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
      border.highest = std::max(border.highest, brightness(light[i]));
      border.smoothness = std::min(border.smoothness, light[i].w);
    }
    batch.count = 0;
  };
  const auto add = [&](glm::vec2 place) {
    if (append(tile.face, place / glm::vec2(extent_), batch)) finish();
  };
  const glm::vec2 begin(tile.begin);
  const glm::vec2 end(tile.end);
  const glm::vec2 step = glm::vec2(points.stride) / glm::vec2(points.smooth);
  for (float x = begin.x; x < end.x; x += step.x) add({x, begin.y}), add({x, end.y});
  for (float y = begin.y; y < end.y; y += step.y) add({begin.x, y}), add({end.x, y});
  add(end);
  finish();
  return border;
}

/// Whether the look-ups at a tile's outer centres read, and found smooth, all that lookUpBorder would read: a bicubic
/// one reads a texel more on each side than the two that it lies between, and where there is one for a texel, that
/// texel's border is at most 0.71 of the source's texels away. Not along a panorama's rows near its poles, whose texels
/// are narrow: a sun there is small.
bool Conversion::seesBorder(const Tile& tile, const PointsPerTexel& points, const TileLight& light) const {
  if (has_disc_ || points.smooth != glm::ivec2(1) || resampling_.interpolation != Interpolation::bicubic) return false;
  if (light.least_smoothness == 1.0f) return true;
  const auto isSmooth = [&](int x, int y) {
    return light.smoothness[static_cast<std::size_t>(tile.index({x, y}))] == 1.0f;
  };
  for (int x = tile.begin.x; x < tile.end.x; ++x)
    if (!isSmooth(x, tile.begin.y) || !isSmooth(x, tile.end.y - 1)) return false;
  for (int y = tile.begin.y; y < tile.end.y; ++y)
    if (!isSmooth(tile.begin.x, y) || !isSmooth(tile.end.x - 1, y)) return false;
  return true;
}

/// Whether something in a tile, or at its border, is small and many times brighter than the rest of the tile, and light
/// not smooth. A texel that is 64 times brighter than 511 others has a ninth of their light, of which the 17 % by which
/// one look-up may be off are 2 %. Gaps of sky between leaves differ as much from one texel to the next, but by less
/// from all; they are many, what one is off by another makes up for, and a mean would blur them.
bool Conversion::hasSun(const Tile& tile, const TileLight& light, const Border& border) {
  constexpr float kSmall = 1.0f / 8.0f;  // of a tile's area
  constexpr float kBrighter = 64.0f;
  constexpr float kPart = 1.0f / 8.0f;  // of a sun's light: what is as bright belongs to it
  if (border.smoothness == 1.0f && light.least_smoothness == 1.0f) return false;
  const auto count = static_cast<std::size_t>(tile.count());
  float highest = border.highest;
  for (std::size_t index = 0; index < count; ++index) highest = std::max(highest, brightness(light.radiance[index]));
  float sum = 0.0f, of_others = 0.0f;
  std::size_t others = 0;
  for (std::size_t index = 0; index < count; ++index) {
    const float here = brightness(light.radiance[index]);
    sum += here;
    if (here >= kPart * highest) continue;
    of_others += here;
    ++others;
  }
  // As if the tile were whole: where a map ends it may be a few texels wide, and a sun most of it.
  const bool is_small = kSmall * highest * static_cast<float>(kTileTexels) > sum;
  return is_small && (others == 0 || highest * static_cast<float>(others) > kBrighter * of_others);
}

/// Whether light at a texel of a tile or beside it is not smooth: a look-up at its centre does not see all that its
/// mean does.
bool Conversion::isBesideSun(const Tile& tile, glm::ivec2 texel, const TileLight& light, const Border& border) {
  const glm::ivec2 first = texel - 1;
  const glm::ivec2 last = texel + 1;
  const bool is_at_border =
      glm::any(glm::lessThan(first, tile.begin)) || glm::any(glm::greaterThanEqual(last, tile.end));
  if (is_at_border && border.smoothness < 1.0f) return true;
  for (int y = std::max(first.y, tile.begin.y); y <= std::min(last.y, tile.end.y - 1); ++y)
    for (int x = std::max(first.x, tile.begin.x); x <= std::min(last.x, tile.end.x - 1); ++x)
      if (light.smoothness[static_cast<std::size_t>(tile.index({x, y}))] < 1.0f) return true;
  return false;
}

/// In a tile with a sun, and where light is not smooth, a mean over so many points that the sun keeps its flux.
void Conversion::lookUpBesideSuns(const Environment& source, const Tile& tile, const PointsPerTexel& points,
                                  TileLight& light) const {
  if (!source.map()) return;  // a function, which is as smooth as it is
  const Border border = seesBorder(tile, points, light) ? Border{} : lookUpBorder(source, tile, points);
  if (!hasSun(tile, light, border)) return;
  PointSums means(*this, source, tile, Interpolation::bilinear);
  for (int index = 0; index < tile.count(); ++index)
    if (light.radiance[static_cast<std::size_t>(index)].w > 0.0f && isBesideSun(tile, tile.texel(index), light, border))
      means.addTexel(index, points.sharp);
  means.finish();
  for (std::size_t index = 0; index < static_cast<std::size_t>(tile.count()); ++index)
    if (means.hasPoints(index))
      light.radiance[index] = glm::mix(means.mean(index), light.radiance[index],
                                       std::min(light.smoothness[index], means.smoothness(index)));
}

void Conversion::fillTile(const Environment& source, const Tile& tile, glm::ivec2 origin, Image& texels) const {
  const PointsPerTexel points =
      pointsPerTexel(source, to_, extent_, tile.face, tile.begin, tile.end, sourceFromTarget());
  const bool is_single = points.smooth == glm::ivec2(1);
  TileLight light;
  if (is_single && !has_disc_)
    lookUpCentres(source, tile, light);
  else
    lookUpMeans(source, tile, points.smooth, is_single ? resampling_.interpolation : Interpolation::bilinear, light);
  if (points.sharp != points.smooth && !isOnSameGrid(source)) lookUpBesideSuns(source, tile, points, light);
  auto radiance = light.radiance.begin();
  for (int y = tile.begin.y; y < tile.end.y; ++y) {
    float* texel = texels.texel(tile.begin.x - origin.x, y - origin.y);
    for (int x = tile.begin.x; x < tile.end.x; ++x, ++radiance) {
      texel[0] = radiance->x;
      texel[1] = radiance->y;
      texel[2] = radiance->z;
      if (has_disc_) texel[3] = radiance->w;
      texel += texels.channels();
    }
  }
}

void Conversion::fill(const Environment& source, const Strip& strip, Image& texels) const {
  for (int x = strip.begin.x; x < strip.end.x; x += kTileWidth)
    fillTile(source, {strip.face, {x, strip.begin.y}, {std::min(x + kTileWidth, strip.end.x), strip.end.y}},
             strip.begin, texels);
}

}  // namespace mirrorball
