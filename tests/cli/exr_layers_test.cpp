// OpenEXR files of several layers, and with a data window of their own, as users meet them.

#include <ImfHeader.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "mirrorball/codec/exr/exr_testing.h"

namespace mirrorball {
namespace {

using testing::constantFile;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::smoothPanorama;

class ExrLayersTest : public testing::CliTest {
 protected:
  ExrLayersTest() {
    std::vector<testing::ConstantChannel> channels{{"N.X", -1}, {"N.Y", -2}, {"N.Z", 3}};
    for (const auto& [layer, light] : {std::pair("AO.", 0.25f), std::pair("Emit.", 4.0f), std::pair("rgba.", 1.0f)}) {
      channels.push_back({std::string(layer) + "R", light});
      channels.push_back({std::string(layer) + "G", 2.0f * light});
      channels.push_back({std::string(layer) + "B", 3.0f * light});
    }
    write("layers.exr", constantFile(channels));
  }
};

TEST_F(ExrLayersTest, ThePictureIsConvertedWithARemarkOnTheChoice) {
  const testing::Outcome outcome = run("convert layers.exr -o out.exr --to equirect");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "mirrorball: note: layers.exr: has several pictures (Emit, rgba): rgba was read; --from layer=NAME takes "
            "another\n");
  EXPECT_EQ(rgbAt(image("out.exr"), 3, 3), glm::vec3(1, 2, 3));
}

TEST_F(ExrLayersTest, AnotherIsTakenByItsName) {
  for (const char* from : {"layer=Emit", "equirect:layer=emit"}) {
    succeed("convert layers.exr --from " + std::string(from) + " -o out.exr --to equirect");
    EXPECT_EQ(rgbAt(image("out.exr"), 3, 3), glm::vec3(4, 8, 12));
  }
  EXPECT_THAT(refuse(1, "convert layers.exr --from layer=Emitt -o new.exr --to equirect"),
              HasSubstr("layers.exr: no layer is named 'Emitt'; did you mean 'Emit'? (there are: AO, Emit, N, rgba)"));
}

TEST_F(ExrLayersTest, ANameWithCommasStandsInQuotationMarks) {
  std::vector<testing::ConstantChannel> channels;
  for (const auto& [layer, light] : {std::pair("key,fill.", 4.0f), std::pair("rgba.", 1.0f)})
    for (const char* channel : {"R", "G", "B"}) channels.push_back({layer + std::string(channel), light});
  write("commas.exr", constantFile(channels));
  succeed("convert commas.exr --from equirect:layer=\"key,fill\" -o out.exr --to equirect");
  EXPECT_EQ(*image("out.exr").texel(0, 0), 4.0f);
}

TEST_F(ExrLayersTest, InfoListsAll) {
  const testing::Outcome outcome = run("info layers.exr");
  EXPECT_THAT(outcome.out, HasSubstr("\n  layers       AO (R G B), Emit (R G B), N (X Y Z), rgba (R G B): read\n"));
  const auto json = nlohmann::json::parse(run("info layers.exr --json").out);
  EXPECT_EQ(json["layer"], "rgba");
  EXPECT_EQ(json["layers"][2]["name"], "N");
  EXPECT_EQ(json["layers"][2]["channels"], "X Y Z");
}

TEST_F(ExrLayersTest, ALayerIsComparedByItsName) {
  write("emit.exr", constantFile({{"R", 4}, {"G", 8}, {"B", 12}}));
  EXPECT_THAT(succeed("compare layers.exr emit.exr --layer Emit"), HasSubstr("RMSE      0"));
  const testing::Outcome outcome = run("compare layers.exr emit.exr");
  EXPECT_THAT(outcome.err, HasSubstr("rgba was read; --layer NAME takes another"));
  EXPECT_THAT(refuse(1, "compare layers.exr emit.exr --layer X"), HasSubstr("no layer is named 'X'"));
  EXPECT_THAT(refuse(1, "compare emit.exr emit.exr --layer Emit"), HasSubstr("have no layers; leave --layer out"));
}

TEST_F(ExrLayersTest, HeightsAndPhotographsAreChosenLikewise) {
  succeed("surface layers.exr --layer N --to height -o heights.exr");
  EXPECT_THAT(run("surface layers.exr -o normals.exr").err, HasSubstr("rgba was read; --layer NAME takes another"));
  EXPECT_THAT(refuse(1, "surface layers.exr --layer M -o other.exr"), HasSubstr("no layer is named 'M'"));
  EXPECT_THAT(refuse(1, "photo layers.exr --layer M -o ball.exr"), HasSubstr("no layer is named 'M'"));
  write("light.png", smoothPanorama());
  EXPECT_THAT(refuse(1, "photo light.png --layer M -o ball.exr"), HasSubstr("light.png: has no layers"));
  EXPECT_THAT(refuse(1, "surface light.png --layer M -o other.exr"), HasSubstr("light.png: has no layers"));
}

TEST_F(ExrLayersTest, FilesWithoutLayersHaveNone) {
  write("light.hdr", smoothPanorama());
  EXPECT_THAT(refuse(1, "convert light.hdr --from layer=rgba -o out.exr --to equirect"),
              HasSubstr("light.hdr: has no layers"));
}

class ExrWindowTest : public testing::CliTest {
 protected:
  /// The part of a panorama of 64 × 32 texels that begins at `corner`; beyond its edges, ones.
  void writePart(const std::string& name, glm::ivec2 corner, glm::ivec2 size) const {
    const Image whole = smoothPanorama();
    Image part(size.x, size.y, 3, 1.0f);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec2 at = corner + glm::ivec2(x, y);
        if (at.x >= 0 && at.y >= 0 && at.x < 64 && at.y < 32)
          for (int c = 0; c < 3; ++c) part.texel(x, y)[c] = whole.texel(at.x, at.y)[c];
      }
    const Imf::Header header(Imath::Box2i({0, 0}, {63, 31}),
                             Imath::Box2i({corner.x, corner.y}, {corner.x + size.x - 1, corner.y + size.y - 1}));
    write(name, testing::foreignFile(header, part, {"R", "G", "B"}));
  }
};

