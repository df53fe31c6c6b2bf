#include "mirrorball/height_field/heights_from_normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "formula/relief.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/map_transform.h"

namespace mirrorball {
namespace {

constexpr std::size_t kRowsPerTransform = 32;
constexpr std::size_t kColumnsPerPiece = 16;  // a line of the cache

/// errors   non_finite; out_of_range
Result<void> checkNormals(const Image& normals) {
  assert(!normals.empty() && normals.channels() >= 3);
  if (const NonFinite bad = findNonFinite(normals); bad.count > 0) return fail(ErrorCode::non_finite, textOf(bad));
  const std::size_t channels = std::size_t(normals.channels());
  const std::size_t count = normals.texelCount();
  const float* samples = normals.samples().data();
  for (std::size_t i = 0; i < count; ++i)
    if (!(samples[channels * i + 2] > 0.0f))
      return fail(ErrorCode::out_of_range,
                  "the normal at (" + std::to_string(i % std::size_t(normals.width())) + ", " +
                      std::to_string(i / std::size_t(normals.width())) +
                      ") does not point out of the surface; its third component should be above 0");
  return {};
}

/// Some rows of slopes, with one row before and one behind them and a texel at either end. What is beyond clamped edges
/// follows from the mirrored heights: differences across the mirror turn their sign (those between a texel and itself
/// are 0), the others are mirrored too.
class PaddedSlopes {
 public:
  PaddedSlopes(const Image& normals, const HeightFieldSettings& settings, int begin, int end)
      : normals_(normals),
        difference_(settings.difference),
        edges_(settings.edges),
        stride_(std::size_t(normals.width()) + 2),
        begin_(begin),
        p_(stride_ * std::size_t(end - begin + 2)),
        q_(p_.size()) {
    for (int y = begin - 1; y <= end; ++y) read(y);
  }

  /// The slope along u or along v of texel 0 in row y; −1 and the width may be asked for too.
  const float* p(int y) const { return p_.data() + rowAt(y); }
  const float* q(int y) const { return q_.data() + rowAt(y); }

 private:
  std::size_t rowAt(int y) const { return std::size_t(y - begin_ + 1) * stride_ + 1; }
  bool isAcrossTwo() const {
    return difference_ == HeightDifference::central || difference_ == HeightDifference::sobel;
  }
  /// Whether a place has no difference with clamped edges, since one of its two texels is the other.
  bool isBetweenSame(int place, int length) const {
    if (edges_ == MapEdges::tiled || isAcrossTwo()) return false;
    return place == (difference_ == HeightDifference::backward ? 0 : length - 1) || place < 0 || place >= length;
  }

  void read(int y) {
    const int width = normals_.width();
    const int height = normals_.height();
    const int channels = normals_.channels();
    const float* from = normals_.row(texelBeyond(y, height, edges_)).data();
    float* to_p = p_.data() + rowAt(y);
    float* to_q = q_.data() + rowAt(y);
    const bool is_beyond = y < 0 || y >= height;
    const float sign = isBetweenSame(y, height) ? 0.0f : is_beyond && edges_ == MapEdges::clamped ? -1.0f : 1.0f;
    for (int x = 0; x < width; ++x, from += channels) {
      const glm::vec2 slope = formula::slopeFromNormal(glm::vec3(from[0], from[1], from[2]));
      to_p[x] = slope.x;
      to_q[x] = sign * slope.y;
    }
    const float first = to_p[0];
    const float last = to_p[width - 1];
    to_p[-1] = edges_ == MapEdges::tiled ? last : -first;
    to_p[width] = edges_ == MapEdges::tiled ? first : -last;
    to_q[-1] = to_q[texelBeyond(-1, width, edges_)];
    to_q[width] = to_q[texelBeyond(width, width, edges_)];
    for (const int x : {-1, 0, width - 1, width})
      if (isBetweenSame(x, width)) to_p[x] = 0.0f;
  }

  const Image& normals_;
  HeightDifference difference_;
  MapEdges edges_;
  std::size_t stride_;
  int begin_;
  std::vector<float> p_;
  std::vector<float> q_;
};

/// D_uᵀ p + D_vᵀ q of a row, where D are heightDifference's (formula/relief/slope.glsl) and ᵀ swaps the places that a
/// weight reads from and writes to.
void sumUp(const PaddedSlopes& slopes, HeightDifference difference, int y, int width, float* to) {
  const float* p = slopes.p(y);
  const float* q = slopes.q(y);
  const float* p_above = slopes.p(y - 1);
  const float* p_below = slopes.p(y + 1);
  const float* q_above = slopes.q(y - 1);
  const float* q_below = slopes.q(y + 1);
  switch (difference) {
    case HeightDifference::backward:
      for (int x = 0; x < width; ++x) to[x] = p[x] - p[x + 1] + (q[x] - q_below[x]);
      return;
    case HeightDifference::forward:
      for (int x = 0; x < width; ++x) to[x] = p[x - 1] - p[x] + (q_above[x] - q[x]);
      return;
    case HeightDifference::central:
      for (int x = 0; x < width; ++x) to[x] = 0.5f * (p[x - 1] - p[x + 1]) + 0.5f * (q_above[x] - q_below[x]);
      return;
    case HeightDifference::sobel:
      for (int x = 0; x < width; ++x) {
        const float left = p_above[x - 1] + 2.0f * p[x - 1] + p_below[x - 1];
        const float right = p_above[x + 1] + 2.0f * p[x + 1] + p_below[x + 1];
        const float above = q_above[x - 1] + 2.0f * q_above[x] + q_above[x + 1];
        const float below = q_below[x - 1] + 2.0f * q_below[x] + q_below[x + 1];
        to[x] = 0.125f * (left - right) + 0.125f * (above - below);
      }
      return;
  }
}

/// What DᵀD does to the basis functions of one axis: how much of them differences leave, and what smoothing across
/// does; and what differences of neighbours leave, which see every wave.
struct AxisEnergies {
  std::vector<double> difference;
  std::vector<double> smoothing;
  std::vector<double> of_neighbours;

