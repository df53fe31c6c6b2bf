#include "mirrorball/study/section_sheet.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::ElementsAre;

constexpr std::uint8_t kRed = 200;

StudiedPicture drawnPicture(const std::string& technique, double psnr_dB, double frame_ms, glm::ivec2 size) {
  StudiedPicture picture{.technique = technique, .settings = "", .picture = Image8(size.x, size.y, 3, kRed)};
  picture.values[static_cast<std::size_t>(Metric::psnr)] = psnr_dB;
  picture.drawn = DrawCost{.frame_ms = frame_ms, .light = {}};
  return picture;
}

StudiedShot shotOf(glm::ivec2 size) {
  StudiedShot shot{.label = "30", .reference = Image8(size.x, size.y, 3, kRed)};
  shot.pictures.push_back(drawnPicture("bump", 20.126, 2.0, size));
  shot.pictures.push_back(drawnPicture("exact", std::numeric_limits<double>::infinity(), 5.0, size));
  return shot;
}

int countOf(const Image8& picture, int code) {
  int count = 0;
  for (const std::uint8_t sample : picture.samples()) count += sample == code ? 1 : 0;
  return count / 3;
}

TEST(SectionSheet, WordsAreOfErrorAndCost) {
  const StudiedShot shot = shotOf({8, 8});
  EXPECT_THAT(wordsOf(shot.pictures[0], shot, "bump"), ElementsAre("bump", "20.13 dB", "2.00 ms", "1.00 x bump"));
  EXPECT_THAT(wordsOf(shot.pictures[1], shot, "bump"), ElementsAre("exact", "infinite", "5.00 ms", "2.50 x bump"));
}

// Nothing is drawn over a picture, and each is there whole: two techniques and the reference in each of two rows.
TEST(SectionSheet, HasAllPicturesWhole) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(20, 300), glm::ivec2(300, 20)}) {
    StudiedSection section;
    section.axis = "degrees above the plane";
    section.shots = {shotOf(size), shotOf(size)};
    const Image8 sheet = sectionSheet(section, "bump");
    EXPECT_EQ(countOf(sheet, kRed), 2 * 3 * size.x * size.y) << size.x << " x " << size.y;
    section.shots.pop_back();
    EXPECT_LT(sectionSheet(section, "bump").height(), sheet.height());
  }
}

}  // namespace
}  // namespace mirrorball
