// Which layers a file has by the names of its channels and parts, and which of them is its picture.

#include "mirrorball/codec/exr/exr_layer.h"

#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A part whose channels are written with blanks between, in the order of OpenEXR's lists.
ExrPartNames partOf(std::string_view channels, const std::string& name = {}) {
  ExrPartNames part{.name = name};
  for (const std::string& channel : split(channels, ' ')) part.channels.push_back({channel});
  return part;
}

/// "rgba (R G B A)" of each.
std::vector<std::string> layersOf(const std::vector<ExrPartNames>& parts) {
  std::vector<std::string> texts;
  for (const ExrLayer& layer : exrLayers(parts)) texts.push_back(layer.name + " (" + join(layer.channels, " ") + ")");
  return texts;
}

/// The name of the layer that is read; else what is wrong.
std::string pictureOf(const std::vector<ExrPartNames>& parts, const std::string& wanted = {}) {
  const std::vector<ExrLayer> layers = exrLayers(parts);
  const auto choice = chooseExrLayer(layers, wanted);
  return choice ? layers[choice->index].name : choice.error().message;
}

std::string pictureOf(std::string_view channels) { return pictureOf(std::vector{partOf(channels)}); }

std::string oddityOf(std::string_view channels) {
  return chooseExrLayer(exrLayers(std::vector{partOf(channels)}), "")->oddity;
}

TEST(ExrLayer, GroupsChannelsByWhatStandsBeforeTheirLastDot) {
  EXPECT_THAT(layersOf({partOf("A B G R Z")}), ElementsAre("RGBA (R G B A)", "Z (Z)"));
  EXPECT_THAT(layersOf({partOf(".B .G .R")}), ElementsAre("RGB (R G B)")) << "tev#168";
  EXPECT_THAT(layersOf({partOf(
                  "V.Combined.A V.Combined.B V.Combined.G V.Combined.R V.Depth.Z V.Normal.X V.Normal.Y V.Normal.Z")}),
              ElementsAre("V.Combined (R G B A)", "V.Depth (Z)", "V.Normal (X Y Z)"));
  EXPECT_THAT(layersOf({partOf("a.blue a.green a.red b.B. b.G")}),
              ElementsAre("a (red green blue)", "b.B. (b.B.)", "b (G)"))
      << "a dot at the end parts nothing";
  EXPECT_THAT(layersOf({partOf("B G R X Y Z")}), ElementsAre("RGB (R G B)", "XYZ (X Y Z)"));
  EXPECT_THAT(layersOf({partOf("f.u f.v other.noise other.samples")}),
              ElementsAre("f (u v)", "other.noise (noise)", "other.samples (samples)"));
}

TEST(ExrLayer, PartsNameTheirPlainChannels) {
  EXPECT_THAT(
      layersOf({partOf("X Y Z", "N"), partOf("A B G R Z", "rgba"), partOf("albedo.B albedo.G albedo.R", "albedo")}),
      ElementsAre("N (X Y Z)", "rgba (R G B A)", "rgba.Z (Z)", "albedo (R G B)"));
  EXPECT_THAT(layersOf({partOf("B G R", "beauty")}), ElementsAre("RGB (R G B)")) << "the only part's name says nothing";
  EXPECT_THAT(layersOf({partOf("B G R"), partOf("B G R"), partOf("B G R")}),
              ElementsAre("RGB (R G B)", "RGB #2 (R G B)", "RGB #3 (R G B)"));
  EXPECT_THAT(layersOf({partOf("d.B d.G d.R", "left"), partOf("d.B d.G d.R", "right")}),
              ElementsAre("left.d (R G B)", "right.d (R G B)"));
  ExrPartNames deep = partOf("A B G R Z", "deep");
  deep.is_deep = true;
  EXPECT_THAT(layersOf({deep, partOf("B G R", "flat")}), ElementsAre("flat (R G B)"));
}

