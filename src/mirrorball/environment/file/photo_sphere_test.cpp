#include "mirrorball/environment/file/photo_sphere.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/file/photo_sphere_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kHalfOfPanorama;
using testing::packetWith;
using testing::sphereIn;

TEST(PhotoSphere, ItsPacketStatesPartAndPose) {
  const auto sphere = sphereIn(
      "\xff\xd8 bytes " +
      packetWith(kHalfOfPanorama + " GPano:PosePitchDegrees=\"-3.5\" GPano:PoseRollDegrees=\"359\"") + " more");
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
  const auto sphere =
      sphereIn(packetWith("GPano:UsePanoramaViewer=\"True\"") + " 65 kB " + packetWith(kHalfOfPanorama));
  ASSERT_TRUE(sphere && sphere->area);
  EXPECT_EQ(sphere->area->size, glm::ivec2(256, 128));
}

TEST(PhotoSphere, TheEndOfALargeFileIsLookedThroughToo) {
  const std::string middle(std::size_t{3} << 20, ' ');
  EXPECT_TRUE(sphereIn(middle + packetWith(kHalfOfPanorama)));
  EXPECT_FALSE(sphereIn(middle + packetWith(kHalfOfPanorama) + middle));
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "mirrorball_photo_sphere_test";
  std::ofstream(path, std::ios::binary) << packetWith("") << middle << packetWith(kHalfOfPanorama);
  const auto ends = readEnds(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(ends) << ends.error().message;
  EXPECT_EQ(ends->size(), std::size_t{2} << 20);
  EXPECT_TRUE(photoSphereIn(*ends));
}

TEST(PhotoSphere, StereoIsStatedInEitherNamespace) {
  const auto sphere = sphereIn(packetWith("GPano:StereoMode=\"Top-Bottom\""));
  ASSERT_TRUE(sphere);
  EXPECT_EQ(sphere->stereo, "top-bottom");
  const auto video = sphereIn(
      "<rdf:SphericalVideo xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\">"
      "<GSpherical:StereoMode>left-right</GSpherical:StereoMode></rdf:SphericalVideo>");
  ASSERT_TRUE(video);
  EXPECT_EQ(video->stereo, "left-right");
  EXPECT_FALSE(video->isTilted());
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
    std::string attributes = kHalfOfPanorama;
    return attributes.replace(attributes.find(from), from.size(), to);
  };
  EXPECT_THAT(mistakesIn(changed("Left", "Lost")),
              ElementsAre(HasSubstr("its GPano:CroppedAreaLeftPixels is missing")));
  EXPECT_THAT(
      mistakesIn(changed("TopPixels=\"64\"", "TopPixels=\"200\"")),
      ElementsAre(HasSubstr("its GPano says that it is 256x128 at (128, 200), which reaches beyond a panorama of "
                            "512x256: that crop is ignored")));
  EXPECT_THAT(mistakesIn(changed("\"512\"", "\"300\"")), ElementsAre(HasSubstr("a whole panorama is 2:1")));
  for (const std::string number : {"1e30", "nan", "many", ""})
    EXPECT_THAT(mistakesIn(changed("\"512\"", "\"" + number + "\"")),
                ElementsAre(HasSubstr("in place of a number of texels")));
}

}  // namespace
}  // namespace mirrorball
