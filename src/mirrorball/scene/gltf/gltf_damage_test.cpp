#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "test_data.h"

// A glTF file of which nothing is left is refused in one line that names the key of what is wrong; of another the rest
// is shown, and the line is a remark. Nothing makes the reader crash.

namespace mirrorball {
namespace {

using testing::expectSafe;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<float> kDamagedTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::string kPrimitive = "{\"attributes\":{\"POSITION\":0}}";

void expectDamageRefused(const std::string& json, const std::string& part, ErrorCode code = ErrorCode::bad_file) {
  const Result<Scene> scene = decodeGltf(Bytes(json.begin(), json.end()), ::testing::TempDir() + "model.gltf");
  ASSERT_FALSE(scene) << part;
  EXPECT_EQ(scene.error().code, code) << scene.error().message;
  EXPECT_THAT(scene.error().message, Not(HasSubstr("model.gltf")));
  EXPECT_THAT(scene.error().message, HasSubstr(part));
  EXPECT_EQ(scene.error().message, printable(scene.error().message));
  EXPECT_LT(scene.error().message.size(), 400u);
}

void expectDamageTold(const std::string& json, const std::string& part) {
  testing::expectTold(decodeGltf(Bytes(json.begin(), json.end()), ::testing::TempDir() + "model.gltf"), part);
}

/// A file whose primitive, accessor or rest is wrong.
std::string withPrimitive(const std::string& primitive, const std::string& rest = "") {
  GltfMaker maker;
  maker.accessor(kDamagedTriangle, "VEC3");
  maker.accessor(std::vector<std::uint16_t>{0, 1, 3}, "SCALAR");
  return maker.gltf(primitive, rest);
}
std::string withRest(const std::string& rest) { return withPrimitive(kPrimitive, rest); }
std::string withAccessor(const std::string& accessor) {
  GltfMaker maker;
  maker.view(kDamagedTriangle);
  maker.rawAccessor(accessor);
  return maker.gltf(kPrimitive);
}
std::string withMaterial(const std::string& rest) {
  return withPrimitive("{\"attributes\":{\"POSITION\":0},\"material\":0}",
                       "\"materials\":[{\"normalTexture\":{\"index\":0}}]," + rest);
}

TEST(GltfDamage, WhatItSaysIsQuoted) {
  const std::string name = "\\u001b[2J\\n\\u009b" + std::string(100'000, 'x');
  expectDamageRefused("{\"asset\":{\"version\":\"" + name + "\"}}", "asset.version is '?[2J??xxx",
                      ErrorCode::unsupported);
  expectDamageTold(withPrimitive("{\"attributes\":{\"POSITION\":0,\"" + name + "\":\"\"}}"), "attributes.?[2J??xxx");
  expectDamageTold(withRest("\"extensionsRequired\":[\"" + name + "\"]"), "by ?[2J??xxx");
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"" + name + "\"]}", "names '?[2J??xxx",
                      ErrorCode::unsupported);
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"" + name + "\"}]"),
                   "images[0].uri '?[2J??xxx");
}

