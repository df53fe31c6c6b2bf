#include "mirrorball/photo/heading_in_file.h"

#include <chrono>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/codec/exif_testing.h"

namespace mirrorball {
namespace {

Result<std::optional<CompassHeading>> headingInText(const std::string& text) {
  return headingIn({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// The one that is there; its source is empty where none is.
CompassHeading statedHeading(const std::string& text) {
  const auto heading = headingInText(text);
  return heading ? heading->value_or(CompassHeading{}) : CompassHeading{.source = heading.error().message};
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
  const CompassHeading heading = statedHeading(
      packet("GPano:PoseHeadingDegrees=\"330.5\" GPano:PosePitchDegrees='-2' GPano:PoseRollDegrees=\"1.5\""));
  EXPECT_EQ(heading.source, "GPano:PoseHeadingDegrees");
  EXPECT_EQ(heading.heading_deg, 330.5);
  EXPECT_EQ(heading.pitch_deg, -2.0);
  EXPECT_EQ(heading.roll_deg, 1.5);
  EXPECT_FALSE(heading.is_magnetic);
  const CompassHeading element = statedHeading(
      "<rdf:Description xmlns:pano='http://ns.google.com/photos/1.0/panorama/'>"
      "<pano:PoseHeadingDegrees> -30 </pano:PoseHeadingDegrees></rdf:Description>");
  EXPECT_EQ(element.source, "GPano:PoseHeadingDegrees") << "an element, another prefix";
  EXPECT_EQ(element.heading_deg, 330.0);
  EXPECT_EQ(statedHeading(packet("GPano:PoseHeadingDegrees=\"360\"")).heading_deg, 0.0);
}

TEST(HeadingInFile, ARollIsTheSameAfterAWholeTurnAndAPlusSignIsRead) {
  const auto rolled = [](const std::string& roll) {
    return statedHeading(
        packet("GPano:PoseHeadingDegrees='+20.5' GPano:PosePitchDegrees='+0' GPano:PoseRollDegrees='" + roll + "'"));
  };
  EXPECT_EQ(rolled("0").heading_deg, 20.5);
  EXPECT_EQ(rolled("+359.5").roll_deg, -0.5);
  EXPECT_EQ(rolled("-270").roll_deg, 90.0);
  EXPECT_EQ(rolled("180").roll_deg, 180.0);
  EXPECT_EQ(rolled("360").roll_deg, 0.0);
}

TEST(HeadingInFile, WhereNoneIsStatedNoneIsFound) {
  for (const std::string attributes :
       {"", "GPano:ProjectionType=\"equirectangular\"", "GPano:PoseHeadingDegrees", "GPano:PosePitchDegrees=\"200\""}) {
    const auto heading = headingInText(packet(attributes));
    ASSERT_TRUE(heading) << attributes;
    EXPECT_FALSE(*heading) << attributes;
  }
  EXPECT_FALSE(*headingInText("GPano:PoseHeadingDegrees=\"20\"")) << "of another namespace";
  EXPECT_FALSE(*headingInText(packet("") + "GPano:PoseHeadingDegrees=\"20\"")) << "behind the packet";
  EXPECT_FALSE(*headingIn({}));
}

// Also where EXIF has a heading, which is not taken in its place.
TEST(HeadingInFile, AnErrorNamesTheFieldThatIsNotAnAngle) {
  const auto refused = [](const std::string& attributes, const std::string& line) {
    const Bytes exif = withDirection(20.0, false);
    const auto heading = headingInText(std::string(exif.begin(), exif.end()) + packet(attributes));
    ASSERT_FALSE(heading) << attributes;
    EXPECT_EQ(heading.error().code, ErrorCode::bad_file);
    EXPECT_TRUE(heading.error().message.starts_with(line)) << heading.error().message;
  };
  const std::string heading = "GPano:PoseHeadingDegrees=\"20\" ";
  const std::string pitch_line = "which is not a number from -90 to 90; correct or remove that field of its XMP";
  refused(heading + "GPano:PosePitchDegrees=\"200\"", "its GPano:PosePitchDegrees is '200', " + pitch_line);
  refused(heading + "GPano:PosePitchDegrees='nan'", "its GPano:PosePitchDegrees is 'nan', " + pitch_line);
  refused(heading + "GPano:PoseRollDegrees='-361'",
          "its GPano:PoseRollDegrees is '-361', which is not a number from -360 to 360");
  for (const std::string value : {"", "north", "nan", "1e9", "inf", "++20", "+", "20 W"})
    refused("GPano:PoseHeadingDegrees=\"" + value + "\"", "its GPano:PoseHeadingDegrees is '" + value + "'");
  refused("GPano:PoseHeadingDegrees=\"20", "its GPano:PoseHeadingDegrees is '20/>");
}

// A MiB that is all hits, white space, prefix or opening brackets: 7 seconds where each hit looks at all that follows.
TEST(HeadingInFile, AnyMebibyteIsReadInAMoment) {
  constexpr std::size_t kSize = std::size_t{1} << 20;
  const auto filled = [](const std::string& begin, const std::string& piece, std::size_t size, char rest) {
    std::string text = begin;
    while (text.size() < size) text += piece;
    return text + std::string(text.size() < kSize ? kSize - text.size() : 0, rest);
  };
  const std::string uri = "='http://ns.google.com/photos/1.0/panorama/' ";
  for (const std::string& text :
       {filled("<a xmlns:a" + uri, "a:PoseHeadingDegrees,", kSize / 2, ' '),
        filled("<a xmlns:a" + uri, "a:PoseHeadingDegrees = ", kSize / 2, ' '),
        filled("<a xmlns:a" + uri, "<a:PoseHeadingDegrees ", kSize / 2, '\n'),
        filled("<a xmlns:a" + uri, "<a:PoseHeadingDegrees> <rdf:li>", kSize, ' '),
        filled("<a xmlns:" + std::string(kSize / 2, 'a') + uri, "aaaaaaaa", kSize, 'a'),
        filled("<a xmlns:a" + uri, uri, kSize, ' '), filled("", "xmlns:" + uri, kSize, ' ')}) {
    const auto begin = std::chrono::steady_clock::now();
    static_cast<void>(headingInText(text));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), 1.0) << text.substr(0, 100);
  }
}

TEST(HeadingInFile, ExifHasTheCamerasDirection) {
  const auto found = headingIn(withDirection(123.25, false));
  ASSERT_TRUE(found && *found);
  EXPECT_NEAR((*found)->heading_deg, 123.25, 1e-4);
  EXPECT_FALSE((*found)->is_magnetic);
  EXPECT_EQ((*found)->source, "GPSImgDirection");
  EXPECT_TRUE((*headingIn(withDirection(20.0, true)))->is_magnetic);
  EXPECT_FALSE(*headingIn(withDirection(400.0, false))) << "not a direction";
  EXPECT_FALSE(*headingIn(testing::withExif({0xff, 0xd8, 0xff, 0xd9}, {.iso = 100.0})));
}

TEST(HeadingInFile, AFolderAndNothingHaveNone) {
  const auto folder = headingInFile(std::filesystem::temp_directory_path());
  ASSERT_TRUE(folder);
  EXPECT_FALSE(*folder);
  const auto nothing = headingInFile("an absent file");
  ASSERT_TRUE(nothing);
  EXPECT_FALSE(*nothing);
  EXPECT_EQ(requiredHeading("an absent file").error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace mirrorball
