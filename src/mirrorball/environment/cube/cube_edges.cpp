#include "mirrorball/environment/cube/cube_edges.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "formula/color.h"

namespace mirrorball {
namespace {

/// A cube whose faces are read as images of an arrangement.
class ArrangedCube {
 public:
  ArrangedCube(const EnvironmentMap& cube, const CubeArrangement& arrangement) : cube_(cube) {
    for (int slot = 0; slot < 6; ++slot) {
      const FaceFrame& frame = arrangement.slots[static_cast<std::size_t>(slot)];
      const auto face = static_cast<std::size_t>(frame.centre);
      slot_of_[face] = slot;
      from_image_[face] = faceFromImage(frame);
    }
  }

  int side() const { return cube_.size(); }

  float lightAt(int face, glm::ivec2 texel) const {
    const glm::ivec2 from = from_image_[static_cast<std::size_t>(face)].from(texel, side());
    const Image& image = cube_.face(slot_of_[static_cast<std::size_t>(face)]);
    return std::max(formula::luminance(rgbAt(image, from.x, from.y)), 0.0f);
  }

  /// The light of the texel that another face has in the direction where this one, continued, would have `texel`.
  float lightBeyond(int face, glm::ivec2 texel) const {
    const auto extent = static_cast<float>(side());
    const glm::vec2 uv = (glm::vec2(texel) + 0.5f) / extent;
    const MapPosition place = positionOf(cube_.projection(), directionAt(cube_.projection(), {face, uv}));
    return lightAt(place.face, glm::clamp(glm::ivec2(place.uv * extent), 0, side() - 1));
  }

 private:
  const EnvironmentMap& cube_;
  FaceOrder slot_of_{};
  std::array<SquareSymmetry, 6> from_image_;
};

float difference(float a, float b) { return a + b > 0.0f ? std::abs(a - b) / (a + b) : 0.0f; }

/// The texel at an edge, `along` texels from its beginning.
glm::ivec2 borderTexel(glm::ivec2 outward, int along, int side) {
  const auto across = [&](int way) { return way > 0 ? side - 1 : 0; };
  return outward.x != 0 ? glm::ivec2(across(outward.x), along) : glm::ivec2(along, across(outward.y));
}

}  // namespace

bool EdgeFit::isClearlyBetterThan(const EdgeFit& other) const {
  constexpr double kMinGain = 0.01;  // a mean over the stretches that differ
  constexpr double kMinDeviations = 4.0;
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (std::size_t stretch = 0; stretch < kStretches; ++stretch) {
    const double gain = double(other.stretches[stretch]) - double(stretches[stretch]);
    if (gain == 0.0) continue;
    sum += gain;
    squares += gain * gain;
    ++count;
  }
  // Were the gains of either sign by chance, their sum would have the standard deviation √Σ gain².
  return count > 0 && sum > kMinGain * count && sum > kMinDeviations * std::sqrt(squares);
}

EdgeFit edgeFit(const EnvironmentMap& cube, const CubeArrangement& arrangement) {
  assert(cube.faces() == 6 && isComplete(arrangement));
  constexpr int kPlaces = 128;  // along an edge
  constexpr int kStretchesOfEdge = 8;
  const ArrangedCube faces(cube, arrangement);
  const int side = faces.side();
  if (side < kStretchesOfEdge) return {};
  constexpr std::array<glm::ivec2, 4> kOutwards{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  EdgeFit fit;
  double across = 0.0;
  double beside = 0.0;
  std::size_t stretch = 0;
  for (int face = 0; face < 6; ++face)
    for (const glm::ivec2 outward : kOutwards)
      for (int part = 0; part < kStretchesOfEdge; ++part, ++stretch) {
        const int begin = part * side / kStretchesOfEdge;
        const int end = (part + 1) * side / kStretchesOfEdge;
        const int step = std::max(1, side / kPlaces);
        const int count = (end - begin + step - 1) / step;
        for (int along = begin; along < end; along += step) {
          const glm::ivec2 border = borderTexel(outward, along, side);
          const float light = faces.lightAt(face, border);
          fit.stretches[stretch] += difference(light, faces.lightBeyond(face, border + outward)) / float(count);
          beside += double(difference(light, faces.lightAt(face, border - outward))) / count;
        }
        across += double(fit.stretches[stretch]);
      }
  fit.across = float(across / EdgeFit::kStretches);
  fit.beside = float(beside / EdgeFit::kStretches);
  return fit;
}

}  // namespace mirrorball
