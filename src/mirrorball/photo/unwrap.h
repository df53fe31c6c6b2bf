#pragma once

#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/photo/ball_view.h"

namespace mirrorball {

/// One photograph of the ball.
struct BallPhotograph {
  Image light;  ///< linear
  BallView view;
  double turn_deg = 0.0;  ///< how far the camera was moved around the ball, about the vertical axis: at 90 it is on +X
};

/// The light around a ball.
struct UnwrappedPhotographs {
  Environment environment;
  std::vector<double> gains;  ///< what each photograph's light was multiplied by to agree with the first
  double filled_sr = 0.0;     ///< solid angle of the directions that no photograph sees and that were filled
};

/// How far inside the rim a photograph is used: the outermost pixels mix the ball with what stands behind it.
double rimMargin_px(const BallView& view);

/// Unwraps photographs of one mirror ball into the light around it.
///
/// Directions that several photographs see are blended by the fourth power of the cosine between the ball's normal and
/// the direction to the camera, because a pixel closer to the rim shows more of the surroundings. Directions that no
/// photograph sees are filled smoothly (fill.h). A later photograph is scaled by the median ratio of its light to the
/// first one's, over the directions that both see well. Directions are those of the first photograph's camera, which is
/// taken as level.
///
/// photographs  at least one
/// errors       bad_shape: a photograph shows no direction at all
/// cost         the environment looks up one pixel a photograph for each direction; see fill.h for the rest
Result<UnwrappedPhotographs> unwrapBall(std::vector<BallPhotograph> photographs);

}  // namespace mirrorball
