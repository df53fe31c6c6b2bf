#include "mirrorball/photo/find_ball.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "formula/color.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/photo/ball_evidence.h"
#include "mirrorball/photo/rim_fit.h"
#include "mirrorball/photo/rim_votes.h"

namespace mirrorball {
namespace {

constexpr int kCoarseSide = 320;
constexpr double kMinShare = 0.4;
constexpr double kMinVisible = 0.4;
constexpr double kMinRadius_px = 8.0;
/// Below it no circle is named.
constexpr double kMinConfidence = 0.2;

/// Brightness as the eye grades it, in any exposure: the median becomes a middle grey, lights above it are compressed,
/// so that a lamp's edge is no stronger than a hundred times the rim's,
/// and what is nearly black does not show its noise.
Image greyOf(const Image& light) {
  Image grey(light.width(), light.height(), 1);
  std::vector<float> sorted;
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      *grey.texel(x, y) = std::max(0.0f, formula::luminance(rgbAt(light, x, y)));
      if ((x + y) % 7 == 0) sorted.push_back(*grey.texel(x, y));
    }
  const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  constexpr float kDark = 0.01f;
  const float scale = 0.25f / std::max(*middle, 1e-6f);
  for (float& sample : grey.samples()) sample = std::sqrt((sample * scale + kDark) / (1.0f + sample * scale));
  return grey;
}

/// Means of factor × factor pixels; a rest at the right and below is left out.
Image shrunk(const Image& grey, int factor) {
  Image small(std::max(1, grey.width() / factor), std::max(1, grey.height() / factor), 1);
  parallelFor(std::size_t(small.height()), 8, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y)
      for (int x = 0; x < small.width(); ++x) {
        float sum = 0.0f;
        for (int j = 0; j < factor; ++j)
          for (int i = 0; i < factor; ++i) sum += *grey.texel(x * factor + i, y * factor + j);
        *small.texel(x, y) = sum / static_cast<float>(factor * factor);
      }
  });
  return small;
}

/// The picture laid onto the pinhole camera's plane, at its own scale.
Image planeImage(const PlanePicture& picture, int width, int height, double scale) {
  Image plane(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      *plane.texel(x, y) = static_cast<float>(picture.at((glm::dvec2(x, y) + 0.5) * scale));
  return plane;
}

/// A circle that may be the ball's, fitted to the edges around it.
struct Candidate {
  Circle circle;
  double log_odds = 0.0;  ///< that it is, against there being no ball
};

double distanceBetween(const Circle& a, const Circle& b) {
  return std::max(glm::distance(a.center_px, b.center_px), std::abs(a.radius_px - b.radius_px));
}

/// Fits a circle to the edges around it; nothing where no rim is there. `pixel` is the size of the picture's texels.
std::optional<Candidate> fitCandidate(const PlanePicture& picture, const Circle& start, double pixel) {
  constexpr int kRays = 180;
  constexpr double kWeakest = 0.005;  // change of brightness a texel
  const double reach = std::max(3.0 * pixel, 0.12 * start.radius_px);
  const double tolerance = std::max(1.2 * pixel, 0.012 * start.radius_px);
  const double blur = std::max(0.8 * pixel, 0.006 * start.radius_px);
  Circle circle = start;
  // What is found at the end of the reach is looked for once more, from there.
  for (int round = 0; round < 2; ++round) {
    const Circle before = circle;
    const auto edges = edgesAcross(picture, before, kRays, reach, blur, kWeakest / pixel);
    circle = mostSupported(edges, before, kRays, reach, tolerance);
    circle = refineCircle(edges, circle, 2.0 * tolerance, tolerance);
    if (!std::isfinite(circle.radius_px)) return {};  // too few edges for a circle
    if (distanceBetween(circle, before) < 0.5 * reach) break;
  }
  if (!(circle.radius_px >= kMinRadius_px) || distanceBetween(circle, start) > 2.0 * reach) return {};
  // Along the fitted circle again: an edge counts only where it runs across the fitted circle's own radii.
  const auto across = edgesAcross(picture, circle, kRays, 2.0 * tolerance, blur, kWeakest / pixel);
  const RimSupport support = supportOf(picture, circle, across, kRays, tolerance);
  if (support.visible < kMinVisible) return {};
  return Candidate{circle, ballLogOdds(picture, circle, support.share, pixel)};
}

/// All candidates of the coarse picture, the likeliest first, each rim once.
std::vector<Candidate> findCandidates(const PlanePicture& picture, int width, int height, double pixel) {
  constexpr double kSame = 0.04;  // of the radius: circles nearer than that stand for the same rim
  const std::vector<Circle> votes = voteForCircles(planeImage(picture, width, height, pixel));
  std::vector<std::optional<Candidate>> fits(votes.size());
  parallelFor(votes.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      fits[i] = fitCandidate(picture, {votes[i].center_px * pixel, votes[i].radius_px * pixel}, pixel);
  });
  std::erase(fits, std::nullopt);
  sortDownBy(fits, [](const auto& fit) { return fit->log_odds; });
  std::vector<Candidate> candidates;
  for (const auto& fit : fits)
    if (std::none_of(candidates.begin(), candidates.end(), [&](const Candidate& better) {
          return distanceBetween(better.circle, fit->circle) < kSame * better.circle.radius_px;
        }))
      candidates.push_back(*fit);
  return candidates;
}

