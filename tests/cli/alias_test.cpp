// Names as others write them, and what is said where one is wrong.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class AliasTest : public CliTest {
 protected:
  AliasTest() { write("map.exr", smoothPanorama()); }

  /// Expects two command lines to write the same file.
  void expectSame(const std::string& line, const std::string& other) const {
    succeed(line + " -o a.exr");
    succeed(other + " -o b.exr");
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr")) << line << " and " << other;
  }
};

TEST_F(AliasTest, FormsAndProgramsHaveSeveralNames) {
  const std::string line = "convert map.exr --size 8 ";
  for (const std::string name : {"equirectangular", "latlong", "Equirect", "LatLong"})
    expectSame(line + "--to equirect", line + "--to " + name);
  expectSame(line + "--to equal-area", line + "--to Equal_Area");
  expectSame(line + "--to cube --layout hcross --for directx", line + "--to Cube --layout HCross --for DX");
  expectSame(line + "--to cube --layout hcross --for three", line + "--to cube --layout hcross --for threejs");
  expectSame(line + "--to equirect --for unity", line + "--to equirect --for Unity");
  expectSame(line + "--to equirect --filter bilinear", line + "--to equirect --filter Linear");
  expectSame(line + "--to cube --from equirect", line + "--to cube --from latlong");
  expectSame(line + "--to equirect --from equirect:centre=-z", line + "--to equirect --from equirectangular:center=-Z");
  expectSame(line + "--to equirect --centre 1,0,0", line + "--to equirect --center 1,0,0");
  expectSame(line + "--to cube --flip both --as-seen", line + "--to cube --flip BOTH --as-seen");
  expectSame("convert white --to cube --size 4", "convert White --to cube --size 4");
  for (const std::string name : {"HALF", "float16", "fp16"})
    expectSame(line + "--to cube --format half", line + "--to cube --format " + name);
}

TEST_F(AliasTest, BakeTurnsTheLightByEitherName) {
  succeed("bake map.exr --size 8 --rotate 30,20,10 -o a.ktx2");
  succeed("bake map.exr --size 8 --env-rotation 30,20,10 -o b.ktx2");
  EXPECT_TRUE(bytes("a.ktx2") == bytes("b.ktx2"));
  succeed("bake map.exr --for unity --levels 7 --size 64 -o a.ktx2");
  succeed("bake map.exr --for UNITY --levels 7 --size 64 -o b.ktx2");
  EXPECT_TRUE(bytes("a.ktx2") == bytes("b.ktx2")) << "the mip mapping goes by the program too";
}

TEST_F(AliasTest, OnlyWhatIsCloseIsSuggested) {
  EXPECT_THAT(refuse(2, "convert map.exr --json -o out.exr"),
              AllOf(HasSubstr("--json"), Not(HasSubstr("did you mean"))));
  EXPECT_THAT(refuse(2, "info map.exr --jsno"), HasSubstr("did you mean --json?"));
  EXPECT_THAT(refuse(2, "convert map.exr --rotation 3 -o out.exr"), HasSubstr("did you mean --rotate?"));
}

using AliasRenderTest = RenderCliTest;

TEST_F(AliasRenderTest, MaterialsModelsAndParametersToo) {
  const std::string line = " -e uv --size 24x24 ";
  succeed("render sphere --material gold --tone-map agx" + line + "--rotate 30,20,10 -o a.png");
  succeed("render Sphere --material Gold --tone-map AgX" + line + "--env-rotation 30,20,10 -o b.png");
  EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
  succeed("render teapot --up z" + line + "-o a.png");
  succeed("render teapot --up +Z" + line + "-o b.png");
  EXPECT_TRUE(bytes("a.png") == bytes("b.png"));
  EXPECT_THAT(refuse(2, "render sphere --set roughness=0.3" + line + "-o c.png"),
              HasSubstr("did you mean 'perceptual_roughness'?"));
}

// Light that convert has turned, and light that render turns, are seen alike.
TEST_F(AliasRenderTest, RenderTurnsTheLightAsConvertDoes) {
  succeed("convert uv --to cube --size 64 --rotate 40,25,-15 -o turned.exr");
  for (const std::string command : {"render none --camera 200,10 --size 32x32", "capture none --at 0,0,0 --size 16"}) {
    succeed(command + " -e turned.exr -o a.exr");
    succeed(command + " -e uv --rotate 40,25,-15 -o b.exr");
    const Image a = image("a.exr");
    const Image b = image("b.exr");
    double sum = 0.0;
    for (std::size_t i = 0; i < a.samples().size(); ++i)
      sum += std::abs(double(a.samples()[i]) - double(b.samples()[i]));
    EXPECT_LT(sum / double(a.samples().size()), 0.02) << command;
  }
}

}  // namespace
}  // namespace mirrorball::testing
