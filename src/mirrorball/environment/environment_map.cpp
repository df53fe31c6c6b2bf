#include "mirrorball/environment/environment_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "formula/projection.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/projection/texel_geometry.h"

namespace mirrorball {
namespace {

glm::vec2 centerOf(int x, int y) { return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}; }

/// 1, t, t (t − 1) / 2 and t (t − 1) (t − 2) / 6: each 1 at its own number, and 0 at those before.
std::array<float, 4> risingProducts(float t) {
  return {1.0f, t, t * (t - 1.0f) / 2.0f, t * (t - 1.0f) * (t - 2.0f) / 6.0f};
}

constexpr TexelRange kNoTexels{glm::vec3(std::numeric_limits<float>::max()),
                               glm::vec3(std::numeric_limits<float>::lowest())};

void include(TexelRange& range, glm::vec3 texel) {
  range.min = glm::min(range.min, texel);
  range.max = glm::max(range.max, texel);
}

}  // namespace

EnvironmentMap::EnvironmentMap(Projection projection, ImageSet images)
    : projection_(projection),
      has_disc_(hasDisc(projection)),
      extent_(images.at(0, 0).width(), images.at(0, 0).height()),
      rows_{0, extent_.y},
      images_(std::move(images)) {
  assert(images_.levels() == 1 && images_.faces() == faceCount(projection));
  assert(extent_ == imageSize(projection, size()));
  for ([[maybe_unused]] int index = 0; index < faces(); ++index)
    assert(face(index).width() == extent_.x && face(index).height() == extent_.y);
  if (projection_ == Projection::equirect) row_bends_ = panoramaRowBends(extent_.y);
}

EnvironmentMap EnvironmentMap::windowOfPanorama(int height, int channels, int capacity) {
  EnvironmentMap map;
  map.extent_ = imageSize(Projection::equirect, height);
  map.row_bends_ = panoramaRowBends(height);
  map.images_ = ImageSet(Image::withoutValues(map.extent_.x, capacity, channels));
  return map;
}

void EnvironmentMap::appendRows(const Image& rows) {
  Image& image = face(0);
  assert(rows.width() == image.width() && rows.channels() == image.channels());
  assert(rows_.count() + rows.height() <= image.height() && rows_.end + rows.height() <= extent_.y);
  std::copy(rows.samples().begin(), rows.samples().end(), image.texel(0, rows_.count()));
  rows_.end += rows.height();
}

void EnvironmentMap::dropRowsBefore(int row) {
  const int first = std::clamp(row, rows_.begin, rows_.end);
  if (first == rows_.begin) return;
  if (first < rows_.end) {
    const float* kept = face(0).texel(0, first - rows_.begin);
    const std::size_t count = face(0).row(0).size() * static_cast<std::size_t>(rows_.end - first);
    std::copy(kept, kept + count, face(0).samples().data());
  }
  rows_.begin = first;
}

constexpr int kMinSizeOfCubic = 4;

glm::vec3 EnvironmentMap::radiance(glm::vec3 direction, Interpolation interpolation) const {
  if (interpolation == Interpolation::bilinear && !has_disc_) {
    const MapPosition place = positionOf(projection_, direction);
    const glm::vec2 position = place.uv * glm::vec2(extent_);
    if (const auto light = insideImage(place.face, position)) return *light;
  }
  return interpolated(direction, interpolation).radiance;
}

/// panoramaRowBends between the two rows around y; 0 unless it is a panorama.
float EnvironmentMap::rowBendAt(float y) const {
  const float rows = y + 0.5f;  // from the centre of the row before the first
  const bool has_bend = rows >= 0.0f && rows < static_cast<float>(row_bends_.size());
  return has_bend ? row_bends_[static_cast<std::size_t>(rows)] : 0.0f;
}

/// Where bilinear interpolation looks up a position, for each row of a panorama to keep its light.
glm::vec2 EnvironmentMap::keepingLightOfRows(glm::vec2 position) const {
  const float t = glm::fract(position.y - 0.5f);
  return {position.x, position.y + rowBendAt(position.y) * t * (1.0f - t)};
}

/// Bilinear, where all four texels are the image's own. What a half of a sphere does not show lies at its edge, and so
/// never there.
std::optional<glm::vec3> EnvironmentMap::insideImage(int face_index, glm::vec2 position) const {
  const glm::vec2 last = glm::vec2(extent_.x, rows_.end) - 0.5f;
  const bool is_inside = position.x >= 0.5f && position.x < last.x &&
                         position.y >= static_cast<float>(rows_.begin) + 0.5f && position.y < last.y;
  if (!is_inside) return std::nullopt;
  const Image& image = face(face_index);
  return glm::vec3(bilinear(keepingLightOfRows(position),
                            [&](int x, int y) { return glm::vec4(rgbAt(image, x, y - rows_.begin), 1.0f); }));
}

