// How the program tells what form a map has: --from, else the file's metadata, else its shape.

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class RecognitionTest : public CliTest {
 protected:
  /// What info says of a file's form.
  std::string formOf(const std::string& arguments) const {
    const std::string said = succeed("info " + arguments);
    const std::size_t begin = said.find("projection");
    if (begin == std::string::npos) return said;
    const std::size_t end = said.find('\n', begin);
    return said.substr(said.find_first_not_of(' ', begin + 10), end - said.find_first_not_of(' ', begin + 10));
  }
};

TEST_F(RecognitionTest, EveryFileSaysItself) {
  for (const std::string extension : {"exr", "hdr", "png", "jpg"}) {
    succeed("convert uv --to angular --size 16 -o probe." + extension);
    EXPECT_EQ(formOf("probe." + extension), "angular (recognised by the file's metadata)");
    succeed("convert uv --to cube --layout vstrip --size 8 -o strip." + extension);
    EXPECT_EQ(formOf("strip." + extension), "cube, vstrip (recognised by the file's metadata)");
  }
}

TEST_F(RecognitionTest, AFileThatSaysNothingIsToldByItsShape) {
  struct Shape {
    glm::ivec2 size;
    const char* form;
  };
  for (const Shape& shape : {Shape{{16, 8}, "equirect (recognised by its shape, 2:1)"},
                             Shape{{16, 16}, "sphere (recognised by its shape, 1:1)"},
                             Shape{{16, 12}, "cube, hcross (recognised by its shape, 4:3)"},
                             Shape{{12, 16}, "cube, vcross (recognised by its shape, 3:4)"},
                             Shape{{24, 4}, "cube, hstrip (recognised by its shape, 6:1)"},
                             Shape{{4, 24}, "cube, vstrip (recognised by its shape, 1:6)"},
                             Shape{{12, 8}, "cube, 3x2 (recognised by its shape, 3:2)"}}) {
    write("map.exr", Image(shape.size.x, shape.size.y, 3, 1.0f));
    EXPECT_EQ(formOf("map.exr"), shape.form);
  }
}

TEST_F(RecognitionTest, WhatAShapeLeavesOpenIsRemarkedWithItsOptions) {
  for (const std::string form : {"sphere", "paraboloid"}) {
    succeed("convert studio --to " + form + " --size 64 -o map.exr");
    write(form + ".exr", image("map.exr"));  // without metadata
  }
  EXPECT_EQ(
      run("info sphere.exr").err,
      "mirrorball: note: sphere.exr: is square, with a disc on black: taken as a sphere map, a mirror ball seen from "
      "far away, and --from angular or --from ball names another form\n");
  EXPECT_EQ(run("info sphere.exr --from sphere").err, "");
  EXPECT_THAT(refuse(1, "info paraboloid.exr"), HasSubstr("--from paraboloid reads a dual paraboloid map"));
  EXPECT_EQ(formOf("paraboloid.exr --from paraboloid"), "paraboloid (recognised by --from)");
}

TEST_F(RecognitionTest, FromOverridesWhatTheFileSays) {
  succeed("convert uv --to angular --size 32 -o probe.exr");
  EXPECT_EQ(formOf("probe.exr --from sphere"), "sphere (recognised by --from)");
  succeed("convert probe.exr --to equirect --size 16 -o by_metadata.exr");
  succeed("convert probe.exr --to equirect --size 16 -o by_name.exr --from angular");
  succeed("convert probe.exr --to equirect --size 16 -o as_sphere.exr --from sphere");
  EXPECT_TRUE(bytes("by_metadata.exr") == bytes("by_name.exr"));
  EXPECT_FALSE(bytes("by_metadata.exr") == bytes("as_sphere.exr"));
}

TEST_F(RecognitionTest, APhotographOfACubesShapeIsDoubted) {
  Image photograph(768, 512, 3);
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 768; ++x)
      std::fill_n(photograph.texel(x, y), 3, 0.1f + 0.8f * float(y) / 512.0f + 0.1f * std::sin(0.2f * float(x)));
  write("photo.exr", photograph);
  EXPECT_THAT(run("info photo.exr").err, AllOf(HasSubstr("note: photo.exr: "), HasSubstr("a photograph is no map")));
  EXPECT_EQ(run("info photo.exr --from 3x2").err, "");
  EXPECT_THAT(run("info photo.exr").out, HasSubstr("mirrored writing"));
}

