// Prefiltered cubes are as smooth across their twelve edges, and so around their eight corners, as they are inside a
// face.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/bake/prefilter/prefilter_testing.h"

namespace mirrorball {
namespace {

/// The steepest that a level is between neighbouring texels, in each channel [radiance/rad].
struct Steepness {
  glm::vec3 inside{0.0f};  ///< of any face
  glm::vec3 across{0.0f};  ///< any edge
};

/// A texel of one level of a cube, and where it lies.
struct Texel {
  glm::vec3 direction;
  glm::vec3 light;
};

Texel texelAt(const ImageSet& cube, int level, int face, glm::ivec2 texel) {
  const auto size = static_cast<float>(cube.at(level, 0).width());
  return {directionAt(Projection::cube, {face, (glm::vec2(texel) + 0.5f) / size}),
          rgbAt(cube.at(level, face), texel.x, texel.y)};
}

/// The texel whose centre is a point of the cube's surface, the faces of which lie at ±1.
Texel texelTowards(const ImageSet& cube, int level, glm::vec3 point) {
  const MapPosition position = positionOf(Projection::cube, point);
  return texelAt(cube, level, position.face, glm::ivec2(position.uv * static_cast<float>(cube.at(level, 0).width())));
}

glm::vec3 steepness(const Texel& a, const Texel& b) {
  return glm::abs(a.light - b.light) / std::acos(glm::dot(a.direction, b.direction));
}

glm::vec3 steepestInside(const ImageSet& cube, int level) {
  const int size = cube.at(level, 0).width();
  glm::vec3 steepest(0.0f);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x + 1 < size; ++x) {
        const auto at = [&](int column, int row) { return texelAt(cube, level, face, {column, row}); };
        steepest = glm::max(steepest, steepness(at(x, y), at(x + 1, y)));
        steepest = glm::max(steepest, steepness(at(y, x), at(y, x + 1)));
      }
  return steepest;
}

/// Where two faces meet, the texels on both sides are each other's mirror images in the plane through that edge and the
/// middle. The first and the last pair of an edge lie in corners.
glm::vec3 steepestAcross(const ImageSet& cube, int level) {
  const int size = cube.at(level, 0).width();
  const float border = 1.0f - 1.0f / static_cast<float>(size);  // the centres of a face's outermost texels
  glm::vec3 steepest(0.0f);
  for (int along = 0; along < 3; ++along)
    for (const float first : {-1.0f, 1.0f})
      for (const float second : {-1.0f, 1.0f})
        for (int i = 0; i < size; ++i) {
          glm::vec3 point;
          point[along] = static_cast<float>(2 * i + 1) / static_cast<float>(size) - 1.0f;
          point[(along + 1) % 3] = first;
          point[(along + 2) % 3] = second * border;
          const Texel here = texelTowards(cube, level, point);
          point[(along + 1) % 3] = first * border;
          point[(along + 2) % 3] = second;
          steepest = glm::max(steepest, steepness(here, texelTowards(cube, level, point)));
        }
  return steepest;
}

/// How much steeper a level is across its edges than inside its faces, in the channel where that is most.
float excessAcrossEdges(const ImageSet& cube, int level) {
  const glm::vec3 ratio = steepestAcross(cube, level) / steepestInside(cube, level);
  return std::max({ratio.x, ratio.y, ratio.z});
}

/// In each channel another light, which differs along every edge.
EnvironmentMap colorfulPanorama() {
  return panoramaOf(384, 192, [](glm::vec3 d) {
    const glm::vec3 fine(std::sin(5.0f * d.y), std::sin(6.0f * d.z), std::sin(7.0f * d.x));
    return 3.0f + d + 0.3f * fine;
  });
}

// Chords of 4² texels to a face are not quite the slopes between them.
constexpr float kSmooth = 1.1f;

class PrefilterSeams : public ::testing::TestWithParam<Distribution> {};

TEST_P(PrefilterSeams, AreNotSeenOnAnyLevel) {
  const ImageSet chain = chainOf(Environment(colorfulPanorama()), {.size = 64, .distribution = GetParam()});
  for (int level = 0; level < chain.levels(); ++level) EXPECT_LT(excessAcrossEdges(chain, level), kSmooth) << level;
}

INSTANTIATE_TEST_SUITE_P(All, PrefilterSeams,
                         ::testing::Values(Distribution::ggx, Distribution::phong, Distribution::blinn,
                                           Distribution::charlie));

TEST(CubeSeams, AreNotSeenInIrradiance) {
  for (const int size : {4, 32})
    EXPECT_LT(excessAcrossEdges(irradianceCubeOf(colorfulPanorama(), size), 0), kSmooth) << size;
}

/// One of a square's eight symmetries: a mirror image if `symmetry` is odd, turned by a quarter `symmetry / 2` times.
Image turned(const Image& image, int symmetry) {
  const int last = image.width() - 1;
  Image result(image.width(), image.height(), image.channels());
  for (int y = 0; y <= last; ++y)
    for (int x = 0; x <= last; ++x) {
      glm::ivec2 from(symmetry % 2 == 0 ? x : last - x, y);
      for (int quarter = 0; quarter < symmetry / 2; ++quarter) from = {last - from.y, from.x};
      std::copy_n(image.texel(from.x, from.y), image.channels(), result.texel(x, y));
    }
  return result;
}

// What the tests above would miss if they could not fail.
TEST(CubeSeams, AreSeenWhereOneFaceIsMirroredOrTurned) {
  const ImageSet chain = chainOf(colorfulPanorama(), 64);
  for (int level = 0; level < chain.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      for (int symmetry = 1; symmetry < 8; ++symmetry) {
        ImageSet wrong = chain;
        wrong.at(level, face) = turned(chain.at(level, face), symmetry);
        EXPECT_GT(excessAcrossEdges(wrong, level), 1.5f * kSmooth)
            << "level " << level << " face " << face << " symmetry " << symmetry;
      }
}

}  // namespace
}  // namespace mirrorball