EnvironmentMap::Interpolated EnvironmentMap::interpolated(glm::vec3 direction, Interpolation interpolation) const {
  if (projection_ == Projection::hemioctahedral && direction.z < 0.0f)
    return {glm::vec3(0.0f), {glm::vec3(0.0f), glm::vec3(0.0f)}};
  const MapPosition place = positionOf(projection_, direction);
  const glm::vec2 position = place.uv * glm::vec2(extent_);
  // Of the min_count texels a cubic would reach over several borders.
  if (interpolation == Interpolation::bicubic && hasSmoothRegions(projection_) && size() < kMinSizeOfCubic)
    interpolation = Interpolation::bilinear;
  if (interpolation == Interpolation::bicubic && hasSmoothRegions(projection_)) return cubicOnChart(place, position);
  return betweenTexels(place.face, position, interpolation);
}

/// Between the texels of an image and of its neighbours, wherever they come from.
EnvironmentMap::Interpolated EnvironmentMap::betweenTexels(int face_index, glm::vec2 position,
                                                           Interpolation interpolation) const {
  TexelRange all = kNoTexels;
  const auto fetch_texel = [&](int x, int y) {
    const glm::vec4 texel = fetch(face_index, x, y);
    if (texel.w > 0.0f) include(all, glm::vec3(texel));
    return texel;
  };
  const auto interpolatedAt = [&](glm::vec2 place) {
    return interpolation == Interpolation::bicubic ? bicubic(place, fetch_texel, rowBendAt(place.y))
                                                   : bilinear(keepingLightOfRows(place), fetch_texel);
  };
  glm::vec4 light = interpolatedAt(position);
  // On a rim all four neighbours may lie beside the disc: then the position moves inwards until one does not.
  while (light.w == 0.0f) {
    position += glm::normalize(glm::vec2(extent_) / 2.0f - position) * 0.5f;
    light = interpolatedAt(position);
  }
  return {glm::vec3(light), all};
}

/// A texel for `interpolate`: one that may lie beyond an edge or beside a disc.
glm::vec4 EnvironmentMap::fetch(int face_index, int x, int y) const {
  switch (projection_) {
    case Projection::equirect:
      return fetchEquirect(x, y);
    case Projection::octahedral:
    case Projection::equal_area:
      return fetchFolded(x, y);
    case Projection::cube:
    case Projection::eac:
    case Projection::paraboloid:
      return fetchTowards(face_index, x, y);
    default:
      return fetchCovered(face_index, x, y);
  }
}

/// Left and right edges meet; beyond a pole the row continues on the opposite meridian. Of one row, beyond both poles.
glm::vec4 EnvironmentMap::fetchEquirect(int x, int y) const {
  while (y < 0 || y >= extent_.y) {
    y = y < 0 ? -1 - y : 2 * extent_.y - 1 - y;
    x += extent_.x / 2;
  }
  x = (x % extent_.x + extent_.x) % extent_.x;
  return glm::vec4(rgbAt(face(0), x, y - rows_.begin), 1.0f);
}

/// Each edge of an unfolded octahedron is sewn to itself, turned about its middle; the corners are one point.
glm::vec4 EnvironmentMap::fetchFolded(int x, int y) const {
  const int side = size();
  if (x < 0 || x >= side) {
    x = x < 0 ? -1 - x : 2 * side - 1 - x;
    y = side - 1 - y;
  }
  if (y < 0 || y >= side) {
    y = y < 0 ? -1 - y : 2 * side - 1 - y;
    x = side - 1 - x;
  }
  // A cubic reaches over both edges of a map of one texel.
  return glm::vec4(rgbAt(face(0), std::clamp(x, 0, side - 1), std::clamp(y, 0, side - 1)), 1.0f);
}

/// A texel outside the image, or whose centre lies beside the disc, has no weight.
glm::vec4 EnvironmentMap::fetchCovered(int face_index, int x, int y) const {
  const Image& image = face(face_index);
  if (x < 0 || y < 0 || x >= image.width() || y >= image.height()) return glm::vec4(0.0f);
  if (has_disc_) {
    if (!formula::insideDisc(centerOf(x, y) / static_cast<float>(image.width()))) return glm::vec4(0.0f);
  }
  return glm::vec4(rgbAt(image, x, y), 1.0f);
}

/// Beyond its edge an image is continued by the projection's own formula, and another image answers for what lies in
/// that direction, from its own texels.
glm::vec4 EnvironmentMap::fetchTowards(int face_index, int x, int y) const {
  const glm::vec4 own = fetchCovered(face_index, x, y);
  if (own.w > 0.0f) return own;
  const auto side = static_cast<float>(size());
  const MapPosition place = positionOf(projection_, directionAt(projection_, {face_index, centerOf(x, y) / side}));
  const glm::vec4 light = bilinear(place.uv * side, [&](int i, int j) { return fetchCovered(place.face, i, j); });
  return glm::vec4(glm::vec3(light), light.w > 0.0f ? 1.0f : 0.0f);
}

