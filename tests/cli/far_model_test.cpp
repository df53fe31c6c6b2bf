// Models far from the origin of their coordinates, very small and very large ones: they look as they do near it, of
// ordinary size.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "mirrorball/scene/place_text.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball::testing {
namespace {

using ::testing::HasSubstr;

// A million of the model's sizes away, in numbers that floats do not hold at its own.
constexpr glm::dvec3 kAway(4400000.125, -3100000.5, 2000000.25);

class FarModelTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("smooth.exr", smoothPanorama());
    write("near.obj", objText(1.0, glm::dvec3(0.0)));
  }

  /// A torus that lies askew: no two axes look the same, and no edge lies between two pixels.
  static const Mesh& torus() {
    static const Mesh mesh = [] {
      Mesh made = torusMesh(48, 24);
      for (Vertex& vertex : made.vertices) {
        const auto [x, y, z] = std::tuple(vertex.position.x, vertex.position.y, vertex.position.z);
        vertex.position = {0.8f * x - 0.55f * z + 0.3f, y + 0.2f * x, 0.55f * x + 0.8f * z - 0.1f};
      }
      return made;
    }();
    return mesh;
  }

  static std::string spaced(glm::dvec3 place) {
    std::string text = writtenPlace(place);
    for (char& letter : text)
      if (letter == ',') letter = ' ';
    return text;
  }

  static std::string objText(double scale, glm::dvec3 away) {
    std::string text;
    for (const Vertex& vertex : torus().vertices)
      text += "v " + spaced(scale * glm::dvec3(vertex.position) + away) + "\n";
    const std::vector<std::uint32_t>& indices = torus().indices;
    for (std::size_t i = 0; i < indices.size(); i += 3)
      text += "f " + std::to_string(indices[i] + 1) + " " + std::to_string(indices[i + 1] + 1) + " " +
              std::to_string(indices[i + 2] + 1) + "\n";
    return text;
  }

  template <typename Number>
  static Bytes plyBytes(glm::dvec3 away) {
    const std::vector<Vertex>& vertices = torus().vertices;
    const std::vector<std::uint32_t>& indices = torus().indices;
    const std::string type = sizeof(Number) == 4 ? "float" : "double";
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                               std::to_string(vertices.size()) + "\nproperty " + type + " x\nproperty " + type +
                               " y\nproperty " + type + " z\nelement face " + std::to_string(indices.size() / 3) +
                               "\nproperty list uchar int vertex_indices\nend_header\n";
    Bytes bytes(header.begin(), header.end());
    const auto put = [&](auto number) {
      const auto* const begin = reinterpret_cast<const std::uint8_t*>(&number);
      bytes.insert(bytes.end(), begin, begin + sizeof number);
    };
    for (const Vertex& vertex : vertices)
      for (int axis = 0; axis < 3; ++axis) put(static_cast<Number>(double(vertex.position[axis]) + away[axis]));
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (i % 3 == 0) put(std::uint8_t{3});
      put(indices[i]);
    }
    return bytes;
  }

  /// With normals, and those nodes, of which the first is the root.
  static Bytes glbBytes(const std::string& nodes) {
    GltfMaker maker;
    std::vector<float> positions, normals;
    for (const Vertex& vertex : torus().vertices)
      for (int axis = 0; axis < 3; ++axis) {
        positions.push_back(vertex.position[axis]);
        normals.push_back(vertex.normal[axis]);
      }
    maker.accessor(positions, "VEC3");
    maker.accessor(normals, "VEC3");
    maker.accessor(torus().indices, "SCALAR");
    return maker.glb(R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":2})",
                     R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "]");
  }

  /// Draws a model; remarks are no matter.
  void draw(const std::string& model, const std::string& options, const std::string& output) const {
    const std::string usual = options.find("-e ") == std::string::npos ? " -e smooth.exr" : "";
    succeed("render " + model + usual + " --size 64x48 --no-cache --quiet " + options + " -o " + output);
  }

  /// Whether two models look the same; where they do not, what differs.
  void expectSame(const std::string& model, const std::string& like, const std::string& options,
                  const std::string& options_of_like) const {
    draw(model, options, "seen.exr");
    draw(like, options_of_like, "right.exr");
    succeed("compare seen.exr right.exr --threshold rmse=0.001");
  }
  void expectSame(const std::string& model, const std::string& like, const std::string& options = "") const {
    expectSame(model, like, options, options);
  }
};

TEST_F(FarModelTest, LooksAsItDoesNearTheOrigin) {
  write("far.obj", objText(1.0, kAway));
  write("far.ply", plyBytes<double>(kAway));
  for (const std::string model : {"far.obj", "far.ply"})
    for (const std::string options : {"--material gold --quality good", "--reference --samples 32"}) {
      if (model == "far.ply") write("near.ply", plyBytes<double>(glm::dvec3(0.0)));
      expectSame(model, model == "far.ply" ? "near.ply" : "near.obj", options);
    }
}

TEST_F(FarModelTest, OfGltfLooksSoWhereverItsNodesPutIt) {
  write("near.glb", glbBytes(R"({"mesh":0})"));
  write("node.glb", glbBytes(R"({"mesh":0,"translation":[4400000.125,-3100000.5,2000000.25]})"));
  write("nested.glb", glbBytes(R"({"children":[1],"translation":[4400000,-3100000,1e6]},)"
                               R"({"children":[2],"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0.125,-0.5,1000000.25,1]},)"
                               R"({"mesh":0})"));
  for (const std::string model : {"node.glb", "nested.glb"})
    for (const std::string options : {"--material gold --quality good", "--reference --samples 32"})
      expectSame(model, "near.glb", options);
}

