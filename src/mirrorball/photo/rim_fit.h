#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mirrorball/image/image.h"
#include "mirrorball/photo/pinhole.h"

namespace mirrorball {

/// The brightness of a picture as the eye grades it, 0 … 1, with a pinhole that lays it onto the plane.
class PlanePicture {
 public:
  PlanePicture(Image grey, const Pinhole& pinhole, double scale)
      : grey_(std::move(grey)), pinhole_(pinhole), scale_(scale) {}

  /// The brightness at a position of the plane; positions beyond the border take its nearest pixel.
  double at(glm::dvec2 plane_px) const;

  /// Whether a position of the plane lies at least `margin_px` inside the picture.
  bool contains(glm::dvec2 plane_px, double margin_px) const;

 private:
  Image grey_;  // one channel, `scale_` of the photograph's pixels a texel
  Pinhole pinhole_;
  double scale_;
};

/// A place on a radius of a rim where the brightness changes most.
struct EdgePoint {
  glm::dvec2 plane_px;
  int ray = 0;                 ///< which radius it lies on
  double strength = 0.0;       ///< the change of brightness a pixel
  double to_half_px = 0.0;     ///< how far outwards that change has fallen to a half; NaN: another edge comes first
  double to_quarter_px = 0.0;  ///< and to a quarter
};

/// Looks along the radii of a circle for edges that run across them.
///
/// rays       how many radii, spread evenly
/// reach_px   how far inside and outside the circle
/// blur_px    width of the Gaussian whose derivative finds the edges
/// weakest    the least change of brightness a pixel
/// returns    at most four a radius, the strongest; found between samples by a parabola
std::vector<EdgePoint> edgesAcross(const PlanePicture& picture, const Circle& circle, int rays, double reach_px,
                                   double blur_px, double weakest);

/// The circle through three points; nothing when they lie on a line.
std::optional<Circle> circleThrough(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c);

/// The circle with the least sum of weighted squares of distances; nothing for fewer than three points.
///
/// weights  one a point
/// from     Kåsa 1976 for the start (linear, but biased where only an arc is seen), then Gauss-Newton
std::optional<Circle> fitCircle(std::span<const glm::dvec2> points, std::span<const double> weights);

/// How well a circle is supported by edges.
struct RimSupport {
  double share = 0.0;    ///< of the radii that lie in the picture, how many have an edge within the tolerance
  double visible = 0.0;  ///< how much of the rim lies in the picture
  double rms_px = 0.0;   ///< of those edges' distances
};
RimSupport supportOf(const PlanePicture& picture, const Circle& circle, std::span<const EdgePoint> edges, int rays,
                     double tolerance_px);

/// The circle near which most radii have an edge and few have one outside: a mirror ball squeezes its surroundings into
/// lines that run along its rim, inside of it and nowhere else, and some of them look more like a rim than the rim
/// itself. An edge outside counts half against what one radius with an edge at the rim counts for. Circles through
/// three edges each are tried, in a fixed order.
Circle mostSupported(std::span<const EdgePoint> edges, const Circle& start, int rays, double reach_px,
                     double tolerance_px);

/// Moves edges to where their outer flanks say that they are. The lines just inside a mirror ball's rim melt together
/// with it in the picture and draw the peak inwards, but hardly change its outer flank. There the peak is a Gaussian
/// whose width, that of the picture's own blur, is the median over the edges near the circle.
std::vector<EdgePoint> correctedByFlanks(std::span<const EdgePoint> edges, const Circle& circle, double tolerance_px);

/// Least squares with Tukey's weights over the edges near a circle, repeated while the tolerance shrinks. Of each
/// radius the outermost edge within the tolerance counts: just inside a mirror ball's rim its surroundings are squeezed
/// into lines that run along the rim, outside of it nothing does.
Circle refineCircle(std::span<const EdgePoint> edges, Circle circle, double first_px, double last_px);

}  // namespace mirrorball
