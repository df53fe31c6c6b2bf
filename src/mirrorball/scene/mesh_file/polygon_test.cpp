#include "mirrorball/scene/mesh_file/polygon.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Areas along +Z.
struct Areas {
  double polygon = 0.0;
  double sum = 0.0;    ///< of its triangles
  double wrong = 0.0;  ///< of those that are turned the wrong way
};
Areas measure(const std::vector<glm::vec3>& corners, TriangulationWork* work = nullptr) {
  Areas areas;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a(corners[i]), b(corners[(i + 1) % corners.size()]);
    areas.polygon += 0.5 * (a.x * b.y - a.y * b.x);
  }
  for (const auto& [a, b, c] : triangulate(corners, work)) {
    const glm::dvec3 first(corners[a]);
    const double area = 0.5 * glm::cross(glm::dvec3(corners[b]) - first, glm::dvec3(corners[c]) - first).z;
    areas.sum += area;
    areas.wrong += std::max(0.0, -area);
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
  EXPECT_NEAR(measure(arrow).sum, 4.0, 1e-6);
  EXPECT_EQ(measure(arrow).wrong, 0.0);
  const std::vector<glm::vec3> bracket = {{3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}, {0, 0, 0}};
  EXPECT_NEAR(measure(bracket).sum, 5.0, 1e-6);
  EXPECT_EQ(measure(bracket).wrong, 0.0);
}

/// A star of that many points.
std::vector<glm::vec3> makeStar(int points) {
  std::vector<glm::vec3> star;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = i * 3.141592653589793 / points, radius = i % 2 == 0 ? 1.0 : 0.3;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return star;
}

TEST(Triangulate, KeepsInsideAStar) {
  const std::vector<glm::vec3> star = makeStar(20);
  const double exact = 40.0 * 0.5 * 0.3 * std::sin(0.15707963);
  EXPECT_EQ(triangulate(star).size(), 38u);
  EXPECT_NEAR(measure(star).sum, exact, 1e-5);
  EXPECT_LT(measure(star).wrong, 1e-6);
}

