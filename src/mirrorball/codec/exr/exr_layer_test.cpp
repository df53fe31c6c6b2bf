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
ExrPartNames part(std::string_view channels, const std::string& name = {}) {
  ExrPartNames names{.name = name};
  for (const std::string& channel : split(channels, ' ')) names.channels.push_back({channel});
  return names;
}

/// "rgba (R G B A)" of each.
std::vector<std::string> layerTexts(const std::vector<ExrPartNames>& parts) {
  std::vector<std::string> texts;
  for (const ExrLayer& layer : exrLayers(parts)) texts.push_back(layer.name + " (" + join(layer.channels, " ") + ")");
  return texts;
}

/// The name of the layer that is read; else what is wrong.
std::string chosen(const std::vector<ExrPartNames>& parts, const std::string& wanted = {}) {
  const std::vector<ExrLayer> layers = exrLayers(parts);
  const auto choice = chooseExrLayer(layers, wanted);
  return choice ? layers[choice->index].name : choice.error().message;
}

std::string chosen(std::string_view channels) { return chosen(std::vector{part(channels)}); }

std::string remark(std::string_view channels) {
  return chooseExrLayer(exrLayers(std::vector{part(channels)}), "")->oddity;
}

TEST(ExrLayer, GroupsChannelsByWhatStandsBeforeTheirLastDot) {
  EXPECT_THAT(layerTexts({part("A B G R Z")}), ElementsAre("RGBA (R G B A)", "Z (Z)"));
  EXPECT_THAT(layerTexts({part(".B .G .R")}), ElementsAre("RGB (R G B)")) << "tev#168";
  EXPECT_THAT(layerTexts({part(
                  "V.Combined.A V.Combined.B V.Combined.G V.Combined.R V.Depth.Z V.Normal.X V.Normal.Y V.Normal.Z")}),
              ElementsAre("V.Combined (R G B A)", "V.Depth (Z)", "V.Normal (X Y Z)"));
  EXPECT_THAT(layerTexts({part("a.blue a.green a.red b.B. b.G")}),
              ElementsAre("a (red green blue)", "b.B. (b.B.)", "b (G)"))
      << "a dot at the end parts nothing";
  EXPECT_THAT(layerTexts({part("B G R X Y Z")}), ElementsAre("RGB (R G B)", "XYZ (X Y Z)"));
  EXPECT_THAT(layerTexts({part("f.u f.v other.noise other.samples")}),
              ElementsAre("f (u v)", "other.noise (noise)", "other.samples (samples)"));
}

TEST(ExrLayer, PartsNameTheirPlainChannels) {
  EXPECT_THAT(layerTexts({part("X Y Z", "N"), part("A B G R Z", "rgba"), part("albedo.B albedo.G albedo.R", "albedo")}),
              ElementsAre("N (X Y Z)", "rgba (R G B A)", "rgba.Z (Z)", "albedo (R G B)"));
  EXPECT_THAT(layerTexts({part("B G R", "beauty")}), ElementsAre("RGB (R G B)")) << "the only part's name says nothing";
  EXPECT_THAT(layerTexts({part("B G R"), part("B G R"), part("B G R")}),
              ElementsAre("RGB (R G B)", "RGB #2 (R G B)", "RGB #3 (R G B)"));
  EXPECT_THAT(layerTexts({part("d.B d.G d.R", "left"), part("d.B d.G d.R", "right")}),
              ElementsAre("left.d (R G B)", "right.d (R G B)"));
  ExrPartNames deep = part("A B G R Z", "deep");
  deep.is_deep = true;
  EXPECT_THAT(layerTexts({deep, part("B G R", "flat")}), ElementsAre("flat (R G B)"));
}

