#include "mirrorball/scene/mesh_file/polygon.h"

#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// The sum of the triangles' areas along +Z, and of those that are turned the wrong way.
struct Areas {
  float sum = 0.0f;
  float wrong = 0.0f;
};
Areas areasOf(const std::vector<glm::vec3>& corners) {
  Areas areas;
  for (const auto& [a, b, c] : triangulate(corners)) {
    const float area = 0.5f * glm::cross(corners[b] - corners[a], corners[c] - corners[a]).z;
    areas.sum += area;
    if (area < 0.0f) areas.wrong -= area;
  }
  return areas;
}

TEST(Triangulate, MakesAFanOfAConvexPolygon) {
  const std::vector<glm::vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto triangles = triangulate(square);
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

TEST(Triangulate, KeepsInsideAConcavePolygon) {
  // An arrowhead whose first corner would make a fan that leaves it, and an L.
  const std::vector<glm::vec3> arrow = {{2, 0, 0}, {-1, 2, 0}, {0, 0, 0}, {-1, -2, 0}};
  EXPECT_NEAR(areasOf(arrow).sum, 4.0f, 1e-6f);
  EXPECT_EQ(areasOf(arrow).wrong, 0.0f);
  const std::vector<glm::vec3> bracket = {{3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}, {0, 0, 0}};
  EXPECT_NEAR(areasOf(bracket).sum, 5.0f, 1e-6f);
  EXPECT_EQ(areasOf(bracket).wrong, 0.0f);
}

TEST(Triangulate, KeepsInsideAStar) {
  std::vector<glm::vec3> star;
  for (int i = 0; i < 40; ++i) {
    const float radius = i % 2 == 0 ? 1.0f : 0.3f;
    const float angle = static_cast<float>(i) * 0.15707963f;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0f);
  }
  const float exact = 40.0f * 0.5f * 0.3f * std::sin(0.15707963f);
  EXPECT_EQ(triangulate(star).size(), 38u);
  EXPECT_NEAR(areasOf(star).sum, exact, 1e-5f);
  EXPECT_LT(areasOf(star).wrong, 1e-6f);
}

TEST(Triangulate, EndsForPolygonsWithoutEars) {
  const std::vector<glm::vec3> point(7, glm::vec3(1.0f));
  EXPECT_EQ(triangulate(point).size(), 5u);
  const std::vector<glm::vec3> bow = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(bow).size(), 2u);
}

TEST(Triangulate, MakesAFanOfAHugePolygon) {
  std::vector<glm::vec3> circle;
  for (int i = 0; i < 5000; ++i) {
    const double angle = i * 6.283185307179586 / 5000;
    circle.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  EXPECT_EQ(triangulate(circle).size(), 4998u);
  EXPECT_NEAR(areasOf(circle).sum, 3.14159f, 1e-3f);
}

}  // namespace
}  // namespace mirrorball
