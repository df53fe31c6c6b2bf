// Models by name and from files of every format.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;

class ModelCliTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("smooth.exr", smoothPanorama());
  }

  /// Draws 64 × 64 pixels, nothing behind the model.
  Image draw(const std::string& options) const {
    succeed("render " + options + " -e smooth.exr --size 64x64 --background transparent -o picture.exr");
    return image("picture.exr");
  }
};

TEST_F(ModelCliTest, EveryBuiltInModelIsSeen) {
  for (const std::string_view model : builtinModelNames()) {
    // Without its absorption it would say that it lacks it.
    const std::string options = model == "attenuation-grid" ? " --refraction auto" : "";
    const Contents contents = contentsOf(draw(std::string(model) + options));
    if (model == "none") {
      EXPECT_EQ(contents.texels, 0);
      continue;
    }
    // The plane is seen from 15° above its own, and shows the least.
    EXPECT_GT(contents.texels, model == "plane" ? 250 : 700) << model;
    EXPECT_GT(contents.mean, 0.1) << model;
  }
}

// The same square, x and y from −1 to 1, in every format; its sides are told apart by what they reflect.
TEST_F(ModelCliTest, EveryFormatShowsTheSameSquare) {
  write("square.obj", std::string("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"));
  write("square.ply",
        std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                    "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n"));
  write("square.stl", std::string("solid square\n"
                                  "facet normal 0 0 1\nouter loop\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\n"
                                  "endloop\nendfacet\n"
                                  "facet normal 0 0 1\nouter loop\nvertex -1 -1 0\nvertex 1 1 0\nvertex -1 1 0\n"
                                  "endloop\nendfacet\nendsolid square\n"));
  GltfMaker maker;
  maker.accessor(std::vector<float>{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, "VEC3");
  maker.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR");
  const std::string primitive = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  write("square.gltf", maker.gltf(primitive));
  write("square.glb", maker.glb(primitive));

  const std::string view = " --material mirror --camera 25,10";
  const Image wanted = draw("square.obj" + view);
  EXPECT_GT(contentsOf(wanted).texels, 1000);
  for (const std::string extension : {"ply", "stl", "gltf", "glb"})
    EXPECT_LT(maxDifference(draw("square." + extension + view), wanted), 1e-3) << extension;
}

TEST_F(ModelCliTest, RealModelsAreSeen) {
  for (const char* name : {"Duck.glb", "lucy.glb", "FlightHelmet"})
    if (!share(name)) GTEST_SKIP() << name << " is not there";
  for (const std::string model : {"Duck.glb", "lucy.glb", "FlightHelmet/FlightHelmet.gltf"}) {
    const Contents contents = contentsOf(draw(model + " --quiet"));
    EXPECT_GT(contents.texels, 300) << model;
    EXPECT_GT(contents.mean, 0.02) << model;
  }
}

// All commands that read models, wherever these are told.
TEST_F(ModelCliTest, WhatAModelNamesOutsideOfItsFolderIsRefusedByAllCommandsIfToldSo) {
  fs::create_directory(path("in"));
  constexpr float kPositions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const auto positions = bytesOf(std::span<const float>(kPositions));
  write("outside.bin", Bytes(positions.begin(), positions.end()));
  write("in/model.gltf", std::string(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
                                     R"([{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
                                     R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
                                     R"("byteLength":36}],"buffers":[{"byteLength":36,"uri":"../outside.bin"}]})"));
  Image normals(8, 8, 3);
  for (std::size_t blue = 2; blue < normals.samples().size(); blue += 3) normals.samples()[blue] = 1.0f;
  write("normals.exr", normals);
  for (const std::string command :
       {"render in/model.gltf -e smooth.exr --size 8x8 -o out.exr",
        "render sphere --proxy in/model.gltf -e smooth.exr --size 8x8 -o out.exr",
        "render in/model.gltf --reference -e smooth.exr --size 8x8 -o out.exr",
        "capture in/model.gltf --at 0,0,1 -e smooth.exr --size 8 -o out.exr",
        "capture sphere --proxy in/model.gltf --at 0,0,2 -e smooth.exr --size 8 -o out.exr",
        "study in/model.gltf -e smooth.exr --size 8x8 -o out.html", "export in/model.gltf -o out.glb",
        "info in/model.gltf", "transfer in/model.gltf sphere --size 8 -o out.png",
        "transfer sphere in/model.gltf --size 8 -o out.png",
        "surface normals.exr --to object-normal --model in/model.gltf -o out.exr"})
    EXPECT_THAT(refuse(1, command + " --inside-only"), ::testing::HasSubstr("lies outside of the model's folder"))
        << command;
  EXPECT_THAT(run("export in/model.gltf -o out.glb").err, ::testing::HasSubstr("outside of its folder"));
}

