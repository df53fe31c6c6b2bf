// Models that cannot be read: one clear line each, exit code 1, nothing written. Those of which something is left are
// drawn, with a note.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A triangle in a buffer file of its own, with a texture in a file of its own; any of its parts may be replaced.
struct TriangleGltf {
  std::string buffers = R"([{"byteLength": 60, "uri": "triangle.bin"}])";
  std::string views = R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}])";
  std::string positions = R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})";
  std::string node = R"({"mesh": 0})";
  std::string textures = R"([{"source": 0}])";
  std::string images = R"([{"uri": "color.png"}])";

  std::string text() const {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" + node +
           R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
           "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}], "accessors": [)" +
           positions + R"(, {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}], "bufferViews": )" +
           views + R"(, "buffers": )" + buffers + R"(, "textures": )" + textures + R"(, "images": )" + images + "}";
  }
};

class BadModelTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    const std::vector<float> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
    Bytes buffer(numbers.size() * sizeof(float));
    std::memcpy(buffer.data(), numbers.data(), buffer.size());
    write("triangle.bin", buffer);
    write("color.png", Image(4, 4, 3, 0.5f));
  }

  /// `render` refuses a model file, in a line that begins with its name and says `what`.
  void refuseModel(const std::string& name, const std::string& what = "") const {
    EXPECT_THAT(refuse(1, "render " + name + " -e white --size 8x8 -o out.png"),
                AllOf(StartsWith(name + ": "), HasSubstr(what)));
  }

  void refuseTriangle(const TriangleGltf& gltf, const std::string& what) const {
    write("triangle.gltf", gltf.text());
    refuseModel("triangle.gltf", what);
  }

  /// `render` draws a model file, with one note of `what`.
  void drawWithNote(const std::string& name, const std::string& what) const {
    const Outcome outcome = run("render " + name + " -e white --size 8x8 -o out.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: note: " + name + ": "), HasSubstr(what)));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(image("out.png").width(), 8);
  }
};

const std::vector<std::string> kModelExtensions{"glb", "gltf", "obj", "ply", "stl"};

TEST_F(BadModelTest, TheWholeTriangleIsDrawn) {
  write("triangle.gltf", TriangleGltf{}.text());
  succeed("render triangle.gltf -e white --size 8x8 -o out.png");
}

TEST_F(BadModelTest, AFileThatIsNotThere) {
  for (const std::string& extension : kModelExtensions) refuseModel("missing." + extension, "no such file");
  EXPECT_THAT(refuse(1, "render spheer -e white -o out.png"), AllOf(HasSubstr("spheer"), HasSubstr("sphere, torus")));
}

TEST_F(BadModelTest, OneWithoutAnyAreaIsTold) {
  write("point.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 1\n"));
  const Outcome outcome = run("render point.obj -e white --size 8x8 -o out.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "mirrorball: note: point.obj: none of its triangles has an area; nothing is seen\n");
}

// 128 of 255 and not 128 times white.
TEST_F(BadModelTest, ColoursInCodesAreTold) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{-9, -9, 0, 9, -9, 0, 0, 9, 0}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{128, 0, 0, 255, 128, 0, 0, 255, 128, 0, 0, 255}, "VEC4");
  const std::string unlit = R"("materials":[{"extensions":{"KHR_materials_unlit":{}}}])";
  write("codes.gltf", maker.gltf(R"({"attributes":{"POSITION":0,"COLOR_0":1},"material":0})", unlit));
  drawWithNote("codes.gltf", "accessors[1]: is of colours in integers that are not 'normalized'");
  EXPECT_EQ(run("render codes.gltf -e white --size 8x8 -o out.exr").exit_code, 0);
  EXPECT_NEAR(image("out.exr").texel(4, 4)[0], 128.0f / 255.0f, 1e-3f);
}

TEST_F(BadModelTest, AnOpenSurfaceOfGlassIsTold) {
  const Outcome open = run("render teapot --material glass -e white --size 8x8 -o out.png");
  EXPECT_EQ(open.exit_code, 0);
  EXPECT_EQ(
      open.err,
      "mirrorball: note: teapot: the surface of the material 'glass' is open, so light that enters there may never "
      "leave the body; --set thin_walled=yes makes it a thin sheet without an inside\n");
  succeed("render teapot --material glass --set thin_walled=yes -e white --size 8x8 -o out.png");
  succeed("render tumbler-water -e white --size 8x8 -o out.png");
}

TEST_F(BadModelTest, AnEmptyFileOrOneOfAnotherKind) {
  for (const std::string& extension : kModelExtensions) {
    write("empty." + extension, std::string());
    refuseModel("empty." + extension);
    write("words." + extension, std::string("These are no triangles but words, and quite a few of them, so that even "
                                            "an STL file's 80 bytes of header are there.\n"));
    refuseModel("words." + extension);
  }
  write("model.fbx", std::string("Kaydara"));
  refuseModel("model.fbx", "is an FBX, which is not read; open it in Blender and export it as glTF 2.0 (.glb)");
  write("model.xyz", std::string("1 2 3"));
  refuseModel("model.xyz", ".glb .gltf .obj .ply .stl");
  std::filesystem::create_directory(path("folder.obj"));
  refuseModel("folder.obj", "is a folder");
}

