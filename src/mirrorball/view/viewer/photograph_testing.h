#pragma once

#include <string>

#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/photo/photo_testing.h"

namespace mirrorball::testing {

/// A ball in the studio before a grey wall, in the shape of no map.
inline BallScene ballBeforeWall() {
  BallScene scene;
  scene.size = {240, 170};
  scene.focal_px = 450.0;
  scene.environment = [studio = *builtinEnvironment("studio")](glm::vec3 d) { return studio.radiance(d); };
  scene.background = [](glm::vec3) { return glm::vec3(0.5f); };
  return scene;
}

/// A file of the tests with its photograph.
inline std::string photographOf(const BallScene& scene, const char* name) {
  std::string path = ::testing::TempDir() + name;
  EXPECT_TRUE(writeImage(path, scene.photograph()));
  return path;
}

/// A file in which no ball is found.
inline std::string photographOfWall(const char* name) {
  std::string path = ::testing::TempDir() + name;
  EXPECT_TRUE(writeImage(path, Image(240, 170, 3, 0.5f)));
  return path;
}

}  // namespace mirrorball::testing