/// Between the texels of one smooth region. Near its border there are stand-ins for texels among them, and where
/// contrast is high those do not keep the sum of a sun's light; the map's own texels do.
EnvironmentMap::Interpolated EnvironmentMap::cubicOnChart(const MapPosition& place, glm::vec2 position) const {
  const SmoothRegion region(projection_, size(), place);
  bool has_left_region = false;
  TexelRange all = kNoTexels;
  const auto fetch_texel = [&](int x, int y) {
    has_left_region = has_left_region || !region.holds(centerOf(x, y));
    const glm::vec4 texel = fetchInRegion(region, x, y);
    include(all, glm::vec3(texel));
    return texel;
  };
  const glm::vec3 cubic(bicubic(position, fetch_texel));
  const float share = has_left_region ? shareByContrast(all) : 1.0f;
  if (share == 1.0f) return {cubic, all};
  const glm::vec3 straight = betweenTexels(place.face, position, Interpolation::bilinear).radiance;
  return {glm::mix(straight, cubic, share), all};
}

/// A texel for `bicubic` as if the region went on beyond its border. There the region that shows the same direction
/// answers with a cubic through texels of its own, for across the border between them texels lie on a line with a kink.
glm::vec4 EnvironmentMap::fetchInRegion(const SmoothRegion& region, int x, int y) const {
  const glm::vec2 center = centerOf(x, y);
  if (region.holds(center)) return glm::vec4(rgbAt(face(region.face()), x, y), 1.0f);
  const auto side = static_cast<float>(size());
  const MapPosition place = region.placeOf(center);
  const glm::vec2 position = place.uv * side;
  if (const auto texels = SmoothRegion(projection_, size(), place).cubicStencil(position)) {
    const glm::vec3 straight = betweenTexels(place.face, position, Interpolation::bilinear).radiance;
    return glm::vec4(cubicThrough(place.face, *texels, straight), 1.0f);
  }
  return bilinear(position, [&](int i, int j) { return fetch(place.face, i, j); });
}

/// The polynomial of the third degree in two variables through ten texels (Lagrange's on the triangle's lattice). A
/// little beside them it holds too; since it swings there, it is kept within their range and from high contrast.
///
/// straight  the answer of bilinear interpolation
glm::vec3 EnvironmentMap::cubicThrough(int face_index, const CubicStencil& texels, glm::vec3 straight) const {
  const std::array<float, 4> across = risingProducts(texels.inside.x);
  const std::array<float, 4> down = risingProducts(texels.inside.y);
  const std::array<float, 4> rest = risingProducts(3.0f - texels.inside.x - texels.inside.y);
  glm::vec3 sum(0.0f);
  TexelRange all = kNoTexels;
  for (std::size_t j = 0; j <= 3; ++j)
    for (std::size_t i = 0; i + j <= 3; ++i) {
      const glm::ivec2 place = texels.first + texels.step * glm::ivec2(i, j);
      const glm::vec3 texel = rgbAt(face(face_index), place.x, place.y);
      sum += across[i] * down[j] * rest[3 - i - j] * texel;
      include(all, texel);
    }
  include(all, straight);
  TexelRange range = all;
  // Beyond the edge of one half there is nothing that light could come from: it goes on as it went among the texels.
  const bool is_beyond = projection_ == Projection::hemioctahedral && std::min(texels.inside.x, texels.inside.y) < 0.0f;
  if (is_beyond) {
    const glm::vec3 half = (all.max - all.min) / 2.0f;
    range = {glm::max(all.min - half, glm::min(all.min, 0.0f)), all.max + half};
  }
  return glm::clamp(straight + shareByContrast(all) * (sum - straight), range.min, range.max);
}

std::size_t raiseNegativeLight(Image& image) {
  std::size_t count = 0;
  const auto channels = static_cast<std::size_t>(image.channels());
  const std::size_t colors = std::min<std::size_t>(channels, 3);
  const std::span<float> samples = image.samples();
  for (std::size_t texel = 0; texel < samples.size(); texel += channels)
    for (float& sample : samples.subspan(texel, colors))
      if (sample < 0.0f) {
        sample = 0.0f;
        ++count;
      }
  return count;
}

std::size_t raiseNegativeLight(EnvironmentMap& map) {
  std::size_t count = 0;
  for (int index = 0; index < map.faces(); ++index) count += raiseNegativeLight(map.face(index));
  return count;
}

Result<ValueCounts> checkLight(EnvironmentMap& map, const Observer& observer) {
  ValueCounts counts;
  for (int face = 0; face < map.faces(); ++face) counts.add(map.face(face));
  if (counts.too_bright > 0)
    return fail(ErrorCode::out_of_range,
                countedAre(counts.too_bright, "value") + " above 1e36, too bright to be summed", FixHint::scale_light);
  if (const std::size_t negative = raiseNegativeLight(map); negative > 0)
    observer.tell(RemarkKind::negative_raised,
                  countedAre(negative, "value") + " negative, no light or a colour beyond Rec.709; taken as 0");
  return counts;
}

}  // namespace mirrorball
