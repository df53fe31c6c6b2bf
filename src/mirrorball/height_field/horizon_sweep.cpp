#include "mirrorball/height_field/horizon_sweep.h"

#include <cassert>
#include <cstdlib>
#include <numeric>

namespace mirrorball {

std::vector<LineDirection> directionsOf(int azimuths) {
  assert(azimuths == 8 || azimuths == 16 || azimuths == 32 || azimuths == 64);
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

void HorizonSweep::readLine(int number, std::vector<Place>& line) const {
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

}  // namespace mirrorball