  AxisEnergies(const MapTransform& transform, int length, HeightDifference kind) {
    for (int k = 0; k < length; ++k) {
      const double angle = transform.angle(k);
      const bool is_across_two = kind == HeightDifference::central || kind == HeightDifference::sobel;
      of_neighbours.push_back(std::pow(2.0 * std::sin(0.5 * angle), 2));
      difference.push_back(is_across_two ? std::pow(std::sin(angle), 2) : of_neighbours.back());
      smoothing.push_back(kind == HeightDifference::sobel ? std::pow(std::cos(0.5 * angle), 4) : 1.0);
    }
  }
};

/// By what a wave is divided. Of waves of nearly two texels central differences see next to nothing, and rounding would
/// become waves: what they do not see counts a little against a wave.
///
/// returns  0 for a wave that is not seen at all
double divisorOf(const AxisEnergies& across, std::size_t x, const AxisEnergies& down, std::size_t y) {
  constexpr double kNone = 1e-12;
  constexpr double kUnseenWeight = 1e-5;
  const double seen = across.difference[x] * down.smoothing[y] + down.difference[y] * across.smoothing[x];
  const double all = across.of_neighbours[x] + down.of_neighbours[y];
  return seen > kNone ? seen + kUnseenWeight * (all - seen) : 0.0;
}

/// Transforms rows of a map, or back, two at a time.
template <typename Transform>
void forEachPairOfRows(Image& map, ProgressCounter& counter, const Transform& transformTwo, const MapTransform& rows) {
  const auto height = std::size_t(map.height());
  parallelFor(height, kRowsPerTransform, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    MapTransform::Work work = rows.makeWork();
    std::vector<float> none(std::size_t(map.width()));
    for (std::size_t y = begin; y < end; y += 2)
      transformTwo(map.row(int(y)).data(), y + 1 < end ? map.row(int(y + 1)).data() : none.data(), work);
    counter.advance(end - begin);
  });
}

/// Transforms the columns of a map whose rows are transformed, divides, and transforms the columns back.
void divideByEnergies(Image& map, const HeightFieldSettings& settings, const MapTransform& rows,
                      ProgressCounter& counter) {
  const int width = map.width();
  const auto height = std::size_t(map.height());
  const MapTransform columns(map.height(), settings.edges);
  const AxisEnergies across(rows, width, settings.difference);
  const AxisEnergies down(columns, map.height(), settings.difference);
  const double per_height = 1.0 / (double(settings.scale) * width);
  parallelFor(std::size_t(width), kColumnsPerPiece, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    MapTransform::Work work = columns.makeWork();
    const std::size_t count = end - begin;
    std::vector<float> block((count + count % 2) * height);
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t i = 0; i < count; ++i) block[i * height + y] = map.texel(int(begin + i), int(y))[0];
    for (std::size_t i = 0; i < count; i += 2) {
      float* first = &block[i * height];
      float* second = first + height;
      columns.forward(first, second, work);
      for (std::size_t x = begin + i; x < std::min(begin + i + 2, end); ++x)
        for (std::size_t y = 0; y < height; ++y) {
          const double divisor = divisorOf(across, x, down, y);
          float& value = block[(x - begin) * height + y];
          value = divisor > 0.0 ? static_cast<float>(double(value) * (per_height / divisor)) : 0.0f;
        }
      columns.inverse(first, second, work);
    }
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t i = 0; i < count; ++i) map.texel(int(begin + i), int(y))[0] = block[i * height + y];
    counter.advance(count);
  });
}

}  // namespace

Result<Image> heightsFromNormals(const Image& normals, const HeightFieldSettings& settings,
                                 const ProgressFunction& progress) {
  if (settings.scale == 0.0f)
    return fail(ErrorCode::bad_shape, "a scale of 0 makes every height flat; the heights of normals need another");
  MIRRORBALL_TRY_VOID(checkNormals(normals));
  const int width = normals.width();
  const int height = normals.height();
  MIRRORBALL_TRY_VOID(checkImageMemory(width, height, 1));
  Image map = Image::withoutValues(width, height, 1);
  ProgressCounter counter(progress, 3 * std::size_t(height) + std::size_t(width));
  parallelFor(std::size_t(height), kRowsPerTransform, [&](std::size_t begin, std::size_t end) {
    if (counter.stopped()) return;
    const PaddedSlopes slopes(normals, settings, int(begin), int(end));
    for (int y = int(begin); y < int(end); ++y) sumUp(slopes, settings.difference, y, width, map.row(y).data());
    counter.advance(end - begin);
  });
  const MapTransform rows(width, settings.edges);
  const auto forward = [&](float* a, float* b, MapTransform::Work& work) { rows.forward(a, b, work); };
  const auto inverse = [&](float* a, float* b, MapTransform::Work& work) { rows.inverse(a, b, work); };
  forEachPairOfRows(map, counter, forward, rows);
  divideByEnergies(map, settings, rows, counter);
  forEachPairOfRows(map, counter, inverse, rows);
  MIRRORBALL_TRY_VOID(counter.result());
  return map;
}

}  // namespace mirrorball