/// How likely the first is the ball, of all candidates and none.
double confidenceIn(const std::vector<Candidate>& candidates) {
  const double most = std::max(candidates.front().log_odds, 0.0);  // keeps the powers in range
  double sum = std::exp(-most);
  for (const Candidate& candidate : candidates) sum += std::exp(candidate.log_odds - most);
  return std::exp(candidates.front().log_odds - most) / sum;
}

struct Fit {
  Circle circle;
  RimSupport support;
};

/// Refines in the full picture, from a fit that is right within `within_px`, where the rim spreads over `blur` pixels.
Fit refined(const PlanePicture& picture, Circle circle, double within_px, double blur) {
  constexpr int kRays = 720;
  constexpr double kWeakest = 0.008;
  Fit fit;
  std::vector<EdgePoint> edges;
  for (const double reach : {within_px, std::max(within_px / 3.0, 3.0 * blur), 3.0 * blur}) {
    edges = edgesAcross(picture, circle, kRays, reach, blur, kWeakest / blur);
    if (reach == within_px) circle = mostSupported(edges, circle, kRays, reach, 1.5 * blur);
    circle = refineCircle(edges, circle, std::min(reach, 4.0 * blur), 1.2 * blur);
  }
  edges = correctedByFlanks(edges, circle, 1.2 * blur);
  circle = refineCircle(edges, circle, 2.0 * blur, 1.2 * blur);
  fit.circle = circle;
  fit.support = supportOf(picture, circle, edges, kRays, 1.5 * blur);
  return fit;
}

/// Refines with the least blur that shows the rim: the more, the more do the lines just inside draw it inwards.
Fit refined(const PlanePicture& picture, const Circle& start, double within_px) {
  // A rim is as sharp as the lens: in large pictures it spreads over several pixels.
  const double sharpest = std::clamp(start.radius_px / 400.0, 0.7, 3.0);
  Fit best;
  for (const double width : {1.0, 2.0, 3.5}) {
    const Fit fit = refined(picture, start, within_px, width * sharpest);
    if (fit.support.share > best.support.share) best = fit;
    if (best.support.share >= kMinShare) break;
  }
  return best;
}

/// The circle of the pinhole camera's plane that fits these positions of the picture best.
Circle planeCircle(const Pinhole& pinhole, const std::vector<glm::dvec2>& rim, const Circle& otherwise) {
  std::vector<glm::dvec2> plane;
  for (const glm::dvec2 position : rim) plane.push_back(pinhole.planeFromPicture(position));
  return fitCircle(plane, std::vector<double>(plane.size(), 1.0)).value_or(otherwise);
}

/// The focal length with which a rim at these positions belongs to a ball at that distance: the rim's half-angle is
/// asin(1 / distance). A fixed point, since the half-angle's tangent is nearly inverse to the focal length.
double focalForDistance(const std::vector<glm::dvec2>& rim, glm::dvec2 middle_px, double distance, double start_px) {
  const double wanted = std::tan(std::asin(1.0 / distance));
  double focal = start_px;
  for (int step = 0; step < 60; ++step) {
    const Pinhole pinhole{middle_px, focal};
    const double ratio = std::tan(BallView(pinhole, planeCircle(pinhole, rim, {})).blindHalfAngle_rad()) / wanted;
    focal *= ratio;
    if (std::abs(ratio - 1.0) < 1e-10) break;
  }
  return focal;
}

