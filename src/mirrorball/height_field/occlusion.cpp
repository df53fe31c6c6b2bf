#include "mirrorball/height_field/occlusion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "formula/relief.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

constexpr std::size_t kLinesPerPiece = 64;

/// A way across the map: from a texel `across` ones along an axis and `aside` ones along the other is a texel again.
/// Lines take steps of one texel along the axis.
struct LineDirection {
  bool is_down;  ///< the axis is v's
  int across;    ///< above 0, without a factor in common with `aside`
  int aside;     ///< from −across to across
  float width;   ///< of the slice of the sky that it stands for [radians]
};

/// Half of the azimuths, the others being opposite: slopes of equal steps to each side of both axes.
std::vector<LineDirection> directionsOf(int azimuths) {
  const int steps = azimuths / 8;
  const auto angle = [steps](int step) { return std::atan2(double(step), double(steps)); };
  std::vector<LineDirection> directions;
  for (const bool is_down : {false, true})
    for (int step = is_down ? 1 - steps : -steps; step <= (is_down ? steps - 1 : steps); ++step) {
      // Beyond a diagonal the steps begin anew from the other axis, in a mirror.
      const double width =
          std::abs(step) == steps ? angle(steps) - angle(steps - 1) : 0.5 * (angle(step + 1) - angle(step - 1));
      const int factor = std::gcd(steps, std::abs(step));
      directions.push_back({is_down, steps / factor, step / factor, static_cast<float>(width)});
    }
  return directions;
}

/// One direction's sweeps: finds horizons, adds up what texels see below them.
class Sweep {
 public:
  Sweep(const Image& heights, const HeightFieldSettings& settings, const LineDirection& direction, const Image& normals,
        Occlusion& sum)
      : heights_(heights),
        edges_(settings.edges),
        direction_(direction),
        normals_(normals),
        sum_(sum),
        length_(direction.is_down ? heights.height() : heights.width()),
        width_(direction.is_down ? heights.width() : heights.height()) {
    const float aside = static_cast<float>(direction.aside) / static_cast<float>(direction.across);
    const float step = std::sqrt(1.0f + aside * aside);
    // Heights are in texels from here on, and so per step of this length they are slopes.
    rise_ = settings.scale * static_cast<float>(heights.width()) / step;
    along_ = (direction.is_down ? glm::vec2(aside, -1.0f) : glm::vec2(1.0f, -aside)) / step;
  }

  /// How many lines go through the texels. A line's number is across · minor − aside · major, for the places (major,
  /// minor) that it visits; tiled, numbers come round.
  std::size_t lineCount() const {
    const int beside = edges_ == MapEdges::tiled ? 0 : std::abs(direction_.aside) * (length_ - 1);
    return std::size_t(direction_.across) * std::size_t(width_) + std::size_t(beside);
  }

  /// A place that a line visits.
  struct Place {
    float along;   ///< steps along the line, from the map's first texel
    float height;  ///< in texels, over the length of a step
    int minor;     ///< of the texel whose centre it is, else −1
  };
  /// What a thread needs.
  struct Work {
    std::vector<Place> line;
    std::vector<Place> hull;
  };

  void alongLine(std::size_t index, Work& work) const {
    readLine(firstNumber() + static_cast<int>(index), work.line);
    work.hull.resize(work.line.size());
    sweep(work, 1);
    sweep(work, -1);
  }

 private:
  int firstNumber() const {
    return edges_ == MapEdges::tiled || direction_.aside < 0 ? 0 : -direction_.aside * (length_ - 1);
  }
  float heightAt(int major, int minor) const {
    return direction_.is_down ? heights_.texel(minor, major)[0] : heights_.texel(major, minor)[0];
  }

  /// Of a clamped map what lies within it, of a tiled one a tile to each side too. How far a line is aside is counted
  /// in shares of `across`; from a place to the next it is not more than a texel.
  void readLine(int number, std::vector<Place>& line) const {
    const bool is_tiled = edges_ == MapEdges::tiled;
    const int across = direction_.across;
    const int round = across * width_;
    const int beside = is_tiled ? length_ : 0;
    int shares = number - direction_.aside * beside;
    if (is_tiled) shares = (shares % round + round) % round;
    line.clear();
    for (int place = -beside; place < length_ + beside; ++place, shares += direction_.aside) {
      if (is_tiled && (shares < 0 || shares >= round)) shares += shares < 0 ? round : -round;
      if (!is_tiled && (shares < 0 || shares > round - across)) continue;
      const int major = texelBeyond(place, length_, edges_);
      const auto minor = static_cast<int>(static_cast<unsigned>(shares) / static_cast<unsigned>(across));
      const int part = shares - minor * across;
      float height = heightAt(major, minor);
      if (part != 0) {
        const float next = heightAt(major, texelBeyond(minor + 1, width_, edges_));
        height += static_cast<float>(part) / static_cast<float>(across) * (next - height);
      }
      line.push_back({static_cast<float>(place), rise_ * height, part == 0 ? minor : -1});
    }
  }

