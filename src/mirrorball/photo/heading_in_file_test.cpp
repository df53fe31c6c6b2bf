#include "mirrorball/photo/heading_in_file.h"

#include <string>

#include <gtest/gtest.h>

#include "mirrorball/photo/exif_testing.h"

namespace mirrorball {
namespace {

std::optional<CompassHeading> headingOfText(const std::string& text) {
  return headingIn({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// A packet with these attributes.
std::string packet(const std::string& attributes) {
  return "\xff\xd8 some bytes <x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description "
         "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\" " +
         attributes + "/></rdf:RDF></x:xmpmeta> more";
}

Bytes withDirection(double degrees, bool is_magnetic) {
  return testing::withExif({0xff, 0xd8, 0xff, 0xd9},
                           {.image_direction_deg = degrees, .is_direction_magnetic = is_magnetic});
}

TEST(HeadingInFile, APhotoSphereStatesItsPose) {
  const auto heading =
      headingOfText(packet("GPano:PoseHeadingDegrees=\"330.5\" GPano:PosePitchDegrees='-2' "
                           "GPano:PoseRollDegrees=\"1.5\""));
  ASSERT_TRUE(heading);
  EXPECT_EQ(heading->heading_deg, 330.5);
  EXPECT_EQ(heading->pitch_deg, -2.0);
  EXPECT_EQ(heading->roll_deg, 1.5);
  EXPECT_FALSE(heading->is_magnetic);
  EXPECT_EQ(heading->source, "GPano:PoseHeadingDegrees");
  const auto element = headingOfText(
      "<rdf:Description xmlns:pano='http://ns.google.com/photos/1.0/panorama/'>"
      "<pano:PoseHeadingDegrees> -30 </pano:PoseHeadingDegrees></rdf:Description>");
  ASSERT_TRUE(element) << "an element, another prefix";
  EXPECT_EQ(element->heading_deg, 330.0);
  EXPECT_EQ(headingOfText(packet("GPano:PoseHeadingDegrees=\"360\""))->heading_deg, 0.0);
}

TEST(HeadingInFile, WhatIsNoAngleIsAbsent) {
  for (const std::string attributes :
       {"", "GPano:ProjectionType=\"equirectangular\"", "GPano:PoseHeadingDegrees=\"\"",
        "GPano:PoseHeadingDegrees=\"north\"", "GPano:PoseHeadingDegrees=\"nan\"", "GPano:PoseHeadingDegrees=\"1e9\"",
        "GPano:PoseHeadingDegrees=\"inf\"", "GPano:PoseHeadingDegrees=\"20", "GPano:PoseHeadingDegrees",
        "GPano:PoseHeadingDegrees=\"20\" GPano:PosePitchDegrees=\"200\""})
    EXPECT_FALSE(headingOfText(packet(attributes))) << attributes;
  EXPECT_FALSE(headingOfText("GPano:PoseHeadingDegrees=\"20\"")) << "of another namespace";
  EXPECT_FALSE(headingIn({}));
}

TEST(HeadingInFile, ExifHasTheCamerasDirection) {
  const auto found = headingIn(withDirection(123.25, false));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->heading_deg, 123.25, 1e-4);
  EXPECT_FALSE(found->is_magnetic);
  EXPECT_EQ(found->source, "GPSImgDirection");
  EXPECT_TRUE(headingIn(withDirection(20.0, true))->is_magnetic);
  EXPECT_FALSE(headingIn(withDirection(400.0, false))) << "not a direction";
  EXPECT_FALSE(headingIn(testing::withExif({0xff, 0xd8, 0xff, 0xd9}, {.iso = 100.0})));
}

TEST(HeadingInFile, AFolderAndNothingHaveNone) {
  const auto folder = headingInFile(std::filesystem::temp_directory_path());
  ASSERT_TRUE(folder);
  EXPECT_FALSE(*folder);
  const auto nothing = headingInFile("an absent file");
  ASSERT_TRUE(nothing);
  EXPECT_FALSE(*nothing);
}

}  // namespace
}  // namespace mirrorball
