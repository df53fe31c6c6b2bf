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

}  // namespace
}  // namespace mirrorball::testing