TEST(GltfDamage, NamesTheKeyOfAWrongAccessor) {
  expectDamageRefused(withAccessor("{\"bufferView\":0,\"componentType\":5126,\"count\":75,\"type\":\"VEC3\"}"),
                      "accessors[0] reaches byte 900 of bufferViews[0], which has 36");
  expectDamageRefused(
      withAccessor("{\"bufferView\":0,\"componentType\":5126,\"count\":9007199254740991,\"type\":\"VEC3\"}"),
      "brings the model above", ErrorCode::too_large);
  expectDamageRefused(
      withAccessor("{\"bufferView\":0,\"byteOffset\":18446744073709551615,\"componentType\":5126,\"count\":3,"
                   "\"type\":\"VEC3\"}"),
      "past the end of every buffer");
  expectDamageRefused(withAccessor("{\"bufferView\":7,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}"),
                      "accessors[0].bufferView is 7, but there is 1 bufferView");
  expectDamageRefused(withAccessor("{\"bufferView\":0,\"componentType\":5126,\"count\":-3,\"type\":\"VEC3\"}"),
                      "accessors[0].count is no whole number");
  expectDamageRefused(withAccessor("{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\"}"),
                      "accessors[0].count is missing");
  expectDamageRefused(withAccessor("{\"bufferView\":0,\"componentType\":5130,\"count\":1,\"type\":\"VEC3\"}"),
                      "accessors[0] has a type");
  expectDamageRefused(withAccessor("{\"bufferView\":0,\"componentType\":5126,\"count\":1,\"type\":\"MAT3\"}"),
                      "accessors[0] has a type");
  expectDamageRefused(withAccessor("{\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}"),
                      "accessors[0] (meshes[0].primitives[0].attributes.POSITION) has no bytes",
                      ErrorCode::unsupported);
  GltfMaker zeros;
  zeros.accessor(kDamagedTriangle, "VEC3");
  zeros.rawAccessor("{\"componentType\":5125,\"count\":20000000,\"type\":\"SCALAR\"}");
  expectDamageRefused(zeros.gltf("{\"attributes\":{\"POSITION\":0},\"indices\":1}"), "accessors[1].count",
                      ErrorCode::too_large);
}

TEST(GltfDamage, NamesTheKeyOfAWrongSparseAccessor) {
  const auto sparse = [](const std::string& json) {
    return withAccessor("{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":" + json +
                        "}");
  };
  expectDamageRefused(
      sparse("{\"count\":4,\"indices\":{\"bufferView\":0,\"componentType\":5121},\"values\":{\"bufferView\":0}}"),
      "accessors[0].sparse.count is 4");
  expectDamageRefused(
      sparse("{\"count\":3,\"indices\":{\"bufferView\":0,\"componentType\":5126},\"values\":{\"bufferView\":0}}"),
      "sparse.indices.componentType");
  expectDamageRefused(
      sparse("{\"count\":3,\"indices\":{\"bufferView\":0,\"byteOffset\":34,\"componentType\":5121},\"values\":"
             "{\"bufferView\":0}}"),
      "accessors[0].sparse.indices reaches byte 37");
  expectDamageRefused(
      sparse("{\"count\":1,\"indices\":{\"bufferView\":0,\"byteOffset\":14,\"componentType\":5121},\"values\":"
             "{\"bufferView\":0}}"),
      "names element 128 of 3");  // a byte of the float 1
  expectDamageRefused(sparse("{\"count\":1}"), "sparse.indices is missing");
}

TEST(GltfDamage, NamesTheKeyOfAWrongPrimitive) {
  expectDamageRefused(withPrimitive("{\"attributes\":{\"POSITION\":0},\"indices\":1}"),
                      "1 triangle names a vertex that is not there");
  expectDamageRefused(withPrimitive("{\"attributes\":{\"POSITION\":5}}"),
                      "meshes[0].primitives[0].attributes.POSITION is 5, but there are 2 accessors");
  expectDamageRefused(withPrimitive("{\"attributes\":{\"POSITION\":0},\"indices\":0}"), "accessors[0] has a type");
  expectDamageRefused(withPrimitive("{\"attributes\":{\"POSITION\":1}}"), "attributes.POSITION has 1 component");
  expectDamageTold(withPrimitive("{\"attributes\":{\"POSITION\":0},\"material\":2}"), "primitives[0].material is 2");
  expectDamageRefused(withPrimitive("{}"), "meshes[0].primitives[0].attributes is missing");
  expectDamageRefused(withPrimitive("{\"attributes\":{\"POSITION\":0},\"mode\":1}"), "shows no triangles");

  GltfMaker maker;
  maker.accessor(kDamagedTriangle, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1}, "VEC3");
  expectDamageTold(maker.gltf("{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}"),
                   "NORMAL has 1 element, but POSITION has 3; the attribute is left out");
  GltfMaker not_finite;
  not_finite.accessor(std::vector<float>{0, 0, 0, 1, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1, 0}, "VEC3");
  expectDamageRefused(not_finite.gltf(kPrimitive), "1 triangle reaches NaN or infinity");
}

