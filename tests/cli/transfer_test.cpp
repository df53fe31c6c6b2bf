// What `mirrorball transfer` writes and says.

#include <algorithm>
#include <cmath>
#include <string>

#include "cli/cli_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

/// A square that has no texture coordinates.
const std::string kSquare =
    "solid square\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid square\n";

/// The square of kSquare as it lies in a texture, upright; and a roof over it, whose ridge is at x = ½.
const std::string kFlat =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
const std::string kRoof =
    "v 0 0 0\nv 0.5 0 0.02\nv 1 0 0\nv 0 1 0\nv 0.5 1 0.02\nv 1 1 0\n"
    "vn -0.04 0 1\nvn 0.04 0 1\nf 1//1 2//1 5//1 4//1\nf 2//2 3//2 6//2 5//2\n";

class TransferTest : public CliTest {
 protected:
  void SetUp() override {
    write("flat.obj", kFlat);
    write("roof.obj", kRoof);
    write("square.stl", kSquare);
  }

  /// The worst distance of a map's texels from a vector.
  float farthestFrom(const std::string& name, glm::vec3 wanted) const {
    const Image map = image(name);
    float worst = 0.0f;
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) worst = std::max(worst, glm::distance(rgbAt(map, x, y), wanted));
    return worst;
  }
};

TEST_F(TransferTest, NormalsAndHeightsOfARoof) {
  EXPECT_THAT(succeed("transfer roof.obj flat.obj --size 16 --samples 1 -o normal.exr --height height.exr"), IsEmpty());
  const Image normals = image("normal.exr"), heights = image("height.exr");
  const float slope = 0.04f / std::sqrt(1.0f + 0.04f * 0.04f);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      EXPECT_NEAR(normals.texel(x, y)[0], x < 8 ? -slope : slope, 1e-4f) << x;
      EXPECT_NEAR(normals.texel(x, y)[1], 0.0f, 1e-4f);
      EXPECT_NEAR(heights.texel(x, y)[0], 0.02f - 0.04f * std::abs((float(x) + 0.5f) / 16.0f - 0.5f), 1e-4f);
    }
}

TEST_F(TransferTest, PicturesHoldSharesAndGreenUpOrDown) {
  write("slanted.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.03\nv 0 1 0.03\nf 1 2 3 4\n");
  const std::string told = succeed("transfer slanted.obj flat.obj --size 8 -o up.png --height height.png");
  EXPECT_THAT(told, MatchesRegex("heights from 0.001.* to 0.028.*\n"));
  succeed("transfer slanted.obj flat.obj --size 8 --directx -o down.png");
  const Image8 up = decodeTexture(bytes("up.png")).value(), down = decodeTexture(bytes("down.png")).value();
  const Image8 heights = decodeTexture(bytes("height.png")).value();
  EXPECT_LT(up.texel(4, 4)[1], 125);  // it rises up the texture, and leans down
  EXPECT_EQ(int(up.texel(4, 4)[1]) + int(down.texel(4, 4)[1]), 255);
  EXPECT_EQ(heights.texel(3, 0)[0], 255);
  EXPECT_EQ(heights.texel(3, 7)[0], 0);
}

TEST_F(TransferTest, SpacesAndOcclusion) {
  succeed("transfer sphere sphere --size 32 -o tangent.exr --occlusion visible.exr --bent-normal bent.exr --rays 16");
  EXPECT_LT(farthestFrom("tangent.exr", {0, 0, 1}), 0.02f);
  const Image visible = image("visible.exr");
  double sum = 0.0;
  for (const float share : visible.samples()) sum += double(share);
  EXPECT_GT(sum / double(visible.texelCount()), 0.995);  // a ball hides nothing from itself, its facets hardly anything
  EXPECT_LT(farthestFrom("bent.exr", {0, 0, 1}), 0.6f);  // 16 directions
  succeed("transfer sphere sphere --size 32 --space object -o object.exr");
  succeed("surface object.exr --to tangent-normal --model sphere -o back.exr");
  EXPECT_LT(farthestFrom("back.exr", {0, 0, 1}), 0.05f);
}

TEST_F(TransferTest, MakesALightModelWithItsMap) {
  const std::string told = succeed("transfer sphere --simplify 300 --size 128 -o normal.png --model-out light.glb");
  EXPECT_THAT(told, StartsWith("300 triangles, moved by "));
  EXPECT_THAT(told, HasSubstr(" charts, stretch 1."));
  const auto light = loadModel(path("light.glb").string());
  ASSERT_TRUE(light) << light.error().message;
  EXPECT_EQ(light->meshes[0]->indices.size(), 900u);
  ASSERT_EQ(light->textures.size(), 1u);
  EXPECT_EQ(light->materials[0].normal_map.texture, 0);
  EXPECT_EQ(light->textures[0].image.width(), 128);
  // What was written is the map of what was written: made again of it, it is the same but for rounding.
  succeed("transfer --quiet sphere light.glb --size 128 -o again.png");
  const Image8 first = decodeTexture(bytes("normal.png")).value(), again = decodeTexture(bytes("again.png")).value();
  std::size_t apart = 0;
  for (std::size_t i = 0; i < first.samples().size(); ++i)
    apart += std::abs(int(first.samples()[i]) - int(again.samples()[i])) > 1 ? 1u : 0u;
  EXPECT_LT(apart, first.samples().size() / 100);
}