Pinhole pinholeFor(const Perspective& perspective, glm::dvec2 middle_px, const BallView& seen, double start_px) {
  if (perspective.distance == 0.0) return {middle_px, perspective.focal_px};
  return {middle_px, focalForDistance(seen.outline(64), middle_px, perspective.distance, start_px)};
}

/// A camera far from the ball, from which the search for the focal length starts.
double startingFocal(const Perspective& perspective, double radius_px) {
  return radius_px * std::sqrt(perspective.distance * perspective.distance - 1.0);
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

}  // namespace

double focalLengthFromFov(double fov_deg, int height) { return height / 2.0 / std::tan(glm::radians(fov_deg) / 2.0); }

Circle circleInPicture(const BallView& view) {
  return planeCircle(Pinhole{view.pinhole().middle_px, 0.0}, view.outline(64), view.rim());
}

Result<FoundBall> findBall(const Image& light, const Perspective& perspective) {
  const glm::dvec2 middle = glm::dvec2(light.width(), light.height()) / 2.0;
  const Image grey = greyOf(light);
  const int factor = std::max(1, std::max(light.width(), light.height()) / kCoarseSide);
  const Image coarse = shrunk(grey, factor);
  const Pinhole seen_through{middle, perspective.focal_px};
  Pinhole pinhole = seen_through;
  const auto candidates =
      findCandidates(PlanePicture(coarse, pinhole, factor), coarse.width(), coarse.height(), factor);
  const double confidence = candidates.empty() ? 0.0 : confidenceIn(candidates);
  if (confidence < kMinConfidence) return fail(ErrorCode::bad_shape, "no mirror ball is found", FixHint::give_circle);

  const Circle& likeliest = candidates.front().circle;
  Fit fit = refined(PlanePicture(grey, pinhole, 1.0), likeliest, std::max(2.5 * factor, 0.02 * likeliest.radius_px));
  // The focal length follows from the rim and the distance, and the rim's exact shape from the focal length.
  for (int round = 0; round < 3 && perspective.distance > 0.0; ++round) {
    const BallView seen(pinhole, fit.circle);
    pinhole =
        pinholeFor(perspective, middle, seen,
                   pinhole.isOrthographic() ? startingFocal(perspective, fit.circle.radius_px) : pinhole.focal_px);
    fit = refined(PlanePicture(grey, pinhole, 1.0), planeCircle(pinhole, seen.outline(64), fit.circle),
                  std::max(4.0, 0.03 * fit.circle.radius_px));
  }
  if (fit.support.share < kMinShare || fit.circle.radius_px < kMinRadius_px)
    return fail(ErrorCode::bad_shape,
                "the ball's rim is not sure (an edge along only " + percent(fit.support.share) + " of it)",
                FixHint::give_circle);
  FoundBall ball{
      BallView(pinhole, fit.circle), fit.support.share, fit.support.visible, fit.support.rms_px, confidence, {}};
  if (candidates.size() > 1) ball.rival = circleInPicture(BallView(seen_through, candidates[1].circle));
  return ball;
}

Result<FoundBall> ballOfCircle(const Circle& circle, glm::ivec2 size, const Perspective& perspective) {
  const glm::dvec2 nearest = glm::clamp(circle.center_px, glm::dvec2(0.0), glm::dvec2(size));
  if (!(circle.radius_px > 0.0) || glm::distance(nearest, circle.center_px) >= circle.radius_px)
    return fail(ErrorCode::usage, "a circle is the centre and the radius of a ball that is seen in the photograph of " +
                                      sizeText(size) + " pixels");
  const glm::dvec2 middle = glm::dvec2(size) / 2.0;
  const BallView seen(Pinhole{middle, 0.0}, circle);
  const Pinhole pinhole = pinholeFor(perspective, middle, seen, startingFocal(perspective, circle.radius_px));
  return FoundBall{BallView(pinhole, planeCircle(pinhole, seen.outline(64), circle))};
}

}  // namespace mirrorball
