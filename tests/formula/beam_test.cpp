// formula/bodies/beam.glsl through a ball lens, beside what paraxial optics and rays that are bent one by one say.

#include <cmath>

#include <gtest/gtest.h>

#include "formula/bodies.h"
#include "formula/bsdf.h"

namespace mirrorball::formula {
namespace {

constexpr float kIor = 1.5f;

/// A beam along the axis of a ball of radius 1, in and out again.
Beam throughBall(Beam beam, float alpha) {
  beam = beamBeyond(beam, refractionOfBeam(alpha, 1.0f, kIor, -1.0f));
  return beamBeyond(beamAfter(beam, 2.0f), refractionOfBeam(alpha, 1.0f, 1.0f / kIor, 1.0f));
}

/// The angle to the axis at which a ray leaves that comes down the axis at a distance from it, by Snell's law on the
/// ball, whose facets are tilted where it enters and leaves.
float tracedAngle(float height, float tilt_in, float tilt_out) {
  const auto turned = [](glm::vec3 n, float angle) {
    return glm::vec3(std::cos(angle) * n.x - std::sin(angle) * n.y, std::sin(angle) * n.x + std::cos(angle) * n.y, 0);
  };
  const glm::vec3 in(height, std::sqrt(1.0f - height * height), 0.0f);
  const glm::vec3 inside = glm::refract(glm::vec3(0, -1, 0), turned(in, tilt_in), 1.0f / kIor);
  const glm::vec3 out = in - 2.0f * glm::dot(in, inside) * inside;
  const glm::vec3 left = glm::refract(inside, -turned(out, tilt_out), kIor);
  return std::atan2(left.x, -left.y);
}

// Its focal length is n / (2 (n − 1)) radii from its middle: a ray at the distance h turns by h / f.
TEST(Beam, ABallIsALensOfItsFocalLength) {
  const float height = 0.01f;
  const float focal_length = kIor / (2.0f * (kIor - 1.0f));
  const Beam beam = throughBall({glm::vec3(0.0f), {0.0f, height}}, 0.0f);
  EXPECT_NEAR(beam.pixel.x, -height / focal_length, 1e-6f);
  EXPECT_NEAR(beam.pixel.x, tracedAngle(height, 0.0f, 0.0f), 1e-5f);
}

// A facet tilted by δ turns light by δ (1 − 1 / n) where it enters, of which the second surface leaves the half, and by
// δ (n − 1) where it leaves. A reflection's α² is the variance of 2 δ, so that of both together is
// α² ((1/6)² + (1/2)²) / 4.
TEST(Beam, ARoughBallSpreadsLightByBothItsSurfaces) {
  const float alpha = 0.2f;
  const float tilt = 1e-3f;
  const float entering = tracedAngle(0.0f, tilt, 0.0f) / tilt, leaving = tracedAngle(0.0f, 0.0f, tilt) / tilt;
  EXPECT_NEAR(std::abs(entering), 1.0f / 6.0f, 1e-3f);
  EXPECT_NEAR(std::abs(leaving), 1.0f / 2.0f, 1e-3f);
  const float variance = alpha * alpha * (entering * entering + leaving * leaving) / 4.0f;
  EXPECT_NEAR(throughBall({}, alpha).lobe.x, variance, 2e-3f * variance);
}

// A mirror of radius 1 seen from inside of it gathers light at half the radius.
TEST(Beam, AHollowMirrorGathersAtHalfItsRadius) {
  const float height = 0.01f;
  const Beam mirrored = beamBeyond({glm::vec3(0.0f), {0.0f, height}}, reflectionOfBeam(0.0f, 1.0f, 1.0f));
  EXPECT_NEAR(beamAfter(mirrored, 0.5f).pixel.y, 0.0f, 1e-7f);
}

// Towards neither index is a beam changed: not by roughness, not by curvature.
TEST(Beam, AnIndexOfOneChangesNothing) {
  for (const float cosine : {0.2f, 0.7f, 1.0f}) {
    const glm::vec3 surface = refractionOfBeam(0.5f, cosine, 1.0f, 3.0f);
    EXPECT_NEAR(surface.x, 1.0f, 1e-6f);
    EXPECT_NEAR(surface.y, 0.0f, 1e-6f);
    EXPECT_NEAR(surface.z, 0.0f, 1e-6f);
  }
}

}  // namespace
}  // namespace mirrorball::formula