TEST_F(ExrWindowTest, APanoramaIsItsDisplayWindow) {
  writePart("middle.exr", {16, 8}, {32, 16});
  const testing::Outcome outcome = run("convert middle.exr --to equirect -o out.exr");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "mirrorball: note: middle.exr: holds 32x16 of the 64x32 texels of its display window: what lies outside is "
            "black, and lights nothing; --from equirect:fill=smooth continues the picture into it\n");
  const Image out = image("out.exr");
  ASSERT_EQ(out.width(), 64);
  EXPECT_EQ(rgbAt(out, 16, 8), rgbAt(smoothPanorama(), 16, 8));
  EXPECT_EQ(rgbAt(out, 47, 23), rgbAt(smoothPanorama(), 47, 23));
  EXPECT_EQ(rgbAt(out, 15, 8), glm::vec3(0));
  EXPECT_EQ(rgbAt(out, 48, 23), glm::vec3(0));
}

TEST_F(ExrWindowTest, APanoramaIsReadByRowsAlike) {
  writePart("middle.exr", {16, 8}, {32, 16});
  const std::string whole = run("convert middle.exr --to equirect -o whole.exr").err;
  // A memory of which the map takes more than half.
  EXPECT_EQ(run("convert middle.exr --to equirect -o rows.exr --max-memory 0.045M").err, whole);
  EXPECT_EQ(bytes("rows.exr"), bytes("whole.exr"));
}

TEST_F(ExrWindowTest, TheRestIsFilledOnRequest) {
  writePart("middle.exr", {16, 8}, {32, 16});
  run("convert middle.exr --from equirect:fill=smooth --to equirect -o out.exr");
  EXPECT_GT(image("out.exr").texel(3, 3)[0], 0.1f);
  writePart("overscan.exr", {-4, -2}, {72, 36});
  run("convert overscan.exr --from equirect:fill=smooth --to equirect -o whole.exr");
  EXPECT_EQ(rgbAt(image("whole.exr"), 3, 3), rgbAt(smoothPanorama(), 3, 3));
}

TEST_F(ExrWindowTest, OverscanIsCutOff) {
  writePart("overscan.exr", {-4, -2}, {72, 36});
  run("convert overscan.exr --to equirect -o out.exr");
  const Image out = image("out.exr"), right = smoothPanorama();
  ASSERT_EQ(out.width(), 64);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) ASSERT_EQ(rgbAt(out, x, y), rgbAt(right, x, y));
}

TEST_F(ExrWindowTest, InfoTellsBothWindows) {
  writePart("middle.exr", {16, 8}, {32, 16});
  EXPECT_THAT(run("info middle.exr").out, HasSubstr("at (16, 8) of 64x32 (its display window)"));
  writePart("overscan.exr", {-4, -2}, {72, 36});
  EXPECT_THAT(run("info overscan.exr").out, HasSubstr("72x36 at (-4, -2) of 64x32 (its display window)"));
  const auto json = nlohmann::json::parse(run("info overscan.exr --json").out);
  EXPECT_EQ(json["window"]["size"], (std::vector<int>{72, 36}));
  EXPECT_EQ(json["window"]["corner"], (std::vector<int>{-4, -2}));
  EXPECT_EQ(json["window"]["whole"], (std::vector<int>{64, 32}));
}

}  // namespace
}  // namespace mirrorball
