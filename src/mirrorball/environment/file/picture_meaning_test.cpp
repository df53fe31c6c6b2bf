#include "mirrorball/environment/file/picture_meaning.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/picture_window.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/environment_testing.h"
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

TEST(PictureMeaning, AWholeWiderThanTwoToOneIsRemarkedWithItsPart) {
  const PictureMeaning meaning = meant(
      {1024, 256},
      "GPano:ProjectionType=\"equirectangular\" GPano:FullPanoWidthPixels=\"1024\" GPano:FullPanoHeightPixels=\"256\" "
      "GPano:CroppedAreaImageWidthPixels=\"1024\" GPano:CroppedAreaImageHeightPixels=\"256\" "
      "GPano:CroppedAreaLeftPixels=\"0\" GPano:CroppedAreaTopPixels=\"0\"");
  ASSERT_TRUE(meaning.part);
  EXPECT_EQ(meaning.part->begin, glm::dvec2(0.0, 0.25));
  EXPECT_THAT(meaning.oddities, ElementsAre(HasSubstr("holds 360 x 90 degrees of a panorama, as its GPano says, whose "
                                                      "whole of 1024x256 is taken as a strip about the horizon: the")));
}

TEST(PictureMeaning, AnEyeOfAStereoPictureIsChosen) {
  const Image square(512, 512, 3, 0.5f);
  const auto chosen = [&](const Image& picture, const std::string& attributes, std::string_view hint = "") {
    return chooseEye(picture, {}, sphereIn(packetWith(attributes)), *formHintNamed(hint));
  };
  const StereoEye stated = chosen(square, "GPano:StereoMode='top-bottom'");
  EXPECT_EQ(stated.half, PictureHalf::top);
  EXPECT_EQ(
      stated.oddity,
      "is a stereo picture, as its StereoMode says: the upper one is read; {option:from} equirect:eye=bottom reads "
      "the other");
  EXPECT_EQ(chosen(Image(1024, 256, 3), "GPano:StereoMode='left-right'").half, PictureHalf::left);
  EXPECT_FALSE(stated.is_squeezed);
  const StereoEye thin = chosen(square, "GPano:StereoMode='left-right'");
  EXPECT_EQ(thin.half, std::nullopt);
  EXPECT_EQ(thin.oddity,
            "is a stereo picture, as its StereoMode 'left-right' says, and 512x512 is not the shape of one: taken as "
            "one picture");
  EXPECT_EQ(chosen(square, "").half, std::nullopt) << "one colour shows nothing";
  EXPECT_EQ(chosen(square, "GPano:StereoMode='top-bottom'", "sphere").half, std::nullopt);
  const StereoEye named = chosen(square, "", "equirect:eye=bottom");
  EXPECT_EQ(named.half, PictureHalf::bottom);
  EXPECT_EQ(named.oddity, "");
  EXPECT_THAT(formHintNamed("equirect:eye=middle").error().message, HasSubstr("eye=top, bottom, left or right"));
}

TEST(PictureMeaning, EyesThatWereSqueezedIntoOnePanoramasFrameAreStretched) {
  const auto chosen = [&](glm::ivec2 size, const std::string& attributes, std::string_view hint = "") {
    return chooseEye(Image(size.x, size.y, 3, 0.5f), {}, sphereIn(packetWith(attributes)), *formHintNamed(hint));
  };
  const std::string above = "GPano:StereoMode='top-bottom'", beside = "GPano:StereoMode='left-right'";
  const StereoEye upper = chosen({256, 128}, above);
  EXPECT_EQ(upper.half, PictureHalf::top);
  EXPECT_TRUE(upper.is_squeezed);
  EXPECT_EQ(upper.oddity,
            "is a stereo picture, as its StereoMode says: the upper one is read, stretched to 2:1; {option:from} "
            "equirect:eye=bottom reads the other, {option:from} equirect:crop=none the whole as one panorama");
  const StereoEye left = chosen({256, 128}, beside);
  EXPECT_EQ(left.half, PictureHalf::left);
  EXPECT_TRUE(left.is_squeezed);
  EXPECT_THAT(left.oddity, HasSubstr("equirect:eye=left,fov=180x180 half a sphere"));
  EXPECT_TRUE(chosen({1920, 1080}, above).is_squeezed) << "the frame of a film";
  EXPECT_TRUE(chosen({1920, 1080}, above, "equirect:eye=bottom").is_squeezed);
  EXPECT_TRUE(chosen({256, 128}, "", "equirect:eye=bottom").is_squeezed);
  EXPECT_FALSE(chosen({256, 128}, beside, "equirect:eye=left,fov=180x180").is_squeezed);
  EXPECT_FALSE(chosen({256, 256}, "", "equirect:eye=left").is_squeezed) << "nobody says that";
  EXPECT_EQ(chosen({256, 128}, above, "equirect:crop=none").half, std::nullopt);
  EXPECT_EQ(chosen({256, 128}, "").half, std::nullopt);
  std::string half_sphere = kHalfOfPanorama + (" " + beside);
  half_sphere.replace(half_sphere.find("\"256\" GPano:CroppedAreaImageH"), 5, "\"128\"");
  const StereoEye part = chosen({256, 128}, half_sphere);
  EXPECT_EQ(part.half, PictureHalf::left);
  EXPECT_FALSE(part.is_squeezed) << "it is the part that it says";
  EXPECT_EQ(stretchedSize({256, 64}), glm::ivec2(256, 128));
  EXPECT_EQ(stretchedSize({128, 128}), glm::ivec2(256, 128));
}

