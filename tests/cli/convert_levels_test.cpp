// Mip levels in pictures: all on a sheet, or one; those that a texture has, or made ones.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/codec/texture/texture_file.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A part of an image.
Image cut(const Image& image, glm::ivec2 begin, glm::ivec2 size) {
  Image part(size.x, size.y, image.channels());
  for (int y = 0; y < size.y; ++y)
    std::copy_n(image.texel(begin.x, begin.y + y), size.x * image.channels(), part.texel(0, y));
  return part;
}

glm::ivec2 sizeOf(const Image& image) { return {image.width(), image.height()}; }

class ConvertLevelsTest : public CliTest {
 protected:
  ConvertLevelsTest() { write("map.exr", smoothPanorama()); }

  /// A cube of 8² texels a face with levels of 8, 4 and 2, each of one value: no mip levels of the first.
  void writeOwnLevels(const std::string& name, const Metadata& metadata = {}) const {
    ImageSet levels(3, 6);
    for (int level = 0; level < 3; ++level)
      for (int face = 0; face < 6; ++face)
        levels.at(level, face) = Image(8 >> level, 8 >> level, 3, static_cast<float>(10 * level + face + 1));
    ASSERT_TRUE(writeImageSet(path(name), levels, {.metadata = metadata}));
  }

  /// The value of each face of one level of writeOwnLevels's in a strip, +X first.
  std::vector<float> stripOf(const std::string& file, int y = 0) const {
    const Image strip = image(file);
    const int side = strip.width() / 6;
    std::vector<float> values;
    for (int face = 0; face < 6; ++face) values.push_back(strip.texel(face * side + side / 2, y)[0]);
    return values;
  }

  int levelsIn(const std::string& file) const { return texture(file).levels(); }
};

TEST_F(ConvertLevelsTest, ASheetHasEachLevelInTheLayout) {
  succeed("convert map.exr --to cube --size 8 --mips -o sheet.exr");
  const Image sheet = image("sheet.exr");
  EXPECT_EQ(sizeOf(sheet), glm::ivec2(49, 24)) << "a cross of 32 x 24, and half as wide ones beside it";
  glm::ivec2 corner(0, 0);
  for (int level = 0; level < 4; ++level) {
    succeed("convert map.exr --to cube --size 8 --level " + std::to_string(level) + " -o level.exr");
    const Image alone = image("level.exr");
    EXPECT_EQ(sizeOf(alone), glm::ivec2(32, 24) / (1 << level));
    EXPECT_EQ(maxDifference(cut(sheet, corner, sizeOf(alone)), alone), 0.0) << "level " << level;
    corner = level == 0 ? glm::ivec2(33, 0) : corner + glm::ivec2(0, alone.height());
  }
  for (int y = corner.y; y < 24; ++y) EXPECT_EQ(rgbAt(sheet, 40, y), glm::vec3(0.0f)) << "the rest is black";
}

TEST_F(ConvertLevelsTest, LevelZeroIsTheMap) {
  for (const std::string to : {"--to cube --size 8 --layout vcross", "--to octahedral --size 8", "--size 16"}) {
    succeed("convert map.exr " + to + " -o map_alone.exr");
    succeed("convert map.exr " + to + " --level 0 -o level.exr");
    EXPECT_TRUE(bytes("level.exr") == bytes("map_alone.exr")) << to;
  }
}

TEST_F(ConvertLevelsTest, WideMapsHaveTheirLevelsBelow) {
  succeed("convert map.exr --mips -o sheet.exr");
  EXPECT_EQ(sizeOf(image("sheet.exr")), glm::ivec2(64, 49));
  succeed("convert map.exr --level 1 -o level.exr");
  EXPECT_EQ(maxDifference(cut(image("sheet.exr"), {0, 33}, {32, 16}), image("level.exr")), 0.0);
  succeed("convert map.exr --to cube --size 8 --layout hstrip --mips -o strip.exr");
  EXPECT_EQ(sizeOf(image("strip.exr")), glm::ivec2(48, 13));
}

// As a lecture shows the mip levels of one face.
TEST_F(ConvertLevelsTest, SixFilesAreASheetOfEachFace) {
  succeed("convert map.exr --to cube --size 8 --layout faces --mips -o sheet.png");
  succeed("convert map.exr --to cube --size 8 --mips -o cross.png");
  EXPECT_THAT(files(), ElementsAre("cross.png", "map.exr", "sheet_nx.png", "sheet_ny.png", "sheet_nz.png",
                                   "sheet_px.png", "sheet_py.png", "sheet_pz.png"));
  const Image front = image("sheet_pz.png");
  EXPECT_EQ(sizeOf(front), glm::ivec2(13, 8));
  EXPECT_EQ(maxDifference(cut(front, {0, 0}, {8, 8}), cut(image("cross.png"), {8, 8}, {8, 8})), 0.0);
  EXPECT_EQ(maxDifference(cut(front, {9, 0}, {4, 4}), cut(image("cross.png"), {37, 4}, {4, 4})), 0.0);
}

