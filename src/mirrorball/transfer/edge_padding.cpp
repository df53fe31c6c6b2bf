#include "mirrorball/transfer/edge_padding.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace mirrorball {
namespace {

constexpr std::array<glm::ivec2, 8> kNeighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

/// Grows what is known by a ring of neighbours at a time.
class RingGrowth {
 public:
  explicit RingGrowth(EdgePadding& padding) : padding_(padding) {
    for (std::uint32_t texel = 0; texel < padding_.source.size(); ++texel)
      if (padding_.source[texel] != EdgePadding::kNothing) ring_.push_back(texel);
  }

  /// returns  whether there was anything to do
  bool grow() {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t texel : ring_)
      forEachNeighbour(texel, [&](std::uint32_t beside) {
        if (padding_.source[beside] != EdgePadding::kNothing) return;
        // Marked by any, so that it comes once; which is nearest is asked when all of the ring before is known.
        padding_.source[beside] = padding_.source[texel];
        next.push_back(beside);
      });
    for (const std::uint32_t texel : next) takeNearest(texel);
    ring_ = std::move(next);
    return !ring_.empty();
  }

 private:
  glm::ivec2 placeOf(std::uint32_t texel) const {
    const auto width = static_cast<std::uint32_t>(padding_.size.x);
    return {int(texel % width), int(texel / width)};
  }

  template <typename Visit>
  void forEachNeighbour(std::uint32_t texel, const Visit& visit) const {
    const glm::ivec2 place = placeOf(texel);
    for (const glm::ivec2 step : kNeighbours) {
      const glm::ivec2 beside = place + step;
      if (beside.x < 0 || beside.y < 0 || beside.x >= padding_.size.x || beside.y >= padding_.size.y) continue;
      visit(static_cast<std::uint32_t>(beside.y * padding_.size.x + beside.x));
    }
  }

  long squaredDistance(std::uint32_t texel, std::uint32_t source) const {
    const glm::ivec2 step = placeOf(texel) - placeOf(source);
    return long(step.x) * step.x + long(step.y) * step.y;
  }

  void takeNearest(std::uint32_t texel) {
    std::uint32_t& nearest = padding_.source[texel];
    forEachNeighbour(texel, [&](std::uint32_t beside) {
      const std::uint32_t source = padding_.source[beside];
      if (source != EdgePadding::kNothing && squaredDistance(texel, source) < squaredDistance(texel, nearest))
        nearest = source;
    });
  }

  EdgePadding& padding_;
  std::vector<std::uint32_t> ring_;
};

}  // namespace

EdgePadding edgePadding(const std::vector<bool>& has_value, glm::ivec2 size, int reach) {
  assert(has_value.size() == std::size_t(size.x) * std::size_t(size.y));
  EdgePadding padding{size, std::vector<std::uint32_t>(has_value.size(), EdgePadding::kNothing)};
  for (std::uint32_t texel = 0; texel < has_value.size(); ++texel)
    if (has_value[texel]) padding.source[texel] = texel;
  RingGrowth growth(padding);
  for (int ring = 0; ring < reach && growth.grow(); ++ring) {
  }
  return padding;
}

void pad(Image& map, const EdgePadding& padding) {
  const auto channels = std::size_t(map.channels());
  for (std::size_t texel = 0; texel < padding.source.size(); ++texel)
    if (padding.isPadded(texel))
      std::copy_n(map.samples().data() + padding.source[texel] * channels, channels,
                  map.samples().data() + texel * channels);
}

}  // namespace mirrorball