/// A band of that many corners along a spiral: all of one side bend inwards, and ears are at its two ends alone.
std::vector<glm::vec3> spiral(int corners) {
  std::vector<glm::vec3> outer, inner;
  for (int i = 0; i < corners / 2; ++i) {
    const float angle = 0.2f * static_cast<float>(i);
    const glm::vec3 direction(std::cos(angle), std::sin(angle), 0.0f);
    outer.push_back((1.0f + 0.1f * angle) * direction);
    inner.push_back((0.8f + 0.1f * angle) * direction);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

TEST(Triangulate, KeepsInsideASpiral) {
  for (const int corners : {100, 1000, 3000}) {
    const std::vector<glm::vec3> band = spiral(corners);
    const Areas areas = measure(band);
    EXPECT_EQ(triangulate(band).size(), std::size_t(corners - 2));
    EXPECT_NEAR(areas.sum, areas.polygon, 1e-4 * areas.polygon);
    EXPECT_LT(areas.wrong, 1e-5);
  }
}

TEST(Triangulate, ATiltedPolygonIsCutAsOneThatIsNot) {
  for (const std::vector<glm::vec3>& flat :
       {spiral(60), std::vector<glm::vec3>{{2, 0, 0}, {-1, 2, 0}, {0, 0, 0}, {-1, -2, 0}}}) {
    std::vector<glm::vec3> tilted;
    for (const glm::vec3& corner : flat)
      tilted.push_back(corner.x * glm::vec3(0.6f, 0.0f, -0.8f) + corner.y * glm::vec3(0.48f, 0.8f, 0.36f) + 3.0f);
    EXPECT_EQ(triangulate(tilted), triangulate(flat));
  }
}

// A file of 1 MB has some two hundred of these. With each corner compared with all others at each cut, they took half
// a minute.
TEST(Triangulate, ManyLargePolygonsTakeLittleTime) {
  std::vector<glm::vec3> band;  // up and down, and back above that
  for (int i = 0; i < 500; ++i) band.emplace_back(i, i % 2 * 5, 0);
  for (int i = 500; i-- > 0;) band.emplace_back(i, i % 2 * 5 + 1, 0);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 200; ++i) ASSERT_EQ(triangulate(band).size(), 998u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(Triangulate, EndsForPolygonsWithoutEars) {
  const std::vector<glm::vec3> point(7, glm::vec3(1.0f));
  EXPECT_EQ(triangulate(point).size(), 5u);
  const std::vector<glm::vec3> bow = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(triangulate(bow).size(), 2u);
}

// The outline of a country, and the caps of what CAD programs cut.
TEST(Triangulate, KeepsInsideOfPolygonsOfAHundredThousandCorners) {
  std::vector<glm::vec3> comb;
  for (int i = 0; i < 100'000; ++i) comb.emplace_back(i, i % 2 * 1000, 0);
  comb.emplace_back(100'000, -1, 0);
  comb.emplace_back(0, -1, 0);
  std::reverse(comb.begin(), comb.end());
  std::vector<glm::vec3> zigzag;  // a band that goes to and fro
  for (int i = 0; i < 20'000; ++i) zigzag.emplace_back(i % 2 * 5000, i, 0);
  for (int i = 20'000; i-- > 0;) zigzag.emplace_back(i % 2 * 5000 - 1, i, 0);
  for (const std::vector<glm::vec3>& outline : {makeStar(50'000), comb, zigzag}) {
    TriangulationWork work;
    const Areas areas = measure(outline, &work);
    EXPECT_FALSE(work.gave_up);
    EXPECT_NEAR(areas.sum, areas.polygon, 1e-6 * areas.polygon);
    EXPECT_LT(areas.wrong, 1e-6 * areas.polygon);
  }
}

// A notch far away makes a cell of the grid so large that all others lie in it.
TEST(Triangulate, SaysWhereItGivesUp) {
  std::vector<glm::vec3> band;
  for (int i = 0; i < 12000; ++i) band.emplace_back(i % 2 == 0 ? 0 : 12000, i, 0);
  for (int i = 12000; i-- > 0;) band.emplace_back(i % 2 == 0 ? 0.5 : 12000.5, i - 0.25, 0);
  for (const glm::vec3 notch : {glm::vec3(-1e12, -5, 0), glm::vec3(-9e11, -3, 0), glm::vec3(-1e12, -1, 0)})
    band.push_back(notch);
  TriangulationWork work;
  EXPECT_EQ(triangulate(band, &work).size(), band.size() - 2);
  EXPECT_TRUE(work.gave_up);
  EXPECT_LE(work.steps, mostSteps(band.size()) + 2 * band.size());
}

// The first looks, at all corners, are already too many: a quarter of the square of their number.
TEST(Triangulate, GivesUpAmongItsFirstLooks) {
  std::vector<glm::vec3> comb = {{0, -1, 0}, {1e7, -1, 0}, {0.9999999e7, -0.5, 0}, {1e7, 0, 0}};
  for (int i = 40'000; i-- > 0;) comb.emplace_back(i / 40'000.0, i % 2, 0);
  TriangulationWork work;
  EXPECT_EQ(triangulate(comb, &work).size(), comb.size() - 2);
  EXPECT_TRUE(work.gave_up);
  EXPECT_LE(work.steps, mostSteps(comb.size()) + 2 * comb.size());
}

// The products of such coordinates lie below the least double, and above the greatest.
TEST(Triangulate, PolygonsMayBeOfAnySize) {
  const std::vector<glm::vec3> arrow = {{2, 0, 0}, {-1, 2, 0}, {0, 0, 0}, {-1, -2, 0}, {0.5, -1, 0}};
  for (const float size : {1e-42f, 1e-20f, 1e20f, 1.5e38f}) {
    std::vector<glm::vec3> scaled;
    for (const glm::vec3& corner : arrow) scaled.push_back(corner * size);
    EXPECT_EQ(triangulate(scaled), triangulate(arrow)) << size;
  }
}

TEST(Triangulate, FillsACircleOfManyCorners) {
  std::vector<glm::vec3> circle;
  for (int i = 0; i < 5000; ++i) {
    const double angle = i * 6.283185307179586 / 5000;
    circle.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  EXPECT_EQ(triangulate(circle).size(), 4998u);
  EXPECT_NEAR(measure(circle).sum, 3.14159, 1e-3);
}

}  // namespace
}  // namespace mirrorball