TEST_F(RecognitionTest, OneOfSixFacesIsToldWithTheOthersAndTheOtherReading) {
  succeed("convert uv --to cube --layout faces --size 32 --for quake -o sky.exr");
  for (const char* face : {"rt", "lf", "up", "dn", "ft", "bk"}) {
    // As another program writes them: without metadata.
    write("dust_" + std::string(face) + ".exr", image("sky_" + std::string(face) + ".exr"));
  }
  const auto by_name = run("convert dust_up.exr --to equirect --size 32 -o by_name.exr");
  EXPECT_EQ(by_name.exit_code, 0);
  EXPECT_THAT(by_name.err, HasSubstr("note: dust_up.exr: is read as one of the six faces of a cube, with dust_rt.exr, "
                                     "dust_lf.exr, dust_dn.exr, dust_ft.exr and dust_bk.exr, as "
                                     "faces:for=quake has them, and --from sphere names another form"));
  succeed("convert sky_up.exr --to equirect --size 32 -o by_file.exr");
  EXPECT_TRUE(bytes("by_name.exr") == bytes("by_file.exr"));
  EXPECT_EQ(run("convert dust_up.exr --from faces:for=quake --to equirect --size 32 -o by_hint.exr").err, "");
  EXPECT_TRUE(bytes("by_name.exr") == bytes("by_hint.exr"));
  std::filesystem::remove(path("dust_rt.exr"));
  EXPECT_THAT(refuse(1, "info dust_up.exr"), HasSubstr("without dust_rt.exr"));
  for (const char* face : {"dn", "ft"}) std::filesystem::remove(path("dust_" + std::string(face) + ".exr"));
  EXPECT_THAT(run("info dust_up.exr").err,
              HasSubstr("dust_up.exr: is named like one of the six faces of a cube, of which "
                        "dust_rt.exr, dust_dn.exr and dust_ft.exr are missing"));
}

TEST_F(RecognitionTest, InfoSaysWhetherMinusZStandsOnItsHead) {
  succeed("convert studio --to cube --layout vcross --size 64 -o told.png");
  const Image cross = readImage(path("told.png"))->image;
  Image upright = cross;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      std::copy_n(cross.texel(127 - x, 255 - y), cross.channels(), upright.texel(64 + x, 192 + y));
  write("cross.exr", upright);
  EXPECT_EQ(formOf("cross.exr"), "cube, vcross, turn=-z (recognised by its shape, 3:4, and how its edges meet)");
  succeed("convert cross.exr --to cube --layout vcross -o again.exr");
  // Half floats have 11 bits.
  const Image again = readImage(path("again.exr"))->image;
  EXPECT_TRUE(std::ranges::equal(again.samples(), cross.samples(),
                                 [](float a, float b) { return std::abs(a - b) <= 5e-4f * std::max(a, b); }));
  EXPECT_EQ(formOf("cross.exr --from vcross"), "cube, vcross (recognised by --from)");
}

TEST_F(RecognitionTest, FromNamesACubesLayoutToo) {
  write("map.exr", Image(24, 4, 3, 1.0f));
  EXPECT_EQ(formOf("map.exr --from cube"), "cube, hstrip (recognised by --from)");
  EXPECT_EQ(formOf("map.exr --from hstrip"), "cube, hstrip (recognised by --from)");
  EXPECT_THAT(refuse(1, "info map.exr --from vcross"), HasSubstr("map.exr: is 24x4"));
  EXPECT_THAT(refuse(1, "info map.exr --from equirect"), HasSubstr("2:1"));
}

TEST_F(RecognitionTest, OneOfSixFacesStandsForTheCube) {
  succeed("convert uv --to cube --layout faces --size 8 -o room.png");
  EXPECT_EQ(formOf("room_ny.png"), "cube, faces (recognised by its name, one of six faces px nx py ny pz nz)");
  EXPECT_EQ(formOf("room_ny.png --from faces"), "cube, faces (recognised by --from)");
  std::filesystem::remove(path("room_nz.png"));
  EXPECT_THAT(refuse(1, "info room_ny.png"), HasSubstr("without room_nz.png"));
}

}  // namespace
}  // namespace mirrorball::testing