TEST(ExrLayer, ThePictureIsFoundByTheNamesThatProgramsGiveIt) {
  EXPECT_EQ(chosen("AO.B AO.G AO.R Emit.B Emit.G Emit.R Normal.X Normal.Y Normal.Z rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(chosen("AO.B AO.G AO.R RGBA.A RGBA.B RGBA.G RGBA.R"), "RGBA") << "arnold-usd#2115";
  EXPECT_EQ(chosen("N.X N.Y N.Z beauty.B beauty.G beauty.R"), "beauty");
  EXPECT_EQ(chosen("V.AO.B V.AO.G V.AO.R V.Combined.B V.Combined.G V.Combined.R V.Emit.B V.Emit.G V.Emit.R"),
            "V.Combined");
  EXPECT_EQ(
      chosen("Composite.Combined.B Composite.Combined.G Composite.Combined.R A.Combined.B A.Combined.G A.Combined.R"),
      "Composite.Combined");
  EXPECT_EQ(chosen("Ci.b Ci.g Ci.r a albedo.b albedo.g albedo.r"), "Ci") << "RenderManForBlender#468";
  EXPECT_EQ(chosen("C.B C.G C.R Af.B Af.G Af.R"), "C");
  EXPECT_EQ(chosen("RGB_color.blue RGB_color.green RGB_color.red diffuse.blue diffuse.green diffuse.red"), "RGB_color");
  EXPECT_EQ(chosen("B G R beauty.B beauty.G beauty.R"), "RGB") << "what OpenEXR itself reads";
  EXPECT_EQ(chosen("Beauty.B Beauty.G Beauty.R Beauty_denoised.B Beauty_denoised.G Beauty_denoised.R"), "Beauty");
  EXPECT_EQ(chosen({part("Z", "depth"), part("albedo.B albedo.G albedo.R", "albedo"), part("B G R", "rgba")}), "rgba");
}

TEST(ExrLayer, OfUnknownNamesTheOneMostLikeAPictureIsTaken) {
  EXPECT_EQ(chosen("AO.B AO.G AO.R Diffuse.B Diffuse.G Diffuse.R studio.B studio.G studio.R"), "studio");
  EXPECT_EQ(chosen("AO.B AO.G AO.R DiffCol.B DiffCol.G DiffCol.R"), "DiffCol");
  EXPECT_EQ(chosen("WorldNormal.B WorldNormal.G WorldNormal.R key.B key.G key.R"), "key");
  EXPECT_EQ(chosen("crypto_object00.a crypto_object00.b crypto_object00.g crypto_object00.r z_key.B z_key.G z_key.R"),
            "z_key");
  EXPECT_EQ(chosen("A_mask.Y studio.B studio.G studio.R"), "studio");
  EXPECT_EQ(chosen("Composition.B Composition.G Composition.R Position.B Position.G Position.R"), "Composition");
}

TEST(ExrLayer, NumbersAreNoPicture) {
  EXPECT_THAT(chosen("X Y Z"), HasSubstr("has no picture among its layers: XYZ; name the layer")) << "tinyexr#178";
  EXPECT_THAT(chosen("N.X N.Y N.Z depth.Z"), HasSubstr("N (X Y Z), depth (Z)"));
  EXPECT_THAT(chosen("Normal.B Normal.G Normal.R UV.B UV.G UV.R"), HasSubstr("has no picture"));
  EXPECT_THAT(chosen("Z"), HasSubstr("has no picture"));
  EXPECT_EQ(chosen("Normal.B Normal.G Normal.R"), "Normal") << "there is nothing else to read";
  EXPECT_EQ(remark("Normal.B Normal.G Normal.R"), "has no picture by the names of its layers: Normal was read");
  ExrPartNames deep = part("A B G R Z");
  deep.is_deep = true;
  EXPECT_THAT(chosen(std::vector{deep}), HasSubstr("all are deep or subsampled"));
}

TEST(ExrLayer, LuminanceStandsWithoutAnX) {
  EXPECT_EQ(chosen("Y"), "Y");
  EXPECT_EQ(chosen("Y Z"), "Y") << "with a depth beside it";
  EXPECT_EQ(chosen("A Y"), "YA");
  EXPECT_EQ(chosen("BY RY Y"), "YRYBY");
  EXPECT_EQ(chosen("X Y Z rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(chosen("Y rgba.B rgba.G rgba.R"), "rgba");
  EXPECT_EQ(remark("R"), "has red without green and blue: read as grey");
  EXPECT_EQ(exrLayers(std::vector{part("R")})[0].kind, ExrLayerKind::grey);
}

TEST(ExrLayer, OfSeveralViewsTheDefaultIsTaken) {
  EXPECT_EQ(chosen("left.B left.G left.R right.B right.G right.R"), "left");
  ExrPartNames stereo = part("left.B left.G left.R right.B right.G right.R");
  stereo.views = {"right", "left"};
  EXPECT_EQ(chosen(std::vector{stereo}), "right");
  ExrPartNames centred = part("B G R left.B left.G left.R");
  centred.views = {"centre", "left"};
  EXPECT_EQ(chosen(std::vector{centred}), "RGB");
  EXPECT_EQ(chosen("V.AO.left.B V.AO.left.G V.AO.left.R V.Combined.left.B V.Combined.left.G V.Combined.left.R "
                   "V.Combined.right.B V.Combined.right.G V.Combined.right.R"),
            "V.Combined.left");
}

TEST(ExrLayer, AChoiceBetweenPicturesIsTold) {
  EXPECT_EQ(remark("AO.B AO.G AO.R Emit.B Emit.G Emit.R Normal.X rgba.B rgba.G rgba.R"),
            "has several pictures (Emit, rgba): rgba was read");
  EXPECT_EQ(remark("A B G R Z N.X N.Y N.Z albedo.B albedo.G albedo.R"), "") << "there is one picture";
  EXPECT_EQ(remark(".B .G .R"), "");
  std::string many = "B G R";
  for (int i = 10; i < 40; ++i)
    many += " light" + std::to_string(i) + ".B light" + std::to_string(i) + ".G light" + std::to_string(i) + ".R";
  EXPECT_THAT(remark(many), HasSubstr("light20 and 19 more): RGB was read"));
}

TEST(ExrLayer, ALayerIsChosenByItsName) {
  const std::vector<ExrPartNames> parts{part("N.X N.Y N.Z n.B n.G n.R rgba.B rgba.G rgba.R")};
  EXPECT_EQ(chosen(parts, "N"), "N");
  EXPECT_EQ(chosen(parts, "n"), "n");
  EXPECT_EQ(chosen(parts, "RGBA"), "rgba");
  const auto unknown = chooseExrLayer(exrLayers(parts), "rgb");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::not_found);
  EXPECT_EQ(unknown.error().message, "no layer is named 'rgb'; did you mean 'rgba'? (there are: N, n, rgba)");
}

TEST(ExrLayer, SubsampledChannelsAreLeftOut) {
  ExrPartNames subsampled = part("B G R Y");
  for (ExrChannelName& channel : subsampled.channels) channel.is_subsampled = channel.name != "Y";
  EXPECT_THAT(layerTexts({subsampled}), ElementsAre("Y (Y)"));
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
