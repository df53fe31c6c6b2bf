#include "mirrorball/environment/recognize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

std::string formOfShape(int width, int height) {
  const auto recognition = recognize("a.hdr", width, height, {});
  return recognition ? textOf(recognition->form) + " by " + recognition->told_by : recognition.error().message;
}

TEST(Recognize, ByShape) {
  EXPECT_EQ(formOfShape(64, 32), "equirect by its shape, 2:1");
  EXPECT_EQ(formOfShape(64, 64), "sphere by its shape, 1:1");
  EXPECT_EQ(formOfShape(64, 48), "cube, hcross by its shape, 4:3");
  EXPECT_EQ(formOfShape(48, 64), "cube, vcross by its shape, 3:4");
  EXPECT_EQ(formOfShape(96, 16), "cube, hstrip by its shape, 6:1");
  EXPECT_EQ(formOfShape(16, 96), "cube, vstrip by its shape, 1:6");
  EXPECT_EQ(formOfShape(48, 32), "cube, 3x2 by its shape, 3:2");
  EXPECT_THAT(formOfShape(1000, 600), HasSubstr("a.hdr: is 1000x600, which is neither 2:1"));
}

TEST(Recognize, MetadataComesBeforeTheShape) {
  const auto probe = recognize("a.exr", 64, 64, {{"mirrorball:projection", "angular"}});
  EXPECT_EQ(textOf(probe->form), "angular");
  EXPECT_EQ(probe->told_by, "the file's metadata");
  EXPECT_EQ(textOf(recognize("a.exr", 64, 32, {{"envmap", "latlong"}})->form), "equirect");
  EXPECT_EQ(recognize("a.exr", 64, 60, {{"envmap", "latlong"}}).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(recognize("a.exr", 16, 96, {{"envmap", "cube"}}).error().code, ErrorCode::unsupported);
}

TEST(Recognize, TheHintComesBeforeAll) {
  const auto angular = recognize("a.exr", 64, 64, {{"mirrorball:projection", "sphere"}}, *formHintNamed("angular"));
  EXPECT_EQ(textOf(angular->form), "angular");
  EXPECT_EQ(angular->told_by, "--from");
  EXPECT_EQ(textOf(recognize("a.hdr", 48, 32, {}, *formHintNamed("cube"))->form), "cube, 3x2");
  EXPECT_EQ(textOf(recognize("a.hdr", 64, 48, {}, *formHintNamed("hcross"))->form), "cube, hcross");

  EXPECT_THAT(recognize("a.hdr", 100, 60, {}, *formHintNamed("equirect")).error().message, HasSubstr("2:1"));
  EXPECT_THAT(recognize("a.hdr", 100, 60, {}, *formHintNamed("sphere")).error().message, HasSubstr("square"));
  EXPECT_THAT(recognize("a.hdr", 100, 60, {}, *formHintNamed("cube")).error().message, HasSubstr("no cube layout"));
  EXPECT_THAT(recognize("a.hdr", 100, 60, {}, *formHintNamed("vcross")).error().message, HasSubstr("3:4"));
}

TEST(Recognize, UnknownNamesListAll) {
  const auto hint = formHintNamed("panorama");
  ASSERT_FALSE(hint);
  EXPECT_THAT(hint.error().message, HasSubstr("equirect, sphere, angular, cube, faces, hcross"));
}

}  // namespace
}  // namespace mirrorball
