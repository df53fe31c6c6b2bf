#include "mirrorball/environment/file/picture_meaning.h"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/file/photo_sphere_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kHalfOfPanorama;
using testing::packetWith;
using testing::sphereIn;

/// The meaning of a picture of that size by a hint; its oddities.
PictureMeaning meant(glm::ivec2 size, const std::string& attributes, std::string_view hint = "",
                     const Metadata& metadata = {}) {
  auto meaning = readMeaning(size, metadata, sphereIn(packetWith(attributes)), *formHintNamed(hint));
  EXPECT_TRUE(meaning) << meaning.error().message;
  return meaning ? *meaning : PictureMeaning{};
}

TEST(PictureMeaning, APhotoSpheresPartIsToldWithWhatFillsTheRest) {
  const PictureMeaning part = meant({256, 128}, kHalfOfPanorama);
  EXPECT_EQ(part.recognition.told_by, "its GPano");
  ASSERT_TRUE(part.part);
  EXPECT_EQ(part.part->begin, glm::dvec2(0.25));
  EXPECT_THAT(
      part.oddities,
      ElementsAre("holds 180 x 90 degrees of a panorama, as its GPano says: the rest of the sphere is black, and "
                  "lights nothing; {option:from} equirect:fill=smooth continues the picture into it, "
                  "{option:from} equirect:crop=none takes the picture as the whole"));
  EXPECT_TRUE(meant({100, 50}, kHalfOfPanorama).part) << "scaled afterwards";
  EXPECT_TRUE(meant({256, 128}, kHalfOfPanorama, "equirect:centre=-z").part) << "the hint says nothing of it";
  EXPECT_THAT(meant({256, 128}, kHalfOfPanorama, "equirect:fill=black").oddities, IsEmpty());
  EXPECT_FALSE(meant({256, 128}, kHalfOfPanorama, "equirect:crop=none").changesPicture());
  EXPECT_FALSE(meant({256, 128}, kHalfOfPanorama, "paraboloid").changesPicture());
  EXPECT_FALSE(meant({256, 128}, kHalfOfPanorama, "", {{"mirrorball:projection", "equirect"}}).changesPicture())
      << "what a file of ours says of itself comes first";
  EXPECT_FALSE(meant({256, 128}, kHalfOfPanorama, "equirect:for=openexr").changesPicture());
}

TEST(PictureMeaning, APartThatDoesNotFitItsPictureIsIgnoredAndTold) {
  const PictureMeaning filled = meant({512, 256}, kHalfOfPanorama);
  EXPECT_FALSE(filled.part);
  EXPECT_THAT(filled.oddities, ElementsAre(HasSubstr("has the size of the whole: taken as the whole")));
  std::string strip = kHalfOfPanorama;
  strip.replace(strip.find("\"256\" GPano:CroppedAreaImageH"), 5, "\"384\"");
  const PictureMeaning other = meant({256, 128}, strip);
  EXPECT_FALSE(other.part);
  EXPECT_THAT(other.oddities, ElementsAre(HasSubstr("has not that part's proportion, as 256x128")));
}

TEST(PictureMeaning, AWholePhotoSphereStaysAsItIs) {
  const std::string whole =
      "GPano:ProjectionType=\"equirectangular\" GPano:FullPanoWidthPixels=\"512\" GPano:FullPanoHeightPixels=\"256\" "
      "GPano:CroppedAreaImageWidthPixels=\"512\" GPano:CroppedAreaImageHeightPixels=\"256\" "
      "GPano:CroppedAreaLeftPixels=\"0\" GPano:CroppedAreaTopPixels=\"0\" GPano:PosePitchDegrees=\"0.0\"";
  for (const glm::ivec2 size : {glm::ivec2(512, 256), glm::ivec2(1024, 512)}) {
    const PictureMeaning meaning = meant(size, whole);
    EXPECT_FALSE(meaning.changesPicture());
    EXPECT_THAT(meaning.oddities, IsEmpty());
  }
}

TEST(PictureMeaning, ATiltIsUndoneUnlessItIsToStay) {
  const std::string tilted =
      "GPano:ProjectionType='equirectangular' GPano:PosePitchDegrees='4' GPano:PoseRollDegrees='-2'";
  const PictureMeaning meaning = meant({512, 256}, tilted);
  ASSERT_TRUE(meaning.tilt);
  EXPECT_EQ(meaning.tilt->pitch_deg, 4.0);
  EXPECT_THAT(meaning.oddities, ElementsAre(HasSubstr("(pitch 4, roll -2 degrees): levelled; {option:from} "
                                                      "equirect:level=no leaves it as it is")));
  EXPECT_FALSE(meant({512, 256}, tilted, "equirect:level=no").tilt);
  EXPECT_TRUE(meant({512, 256}, tilted, "equirect:crop=none").tilt);
}

TEST(PictureMeaning, OtherProjectionsOfPhotoSpheresAreNamed) {
  const auto cylinder = sphereIn(packetWith("GPano:ProjectionType=\"cylindrical\""));
  const auto meaning = readMeaning({512, 256}, {}, cylinder, {});
  ASSERT_FALSE(meaning);
  EXPECT_EQ(meaning.error().code, ErrorCode::bad_shape);
  EXPECT_EQ(meaning.error().fix_hint, FixHint::name_form);
  EXPECT_THAT(meaning.error().message, HasSubstr("in the projection 'cylindrical', as its GPano says"));
  EXPECT_TRUE(readMeaning({512, 256}, {}, cylinder, *formHintNamed("equirect"))) << "who says it knows better";
}

