// Wrong usage of convert: one clear line each, which says what is right; exit code 2, and no file.

#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Words behind "convert white", and what the line must say.
struct Mistake {
  const char* words;
  std::vector<const char*> said;
};

class BadConvertOptionTest : public CliTest {
 protected:
  void refuseAll(const std::vector<Mistake>& mistakes) const {
    for (const Mistake& mistake : mistakes) {
      const std::string line = refuse(2, "convert white --size 4 " + std::string(mistake.words));
      for (const char* text : mistake.said) EXPECT_THAT(line, HasSubstr(text)) << mistake.words;
    }
  }
};

TEST_F(BadConvertOptionTest, AWrongNameListsTheRightOnes) {
  refuseAll({
      {"--to cube -o a.ktx2 --format foo", {"'foo'", "auto, half, float32, b10g11r11, e5b9g9r9, bc6h, uastc_hdr"}},
      {"--to cube -o a.ktx2 --mips --mip gauss", {"--mip", "'gauss'", "auto, solid-angle, box"}},
      {"--to cube -o a.exr --flip sideways", {"'sideways'", "none, horizontal, vertical, both"}},
      {"--to cube -o a.exr --filter bicubik", {"--filter", "did you mean 'bicubic'?", "bilinear, bicubic"}},
      {"--to cube -o a.exr --layout cross", {"did you mean 'hcross'?", "hstrip, vstrip, 3x2, lecture"}},
      {"--to cube -o a.exr --half", {"--half"}},
  });
  const std::string programs = refuse(2, "convert white --to cube -o a.exr --for maya");
  EXPECT_THAT(programs, HasSubstr("'maya'"));
  for (const Preset& preset : presets()) EXPECT_THAT(programs, HasSubstr(preset.name));
}

TEST_F(BadConvertOptionTest, OnlyWhatWasGivenIsBlamed) {
  EXPECT_THAT(refuse(2, "convert uv --to equirect --flip horizontal -o out.exr"),
              HasSubstr("flip horizontal: that is for cubes, and equirect is none"));
  EXPECT_THAT(refuse(2, "convert uv --to ball:dist=5 -o out.exr"),
              HasSubstr("a ball's parameter is distance, as in ball:distance=20"));
}

TEST_F(BadConvertOptionTest, AWrongValueIsToldWithWhatIsRight) {
  refuseAll({
      {"--to cube -o a.exr --face-order +x,-x", {"'+x,-x'", "+x,-x,+y,-y,+z,-z"}},
      {"--to cube -o a.exr --face-order +x,+x,+y,-y,+z,-z", {"each of the six once"}},
      {"--to cube -o a.exr --face-order a,b,c,d,e,f", {"+x, -x, +y, -y, +z, -z"}},
      {"--to cube -o a.exr --centre 1,2", {"--centre", "3 numbers", "'1,2'"}},
      {"--to cube -o a.exr --centre 0,0,0", {"--centre", "length"}},
      {"--to cube -o a.exr --centre 1,2,nan", {"--centre", "3 numbers"}},
      {"--to cube -o a.exr --rotate east", {"--rotate", "1 to 3 numbers", "degrees"}},
      {"--to cube -o a.exr --rotate 1,2,3,4", {"--rotate", "1 to 3 numbers"}},
      {"--to cube -o a.ktx2 --zstd 23", {"--zstd", "0 … 22", "'23'"}},
      {"--to cube -o a.ktx2 --zstd fast", {"--zstd", "whole number"}},
      {"--to cube -o a.exr --max-memory 0", {"--max-memory", "'0'", "1.5G or 800M"}},
      {"--to cube -o a.exr --max-memory lots", {"--max-memory", "'lots'"}},
      {"--to cube -o a.exr --max-memory -1G", {"--max-memory", "'-1G'"}},
  });
}