TEST(GltfDamage, NamesTheKeyOfAWrongNode) {
  expectDamageRefused(withRest("\"nodes\":[{\"mesh\":4}]"), "nodes[0].mesh is 4, but there is 1 mesh");
  expectDamageRefused(withRest("\"nodes\":[{\"children\":[9]}]"), "nodes[0].children is 9");
  expectDamageRefused(
      withRest("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[1]},{\"children\":[0]}]"),
      "nodes[0] is reached twice");
  expectDamageTold(withRest("\"nodes\":[{\"children\":[1,2]},{\"children\":[2]},{\"mesh\":0}]"),
                   "nodes[2] is reached twice, and nodes form a tree; the second is left out");
  expectDamageRefused(withRest("\"nodes\":[{\"children\":[0]}]"), "shows no triangles");
  expectDamageRefused(withRest("\"scene\":1,\"scenes\":[{}]"), "scene is 1");
  expectDamageTold(withRest("\"nodes\":[{\"mesh\":0,\"scale\":[1,1]}]"),
                   "nodes[0].scale has not 3 numbers; the value is left out");
  expectDamageTold(withRest("\"nodes\":[{\"mesh\":0,\"rotation\":[0,0,0,0]}]"),
                   "nodes[0].rotation has no direction; the rotation is left out");
  expectDamageRefused(withRest("\"nodes\":[{\"mesh\":0,\"scale\":[1e300,1,1]}]"),
                      "nodes[0] has a transform that is too large");
}

TEST(GltfDamage, ADeepTreeOfNodesIsRead) {
  std::string nodes = "\"nodes\":[";
  for (int i = 0; i < 50000; ++i) nodes += "{\"children\":[" + std::to_string(i + 1) + "]},";
  const std::string json = withRest(nodes + "{\"mesh\":0}]");
  EXPECT_TRUE(decodeGltf(Bytes(json.begin(), json.end()), "model.gltf"));
}

TEST(GltfDamage, NamesTheKeyOfAWrongTexture) {
  expectDamageTold(withMaterial("\"textures\":[]"), "materials[0].normalTexture.index is 0, but there are 0 textures");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":1}]"), "textures[0].source is 1, but there are 0 images");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0,\"sampler\":0}],\"images\":[{\"uri\":\"a.png\"}]"),
                   "textures[0].sampler is 0");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"no-such.png\"}]"),
                   "images[0].uri 'no-such.png' is missing; put it beside the model");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"..\"}]"), "images[0].uri '..'");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":3}]"),
                   "images[0].bufferView is 3");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"bufferView\":0}]"), "images[0]");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{}]"), "images[0] has neither");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"data:image/png;base64,*\"}]"),
                   "images[0].uri is no base64 data");
  expectDamageTold(withMaterial("\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"https://a.b/c.png\"}]"),
                   "lies in a network");
}

TEST(GltfDamage, NamesTheKeyOfAWrongBuffer) {
  const std::string head = "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[";
  expectDamageRefused(head + "{\"byteLength\":4,\"uri\":\"no-such.bin\"}]}",
                      "buffers[0].uri 'no-such.bin' is missing; put it beside the model");
  expectDamageRefused(head + "{\"byteLength\":4,\"uri\":\"data:application/octet-stream;base64,AAA=\"}]}",
                      "buffers[0].byteLength is 4, but 'data:application/octet-stream;base64,AAA=' has 2 bytes");
  expectDamageRefused(head + "{\"byteLength\":4}]}", "buffers[0].byteLength is 4, but the binary chunk has 0 bytes");
  expectDamageRefused(head + "{\"uri\":\"a.bin\"}]}", "buffers[0].byteLength is missing");
  expectDamageRefused(head + "{\"byteLength\":4,\"uri\":\"" + std::string(5000, 'x') + "\"}]}", "is missing");

  GltfMaker maker;
  maker.accessor(kDamagedTriangle, "VEC3");
  std::string json = maker.gltf(kPrimitive);
  const std::size_t at = json.find("\"byteLength\":36");
  json.replace(at, 15, "\"byteLength\":99");
  expectDamageRefused(json, "bufferViews[0] takes 99 bytes from byte 0 of buffers[0], which has 36");
}

