#include "mirrorball/bake/brdf/brdf_table.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/bake/brdf/directional_albedo.h"
#include "mirrorball/base/parallel_testing.h"

namespace mirrorball {
namespace {

/// What the graphics hardware makes of a table at texture coordinates in [0, 1], clamped to its edges.
glm::vec2 bilinear(const Image& table, glm::vec2 uv) {
  const auto last = static_cast<float>(table.width() - 1);
  const glm::vec2 place = glm::clamp(uv * (last + 1.0f) - 0.5f, 0.0f, last);
  const glm::ivec2 low = glm::min(glm::ivec2(place), table.width() - 2);
  const glm::vec2 between = place - glm::vec2(low);
  const auto at = [&](int x, int y) {
    const float* texel = table.texel(low.x + x, low.y + y);
    return glm::vec2(texel[0], texel[1]);
  };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), between.x), glm::mix(at(0, 1), at(1, 1), between.x), between.y);
}

/// The greatest error of scale or bias, and where it is.
struct WorstError {
  float error = 0.0f;
  float perceptual_roughness = 0.0f;
  float cosine = 0.0f;
};

std::string textOf(const WorstError& worst) {
  return std::to_string(worst.error) + " at perceptual roughness " + std::to_string(worst.perceptual_roughness) +
         ", n·v " + std::to_string(worst.cosine);
}

template <typename Coordinates>
void look(const Image& table, Distribution distribution, float perceptual_roughness, float cosine,
          const Coordinates& coordinates, WorstError& worst) {
  const DirectionalAlbedo share = directionalAlbedo(distribution, perceptual_roughness, cosine);
  const glm::vec2 found = bilinear(table, coordinates(perceptual_roughness, cosine));
  const float error = std::max(std::abs(found.x - share.scale), std::abs(found.y - share.bias));
  if (error > worst.error) worst = {error, perceptual_roughness, cosine};
}

/// At and between the rows, between the columns, and at angles of the size of alpha, which the corner consists of.
template <typename Coordinates>
WorstError worstOf(const Image& table, Distribution distribution, float min, float max,
                   const Coordinates& coordinates) {
  WorstError worst;
  const float step = 0.5f / static_cast<float>(table.width() - 1);
  std::vector<float> roughnesses;
  for (float r = step; r <= 1.0f; r += step) roughnesses.push_back(r);
  for (float r = step / 64.0f; r < step; r *= 1.7f) roughnesses.push_back(r);
  for (const float r : roughnesses) {
    if (r < min || r > max) continue;
    for (int i = 1; i <= table.width(); ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(table.width());
      const float of_alpha = r * r * std::exp2(16.0f * part - 8.0f);
      for (const float cosine : {part, part * part * part * part, of_alpha})
        if (cosine >= min && cosine <= max) look(table, distribution, r, cosine, coordinates, worst);
    }
  }
  return worst;
}

TEST(BrdfTable, TexelsOfLinearAxesAreTheShareAtTheirCentres) {
  const Image table = *brdfTable({.size = 8, .channels = 3});
  ASSERT_EQ(table.channels(), 3);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const float perceptual_roughness = (static_cast<float>(y) + 0.5f) / 8.0f;
      const DirectionalAlbedo share =
          directionalAlbedo(Distribution::ggx, perceptual_roughness, (static_cast<float>(x) + 0.5f) / 8.0f);
      EXPECT_EQ(table.texel(x, y)[0], share.scale);
      EXPECT_EQ(table.texel(x, y)[1], share.bias);
      EXPECT_EQ(table.texel(x, y)[2], averageAlbedo(Distribution::ggx, perceptual_roughness));
    }
}

TEST(BrdfTable, LookUpsOnWarpedAxesAreRightEverywhere) {
  for (const Distribution distribution : {Distribution::ggx, Distribution::blinn}) {
    const Image table = *brdfTable({.distribution = distribution, .axes = BrdfAxes::warped});
    const WorstError worst = worstOf(table, distribution, 0.0f, 1.0f, [&](float perceptual_roughness, float cosine) {
      return formula::brdfTableCoordinates(perceptual_roughness, cosine, static_cast<float>(table.width()));
    });
    RecordProperty(distribution == Distribution::ggx ? "ggx" : "blinn", textOf(worst));
    EXPECT_LT(worst.error, 0.002f) << textOf(worst);
  }
}

TEST(BrdfTable, TheCornersOfWarpedAxesAreTheEndsOfBothRanges) {
  const Image table = *brdfTable({.size = 16, .axes = BrdfAxes::warped});
  EXPECT_NEAR(table.texel(15, 0)[0], 1.0f, 1e-4f) << "smooth, at normal incidence";
  EXPECT_NEAR(table.texel(0, 0)[1], 1.0f, 1e-3f) << "smooth, grazing";
  EXPECT_NEAR(table.texel(15, 15)[0] + table.texel(15, 15)[1], 1.0f - std::log(2.0f), 1e-4f)
      << "rough, at normal incidence";
}

// Between the centres of its texels and away from the smooth grazing corner, a table of linear axes is right too. In
// the corner it cannot be, and half a texel from its ends the hardware repeats the last texel: techniques/materials.md.
TEST(BrdfTable, LookUpsOnLinearAxesAreWrongInTheCornerAndAtTheEnds) {
  const Image table = *brdfTable({});
  const auto worst = [&](float min, float max) {
    return worstOf(table, Distribution::ggx, min, max,
                   [](float perceptual_roughness, float cosine) { return glm::vec2(cosine, perceptual_roughness); });
  };
  const float half_texel = 0.5f / 128.0f;
  const WorstError inside = worst(0.06f, 1.0f - half_texel);
  const WorstError with_ends = worst(0.06f, 1.0f);
  const WorstError anywhere = worst(0.0f, 1.0f);
  RecordProperty("inside", textOf(inside));
  RecordProperty("with_ends", textOf(with_ends));
  RecordProperty("anywhere", textOf(anywhere));
  EXPECT_LT(inside.error, 0.002f) << textOf(inside);
  EXPECT_LT(with_ends.error, 0.005f) << textOf(with_ends);
  EXPECT_GT(with_ends.error, inside.error);
  EXPECT_NEAR(anywhere.error, 0.09f, 0.02f) << textOf(anywhere);
}

TEST(BrdfTable, IsTheSameForAnyNumberOfThreads) {
  const Image many = *brdfTable({.size = 32, .channels = 3});
  const testing::OneThread one;
  const Image single = *brdfTable({.size = 32, .channels = 3});
  EXPECT_TRUE(std::equal(many.samples().begin(), many.samples().end(), single.samples().begin()));
}

TEST(BrdfTable, StopsWhenItIsTold) {
  const auto stopped =
      brdfTable({.size = 4096}, [](std::size_t done, std::size_t total) { return done < 2 && total == 4096; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST(BrdfTable, RefusesWhatHasNoTable) {
  EXPECT_EQ(brdfTable({.size = 1}).error().code, ErrorCode::usage);
  EXPECT_EQ(brdfTable({.size = 5000}).error().message, "a BRDF table has 2 to 4096 texels a side, not 5000");
  EXPECT_EQ(brdfTable({.distribution = Distribution::charlie, .axes = BrdfAxes::warped}).error().code,
            ErrorCode::usage);
}

}  // namespace
}  // namespace mirrorball