TEST_F(ConvertLevelsTest, EveryFormatShowsThem) {
  succeed("convert map.exr --to cube --size 8 --mips -o sheet.exr");
  for (const std::string file : {"sheet.hdr", "sheet.png", "sheet.jpg"}) {
    succeed("convert map.exr --to cube --size 8 --mips -o " + file);
    EXPECT_EQ(sizeOf(image(file)), glm::ivec2(49, 24)) << file;
  }
  succeed("convert map.exr --to cube --size 8 --mips --exposure -3 --tone-map aces -o dark.png");
  EXPECT_LT(rgbAt(image("dark.png"), 12, 12).x, rgbAt(image("sheet.png"), 12, 12).x);
  EXPECT_EQ(rgbAt(image("dark.png"), 0, 0), glm::vec3(0.0f)) << "cells without a face stay black";
}

TEST_F(ConvertLevelsTest, OneLevelIsATextureToo) {
  succeed("convert map.exr --to cube --size 8 --mips --format float32 -o all.ktx2");
  succeed("convert map.exr --to cube --size 8 --level 2 --format float32 -o two.ktx2");
  ASSERT_EQ(levelsIn("two.ktx2"), 1);
  for (int face = 0; face < 6; ++face)
    EXPECT_EQ(maxDifference(texture("two.ktx2").at(0, face), texture("all.ktx2").at(2, face)), 0.0);
}

TEST_F(ConvertLevelsTest, WeightsCount) {
  const std::string line = "convert map.exr --to cube --size 8 --level 3 -o ";
  succeed(line + "usual.exr");
  succeed(line + "weighted.exr --mip solid-angle");
  succeed(line + "box.exr --mip box");
  EXPECT_TRUE(bytes("usual.exr") == bytes("weighted.exr"));
  EXPECT_FALSE(bytes("usual.exr") == bytes("box.exr"));
}

// 30 x 15, 15 x 7, 7 x 3: of an odd height a level is no panorama any more, but a picture.
TEST_F(ConvertLevelsTest, OddPanoramasHaveLevelsToo) {
  for (const std::string program : {"", " --for blender"}) {
    succeed("convert map.exr --size 15 --level 1 -o level.exr" + program);
    EXPECT_EQ(sizeOf(image("level.exr")), glm::ivec2(15, 7));
    succeed("convert map.exr --size 15 --mips -o sheet.exr" + program);
    EXPECT_EQ(sizeOf(image("sheet.exr")), glm::ivec2(30, 23));
    succeed("convert --quiet map.exr --size 15 --mips -o own.ktx2" + program);
    succeed("convert own.ktx2 --mips -o again.exr" + program);
    EXPECT_LT(maxDifference(image("again.exr"), image("sheet.exr")), 2e-3) << "half floats of light up to 2";
  }
}

TEST_F(ConvertLevelsTest, ATexturesOwnLevelsAreShown) {
  for (const std::string file : {"own.ktx2", "own.dds"}) {
    writeOwnLevels(file);
    succeed("convert " + file + " --from cube --mips --layout hstrip -o sheet.exr");
    EXPECT_EQ(sizeOf(image("sheet.exr")), glm::ivec2(48, 13));
    EXPECT_EQ(image("sheet.exr").texel(47, 0)[0], 6.0f);
    EXPECT_EQ(image("sheet.exr").texel(0, 9)[0], 11.0f);
    EXPECT_EQ(image("sheet.exr").texel(24, 9)[0], 21.0f);
    succeed("convert " + file + " --from cube --level 2 --layout hstrip -o level.exr");
    EXPECT_THAT(stripOf("level.exr"), ElementsAre(21, 22, 23, 24, 25, 26));
    succeed("convert " + file + " --from cube --mips -o again.ktx2");
    EXPECT_EQ(levelsIn("again.ktx2"), 3);
    EXPECT_EQ(texture("again.ktx2").at(1, 4).texel(0, 0)[0], 15.0f);
  }
}

TEST_F(ConvertLevelsTest, OwnLevelsLieAsTheFileAndTheOptionsSay) {
  // Unity's slots ±X are our ∓X.
  succeed("convert map.exr --to cube --size 8 --mips --format float32 -o ours.ktx2");
  succeed("convert --quiet map.exr --to cube --size 8 --mips --format float32 --for unity -o theirs.ktx2");
  for (const std::string level : {"0", "1", "3"}) {
    succeed("convert ours.ktx2 --level " + level + " -o a.exr");
    succeed("convert theirs.ktx2 --level " + level + " -o b.exr");
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr")) << level;
    succeed("convert ours.ktx2 --level " + level + " --for unity --layout 3x2 -o a.exr");
    succeed("convert theirs.ktx2 --level " + level + " --for unity --layout 3x2 -o b.exr");
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr")) << level;
  }
}

TEST_F(ConvertLevelsTest, OwnLevelsAreScaledAndClamped) {
  writeOwnLevels("own.ktx2");
  succeed("convert own.ktx2 --from cube --level 1 --layout hstrip --scale-light 2 -o level.exr");
  EXPECT_THAT(stripOf("level.exr"), ElementsAre(22, 24, 26, 28, 30, 32));
  // What --clamp-light takes is told of the map.
  succeed("convert own.ktx2 --from cube --level 1 --layout hstrip --clamp-light 13 -o level.exr");
  EXPECT_THAT(stripOf("level.exr"), ElementsAre(11, 12, 13, 13, 13, 13));
}

