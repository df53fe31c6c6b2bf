#include "mirrorball/image/level_sheet.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Levels from that size down to one texel, each filled with its number + 1.
std::vector<Image> levelsFrom(int width, int height) {
  std::vector<Image> levels;
  for (int level = 0; width >> level > 0 || height >> level > 0; ++level)
    levels.emplace_back(std::max(width >> level, 1), std::max(height >> level, 1), 1, static_cast<float>(level + 1));
  return levels;
}

TEST(LevelSheet, OfASquareTheSmallerOnesAreOnTheRightOneBelowTheOther) {
  const Image sheet = levelSheet(levelsFrom(8, 8));
  EXPECT_EQ(glm::ivec2(sheet.width(), sheet.height()), glm::ivec2(13, 8));
  EXPECT_EQ(*sheet.texel(7, 7), 1.0f);
  EXPECT_EQ(*sheet.texel(8, 0), 0.0f) << "the gap";
  EXPECT_EQ(*sheet.texel(9, 0), 2.0f);
  EXPECT_EQ(*sheet.texel(12, 3), 2.0f);
  EXPECT_EQ(*sheet.texel(10, 5), 3.0f);
  EXPECT_EQ(*sheet.texel(9, 6), 4.0f);
  EXPECT_EQ(*sheet.texel(11, 5), 0.0f);
  EXPECT_EQ(*sheet.texel(9, 7), 0.0f);
}

TEST(LevelSheet, OfAPanoramaTheyAreSideBySideBelowIt) {
  const Image sheet = levelSheet(levelsFrom(16, 8));
  EXPECT_EQ(glm::ivec2(sheet.width(), sheet.height()), glm::ivec2(16, 13));
  EXPECT_EQ(*sheet.texel(15, 7), 1.0f);
  EXPECT_EQ(*sheet.texel(0, 8), 0.0f) << "the gap";
  EXPECT_EQ(*sheet.texel(0, 9), 2.0f);
  EXPECT_EQ(*sheet.texel(7, 12), 2.0f);
  EXPECT_EQ(*sheet.texel(11, 10), 3.0f);
  EXPECT_EQ(*sheet.texel(14, 9), 5.0f);
  EXPECT_EQ(*sheet.texel(15, 9), 0.0f);
  EXPECT_EQ(*sheet.texel(11, 11), 0.0f);
}

TEST(LevelSheet, OfOneLevelItIsThatLevel) {
  const Image level(3, 5, 4, 0.5f);
  const Image sheet = levelSheet({&level, 1});
  EXPECT_EQ(glm::ivec2(sheet.width(), sheet.height()), glm::ivec2(3, 5));
  EXPECT_EQ(sheet.channels(), 4);
  for (const float sample : sheet.samples()) EXPECT_EQ(sample, 0.5f);
}

TEST(LevelSheet, NoLevelIsCutOff) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(5, 5), glm::ivec2(12, 9), glm::ivec2(9, 12),
                                glm::ivec2(6, 1), glm::ivec2(1, 6), glm::ivec2(30, 15)}) {
    const std::vector<Image> levels = levelsFrom(size.x, size.y);
    std::vector<std::size_t> found(levels.size() + 1);
    const Image sheet = levelSheet(levels);
    for (const float sample : sheet.samples()) ++found[static_cast<std::size_t>(sample)];
    for (std::size_t level = 0; level < levels.size(); ++level)
      EXPECT_EQ(found[level + 1], levels[level].texelCount()) << size.x << "x" << size.y << ", level " << level;
  }
}

}  // namespace
}  // namespace mirrorball
