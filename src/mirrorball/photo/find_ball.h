#pragma once

#include <optional>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/photo/ball_view.h"

namespace mirrorball {

/// What is known about the camera; at most one of the two. Neither: rays are taken as parallel.
struct Perspective {
  double distance = 0.0;  ///< from the camera to the ball's centre, in radii of the ball, > 1; 0: unknown
  double focal_px = 0.0;  ///< focal length in pixels of the whole photograph; 0: unknown
};

/// A ball in a photograph, and how sure its rim is.
struct FoundBall {
  BallView view;
  double share = 1.0;    ///< of the rim inside the picture, how much has an edge that runs along it
  double visible = 1.0;  ///< how much of the rim lies inside the picture
  double rms_px = 0.0;   ///< root of the mean square distance of those edges from the rim
};

/// Finds a mirror ball's rim in a photograph, to a fraction of a pixel.
///
/// Circles are voted for by edges in a coarse picture (rim_votes.h). Each candidate is then fitted to the edges across
/// its radii by trying circles through three of them, and counted by how much of its rim has an edge that runs along it
/// beyond what neighbouring circles have by chance. The best is refined by robust least squares in the full picture.
/// All of this happens in the lens' plane, where the rim is a circle even beside the picture's middle.
///
/// light    a photograph, linear; 1 or 3 channels or more
/// name     the file, for messages
/// errors   bad_shape: no rim that is sure enough, or the ball would surround the camera
/// cost     about 0.3 s, little depending on the size; deterministic
Result<FoundBall> findBall(const Image& light, const Perspective& perspective, const std::string& name);

/// The ball whose rim is given as a circle in the photograph; of a ball beside the middle, whose rim is an ellipse, the
/// circle that fits it best.
///
/// errors   usage: the circle has no radius, or lies wholly beside the picture
Result<FoundBall> ballOfCircle(const Circle& circle, glm::ivec2 size, const Perspective& perspective);

/// The circle that fits a ball's outline in the photograph best: what ballOfCircle takes.
Circle circleInPicture(const BallView& view);

/// The focal length in pixels of a photograph of that height with that vertical field of view.
double focalLengthFromFov(double fov_deg, int height);

}  // namespace mirrorball
