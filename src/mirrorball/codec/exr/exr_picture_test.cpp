// Files of several layers and parts, as other programs write them: OpenEXR itself writes them here.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/exr/exr_rows.h"
#include "mirrorball/codec/exr/exr_testing.h"

namespace mirrorball {
namespace {

using testing::constantFile;
using testing::constantParts;
using testing::decoded;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// "rgba: R G B" of each.
std::vector<std::string> layerTexts(const std::vector<PictureLayer>& layers) {
  std::vector<std::string> texts;
  for (const PictureLayer& layer : layers) texts.push_back(layer.name + ": " + layer.channels);
  return texts;
}

const std::vector<testing::ConstantChannel> kBlender{
    {"View.AO.R", .1f},     {"View.AO.G", .1f},     {"View.AO.B", .1f},        {"View.Combined.R", 1},
    {"View.Combined.G", 2}, {"View.Combined.B", 3}, {"View.Combined.A", 0.5f}, {"View.Depth.Z", 7},
    {"View.Emit.R", 4},     {"View.Emit.G", 5},     {"View.Emit.B", 6},        {"View.Normal.X", -1},
    {"View.Normal.Y", -2},  {"View.Normal.Z", -3}};

TEST(ExrPicture, OfBlendersLayersIsTheCombinedOne) {
  const DecodedImage back = decoded(constantFile(kBlender));
  EXPECT_THAT(back.image.samples().first(4), ElementsAre(1.0f, 2.0f, 3.0f, 0.5f));
  EXPECT_EQ(back.layer, "View.Combined");
  EXPECT_THAT(back.oddities, ::testing::Contains(back.layer_guess));
  EXPECT_THAT(layerTexts(back.layers), ElementsAre("View.AO: R G B", "View.Combined: R G B A", "View.Depth: Z",
                                                   "View.Emit: R G B", "View.Normal: X Y Z"));
  EXPECT_THAT(back.oddities, ElementsAre("has several pictures (View.Combined, View.Emit): View.Combined was read"));
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, layer View.Combined");
}

TEST(ExrPicture, IsTheLayerThatIsAskedFor) {
  const Bytes bytes = constantFile(kBlender);
  const auto normal = decodeExr(bytes, {.layer = "view.normal"});
  ASSERT_TRUE(normal);
  EXPECT_THAT(normal->image.samples().first(3), ElementsAre(-1.0f, -2.0f, -3.0f));
  EXPECT_EQ(normal->layer, "View.Normal");
  EXPECT_EQ(normal->layer_guess, "");
  EXPECT_TRUE(normal->oddities.empty());
  const auto depth = decodeExr(bytes, {.layer = "View.Depth"});
  ASSERT_TRUE(depth);
  EXPECT_EQ(depth->image.channels(), 1);
  EXPECT_EQ(depth->image.samples()[0], 7.0f);
  const auto none = decodeExr(bytes, {.layer = "View.Combine"});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::not_found);
  EXPECT_THAT(none.error().message, HasSubstr("did you mean 'View.Combined'?"));
}

TEST(ExrPicture, IsReadByRowsAlike) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "exr_picture_test.exr";
  ASSERT_TRUE(writeFile(path, constantFile(kBlender)));
  for (const auto& [layer, red] :
       {std::pair("", 1.0f), std::pair("View.Emit", 4.0f), std::pair("View.Normal", -1.0f)}) {
    const auto rows = openRows(path, {.layer = layer});
    ASSERT_TRUE(rows && *rows);
    EXPECT_EQ((*rows)->read(2)->samples()[0], red);
    EXPECT_EQ((*rows)->description().layers.size(), 5u);
    EXPECT_EQ((*rows)->description().oddities.size(), *layer == '\0' ? 1u : 0u);
  }
  EXPECT_EQ(openRows(path, {.layer = "x"}).error().code, ErrorCode::not_found);
}

TEST(ExrPicture, OfVRaysNamesWithADotIsThePlainOne) {
  const DecodedImage back = decoded(constantFile({{".R", 1}, {".G", 2}, {".B", 3}}));
  EXPECT_THAT(back.image.samples().first(3), ElementsAre(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP");
  EXPECT_TRUE(back.layers.empty());
}

TEST(ExrPicture, IsNoVectorsSecondCoordinate) {
  const DecodedImage back =
      decoded(constantFile({{"N.X", -1}, {"N.Y", -2}, {"N.Z", -3}, {"rgba.R", 1}, {"rgba.G", 2}, {"rgba.B", 3}}));
  EXPECT_THAT(back.image.samples().first(3), ElementsAre(1.0f, 2.0f, 3.0f));
  EXPECT_TRUE(back.oddities.empty()) << "there is one picture";
  const auto vector = decodeExr(constantFile({{"X", -1}, {"Y", -2}, {"Z", -3}}));
  ASSERT_FALSE(vector);
  EXPECT_EQ(vector.error().code, ErrorCode::unsupported);
  EXPECT_THAT(vector.error().message, HasSubstr("layers: XYZ;"));
}

TEST(ExrPicture, OfSeveralPartsIsThePartSoNamed) {
  const DecodedImage back =
      decoded(constantParts({{"depth", {{"Z", 5}}},
                             {"albedo", {{"albedo.R", .1f}, {"albedo.G", .1f}, {"albedo.B", .1f}}},
                             {"rgba", {{"R", 1}, {"G", 2}, {"B", 3}}}}));
  EXPECT_THAT(back.image.samples().first(3), ElementsAre(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(back.layer, "rgba");
  EXPECT_THAT(layerTexts(back.layers), ElementsAre("depth: Z", "albedo: R G B", "rgba: R G B"));
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, layer rgba, part 3");
}

TEST(ExrPicture, OfRenderManHasSmallLetters) {
  const DecodedImage back = decoded(constantFile({{"Ci.r", 1}, {"Ci.g", 2}, {"Ci.b", 3}, {"a", 0.5f}}));
  EXPECT_THAT(back.image.samples().first(3), ElementsAre(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(back.layer, "Ci");
}

TEST(ExrPicture, OfRedAloneIsGrey) {
  const DecodedImage back = decoded(constantFile({{"R", 2}}));
  EXPECT_EQ(back.image.channels(), 1);
  EXPECT_EQ(back.image.samples()[0], 2.0f);
  EXPECT_THAT(back.oddities, ElementsAre("has red without green and blue: read as grey"));
  EXPECT_EQ(back.layer_guess, "");
}

}  // namespace
}  // namespace mirrorball