TEST(GltfDamage, RefusesWhatItCannotRead) {
  expectDamageRefused("{\"asset\":{\"version\":\"1.0\"}}", "asset.version is '1.0'", ErrorCode::unsupported);
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"EXT_mesh_gpu_instancing\"]}",
                      "extensionsRequired names 'EXT_mesh_gpu_instancing'", ErrorCode::unsupported);
  expectDamageRefused("{}", "asset is missing");
  expectDamageRefused("", "is not valid JSON at byte 1 of it, where it ends");
  expectDamageRefused("[1,2]", "is no object");
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":7}", "nodes is no array");
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[7]}", "nodes[0] is no object");
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"mesh\":1e999}]",
                      "its JSON holds a number out of range; the file is damaged");
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"}}", "shows no triangles");
  expectDamageRefused(std::string(1000000, '['), "is not valid JSON");
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  expectDamageRefused("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + "}", "shows no triangles");
}

TEST(GltfDamage, RefusesAModelThatRepeatsItselfBeyondMemory) {
  GltfMaker maker;
  maker.accessor(kDamagedTriangle, "VEC3");
  maker.rawAccessor("{\"componentType\":5125,\"count\":16000000,\"type\":\"SCALAR\"}");
  const std::string zeros = "{\"attributes\":{\"POSITION\":0},\"indices\":1}";
  expectDamageRefused(maker.gltf(zeros + "," + zeros + "," + zeros + "," + zeros + "," + zeros),
                      "brings the model above", ErrorCode::too_large);
}

/// A .glb with indices, a picture and a material.
Bytes smallGlb() {
  GltfMaker maker;
  maker.accessor(kDamagedTriangle, "VEC3");
  maker.accessor(std::vector<std::uint16_t>{0, 1, 2}, "SCALAR");
  const std::string path = ::testing::TempDir() + "gltf_damage.png";
  EXPECT_TRUE(savePicture(path, Image8(2, 2, 3, 50)));
  const int view = maker.view(*readFile(path));
  return maker.glb("{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}",
                   "\"images\":[{\"bufferView\":" + std::to_string(view) +
                       "}],\"textures\":[{\"source\":0}],\"materials\":[{\"normalTexture\":{\"index\":0}}]");
}

// What is left of a file that is cut is shown if it has a triangle, with a remark.
TEST(GltfDamage, OfABinaryFileThatIsCutTheRestIsShown) {
  const Bytes whole = smallGlb();
  const Result<Scene> sound = decodeGltf(whole, "model.glb");
  ASSERT_TRUE(sound);
  EXPECT_THAT(sound->warnings, ::testing::IsEmpty());
  std::size_t first_shown = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<Scene> scene = decodeGltf(cut, "model.glb");
    if (!scene) {
      EXPECT_THAT(scene.error().message, Not(HasSubstr("model.glb")));
      EXPECT_EQ(first_shown, 0u) << size;
      continue;
    }
    if (first_shown == 0) first_shown = size;
    if (size + 3 < whole.size()) testing::expectTold(scene, "it is truncated");
    EXPECT_EQ(scene->meshes.at(0)->vertices.at(1).position, glm::vec3(1, 0, 0));
  }
  EXPECT_GT(first_shown, 0u);
}

TEST(GltfDamage, ABinaryFileSurvivesRandomDamage) {
  const Bytes whole = smallGlb();
  std::mt19937 random(4);
  int read = 0;
  for (int i = 0; i < 5000; ++i) {
    Bytes damaged = whole;
    for (int flips = 0; flips < 2; ++flips)
      damaged[random() % damaged.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
    const Result<Scene> scene = decodeGltf(damaged, "model.glb");
    if (!scene) continue;
    ++read;
    expectSafe(*scene);
  }
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace mirrorball