TEST(PictureMeaning, TheWindowOfAPictureThatIsResampledIsThatOfTheMap) {
  const auto completed = [](std::string_view hint) {
    DecodedImage decoded{.image = Image(512, 255, 3)};
    decoded.window = PictureWindow{.whole = {512, 255}, .corner = {128, 85}, .source = "its window", .size = {256, 85}};
    for (int y = 85; y < 170; ++y) std::fill_n(decoded.image.texel(128, y), 3 * 256, 0.5f);
    const FormHint named = *formHintNamed(hint);
    const auto done = completePanorama(*readMeaning({512, 255}, {}, {}, named), named, decoded);
    EXPECT_TRUE(done) << done.error().message;
    EXPECT_EQ(decoded.image.height(), 256);
    return decoded;
  };
  const DecodedImage plain = completed("");
  ASSERT_TRUE(plain.window);
  EXPECT_EQ(plain.window->whole, glm::ivec2(512, 256));
  EXPECT_EQ(plain.window->corner, glm::ivec2(128, 85));
  EXPECT_EQ(plain.window->size, glm::ivec2(256, 86));
  const DecodedImage filled = completed("equirect:fill=smooth");
  for (const float sample : filled.image.samples()) ASSERT_NEAR(sample, 0.5f, 1e-3f) << "no black is mixed in";
}

// Remarks on what is missing may stand behind it.
TEST(PictureMeaning, TheRemarkOnAWindowIsKnownByItsWords) {
  const PictureWindow window{.whole = {512, 256}, .corner = {128, 64}, .source = "its window", .size = {256, 128}};
  std::vector<std::string> oddities{"a choice of layers", windowText(window), "3 rows are missing"};
  adviseOnRest(window, oddities);
  EXPECT_THAT(oddities, ElementsAre("a choice of layers",
                                    windowText(window) + ", and lights nothing; {option:from} equirect:fill=smooth "
                                                         "continues the picture into it",
                                    "3 rows are missing"));
}

