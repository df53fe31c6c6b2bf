#include "mirrorball/render/surface/pixel_cells.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "formula/prefilter.h"

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

/// In sides of a square of a cell's area.
float farthestFromItsCell(int samples) {
  const auto cells = pixelCells(samples);
  float farthest = 0.0f;
  for (int i = 0; i < samples; ++i)
    farthest = std::max(farthest, glm::distance(placeOfSample(i, samples), cells[std::size_t(i)].middle));
  return farthest * std::sqrt(static_cast<float>(samples));
}

TEST(PixelCells, ASampleLiesNearItsCell) {
  for (int samples = 1; samples <= 65; ++samples) EXPECT_LT(farthestFromItsCell(samples), 1.1f) << samples;
  for (const int samples : {100, 128, 256}) EXPECT_LT(farthestFromItsCell(samples), 1.75f) << samples;
  for (const int samples : {393, 512, 1024}) EXPECT_LT(farthestFromItsCell(samples), 3.0f) << samples;
}

// A cell is a look-up of its own, so that long ones are seen worse.
TEST(PixelCells, NoneIsMuchLongerThanWide) {
  for (int samples = 1; samples <= 65; ++samples)
    for (const PixelCell& cell : pixelCells(samples)) {
      const float longer = std::max(cell.size.x, cell.size.y) / std::min(cell.size.x, cell.size.y);
      EXPECT_LT(longer, samples == 5 ? 5.01f : 3.3f) << samples;  // of 5 the one in the middle
    }
}

// The first pairs of samples decide whether others are needed (PixelMask), and pixels may end after any.
TEST(PixelCells, OfAPairTheMeanIsThePixelsMiddle) {
  for (int samples = 1; samples <= 128; ++samples) {
    const auto cells = pixelCells(samples);
    const std::size_t alone = cells.size() % 2;
    if (alone == 1) EXPECT_LT(glm::distance(cells[0].middle, glm::vec2(0.5f)), 1e-5f) << samples;
    for (std::size_t i = alone; i < cells.size(); i += 2) {
      EXPECT_LT(glm::distance(cells[i].middle + cells[i + 1].middle, glm::vec2(1.0f)), 1e-5f) << samples << ": " << i;
      EXPECT_LT(glm::distance(cells[i].size, cells[i + 1].size), 1e-6f) << samples << ": " << i;
    }
  }
}

// Of a pair each lobe of a row reads parts of the cells that are mirror images; of a round, all parts.
TEST(PixelCells, LobesOfARowReadEachPartInAPairsBalance) {
  for (const int lobes : {2, 4, 6})
    for (const int samples : {lobes, lobes + 1, 4 * lobes, 4 * lobes + 1}) {
      const int alone = samples % 2;
      std::vector<std::vector<int>> reads(std::size_t(lobes), std::vector<int>(std::size_t(lobes), 0));
      for (int i = alone; i < samples; ++i) {
        std::vector<int> of_sample;
        for (int lobe = 0; lobe < lobes; ++lobe) {
          const int part = formula::partOfLobe(lobe, lobes, i, samples);
          ASSERT_TRUE(part >= 0 && part < lobes) << part;
          of_sample.push_back(part);
          ++reads[std::size_t(lobe)][std::size_t(part)];
          const int partner = alone + ((i - alone) ^ 1);
          EXPECT_EQ(formula::partOfLobe(lobe, lobes, partner, samples), lobes - 1 - part) << samples << ": " << i;
        }
        std::sort(of_sample.begin(), of_sample.end());
        for (int lobe = 0; lobe < lobes; ++lobe) EXPECT_EQ(of_sample[std::size_t(lobe)], lobe) << samples << ": " << i;
      }
      for (const auto& of_lobe : reads)
        for (const int count : of_lobe) EXPECT_EQ(count, (samples - alone) / lobes) << samples;
      if (alone == 1) EXPECT_EQ(formula::partOfLobe(0, lobes, 0, samples), -1);
    }
  for (const int lobe : {0, 1, 2, 3}) {
    EXPECT_EQ(formula::partOfLobe(lobe, 4, 0, 1), -1);
    EXPECT_EQ(formula::partOfLobe(lobe, 4, 1, 2), -1);
  }
}

TEST(PixelCells, ACameraIsShiftedByPartsOfAPixel) {
  Camera camera;
  camera.clip_from_view = glm::mat4(1.0f);
  const Camera shifted = shiftedInPixel(camera, {0.5f, -1.0f}, {10, 20});
  const glm::vec4 clip = shifted.clip_from_view * glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  EXPECT_NEAR(clip.x, 0.1f, 1e-6f);
  EXPECT_NEAR(clip.y, -0.1f, 1e-6f);
  const Camera back = shiftedInPixel(shifted, {-0.5f, 1.0f}, {10, 20});
  EXPECT_LT(glm::length((back.clip_from_view - camera.clip_from_view)[3]), 1e-6f);
}

}  // namespace
}  // namespace mirrorball