TEST_F(BadModelTest, AFolderNamesTheModelsInIt) {
  const auto make = [&](const std::string& file) {
    std::filesystem::create_directories(path(file).parent_path());
    write(file, std::string("v"));
  };
  std::filesystem::create_directory(path("empty"));
  refuseModel("empty", "is a folder without a model (.glb .gltf .obj .ply .stl)");
  make("helmet/helmet.gltf");
  make("helmet/helmet.bin");
  for (const std::string name : {"helmet", "helmet/"})
    EXPECT_THAT(refuse(1, "render " + name + " -e white --size 8x8 -o out.png"),
                AllOf(StartsWith(name + ": is a folder; "), HasSubstr("name the model in it: helmet/helmet.gltf")));
  for (const std::string name : {"many/b.obj", "many/a.glb", "many/c.STL"}) make(name);
  refuseModel("many", "one of the models in it: many/a.glb, many/b.obj, many/c.STL");
  make("many/d.ply");
  make("many/e.ply");
  refuseModel("many", "many/d.ply, …");
}

TEST_F(BadModelTest, ATruncatedFile) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const Bytes whole = maker.glb("{\"attributes\":{\"POSITION\":0}}");
  write("whole.glb", whole);
  succeed("render whole.glb -e white --size 8x8 -o whole.png");
  for (const std::size_t length : {std::size_t{3}, std::size_t{15}, whole.size() / 2, whole.size() - 5}) {
    write("cut.glb", Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length)));
    refuseModel("cut.glb");
  }
  const std::string gltf = TriangleGltf{}.text();
  write("cut.gltf", gltf.substr(0, gltf.size() / 2));
  refuseModel("cut.gltf");
  write("cut.ply", std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                               "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"));
  refuseModel("cut.ply");
  write("cut.stl", std::string("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"));
  refuseModel("cut.stl");
}

TEST_F(BadModelTest, ABufferThatIsMissingOrTooShort) {
  refuseTriangle({.buffers = R"([{"byteLength": 60, "uri": "none.bin"}])"}, "none.bin");
  write("short.bin", std::string(20, '\0'));
  refuseTriangle({.buffers = R"([{"byteLength": 60, "uri": "short.bin"}])"}, "short.bin");
  refuseTriangle({.buffers = "[]"}, "buffers");
}

TEST_F(BadModelTest, NumbersThatReachBeyondTheirBuffer) {
  const std::string second = R"({"buffer": 0, "byteOffset": 36, "byteLength": 24})";
  refuseTriangle({.views = R"([{"buffer": 3, "byteLength": 36}, )" + second + "]"}, "bufferViews[0]");
  refuseTriangle({.views = R"([{"buffer": 0, "byteOffset": 40, "byteLength": 36}, )" + second + "]"}, "bufferViews[0]");
  refuseTriangle({.positions = R"({"bufferView": 0, "componentType": 5126, "count": 3000, "type": "VEC3"})"},
                 "accessors[0]");
  refuseTriangle({.positions = R"({"bufferView": 9, "componentType": 5126, "count": 3, "type": "VEC3"})"},
                 "accessors[0]");
  refuseTriangle({.node = R"({"mesh": 7})"}, "nodes[0]");
}

// As of an OBJ: the model is worth showing without it.
TEST_F(BadModelTest, WithoutATextureThatIsMissingOutOfRangeOrNoPictureItIsDrawnWithANote) {
  const auto drawTriangle = [&](const TriangleGltf& gltf, const std::string& what) {
    write("triangle.gltf", gltf.text());
    drawWithNote("triangle.gltf", what);
  };
  drawTriangle({.images = R"([{"uri": "none.png"}])"},
               "'none.png' is missing; put it beside the model; the picture is");
  write("words.png", std::string("no picture"));
  drawTriangle({.images = R"([{"uri": "words.png"}])"}, "images[0]");
  write("empty.png", std::string());
  drawTriangle({.images = R"([{"uri": "empty.png"}])"}, "images[0] is empty");
  drawTriangle({.images = R"([{"uri": "C:\\maps\\Color.PNG"}])"}, "is read from 'color.png' in the model's folder");
  drawTriangle({.textures = R"([{"source": 9}])"}, "textures[0]");
  drawTriangle({.textures = "[]"}, "baseColorTexture");
}

TEST_F(BadModelTest, NormalsOfNoDirectionAreMadeAndTold) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 0, std::nanf(""), 0, 1}, "VEC3");
  write("normals.glb", maker.glb(R"({"attributes":{"POSITION":0,"NORMAL":1}})"));
  drawWithNote("normals.glb", "2 normals have no direction and are made from the triangles around");
}

TEST_F(BadModelTest, AnIndexBeyondTheVertices) {
  write("model.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"));
  refuseModel("model.obj", "names a vertex that is not there");
  write("model.ply",
        std::string(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n"));
  refuseModel("model.ply");
}

// A model is worth showing without its materials: that is a note, and the picture is there.
TEST_F(BadModelTest, AnObjWithoutItsMaterialsIsDrawnWithANote) {
  write("model.obj", std::string("mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  const Outcome outcome = run("render model.obj -e white --size 8x8 -o out.png");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("mirrorball: note: "), HasSubstr("none.mtl")));
  EXPECT_EQ(image("out.png").width(), 8);
}

}  // namespace
}  // namespace mirrorball::testing