TEST_F(TransferTest, OneTriangleIsOneChart) {
  write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string told = succeed("transfer one.obj --simplify 1 --size 16 -o normal.png");
  EXPECT_THAT(told, AllOf(StartsWith("1 triangle, "), HasSubstr("; 1 chart, ")));
}

TEST_F(TransferTest, IsTheSameForAnyNumberOfThreads) {
  const std::string line = "transfer knot --simplify 500 --size 64 --occlusion visible.exr --rays 4 -o ";
  succeed(line + "one.exr --threads 1");
  const Bytes visible = bytes("visible.exr");
  succeed(line + "three.exr --threads 3");
  EXPECT_EQ(bytes("one.exr"), bytes("three.exr"));
  EXPECT_EQ(visible, bytes("visible.exr"));
}

TEST_F(TransferTest, SaysWhatIsDoubtful) {
  write("half.obj", "v 0 0 0\nv 0.5 0 0\nv 0.5 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_THAT(run("transfer half.obj flat.obj --size 8 -o normal.png").err,
              AllOf(HasSubstr("50.0 % of the rays met nothing of half.obj"), HasSubstr("--cage")));
  write("mirrored.obj",
        "v 0 0 0\nv 0.5 0 0\nv 1 0 0\nv 0 1 0\nv 0.5 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 5/4/1 4/3/1\nf 2/2/1 3/1/1 6/3/1 5/4/1\n");
  EXPECT_THAT(run("transfer flat.obj mirrored.obj --size 8 -o normal.png").err, HasSubstr("several triangles"));
}

TEST_F(TransferTest, RefusesWithOneLine) {
  EXPECT_THAT(refuse(2, "transfer"), HasSubstr("dense model"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj"), HasSubstr("-o"));
  EXPECT_THAT(refuse(2, "transfer roof.obj -o normal.png"), HasSubstr("--simplify"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj --simplify 3 -o normal.png"), HasSubstr("leave flat.obj out"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o normal.jpg"), HasSubstr(".png"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o a.png --height a.png"), HasSubstr("a.png"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o a.png --model-out low.obj"), HasSubstr(".glb"));
  EXPECT_THAT(refuse(2, "transfer roof.obj --simplify 0 -o a.png"), HasSubstr("needs a light model"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o a.png --space object --model-out low.glb"),
              HasSubstr("tangent"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o a.png --rays 8"), HasSubstr("--occlusion"));
  EXPECT_THAT(refuse(2, "transfer roof.obj flat.obj -o a.png --samples 5"), HasSubstr("16"));
  EXPECT_THAT(refuse(1, "transfer roof.obj flat.obj -o nowhere/a.png"), HasSubstr("nowhere"));
  EXPECT_THAT(refuse(1, "transfer absent.ply flat.obj -o a.png"), HasSubstr("absent.ply"));
  EXPECT_THAT(refuse(1, "transfer roof.obj square.stl -o a.png"), HasSubstr("square.stl: has no texture coordinates"));
  EXPECT_THAT(refuse(1, "transfer none flat.obj -o a.png"), HasSubstr("no triangles"));
  write("far.obj", "v 0 0 9\nv 1 0 9\nv 1 1 9\nf 1 2 3\n");
  EXPECT_THAT(refuse(1, "transfer far.obj flat.obj -o a.png"), HasSubstr("no ray"));
  EXPECT_THAT(refuse(1, "transfer sphere --simplify 100 --size 4 -o a.png"), HasSubstr("do not fit"));
  EXPECT_THAT(refuse(1, "transfer roof.obj flat.obj --size 8192 --max-memory 50M -o a.png"),
              AllOf(HasSubstr("the maps"), HasSubstr("--max-memory")));
  write("stretched.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 99999 0\nvt 0 1\nf 1/1 2/2 3/3\n");
  EXPECT_THAT(refuse(1, "transfer roof.obj stretched.obj -o a.png"), HasSubstr("from 0 to 1"));
}

class TransferRenderTest : public RenderCliTest {
 protected:
  /// How far a picture is from dense.png, as an observer sees it.
  double flipOf(const std::string& picture) const {
    const std::string told = succeed("compare " + picture + " dense.png");
    return std::stod(told.substr(told.find("FLIP") + 4));
  }
};

TEST_F(TransferRenderTest, AStatueOfFewTrianglesLooksAsTheDenseOne) {
  if (!share("lucy.glb")) GTEST_SKIP() << "lucy.glb is not in the shared data folder";
  succeed("transfer lucy.glb --simplify 5000 --model-out light.glb");
  const std::string size = " --size 480x640 -o ";
  succeed("render lucy.glb" + size + "dense.png");
  succeed("render --quiet light.glb" + size + "mapped.png");
  succeed("render --quiet light.glb --set normal_scale=0" + size + "bare.png");
  EXPECT_LT(flipOf("mapped.png"), 0.05);
  EXPECT_LT(flipOf("mapped.png"), flipOf("bare.png") / 3.0);
}

}  // namespace
}  // namespace mirrorball::testing