// Colours and pictures of models as scanners and painters write them, and the notes on what is odd about their files.
TEST_F(ModelCliTest, ModelsOfOtherProgramsAreShownAsTheyAreMeant) {
  const std::string view =
      " --camera 0,0 --orthographic 1.4142 --size 16x16 --background 0,0,0 --set unlit=yes -e white -o picture.exr";
  const auto colorAt = [&](int x) {
    const Image picture = image("picture.exr");
    return glm::vec3(picture.texel(x, 8)[0], picture.texel(x, 8)[1], picture.texel(x, 8)[2]);
  };
  // A picture of red and blue, twice across and a quarter on.
  std::string halves = "P6 8 1 255\n";
  for (int x = 0; x < 8; ++x) halves += x < 4 ? std::string("\xFF\0\0", 3) : std::string("\0\0\xFF", 3);
  write("two colors.ppm", halves);
  write("my model.mtl", std::string("newmtl a\nKd 1 1 1\nmap_Kd -s 2 1 1 -o 0.25 0 0 two colors.ppm\n"));
  write("tiled.obj", std::string("mtllib my model.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                 "vt 0 1\nusemtl a\nf 1/1 2/2 3/3 4/4\n"));
  succeed("render tiled.obj" + view);
  for (const auto& [x, red] : {std::pair(0, 1.0f), std::pair(4, 0.0f), std::pair(8, 1.0f), std::pair(12, 0.0f)})
    EXPECT_NEAR(colorAt(x).r, red, 0.01f) << x;

  write("painted.ply",
        std::string("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                    "float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty uchar "
                    "red\nproperty uchar green\nproperty uchar blue\nend_header\n-1 -1 0\n1 -1 0\n1 1 "
                    "0\n-1 1 0\n4 0 1 2 3 0 255 0\n"));
  succeed("render painted.ply" + view);
  EXPECT_LT(glm::length(colorAt(4) - glm::vec3(0, 1, 0)), 1e-3f);

  // A scan of which a single number is above 1, by rounding and by light.
  for (const auto& [brightest, note] :
       {std::pair("1.0001", ""),
        std::pair("1.5",
                  "mirrorball: note: scan.obj: has colours of vertices from 0 to 1.5: they are cut to 0 to 1\n")}) {
    write("scan.obj",
          std::string("v -1 -1 0 ") + brightest + " 1 0\nv 1 -1 0 1 1 0\nv 1 1 0 1 1 0\nv -1 1 0 1 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(run("render scan.obj" + view).err, note);
    EXPECT_LT(glm::length(colorAt(4) - glm::vec3(1, 1, 0)), 1e-3f) << brightest;
  }

  write("cut.stl", std::string("SOLID a\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX -1 -1 0\nVERTEX 1 -1 0\nVERTEX 1 1 "
                               "0\nENDLOOP\nENDFACET\n"));
  EXPECT_EQ(run("render cut.stl" + view).err,
            "mirrorball: note: cut.stl: does not end with 'endsolid'; it may be truncated\n");
}

}  // namespace
}  // namespace mirrorball::testing
