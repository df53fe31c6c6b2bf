#include "mirrorball/scene/mesh_file/smoothing.h"

#include <cmath>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Two squares that share an edge and turn there by an angle, the second one's edges from its `first`-th corner on.
struct Fold {
  std::vector<glm::vec3> positions;
  std::vector<std::vector<std::uint32_t>> corners{{0, 1, 2, 3}, {1, 4, 5, 2}};

  explicit Fold(float turn_deg) {
    const float turn = glm::radians(turn_deg);
    const glm::vec3 along(std::cos(turn), 0.0f, -std::sin(turn));
    positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    positions.push_back(positions[1] + along);
    positions.push_back(positions[2] + along);
  }

  CornerNormals normals(int first, int second) const {
    const std::vector<PolygonFace> faces{{corners[0], first}, {corners[1], second}};
    return cornerNormals(positions, faces);
  }
};

TEST(CornerNormals, EdgesAreSmoothUnder45Degrees) {
  const CornerNormals smooth = Fold(44.0f).normals(kSmoothByAngle, kSmoothByAngle);
  EXPECT_EQ(smooth.normals.size(), 6u);
  EXPECT_EQ(smooth.of_corner[1], smooth.of_corner[4]);
  EXPECT_EQ(smooth.of_corner[2], smooth.of_corner[7]);
  // Both squares have the same angle there: the normal lies in the middle.
  const glm::vec3 middle(std::sin(glm::radians(22.0f)), 0.0f, std::cos(glm::radians(22.0f)));
  EXPECT_LT(glm::distance(smooth.normals[smooth.of_corner[1]], middle), 1e-6f);

  const CornerNormals sharp = Fold(46.0f).normals(kSmoothByAngle, kSmoothByAngle);
  EXPECT_EQ(sharp.normals.size(), 8u);
  EXPECT_EQ(sharp.normals[sharp.of_corner[1]], glm::vec3(0, 0, 1));
}

TEST(CornerNormals, GroupsAreSmoothWithinAndSharpBetween) {
  EXPECT_EQ(Fold(90.0f).normals(1, 1).normals.size(), 6u);
  EXPECT_EQ(Fold(10.0f).normals(1, 2).normals.size(), 8u);
  EXPECT_EQ(Fold(10.0f).normals(1, kFlat).normals.size(), 8u);
  EXPECT_EQ(Fold(0.0f).normals(kFlat, kFlat).normals.size(), 8u);
}

// A file may have each face from both sides, or turned the wrong way round:
// what lies flat on each other must not cancel.
TEST(CornerNormals, BacksAreNotJoined) {
  Fold plate(0.0f);
  plate.corners[1] = {0, 3, 2, 1};
  for (const int group : {kSmoothByAngle, 1}) {
    const CornerNormals both = plate.normals(group, group);
    ASSERT_EQ(both.normals.size(), 8u);
    for (int corner = 0; corner < 8; ++corner)
      EXPECT_EQ(both.normals[both.of_corner[std::size_t(corner)]], glm::vec3(0, 0, corner < 4 ? 1 : -1));
  }
}

TEST(CornerNormals, OfWhatHasNoAreaAreUnitStill) {
  const std::vector<glm::vec3> positions(3, glm::vec3(1.0f));
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 0};
  const std::vector<PolygonFace> faces{{corners, kSmoothByAngle}};
  for (const glm::vec3 normal : cornerNormals(positions, faces).normals) EXPECT_EQ(glm::length(normal), 1.0f);
}

}  // namespace
}  // namespace mirrorball
