#include "mirrorball/codec/primaries.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

constexpr Primaries kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
constexpr Primaries kAces{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, {0.32168, 0.33767}};

void expectNear(glm::vec3 actual, glm::vec3 expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 2e-4f) << "component " << c;
}

TEST(Primaries, Rec709AndNoneNeedNothing) {
  EXPECT_FALSE(rec709FromPrimaries(kRec709));
  EXPECT_FALSE(rec709FromPrimaries(Primaries{}));
  EXPECT_FALSE(rec709FromPrimaries({{0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}, {0.3, 0.3}}));
}

TEST(Primaries, Rec2020GivesThePublishedMatrix) {
  const auto matrix = rec709FromPrimaries(kRec2020);
  ASSERT_TRUE(matrix);
  // ITU-R BT.2087-0 gives the inverse; these are the columns of BT.2407-0, eq. 4.
  expectNear((*matrix)[0], {1.6605f, -0.1246f, -0.0182f});
  expectNear((*matrix)[1], {-0.5876f, 1.1329f, -0.1006f});
  expectNear((*matrix)[2], {-0.0728f, -0.0083f, 1.1187f});
}

TEST(Primaries, WhiteStaysWhiteUnderAnotherWhitePoint) {
  const auto matrix = rec709FromPrimaries(kAces);
  ASSERT_TRUE(matrix);
  expectNear(*matrix * glm::vec3(1.0f), glm::vec3(1.0f));
}

TEST(Primaries, AlphaIsNotTransformed) {
  Image image(2, 1, 4, 0.5f);
  transformColors(image, glm::mat3(2.0f));
  EXPECT_EQ(image.samples()[4], 1.0f);
  EXPECT_EQ(image.samples()[7], 0.5f);
}

}  // namespace
}  // namespace mirrorball