/// Files of grey panoramas, which are read by rows where they need not be completed.
class CompletedPanoramaTest : public testing::FolderTest {
 protected:
  /// A Radiance picture, with a packet in a comment of its header.
  std::string panorama(glm::ivec2 size, const std::string& attributes = "") const {
    const std::string map = path("map.hdr");
    EXPECT_TRUE(writeImage(map, Image(size.x, size.y, 3, 0.5f)));
    Bytes bytes = *readFile(map);
    const std::string comment = "# " + packetWith(attributes) + "\n";
    const auto behind_first_line = std::find(bytes.begin(), bytes.end(), '\n') + 1;
    bytes.insert(behind_first_line, comment.begin(), comment.end());
    EXPECT_TRUE(writeFile(map, bytes));
    return map;
  }
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

TEST_F(CompletedPanoramaTest, APartGoesOnAcrossTheSeam) {
  std::string attributes = kHalfOfPanorama;
  attributes.replace(attributes.find("Left") + 12, 3, "384");
  const auto loaded = loadEnvironment(panorama({256, 128}, attributes));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->environment.map()->extent(), glm::ivec2(512, 256));
  ASSERT_TRUE(loaded->window);
  EXPECT_EQ(loaded->window->corner, glm::ivec2(384, 64));
  EXPECT_TRUE(loaded->window_goes_round);
  EXPECT_NEAR(shareOfSphere(*loaded->window, true), std::sqrt(0.125), 1e-6);
  for (const glm::vec3 d : {glm::vec3(0, 0, -1), glm::vec3(0.6f, 0, -0.8f), glm::vec3(-0.6f, 0, -0.8f)})
    EXPECT_EQ(loaded->environment.radiance(d), glm::vec3(0.5f));
  EXPECT_EQ(loaded->environment.radiance({0, 0, 1}), glm::vec3(0.0f));
  const auto filled =
      loadEnvironment(panorama({256, 128}, attributes), {.from = *formHintNamed("equirect:fill=smooth")});
  ASSERT_TRUE(filled) << filled.error().message;
  for (const glm::vec3 d : testing::manyDirections(100)) EXPECT_NEAR(filled->environment.radiance(d).x, 0.5f, 1e-3f);
  // The whole circle, from another meridian, between texels.
  const auto turned =
      loadEnvironment(panorama({512, 256}, ""), {.from = *formHintNamed("equirect:crop=1001,0,4096,2048/4096x2048")});
  ASSERT_TRUE(turned) << turned.error().message;
  EXPECT_FALSE(turned->window);
  EXPECT_TRUE(turned->oddities.empty());
  for (const glm::vec3 d : testing::manyDirections(100)) EXPECT_NEAR(turned->environment.radiance(d).x, 0.5f, 1e-3f);
}

TEST_F(CompletedPanoramaTest, OneEyeOfTwoIsLoaded) {
  const std::string path = (folder_ / "stereo.hdr").string();
  Image both(256, 256, 3, 0.25f);
  for (int y = 128; y < 256; ++y) std::fill_n(both.texel(0, y), 3 * 256, 0.75f);
  ASSERT_TRUE(writeImage(path, both));
  for (const auto& [hint, light] : {std::pair("equirect:eye=top", 0.25f), std::pair("equirect:eye=bottom", 0.75f)}) {
    EXPECT_FALSE(*openPanorama(path, {.from = *formHintNamed(hint)}));
    const auto loaded = loadEnvironment(path, {.from = *formHintNamed(hint)});
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->file_size, glm::ivec2(256));
    EXPECT_EQ(loaded->environment.map()->extent(), glm::ivec2(256, 128));
    EXPECT_EQ(loaded->environment.radiance({0, 0, 1}), glm::vec3(light));
  }
  ASSERT_TRUE(writeImage(path, Image(256, 128, 3, 0.5f)));
  const auto half = loadEnvironment(path, {.from = *formHintNamed("equirect:eye=left,fov=180x180")});
  ASSERT_TRUE(half) << half.error().message;
  EXPECT_EQ(half->environment.map()->extent(), glm::ivec2(256, 128));
  EXPECT_EQ(half->environment.radiance({0, 0, -1}), glm::vec3(0.0f));
  ASSERT_TRUE(writeImage(path, both));
  EXPECT_EQ(loadEnvironment(path, {.from = *formHintNamed("equirect:eye=left")}).error().code, ErrorCode::bad_shape);
}

TEST_F(CompletedPanoramaTest, ASqueezedEyeIsTheWholeSphere) {
  const std::string path = panorama({256, 128}, "GPano:StereoMode='top-bottom'");
  const auto loaded = loadEnvironment(path);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->file_size, glm::ivec2(256, 128));
  EXPECT_EQ(loaded->environment.map()->extent(), glm::ivec2(256, 128));
  EXPECT_THAT(loaded->oddities, ElementsAre(HasSubstr("the upper one is read, stretched to 2:1")));
  Image both(256, 128, 3, 0.25f);
  for (int y = 64; y < 128; ++y) std::fill_n(both.texel(0, y), 3 * 256, 0.75f);
  ASSERT_TRUE(writeImage(path, both));
  const auto lower = loadEnvironment(path, {.from = *formHintNamed("equirect:eye=bottom")});
  ASSERT_TRUE(lower) << lower.error().message;
  EXPECT_EQ(lower->environment.map()->extent(), glm::ivec2(256, 128));
  for (const glm::vec3 d : testing::manyDirections(100)) EXPECT_NEAR(lower->environment.radiance(d).x, 0.75f, 1e-6f);
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