TEST_F(ConvertLevelsTest, OtherLevelsAreMade) {
  writeOwnLevels("own.ktx2");
  succeed("convert own.ktx2 --from cube --level 1 --mip box --layout hstrip -o made.exr");
  EXPECT_THAT(stripOf("made.exr"), ElementsAre(1, 2, 3, 4, 5, 6)) << "of the first level";
  for (const std::string other : {"--size 16 --layout hstrip", "--to equirect", "--rotate 90 --layout hstrip"}) {
    const Outcome outcome = run("convert own.ktx2 --from cube --mips -o sheet.exr " + other);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, StartsWith("mirrorball: note: own.ktx2: the mip levels that it has")) << other;
    const Image sheet = image("sheet.exr");
    for (const float sample : sheet.samples()) ASSERT_LT(sample, 6.5f) << other;
  }
}

TEST_F(ConvertLevelsTest, BadTexelsOfALevelAreTold) {
  ImageSet levels(2, 6);
  for (int face = 0; face < 6; ++face) {
    levels.at(0, face) = Image(2, 2, 3, 1.0f);
    levels.at(1, face) = Image(1, 1, 3, 0.5f);
  }
  levels.at(1, 3).texel(0, 0)[0] = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(writeImageSet(path("bad.ktx2"), levels, {.format = TexelFormat::float32}));
  EXPECT_THAT(refuse(1, "convert bad.ktx2 --from cube --mips -o a.png"),
              AllOf(StartsWith("bad.ktx2, level 1: "), HasSubstr("--repair")));
}

TEST_F(ConvertLevelsTest, WhatBakeWroteIsSeen) {
  succeed("bake map.exr --size 32 -o specular.ktx2");
  const ImageSet chain = texture("specular.ktx2");
  ASSERT_EQ(chain.levels(), 4);
  succeed("convert specular.ktx2 --level 3 --layout faces -o last.exr");
  EXPECT_EQ(maxDifference(image("last_py.exr"),
                          [&] {
                            Image rgb(4, 4, 3);
                            for (int y = 0; y < 4; ++y)
                              for (int x = 0; x < 4; ++x) std::copy_n(chain.at(3, 2).texel(x, y), 3, rgb.texel(x, y));
                            return rgb;
                          }()),
            0.0);
  EXPECT_THAT(refuse(2, "convert specular.ktx2 --level 4 -o a.png"),
              HasSubstr("a.png: there is no level 4; the last is 3"));
}

TEST_F(ConvertLevelsTest, ALevelThatIsNotThereIsToldWithTheLast) {
  EXPECT_THAT(refuse(2, "convert map.exr --to cube --size 8 --level 4 -o a.png"),
              HasSubstr("no level 4; the last is 3"));
  EXPECT_THAT(refuse(2, "convert map.exr --level 9 -o a.exr"), HasSubstr("no level 9; the last is 6"));
  EXPECT_THAT(refuse(2, "convert map.exr --max-memory 1M --level 9 -o a.exr"), HasSubstr("the last is 6"));
  EXPECT_THAT(refuse(2, "convert map.exr --level 1.5 -o a.exr"), HasSubstr("--level takes a whole number"));
  EXPECT_THAT(refuse(2, "convert map.exr --level -1 -o a.exr"), HasSubstr("--level takes a whole number"));
}

TEST_F(ConvertLevelsTest, WhatCannotBeIsRefused) {
  EXPECT_THAT(refuse(2, "convert map.exr --mips --level 1 -o a.png"), HasSubstr("leave one of them out"));
  EXPECT_THAT(refuse(2, "convert map.exr --mip box -o a.png"), HasSubstr("--mips or --level"));
  EXPECT_THAT(refuse(2, "convert map.exr --mips --level 1 --extension png -o out/"),
              HasSubstr("leave one of them out"));
  EXPECT_THAT(refuse(2, "convert map.exr --to sphere --level 1 -o a.png"),
              AllOf(HasSubstr("mip levels of sphere"), HasSubstr("disc")));
  EXPECT_THAT(refuse(2, "convert map.exr --to paraboloid --mips -o a.png"),
              AllOf(HasSubstr("mip levels of paraboloid"), HasSubstr("disc")));
  EXPECT_THAT(refuse(2, "convert map.exr --for openexr --mips -o a.exr"), HasSubstr("mip levels are not for openexr"));
}

TEST_F(ConvertLevelsTest, ASheetIsNoMap) {
  for (const std::string file : {"sheet.exr", "sheet.hdr", "sheet.png", "sheet.jpg"}) {
    succeed("convert map.exr --to cube --size 8 --mips -o " + file);
    EXPECT_THAT(refuse(1, "info " + file), StartsWith(file + ": is a sheet of mip levels, no map")) << file;
  }
}

}  // namespace
}  // namespace mirrorball::testing
