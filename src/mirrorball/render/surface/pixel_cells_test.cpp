#include "mirrorball/render/surface/pixel_cells.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

bool isIn(const PixelCell& cell, glm::vec2 place) {
  const glm::vec2 beside = glm::abs(place - cell.middle);
  return beside.x < 0.5f * cell.size.x && beside.y < 0.5f * cell.size.y;
}

TEST(PixelCells, OfOneSampleItIsThePixel) {
  const auto cells = pixelCells(1);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].middle, glm::vec2(0.5f));
  EXPECT_EQ(cells[0].size, glm::vec2(1.0f));
  EXPECT_EQ(placeOfSample(0, 1), glm::vec2(0.5f));
}

TEST(PixelCells, EachPlaceOfThePixelIsInOneCell) {
  for (const int samples : {1, 2, 3, 4, 5, 7, 9, 16, 17, 64, 100}) {
    const auto cells = pixelCells(samples);
    ASSERT_EQ(cells.size(), std::size_t(samples));
    for (const PixelCell& cell : cells) EXPECT_NEAR(cell.size.x * cell.size.y * float(samples), 1.0f, 1e-5f);
    for (float y = 0.0123f; y < 1.0f; y += 0.0371f)
      for (float x = 0.0117f; x < 1.0f; x += 0.0371f)
        EXPECT_EQ(std::count_if(cells.begin(), cells.end(),
                                [&](const PixelCell& c) {
                                  return isIn(c, {x, y});
                                }),
                  1)
            << samples << " samples: " << x << " " << y;
  }
}

TEST(PixelCells, ASampleLiesNearItsCell) {
  for (const int samples : {2, 4, 9, 16, 64, 256}) {
    const auto cells = pixelCells(samples);
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
      const glm::vec2 beside = placeOfSample(i, samples) - cells[std::size_t(i)].middle;
      sum += double(glm::dot(beside, beside)) * samples;
    }
    // In areas of a cell; a place at random in the pixel would be `samples` / 3 away.
    EXPECT_LT(sum / samples, std::min(1.0, samples / 6.0)) << samples;
  }
}

// The first pair of samples decides whether others are needed (PixelMask).
TEST(PixelCells, OfAPairTheMeanIsThePixelsMiddle) {
  for (const int samples : {2, 4, 16, 64}) {
    const auto cells = pixelCells(samples);
    for (std::size_t i = 0; i < cells.size(); i += 2)
      EXPECT_LT(glm::distance(cells[i].middle + cells[i + 1].middle, glm::vec2(1.0f)), 1e-5f) << samples << ": " << i;
  }
}

}  // namespace
}  // namespace mirrorball
