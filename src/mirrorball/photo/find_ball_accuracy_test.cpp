// How far from its rim a ball is found, in many photographs. What else there is to finding one: find_ball_test.cpp.

#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "mirrorball/photo/find_ball_testing.h"

namespace mirrorball {
namespace {

using testing::BallScene;
using testing::builtin;
using testing::clutter;
using testing::expectFound;
using testing::kPromised_px;
using testing::throughJpeg;

TEST(FindBallAccuracy, EveryBuiltinEnvironmentThroughJpeg) {
  for (const char* name : {"studio", "sky", "uv"}) {
    SCOPED_TRACE(name);
    BallScene scene;
    scene.environment = builtin(name);
    Image photograph = scene.photograph();
    testing::addNoise(photograph, 0.01f, 0.003f);
    // The grid of "uv" is mirrored as lines within a pixel along the rim, on a background hardly brighter than they.
    expectFound(scene, throughJpeg(photograph), std::string_view(name) == "uv" ? 1.0 : kPromised_px);
  }
}

TEST(FindBallAccuracy, ClutterBehindTheBall) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    BallScene scene;
    scene.environment = seed % 2 ? builtin("studio") : builtin("sky");
    scene.background = clutter(seed);
    scene.center = {0.6 * std::sin(seed), 0.4 * std::cos(2.0 * seed), -8.0};
    Image photograph = scene.photograph();
    testing::addNoise(photograph, 0.02f, 0.005f, seed);
    expectFound(scene, throughJpeg(photograph));
  }
}

TEST(FindBallAccuracy, SizesFromATinyBallToOneThatFillsThePicture) {
  struct Place {
    const char* light;
    double distance;
  };
  for (const auto& [light, distance] : {Place{"sky", 3.5}, Place{"sky", 6.0}, Place{"sky", 12.0}, Place{"sky", 24.0},
                                        Place{"sky", 40.0}, Place{"studio", 3.5}, Place{"studio", 12.0}}) {
    SCOPED_TRACE(std::string(light) + " " + std::to_string(distance));
    BallScene scene;
    scene.size = {600, 450};
    scene.focal_px = 700.0;
    scene.center = {0.05 * distance, 0.0, -distance};
    scene.environment = builtin(light);
    // Within a pixel of a small ball's rim it mirrors all that lies 30° around the blind cone: its edge is less clear.
    // In the studio half of the rim mirrors a smooth wall before that same wall.
    const double radius = scene.focal_px / distance;
    const double bound = std::string_view(light) == "studio" ? std::max(0.6, 0.01 * radius)
                         : distance < 20.0                   ? kPromised_px
                                                             : 0.6;
    expectFound(scene, throughJpeg(scene.photograph()), bound);
  }
}

TEST(FindBallAccuracy, AnyLightFromAnySide) {
  // All but the skies were once found up to two radii away from the ball, or on a line inside of its rim.
  struct Light {
    const char* name;
    double turn_deg, distance;
  };
  for (const Light& light :
       {Light{"studio", 0.0, 16.0}, Light{"studio", 60.0, 5.5}, Light{"studio", 60.0, 16.0},
        Light{"studio", 240.0, 9.0}, Light{"sky", 120.0, 9.0}, Light{"sky:elevation=8", 120.0, 5.5},
        Light{"sky:elevation=70", 0.0, 16.0}, Light{"uv", 60.0, 9.0}, Light{"uv", 180.0, 16.0}}) {
    SCOPED_TRACE(std::string(light.name) + " " + std::to_string(light.turn_deg));
    BallScene scene;
    scene.turn_deg = light.turn_deg;
    scene.center = light.distance * glm::dvec3(0.04, 0.03, -1.0);
    scene.environment = builtin(light.name);
    expectFound(scene, throughJpeg(scene.photograph()), 0.01 * scene.focal_px / light.distance);
  }
}

TEST(FindBallAccuracy, TouchesOrCrossesTheBorder) {
  for (const double right : {1.02, 1.12, 1.25}) {  // of half the picture's width, where the rim ends
    SCOPED_TRACE(right);
    BallScene scene;
    scene.environment = builtin("studio");
    scene.background = clutter(5);
    const double radius = scene.focal_px / 8.0;
    scene.center = {(right * 240.0 - radius) / scene.focal_px * 8.0, 0.0, -8.0};
    const Image photograph = throughJpeg(scene.photograph());
    // Up to a quarter of the diameter lies outside, where the error of the rest of the rim is extrapolated.
    double visible = 1.0;
    expectFound(scene, photograph, right < 1.1 ? kPromised_px : 0.6, &visible);
    EXPECT_LT(visible, 1.0);
  }
}

}  // namespace
}  // namespace mirrorball