// What 32 bits hold is shown, and reported: a model with its coordinates rounded likewise looks the same.
TEST_F(FarModelTest, OfFloatsIsTheOneThatTheyWereRoundedTo) {
  write("far.ply", plyBytes<float>(kAway));
  std::string rounded;
  Bytes same = plyBytes<double>(glm::dvec3(0.0));
  const std::size_t begin = std::string(same.begin(), same.begin() + 300).find("end_header\n") + 11;
  for (std::size_t i = 0; i < torus().vertices.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double there = double(torus().vertices[i].position[axis]) + kAway[axis];
      const double back = double(static_cast<float>(there)) - kAway[axis];
      std::memcpy(same.data() + begin + (3 * i + std::size_t(axis)) * sizeof back, &back, sizeof back);
    }
  write("rounded.ply", same);
  expectSame("far.ply", "rounded.ply");
  const Outcome outcome = run("render far.ply -e smooth.exr --size 8x8 -o outcome.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("its 32-bit vertices are rounded to 0.5"));
}

TEST_F(FarModelTest, PlacesOnTheCommandLineAreInItsCoordinates) {
  write("far.obj", objText(1.0, kAway));
  expectSame("far.obj", "near.obj", "--target 4400001.125,-3100000.5,2000000.25 --camera 20,10,4",
             "--target 1,0,0 --camera 20,10,4");
  expectSame("far.obj", "near.obj", "--light 4400001.125,-3099997.5,2000002.25,2,1,0.5", "--light 1,3,2,2,1,0.5");
  expectSame("far.obj", "near.obj",
             "--material gold --proxy sphere:4400000.125,-3100000.5,2000000.25,5 "
             "--captured-at 4400001.125,-3100000.5,2000000.25",
             "--material gold --proxy sphere:0,0,0,5 --captured-at 1,0,0");
  // A light turns with the camera, about the middle that it looks at.
  for (const std::string model : {"far", "near"})
    draw(model + ".obj",
         "--frames 3 --turn model --camera 20,10,4 --light " +
             std::string(model == "far" ? "4400001.125,-3099997.5,2000002.25" : "1,3,2") + ",2,1,0.5",
         model + "_%d.exr");
  succeed("compare far_1.exr near_1.exr --threshold rmse=0.001");
  succeed("capture far.obj --at 4400000.125,-3098500.5,2000000.25 -e smooth.exr --size 16 --quiet -o far.exr");
  succeed("capture near.obj --at 0,1500,0 -e smooth.exr --size 16 --quiet -o near.exr");
  succeed("compare far.exr near.exr --threshold rmse=0.001");
}

TEST_F(FarModelTest, IsDescribedAndExportedWhereItIs) {
  write("far.obj", objText(1.0, kAway));
  const std::string place = "a ball about 4400000.425 -3100000.5 2000000.15 of radius";
  EXPECT_THAT(succeed("info far.obj"), HasSubstr(place));
  succeed("export far.obj --quiet -o out.glb");
  expectSame("out.glb", "near.obj", "--material gold");
  EXPECT_THAT(succeed("info out.glb"), HasSubstr(place));
}

// What is transferred between two models that lie in one place is so however far away that is.
TEST_F(FarModelTest, TwoModelsStayAtTheSamePlace) {
  write("far.obj", objText(1.0, kAway));
  const auto sidesAt = [](glm::dvec3 away) {
    std::string text = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    for (const glm::dvec3 corner : {glm::dvec3(-2.03, 0.3, 2.07), glm::dvec3(3.04, 0.3, 2.07),
                                    glm::dvec3(3.04, 0.3, -2.01), glm::dvec3(-2.03, 0.3, -2.01)})
      text += "v " + spaced(corner + away) + "\n";
    return text + "f 1/1 2/2 3/3 4/4\n";
  };
  write("far_low.obj", sidesAt(kAway));
  write("near_low.obj", sidesAt(glm::dvec3(0.0)));
  for (const std::string place : {"far", "near"})
    run("transfer " + place + ".obj " + place + "_low.obj --size 64 --cage 0.5 --quiet -o " + place + ".png");
  succeed("compare far.png near.png --threshold rmse=0.01");
}

TEST_F(FarModelTest, AModelLooksTheSameInAnyUnit) {
  write("near.glb", glbBytes(R"({"mesh":0})"));
  for (const std::string options : {"--material gold --quality good", "--reference --samples 16 --material gold"}) {
    for (const std::string form : {".obj", ".glb"}) draw("near" + form, options, "near" + form + ".exr");
    for (const std::string scale : {"1e-9", "1e-6", "1e9", "1e12"}) {
      SCOPED_TRACE(scale);
      write("scaled.obj", objText(std::stod(scale), glm::dvec3(0.0)));
      write("scaled.glb", glbBytes(R"({"mesh":0,"scale":[)" + scale + "," + scale + "," + scale + "]}"));
      for (const std::string form : {".obj", ".glb"}) {
        draw("scaled" + form, options, "scaled.exr");
        succeed("compare scaled.exr near" + form + ".exr --threshold rmse=0.001");
      }
    }
  }
  write("scaled.obj", objText(1e-6, glm::dvec3(0.0)));
  expectSame("scaled.obj", "near.obj", "-e sky --stand");
}

TEST_F(FarModelTest, WhatNoNumbersHoldIsRefusedInOneLine) {
  write("huge.obj", objText(1e30, glm::dvec3(0.0)));
  EXPECT_THAT(refuse(1, "render huge.obj -e white -o out.exr"), HasSubstr("scale the model down"));
  write("nowhere.obj", objText(1.0, glm::dvec3(1e30)));
  EXPECT_THAT(run("render nowhere.obj -e white --size 8x8 -o out.exr").err, HasSubstr("has an area; nothing is seen"));
}

}  // namespace
}  // namespace mirrorball::testing
