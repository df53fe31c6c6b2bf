#pragma once

#include <optional>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/photo/ball_view.h"

namespace mirrorball {

/// What is known about the camera: at most one of the two. With neither, rays are parallel.
struct Perspective {
  double distance = 0.0;  ///< from the camera to the ball's centre, in radii of the ball, > 1; 0: unknown
  double focal_px = 0.0;  ///< focal length in pixels of the whole photograph; 0: unknown
};

/// A ball in a photograph, and how sure its rim is.
struct FoundBall {
  BallView view;
  double share = 1.0;                ///< of the rim inside the picture, how much has an edge that runs along it
  double visible = 1.0;              ///< how much of the rim lies inside the picture
  double rms_px = 0.0;               ///< root of the mean square distance of those edges from the rim
  double confidence = 1.0;           ///< 0 … 1: how likely it is the ball, among all found circles and no ball at all
  std::optional<Circle> rival = {};  ///< the next likely one, to some percent, in the form of ballOfCircle

  /// Whether it hardly needs to be checked: 1 in 100 of the sure circles in traced photographs is off by more than 3 %
  /// of the radius.
  bool isSure() const { return confidence >= 0.7; }
};

/// Finds a mirror ball's rim in a photograph, to a fraction of a pixel.
///
///   1. Circles are voted for by edges in a coarse picture (rim_votes.h).
///   2. Each is moved to where its radii have an edge and few have one outside (rim_fit.h).
///   3. The likeliest is taken: edges at the rim, more detail inside than outside, size (ball_evidence.h).
///   4. It is refined in the full picture by robust least squares.
///
/// All of this happens in the pinhole camera's plane, where the rim is a circle even beside the picture's middle.
///
/// light    a photograph, linear; 1 or 3 channels or more
/// returns  a circle that may be the wrong one unless isSure()
/// errors   bad_shape: nothing that is likely a ball, or the ball would surround the camera
/// cost     about 0.3 s, nearly independent of the size; deterministic
Result<FoundBall> findBall(const Image& light, const Perspective& perspective);

/// The ball whose rim is given as a circle in the photograph; of a ball beside the middle, whose rim is an ellipse, the
/// circle that fits it best.
///
/// errors   usage: the circle has no radius, or is completely outside the picture
Result<FoundBall> ballOfCircle(const Circle& circle, glm::ivec2 size, const Perspective& perspective);

/// The circle that fits a ball's outline in the photograph best: what ballOfCircle takes.
Circle circleInPicture(const BallView& view);

/// The focal length in pixels of a photograph of that height with that vertical field of view.
double focalLengthFromFov(double fov_deg, int height);

}  // namespace mirrorball
