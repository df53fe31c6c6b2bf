#include "mirrorball/environment/file/photo_sphere.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/file/picture_meaning.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string packetWith(const std::string& attributes) {
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description "
         "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" " +
         attributes + "/></rdf:RDF></x:xmpmeta>";
}

const std::string kCrop =
    "GPano:ProjectionType=\"equirectangular\" GPano:FullPanoWidthPixels=\"512\" GPano:FullPanoHeightPixels=\"256\" "
    "GPano:CroppedAreaImageWidthPixels=\"256\" GPano:CroppedAreaImageHeightPixels=\"128\" "
    "GPano:CroppedAreaLeftPixels=\"128\" GPano:CroppedAreaTopPixels=\"64\"";

std::optional<PhotoSphere> sphereIn(const std::string& text) {
  return photoSphereIn({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(PhotoSphere, ItsPacketStatesPartAndPose) {
  const auto sphere =
      sphereIn("\xff\xd8 bytes " +
               packetWith(kCrop + " GPano:PosePitchDegrees=\"-3.5\" GPano:PoseRollDegrees=\"359\"") + " more");
  ASSERT_TRUE(sphere);
  EXPECT_TRUE(sphere->isEquirectangular());
  ASSERT_TRUE(sphere->area);
  EXPECT_EQ(sphere->area->corner, glm::ivec2(128, 64));
  EXPECT_EQ(sphere->area->size, glm::ivec2(256, 128));
  EXPECT_EQ(sphere->area->whole, glm::ivec2(512, 256));
  EXPECT_EQ(sphere->pitch_deg, -3.5);
  EXPECT_EQ(sphere->roll_deg, -1.0);
  EXPECT_TRUE(sphere->isTilted());
  EXPECT_THAT(sphere->mistakes, IsEmpty());
}

TEST(PhotoSphere, WhereNothingIsSaidNothingIsFound) {
  EXPECT_FALSE(sphereIn(""));
  EXPECT_FALSE(sphereIn("GPano:PosePitchDegrees=\"3\""));
  EXPECT_FALSE(sphereIn(packetWith("GPano:UsePanoramaViewer=\"True\"")));
  const auto whole = sphereIn(packetWith("GPano:ProjectionType=\"Equirectangular\" GPano:FullPanoWidthPixels=\"512\""));
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->isEquirectangular()) << "in any case";
  EXPECT_FALSE(whole->area);
  EXPECT_FALSE(whole->isTilted());
  EXPECT_THAT(whole->mistakes, IsEmpty());
}

// A JPEG's extension of XMP is a second packet.
TEST(PhotoSphere, ALaterPacketCountsWhereTheFirstSaysNothing) {
  const auto sphere = sphereIn(packetWith("GPano:UsePanoramaViewer=\"True\"") + " 65 kB " + packetWith(kCrop));
  ASSERT_TRUE(sphere && sphere->area);
  EXPECT_EQ(sphere->area->size, glm::ivec2(256, 128));
}

TEST(PhotoSphere, TheEndOfALargeFileIsLookedThroughToo) {
  const std::string middle(std::size_t{3} << 20, ' ');
  EXPECT_TRUE(sphereIn(middle + packetWith(kCrop)));
  EXPECT_FALSE(sphereIn(middle + packetWith(kCrop) + middle));
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "mirrorball_photo_sphere_test";
  std::ofstream(path, std::ios::binary) << packetWith("") << middle << packetWith(kCrop);
  const auto ends = readEnds(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(ends) << ends.error().message;
  EXPECT_EQ(ends->size(), std::size_t{2} << 20);
  EXPECT_TRUE(photoSphereIn(*ends));
}

TEST(PhotoSphere, WhatCannotBeMeantIsToldAndLeftOut) {
  const auto mistakesIn = [](const std::string& attributes) {
    const auto sphere = sphereIn(packetWith(attributes));
    return sphere ? sphere->mistakes : std::vector<std::string>{"none"};
  };
  EXPECT_THAT(mistakesIn("GPano:PosePitchDegrees='200' GPano:PoseRollDegrees='3'"),
              ElementsAre(HasSubstr("its GPano:PosePitchDegrees is '200', which is not a number from -90 to 90")));
  EXPECT_FALSE(sphereIn(packetWith("GPano:PosePitchDegrees='200' GPano:PoseRollDegrees='3'"))->isTilted());
  EXPECT_THAT(mistakesIn("GPano:CroppedAreaImageWidthPixels='256'"),
              ElementsAre(HasSubstr("its GPano:CroppedAreaImageHeightPixels is missing")));
  const auto changed = [](std::string from, const std::string& to) {
    std::string attributes = kCrop;
    return attributes.replace(attributes.find(from), from.size(), to);
  };
  EXPECT_THAT(mistakesIn(changed("Left", "Lost")),
              ElementsAre(HasSubstr("its GPano:CroppedAreaLeftPixels is missing")));
  EXPECT_THAT(
      mistakesIn(changed("\"128\" GPano:CroppedAreaTop", "\"400\" GPano:CroppedAreaTop")),
      ElementsAre(HasSubstr("its GPano says that it is 256x128 at (400, 64), which reaches beyond a panorama of "
                            "512x256: that crop is ignored")));
  EXPECT_THAT(mistakesIn(changed("\"512\"", "\"300\"")), ElementsAre(HasSubstr("a whole panorama is 2:1")));
  for (const std::string number : {"1e30", "nan", "many", ""})
    EXPECT_THAT(mistakesIn(changed("\"512\"", "\"" + number + "\"")),
                ElementsAre(HasSubstr("in place of a number of texels")));
}

/// The meaning of a picture of that size by a hint; its oddities.
PictureMeaning meant(glm::ivec2 size, const std::string& attributes, std::string_view hint = "",
                     const Metadata& metadata = {}) {
  auto meaning = readMeaning(size, metadata, sphereIn(packetWith(attributes)), *formHintNamed(hint));
  EXPECT_TRUE(meaning) << meaning.error().message;
  return meaning ? *meaning : PictureMeaning{};
}

TEST(PictureMeaning, APhotoSpheresPartIsToldWithWhatFillsTheRest) {
  const PictureMeaning part = meant({256, 128}, kCrop);
  EXPECT_EQ(part.recognition.told_by, "its GPano");
  ASSERT_TRUE(part.part);
  EXPECT_EQ(part.part->begin, glm::dvec2(0.25));
  EXPECT_THAT(
      part.oddities,
      ElementsAre("holds 180 x 90 degrees of a panorama, as its GPano says: the rest of the sphere is black, and "
                  "lights nothing; {option:from} equirect:fill=smooth continues the picture into it, "
                  "{option:from} equirect:crop=none takes the picture as the whole"));
  EXPECT_TRUE(meant({100, 50}, kCrop).part) << "scaled afterwards";
  EXPECT_TRUE(meant({256, 128}, kCrop, "equirect:centre=-z").part) << "the hint says nothing of it";
  EXPECT_THAT(meant({256, 128}, kCrop, "equirect:fill=black").oddities, IsEmpty());
  EXPECT_FALSE(meant({256, 128}, kCrop, "equirect:crop=none").changesPicture());
  EXPECT_FALSE(meant({256, 128}, kCrop, "paraboloid").changesPicture());
  EXPECT_FALSE(meant({256, 128}, kCrop, "", {{"mirrorball:projection", "equirect"}}).changesPicture())
      << "what a file of ours says of itself comes first";
  EXPECT_FALSE(meant({256, 128}, kCrop, "equirect:for=openexr").changesPicture());
}

TEST(PictureMeaning, APartThatDoesNotFitItsPictureIsIgnoredAndTold) {
  const PictureMeaning filled = meant({512, 256}, kCrop);
  EXPECT_FALSE(filled.part);
  EXPECT_THAT(filled.oddities, ElementsAre(HasSubstr("has the size of the whole: taken as the whole")));
  std::string strip = kCrop;
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
  EXPECT_EQ(meant({256, 128}, kCrop, "equirect:fov=90x45").part->begin.x, 0.375) << "before what the file says";
  const auto wrong = readMeaning({300, 200}, {}, {}, *formHintNamed("equirect:fov=360x90"));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message, "is 300x200, and 360 x 90 degrees of a panorama are 4:1");
}

}  // namespace
}  // namespace mirrorball
