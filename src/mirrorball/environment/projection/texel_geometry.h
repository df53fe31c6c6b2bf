#pragma once

#include <vector>

#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {

/// The solid angle [sr] of texel (x, y) of an image of width × height texels; 0 when its centre is beside the disc.
/// Exact to single precision, but on a photographed ball's rim to 5e-2 and beside it to 4e-3:
/// the density has a pole there. A disc's rim texels count wholly.
///
/// cost     up to 0.3 µs, in double: a texel's is a small difference of large angles
float texelSolidAngle(Projection projection, glm::ivec2 size, glm::ivec2 texel);

/// How bilinear interpolation between two rows of a panorama keeps the light of both: at t in [0, 1] from the centre of
/// row k − 1 to that of row k it takes the weights of t + b t (1 − t), with b = element k.
///
/// Rows get shorter towards a pole, so the plain weights give the row nearer to it more solid angle than its texels
/// have: a bright first row of a panorama gains 8 %. At the distance x from the border at the polar angle θ, with rows
/// of the height s, the integral of (b/4 − b x²/s²) (sin θ + x cos θ) makes up for it where b = s cot θ / 4, to the
/// second order in s.
///
/// returns  height + 1 elements from −¼ to ¼; 0 at both poles, across which a row meets itself
std::vector<float> panoramaRowBends(int height);

/// formula::cubeCornerSolidAngle in double: the solid angle between a cube face's centre and the point (x, y) of its
/// plane, both in [−1, 1]. In float the difference of four leaves texels of a 1024² face with errors of up to 15 %.
double cubeCornerSolidAngle(double x, double y);

/// Texels a radian in the middle of an image of that size; of a cube, in the middle of a face, where it is least. Of an
/// equal-area map the mean over all directions.
float texelDensity(Projection projection, int size);

/// Texels a radian around a position, along the two orthogonal directions on the sphere in which they lie closest and
/// farthest: the reciprocals of the singular values of d(direction)/d(texel). 1 / (greater · lesser) is a texel's solid
/// angle.
struct TexelDensity {
  float greater;
  float lesser;
};

/// The density at a position, from differences of directionAt over ± 1/1024 of the image's sides: good to 1e-3, and
/// across a fold the mean of both sides. Within 1/512 of an edge, a pole or a rim, where it may be infinite, that at
/// 1/512 from it.
///
/// size     as for imageSize
/// cost     four times directionAt, about 0.2 µs
TexelDensity texelDensityAt(Projection projection, int size, MapPosition position);

}  // namespace mirrorball
