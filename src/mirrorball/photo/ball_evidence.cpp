#include "mirrorball/photo/ball_evidence.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace mirrorball {
namespace {

/// What is seen in a ring around a circle's centre.
struct Ring {
  double visible = 0.0;  ///< how much of it lies in the picture
  double detail = 0.0;   ///< change of brightness over two texels, the mean
};

/// from, to   the ring's radii in those of the circle
Ring ringAround(const PlanePicture& picture, const Circle& circle, double from, double to, double pixel) {
  constexpr int kRadii = 8;
  constexpr int kPlaces = 96;
  int seen = 0;
  double change = 0.0;
  for (int place = 0; place < kPlaces; ++place) {
    const double angle = glm::two_pi<double>() * (place + 0.5) / kPlaces;
    const glm::dvec2 outwards(std::cos(angle), std::sin(angle));
    for (int i = 0; i < kRadii; ++i) {
      const double share = glm::mix(from, to, (i + 0.5) / kRadii);
      const glm::dvec2 position = circle.center_px + share * circle.radius_px * outwards;
      if (!picture.contains(position, 2.0 * pixel)) continue;
      const glm::dvec2 right(pixel, 0.0), down(0.0, pixel);
      change += std::hypot(picture.at(position + right) - picture.at(position - right),
                           picture.at(position + down) - picture.at(position - down));
      ++seen;
    }
  }
  return {double(seen) / (kRadii * kPlaces), change / std::max(seen, 1)};
}

}  // namespace

double ballLogOdds(const PlanePicture& picture, const Circle& circle, double share, double pixel) {
  constexpr double kMiddling_px = 30.0;
  constexpr double kLittle = 0.005;  // detail below it is noise
  const double size = std::log(circle.radius_px / pixel / kMiddling_px);
  const Ring inside = ringAround(picture, circle, 0.78, 0.96, pixel);
  const Ring outside = ringAround(picture, circle, 1.05, 1.25, pixel);
  // Around a ball that fills the picture too little is seen.
  const double contrast =
      outside.visible > 0.1 ? std::log((inside.detail + kLittle) / (outside.detail + kLittle)) : 0.0;
  return 6.5 * share + 4.5 * contrast + 1.1 * size - 6.5;
}

}  // namespace mirrorball