TEST(ExrLayer, ThePictureIsFoundByTheNamesThatProgramsGiveIt) {
  EXPECT_EQ(pictureOf("AO.B AO.G AO.R Emit.B Emit.G Emit.R Normal.X Normal.Y Normal.Z rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(pictureOf("AO.B AO.G AO.R RGBA.A RGBA.B RGBA.G RGBA.R"), "RGBA") << "arnold-usd#2115";
  EXPECT_EQ(pictureOf("N.X N.Y N.Z beauty.B beauty.G beauty.R"), "beauty");
  EXPECT_EQ(pictureOf("V.AO.B V.AO.G V.AO.R V.Combined.B V.Combined.G V.Combined.R V.Emit.B V.Emit.G V.Emit.R"),
            "V.Combined");
  EXPECT_EQ(
      pictureOf(
          "Composite.Combined.B Composite.Combined.G Composite.Combined.R A.Combined.B A.Combined.G A.Combined.R"),
      "Composite.Combined");
  EXPECT_EQ(pictureOf("Ci.b Ci.g Ci.r a albedo.b albedo.g albedo.r"), "Ci") << "RenderManForBlender#468";
  EXPECT_EQ(pictureOf("C.B C.G C.R Af.B Af.G Af.R"), "C");
  EXPECT_EQ(pictureOf("RGB_color.blue RGB_color.green RGB_color.red diffuse.blue diffuse.green diffuse.red"),
            "RGB_color");
  EXPECT_EQ(pictureOf("B G R beauty.B beauty.G beauty.R"), "RGB") << "what OpenEXR itself reads";
  EXPECT_EQ(pictureOf("Beauty.B Beauty.G Beauty.R Beauty_denoised.B Beauty_denoised.G Beauty_denoised.R"), "Beauty");
  EXPECT_EQ(pictureOf({partOf("Z", "depth"), partOf("albedo.B albedo.G albedo.R", "albedo"), partOf("B G R", "rgba")}),
            "rgba");
}

TEST(ExrLayer, OfUnknownNamesTheOneMostLikeAPictureIsTaken) {
  EXPECT_EQ(pictureOf("AO.B AO.G AO.R Diffuse.B Diffuse.G Diffuse.R studio.B studio.G studio.R"), "studio");
  EXPECT_EQ(pictureOf("AO.B AO.G AO.R DiffCol.B DiffCol.G DiffCol.R"), "DiffCol");
  EXPECT_EQ(pictureOf("WorldNormal.B WorldNormal.G WorldNormal.R key.B key.G key.R"), "key");
  EXPECT_EQ(
      pictureOf("crypto_object00.a crypto_object00.b crypto_object00.g crypto_object00.r z_key.B z_key.G z_key.R"),
      "z_key");
  EXPECT_EQ(pictureOf("A_mask.Y studio.B studio.G studio.R"), "studio");
  EXPECT_EQ(pictureOf("Composition.B Composition.G Composition.R Position.B Position.G Position.R"), "Composition");
}

TEST(ExrLayer, NumbersAreNoPicture) {
  EXPECT_THAT(pictureOf("X Y Z"), HasSubstr("has no picture among its layers: XYZ; name the layer")) << "tinyexr#178";
  EXPECT_THAT(pictureOf("N.X N.Y N.Z depth.Z"), HasSubstr("N (X Y Z), depth (Z)"));
  EXPECT_THAT(pictureOf("Normal.B Normal.G Normal.R UV.B UV.G UV.R"), HasSubstr("has no picture"));
  EXPECT_THAT(pictureOf("Z"), HasSubstr("has no picture"));
  EXPECT_EQ(pictureOf("Normal.B Normal.G Normal.R"), "Normal") << "there is nothing else to read";
  EXPECT_EQ(oddityOf("Normal.B Normal.G Normal.R"), "has no picture by the names of its layers: Normal was read");
  ExrPartNames deep = partOf("A B G R Z");
  deep.is_deep = true;
  EXPECT_THAT(pictureOf(std::vector{deep}), HasSubstr("all are deep or subsampled"));
}

TEST(ExrLayer, LuminanceStandsWithoutAnX) {
  EXPECT_EQ(pictureOf("Y"), "Y");
  EXPECT_EQ(pictureOf("Y Z"), "Y") << "with a depth beside it";
  EXPECT_EQ(pictureOf("A Y"), "YA");
  EXPECT_EQ(pictureOf("BY RY Y"), "YRYBY");
  EXPECT_EQ(pictureOf("X Y Z rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(pictureOf("Y rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(oddityOf("R"), "has red without green and blue: read as grey");
  EXPECT_EQ(exrLayers(std::vector{partOf("R")})[0].kind, ExrLayerKind::grey);
}

TEST(ExrLayer, OfSeveralViewsTheDefaultIsTaken) {
  EXPECT_EQ(pictureOf("left.B left.G left.R right.B right.G right.R"), "left");
  ExrPartNames stereo = partOf("left.B left.G left.R right.B right.G right.R");
  stereo.views = {"right", "left"};
  EXPECT_EQ(pictureOf(std::vector{stereo}), "right");
  ExrPartNames centred = partOf("B G R left.B left.G left.R");
  centred.views = {"centre", "left"};
  EXPECT_EQ(pictureOf(std::vector{centred}), "RGB");
  EXPECT_EQ(pictureOf("V.AO.left.B V.AO.left.G V.AO.left.R V.Combined.left.B V.Combined.left.G V.Combined.left.R "
                      "V.Combined.right.B V.Combined.right.G V.Combined.right.R"),
            "V.Combined.left");
}

TEST(ExrLayer, AChoiceBetweenPicturesIsTold) {
  EXPECT_EQ(oddityOf("AO.B AO.G AO.R Emit.B Emit.G Emit.R Normal.X rgba.B rgba.G rgba.R"),
            "has several pictures (Emit, rgba): rgba was read");
  EXPECT_EQ(oddityOf("A B G R Z N.X N.Y N.Z albedo.B albedo.G albedo.R"), "") << "there is one picture";
  EXPECT_EQ(oddityOf(".B .G .R"), "");
  std::string many = "B G R";
  for (int i = 10; i < 40; ++i)
    many += " light" + std::to_string(i) + ".B light" + std::to_string(i) + ".G light" + std::to_string(i) + ".R";
  EXPECT_THAT(oddityOf(many), HasSubstr("light20 and 19 more): RGB was read"));
}

TEST(ExrLayer, ALayerIsChosenByItsName) {
  const std::vector<ExrPartNames> parts{partOf("N.X N.Y N.Z n.B n.G n.R rgba.B rgba.G rgba.R")};
  EXPECT_EQ(pictureOf(parts, "N"), "N");
  EXPECT_EQ(pictureOf(parts, "n"), "n");
  EXPECT_EQ(pictureOf(parts, "RGBA"), "rgba");
  const auto unknown = chooseExrLayer(exrLayers(parts), "rgb");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::not_found);
  EXPECT_EQ(unknown.error().message, "no layer is named 'rgb'; did you mean 'rgba'? (there are: N, n, rgba)");
}

TEST(ExrLayer, SubsampledChannelsAreLeftOut) {
  ExrPartNames part = partOf("B G R Y");
  for (ExrChannelName& channel : part.channels) channel.is_subsampled = channel.name != "Y";
  EXPECT_THAT(layersOf({part}), ElementsAre("Y (Y)"));
}

// A header may name as many channels as it has bytes.
TEST(ExrLayer, TakesManyChannels) {
  ExrPartNames part;
  for (int i = 0; i < 200000; ++i) part.channels.push_back({"c" + std::to_string(i)});
  EXPECT_EQ(exrLayers(std::vector{part}).size(), 200000u);
  EXPECT_LT(chooseExrLayer(exrLayers(std::vector{part}), "").error().message.size(), 1000u);
  EXPECT_LT(chooseExrLayer(exrLayers(std::vector{part}), "x").error().message.size(), 2000u);
}

}  // namespace
}  // namespace mirrorball
