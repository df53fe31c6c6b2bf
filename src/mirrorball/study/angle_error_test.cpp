#include "mirrorball/study/angle_error.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

/// n·v of the unit sphere where a ray meets it; nothing where it passes.
std::optional<float> cosineOnSphere(glm::vec3 eye, glm::vec3 ray) {
  const float towards = -glm::dot(eye, ray);
  const float root = towards * towards - glm::dot(eye, eye) + 1.0f;
  if (root < 0.0f) return {};
  return -glm::dot(eye + (towards - std::sqrt(root)) * ray, ray);
}

TEST(AngleError, TheCosinesOfASphereAreThoseOfItsRays) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  auto renderer = Renderer::on(std::move(context));
  ASSERT_TRUE(renderer);
  ASSERT_TRUE(renderer->setEnvironment(environmentOfDirections()));
  FrameSettings frame{.size = {64, 48}};
  frame.camera.distance = 3.0f;
  const Scene scene = meshScene(sphereMesh());
  const auto cosines = cosinesOf(*renderer, scene, frame);
  ASSERT_TRUE(cosines) << cosines.error().message;

  const Camera camera = *framedCamera(scene, boundingSphere(scene), frame.camera, frame.size);
  const float slope = 1.0f / camera.clip_from_view[1][1];  // of the picture's upper edge
  int inside = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::vec2 place((float(x) + 0.5f - 32.0f) / 24.0f, (24.0f - float(y) - 0.5f) / 24.0f);
      const glm::vec3 in_view = glm::normalize(glm::vec3(place * slope, -1.0f));
      const auto right = cosineOnSphere(camera.position, glm::transpose(glm::mat3(camera.view_from_world)) * in_view);
      const float found = *cosines->texel(x, y);
      if (found >= 0.0f && right && *right > 0.3f) {
        // The mean of a pixel's normals, in half floats.
        ASSERT_NEAR(found, *right, 0.01f) << x << ", " << y;
        ++inside;
      }
      ASSERT_TRUE(right || found < 0.0f) << "there is nothing at " << x << ", " << y;
    }
  EXPECT_GT(inside, 600);
}

TEST(AngleError, EachStepHasTheErrorOfItsPixels) {
  constexpr int kWidth = 40;
  Image cosines(kWidth, 1, 1, -1.0f), test(kWidth, 1, 4, 1.0f), reference(kWidth, 1, 4, 1.0f);
  for (int x = 0; x < 20; ++x) {
    *cosines.texel(x, 0) = 0.25f;
    for (int channel = 0; channel < 3; ++channel) test.texel(x, 0)[channel] = 1.5f;
  }
  for (int x = 20; x < 30; ++x) *cosines.texel(x, 0) = 1.0f;  // too few
  const ErrorByAngle errors = errorByAngle(test, reference, cosines);
  for (std::size_t step = 0; step < kAngleSteps; ++step) {
    if (step == 2)
      EXPECT_NEAR(errors[step].value_or(0.0), 0.5 / std::sqrt(1.01), 1e-6);
    else
      EXPECT_FALSE(errors[step]) << step;
  }
}

}  // namespace
}  // namespace mirrorball