TEST(PictureMeaning, NearlyTwoToOneIsResampledAndTold) {
  const PictureMeaning meaning = meant({4096, 2047}, "");
  ASSERT_TRUE(meaning.part && meaning.part->isWhole());
  EXPECT_EQ(meaning.recognition.told_by, "its shape, nearly 2:1");
  EXPECT_THAT(meaning.oddities,
              ElementsAre("is nearly 2:1, 4096x2047: taken as a whole panorama, resampled to 4096x2048"));
  EXPECT_TRUE(meant({8191, 4096}, "", "equirect").part);
}

TEST(PictureMeaning, APartIsNamedByHand) {
  const PictureMeaning meaning = meant({256, 64}, "", "equirect:fov=360x90,centre=+x");
  ASSERT_TRUE(meaning.part);
  EXPECT_EQ(meaning.recognition.form.centre, SignedAxis::plus_x);
  EXPECT_THAT(meaning.oddities, ElementsAre(HasSubstr("the word fill=smooth behind its crop or fov")));
  EXPECT_EQ(meant({256, 128}, kHalfOfPanorama, "equirect:fov=90x45").part->begin.x, 0.375)
      << "before what the file says";
  const auto wrong = readMeaning({300, 200}, {}, {}, *formHintNamed("equirect:fov=360x90"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message, "is 300x200, and 360 x 90 degrees of a panorama are 4:1");
}

/// Files of grey panoramas, which are read by rows where they need not be completed.
class CompletedPanoramaTest : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// A Radiance picture, with a packet in a comment of its header.
  std::string panorama(glm::ivec2 size, const std::string& attributes = "") const {
    const std::string path = (folder_ / "map.hdr").string();
    EXPECT_TRUE(writeImage(path, Image(size.x, size.y, 3, 0.5f)));
    Bytes bytes = *readFile(path);
    const std::string comment = "# " + packetWith(attributes) + "\n";
    const auto behind_first_line = std::find(bytes.begin(), bytes.end(), '\n') + 1;
    bytes.insert(behind_first_line, comment.begin(), comment.end());
    EXPECT_TRUE(writeFile(path, bytes));
    return path;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("mirrorball_completed_test_" + std::to_string(::getpid()));
};

TEST_F(CompletedPanoramaTest, RowsAreReadOnlyOfWhatStaysAsItIs) {
  const auto isByRows = [](const std::string& path, std::string_view from = "") {
    const auto rows = openPanorama(path, {.from = *formHintNamed(from)});
    EXPECT_TRUE(rows) << rows.error().message;
    return rows && rows->has_value();
  };
  EXPECT_TRUE(isByRows(panorama({512, 256})));
  EXPECT_FALSE(isByRows(panorama({512, 255})));
  EXPECT_FALSE(isByRows(panorama({256, 128}, kHalfOfPanorama)));
  EXPECT_TRUE(isByRows(panorama({256, 128}, kHalfOfPanorama), "equirect:crop=none"));
  EXPECT_FALSE(isByRows(panorama({256, 128}), "equirect:fov=180x90"));
  const std::string tilted = "GPano:PosePitchDegrees='4'";
  EXPECT_FALSE(isByRows(panorama({256, 128}, tilted)));
  EXPECT_TRUE(isByRows(panorama({256, 128}, tilted), "equirect:level=no"));
}

TEST_F(CompletedPanoramaTest, WhatIsLoadedIsTheWholeAndSaysWhatOfItTheFileHolds) {
  const auto loaded = loadEnvironment(panorama({256, 128}, kHalfOfPanorama));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->file_size, glm::ivec2(256, 128));
  EXPECT_EQ(loaded->environment.map()->extent(), glm::ivec2(512, 256));
  ASSERT_TRUE(loaded->window);
  EXPECT_EQ(loaded->window->corner, glm::ivec2(128, 64));
  EXPECT_EQ(loaded->oddities.size(), 1u);
  EXPECT_EQ(loaded->environment.radiance({0, 0, 1}), glm::vec3(0.5f));
  EXPECT_EQ(loaded->environment.radiance({0, 0, -1}), glm::vec3(0.0f));
  const auto level = loadEnvironment(panorama({256, 128}, "GPano:PoseRollDegrees='90'"));
  ASSERT_TRUE(level) << level.error().message;
  EXPECT_TRUE(level->is_levelled);
  EXPECT_NEAR(level->environment.radiance({0, 1, 0}).x, 0.5f, 1e-4f);
}

// The smaller levels of a texture are not those of the panorama that was made of it.
TEST_F(CompletedPanoramaTest, LevelsOfATextureThatWasCompletedAreNotItsOwn) {
  const std::string path = (folder_ / "map.ktx2").string();
  ImageSet levels(2, 1);
  levels.at(0, 0) = Image(512, 255, 3, 0.5f);
  levels.at(1, 0) = Image(256, 127, 3, 0.5f);
  ASSERT_TRUE(writeImageSet(path, levels));
  const auto loaded = loadEnvironment(path);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->environment.map()->extent(), glm::ivec2(512, 256));
  const auto own = loadLevels(*loaded, {Projection::equirect});
  ASSERT_TRUE(own) << own.error().message;
  EXPECT_FALSE(*own);
}

}  // namespace
}  // namespace mirrorball