TEST_F(BadConvertOptionTest, WhatAFileCannotHoldIsToldWithWhatCan) {
  refuseAll({
      {"--to cube -o a.exr --zstd 5", {"a.exr: ", "no Zstandard compression; .ktx2 has"}},
      {"--to cube -o a.dds --zstd 5", {"a.dds: ", "no Zstandard compression; .ktx2 has"}},
      {"--to cube -o a.exr --format b10g11r11", {"a.exr: ", "b10g11r11", "half and float32"}},
      {"--to cube -o a.hdr --format half", {"a.hdr: ", "cannot hold half texels"}},
      {"--to cube -o a.png --format float32", {"a.png: ", "cannot hold float32 texels"}},
      {"--to cube -o a.ktx2 --layout hcross", {"a.ktx2: ", "in no layout"}},
      {"--to cube -o a.dds --layout faces", {"a.dds: ", "in no layout"}},
      {"--to cube -o a.ktx2 --for openexr", {"a.ktx2: ", ".exr"}},
      {"--to equirect -o a.hdr --for openexr", {"a.hdr: ", ".exr"}},
      {"--to sphere -o a.ktx2 --mips", {"mip levels of sphere", "a cube or a panorama"}},
      {"--to paraboloid -o a.dds --mips", {"mip levels of paraboloid"}},
      {"--to cube -o a.ktx2 --mip box", {"--mip", "--mips"}},
      {"--to cube -o a.pfm", {"a.pfm: is not a format that Mirrorball writes", ".hdr or .exr", ".ktx2, .ktx or .dds"}},
  });
}

TEST_F(BadConvertOptionTest, WhatSaysNothingOfTheProjectionIsRefused) {
  const std::vector<std::pair<std::string, std::string>> options{{"--layout lecture", "layout lecture: "},
                                                                 {"--as-seen", "as seen: "},
                                                                 {"--flip both", "flip both: "},
                                                                 {"--face-order -x+x+y-y+z-z", "face order -x,+x"}};
  for (const auto& [option, words] : options)
    for (const std::string to : {"sphere", "equirect", "octahedral", "paraboloid"})
      EXPECT_THAT(refuse(2, "convert white --to " + to + " -o a.exr " + option),
                  AllOf(HasSubstr(words), HasSubstr("for cubes"), HasSubstr(to)));
  refuseAll({
      {"--to sphere -o a.exr --for unity", {"Unity", "cubes and panoramas", "sphere"}},
      {"--to cube -o a.exr --for blender", {"Blender", "--to equirect"}},
      {"--to eac -o a.exr --for openexr", {"OpenEXR", "eac"}},
      {"--to cube -o a.exr --for openexr --layout hcross", {"OpenEXR", "vstrip", "hcross"}},
  });
}

TEST_F(BadConvertOptionTest, AWrongFormOfTheInputIsTold) {
  refuseAll({
      {"--to cube -o a.exr --from cube:for=maya", {"'maya'", "three"}},
      {"--to cube -o a.exr --from cube:upside-down", {"upside-down", "as-seen"}},
      {"--to cube -o a.exr --from equirect:as-seen", {"as-seen", "equirect", "centre=AXIS"}},
      {"--to cube -o a.exr --from equirect:centre=+y", {"horizon"}},
      {"--to cube -o a.exr --from cube:for=blender", {"Blender"}},
      {"--to cube -o a.exr --from hcross:order=+x", {"order"}},
  });
}

TEST_F(BadConvertOptionTest, AnExtensionIsForFolders) {
  EXPECT_THAT(refuse(2, "convert white --to cube -o a.exr --extension ktx2"),
              AllOf(HasSubstr("--extension is for an output folder"), HasSubstr("a.exr")));
  EXPECT_THAT(
      refuse(2, "convert white --to cube -o a --extension tga"),
      AllOf(StartsWith("white would become a/white.tga"), HasSubstr(".hdr, .exr, .png, .jpg, .ktx2, .ktx or .dds")));
  EXPECT_THAT(refuse(2, "convert white --to cube -o a/"), AllOf(StartsWith("white "), HasSubstr("--extension")));
}

// "photo" writes its maps by the same options.
TEST_F(BadConvertOptionTest, PhotoRefusesTheSame) {
  succeed("convert white --to sphere --size 32 -o ball.exr");
  EXPECT_THAT(refuse(2, "photo ball.exr -o out.exr --mips --level 1"), HasSubstr("leave one of them out"));
  EXPECT_THAT(refuse(2, "photo ball.exr -o out.exr --layout vcross"), HasSubstr("for cubes"));
  EXPECT_THAT(refuse(1, "photo ball.exr -o none/out.exr"), HasSubstr("there is no folder none"));
  EXPECT_THAT(refuse(2, "photo ball.exr -o out.exr --debug rim.exr"), HasSubstr("use .png or .jpg"));
  EXPECT_THAT(refuse(2, "photo ball.exr -o out.exr --for maya"), HasSubstr("'maya'"));
}

}  // namespace
}  // namespace mirrorball::testing