  /// Goes along a line, forwards or backwards, with the upper hull of what it has passed in view.
  void sweep(Work& work, int step) const {
    const auto count = static_cast<int>(work.line.size());
    Place* hull = work.hull.data();
    int size = 0;
    for (int i = 0; i < count; ++i) {
      const Place here = work.line[std::size_t(step > 0 ? i : count - 1 - i)];
      const int major = static_cast<int>(here.along);
      if (step > 0 ? major >= length_ : major < 0) return;
      const auto rise = [&here](const Place& other) { return other.height - here.height; };
      const auto distance = [&here, step](const Place& other) { return float(step) * (here.along - other.along); };
      const auto isHidden = [&](const Place& near, const Place& far) {
        return rise(near) * distance(far) <= rise(far) * distance(near);
      };
      while (size > 1 && isHidden(hull[size - 1], hull[size - 2])) --size;
      if (here.minor >= 0 && major >= 0 && major < length_) {
        const float horizon = size == 0 ? 0.0f : std::max(rise(hull[size - 1]) / distance(hull[size - 1]), 0.0f);
        add(major, here.minor, horizon, -static_cast<float>(step));
      }
      hull[size++] = here;
    }
  }

  /// Adds what a texel sees above a horizon.
  void add(int major, int minor, float horizon, float side) const {
    const int x = direction_.is_down ? minor : major;
    const int y = direction_.is_down ? major : minor;
    const float* normal = normals_.texel(x, y);
    const glm::vec2 away = side * along_;
    const glm::vec3 seen =
        direction_.width * formula::visibleSlice(normal[0] * away.x + normal[1] * away.y, normal[2], horizon);
    float* mean = sum_.bent_normals.texel(x, y);
    mean[0] += seen.x * away.x;
    mean[1] += seen.x * away.y;
    mean[2] += seen.y;
    sum_.visible.texel(x, y)[0] += seen.z;
  }

  const Image& heights_;
  MapEdges edges_;
  LineDirection direction_;
  const Image& normals_;
  Occlusion& sum_;
  int length_;
  int width_;
  float rise_ = 0.0f;
  glm::vec2 along_{0.0f};
};

/// Sums become a share and a direction. Rounding may take a share a little beyond 1; a texel that sees nothing keeps
/// its normal.
void finish(const Image& normals, Occlusion& sum) {
  constexpr std::size_t kTexelsPerPiece = 1 << 14;
  parallelFor(sum.visible.texelCount(), kTexelsPerPiece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float& visible = sum.visible.samples()[i];
      visible = std::clamp(visible / std::numbers::pi_v<float>, 0.0f, 1.0f);
      float* mean = &sum.bent_normals.samples()[3 * i];
      const float length = std::sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
      for (std::size_t c = 0; c < 3; ++c) mean[c] = length > 1e-12f ? mean[c] / length : normals.samples()[3 * i + c];
    }
  });
}

}  // namespace

Result<Occlusion> occlusionOf(const Image& heights, const HeightFieldSettings& settings, int azimuths,
                              const ProgressFunction& progress) {
  assert(azimuths == 8 || azimuths == 16 || azimuths == 32 || azimuths == 64);
  MIRRORBALL_TRY(normals, normalsFromHeights(heights, settings));
  MIRRORBALL_TRY_VOID(checkRange(heights));
  constexpr std::uint64_t kFloatsPerTexel = 7;
  MIRRORBALL_TRY_VOID(checkMemory(heights.texelCount() * kFloatsPerTexel * sizeof(float)));
  Occlusion sum{Image(heights.width(), heights.height(), 1), Image(heights.width(), heights.height(), 3)};
  const std::vector<LineDirection> directions = directionsOf(azimuths);
  std::vector<Sweep> sweeps;
  std::size_t lines = 0;
  for (const LineDirection& direction : directions) {
    sweeps.emplace_back(heights, settings, direction, normals, sum);
    lines += sweeps.back().lineCount();
  }
  ProgressCounter counter(progress, lines);
  for (const Sweep& sweep : sweeps)
    parallelFor(sweep.lineCount(), kLinesPerPiece, [&](std::size_t begin, std::size_t end) {
      if (counter.stopped()) return;
      Sweep::Work work;
      for (std::size_t line = begin; line < end; ++line) sweep.alongLine(line, work);
      counter.advance(end - begin);
    });
  MIRRORBALL_TRY_VOID(counter.result());
  finish(normals, sum);
  return sum;
}

}  // namespace mirrorball
