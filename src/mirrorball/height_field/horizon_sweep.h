#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/height_field/height_field.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// What a texel sees in an azimuth.
struct HorizonSlice {
  glm::ivec2 texel;
  glm::vec2 away;  ///< unit: x right, y up
  float width;     ///< of the slice of the sky that it stands for [radians]
  float slope;     ///< of the horizon, at least 0
};

/// A way across the map: from a texel `across` ones along an axis and `aside` ones along the other is a texel again.
/// Lines take steps of one texel along the axis.
struct LineDirection {
  bool is_down;  ///< the axis is v's
  int across;    ///< above 0, without a factor in common with `aside`
  int aside;     ///< from −across to across
  float width;   ///< of the slice of the sky that it stands for [radians]
};

/// Half of the azimuths, the others being opposite: slopes of equal steps to each side of both axes.
std::vector<LineDirection> directionsOf(int azimuths);

/// Finds the horizons along one direction and against it.
class HorizonSweep {
 public:
  HorizonSweep(const Image& heights, const HeightFieldSettings& settings, const LineDirection& direction)
      : heights_(heights),
        edges_(settings.edges),
        direction_(direction),
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

  template <typename Visit>
  void alongLine(std::size_t index, Work& work, const Visit& visit) const {
    readLine(firstNumber() + static_cast<int>(index), work.line);
    work.hull.resize(work.line.size());
    sweep(work, 1, visit);
    sweep(work, -1, visit);
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
  void readLine(int number, std::vector<Place>& line) const;

  /// Goes along a line, forwards or backwards, with the upper hull of what it has passed in view.
  template <typename Visit>
  void sweep(Work& work, int step, const Visit& visit) const {
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
        const glm::ivec2 texel = direction_.is_down ? glm::ivec2(here.minor, major) : glm::ivec2(major, here.minor);
        visit(HorizonSlice{texel, -static_cast<float>(step) * along_, direction_.width, horizon});
      }
      hull[size++] = here;
    }
  }

  const Image& heights_;
  MapEdges edges_;
  LineDirection direction_;
  int length_;
  int width_;
  float rise_ = 0.0f;
  glm::vec2 along_{0.0f};
};

/// Visits every texel of a height field in each azimuth, over the horizon of what is around it. A texel of a tiled map
/// sees at least one tile to each side; beyond, and beyond clamped edges, the ground is even.
///
/// In each of some azimuths the map is swept along parallel lines that visit the texels' centres; a line keeps the
/// upper hull of what it has passed, whose tangent is the horizon. Heights are interpolated where a line crosses the
/// rows or columns of texels.
///
/// azimuths  8, 16, 32 or 64
/// visit     void(const HorizonSlice&), from several threads, but no texel from two at a time
/// errors    interrupted
/// cost      O(azimuths²) steps a texel, whatever the heights
/// from      Timonen and Westerholm 2010, "Scalable height field self-shadowing"
template <typename Visit>
Result<void> sweepHorizons(const Image& heights, const HeightFieldSettings& settings, int azimuths,
                           const ProgressFunction& progress, const Visit& visit) {
  constexpr std::size_t kLinesPerPiece = 64;
  std::vector<HorizonSweep> sweeps;
  std::size_t lines = 0;
  for (const LineDirection& direction : directionsOf(azimuths)) {
    sweeps.emplace_back(heights, settings, direction);
    lines += sweeps.back().lineCount();
  }
  ProgressCounter counter(progress, lines);
  for (const HorizonSweep& sweep : sweeps)
    parallelFor(sweep.lineCount(), kLinesPerPiece, [&](std::size_t begin, std::size_t end) {
      if (counter.stopped()) return;
      HorizonSweep::Work work;
      for (std::size_t line = begin; line < end; ++line) sweep.alongLine(line, work, visit);
      counter.advance(end - begin);
    });
  return counter.result();
}

}  // namespace mirrorball
