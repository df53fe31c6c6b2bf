// glTF files as other programs write them: docs/files.md.

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using testing::expectTold;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const std::vector<float> kPlaces = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::string kPlain = R"({"attributes":{"POSITION":0}})";

GltfMaker triangleFile() {
  GltfMaker maker;
  maker.accessor(kPlaces, "VEC3");
  return maker;
}

Result<Scene> decodedOdd(const std::string& json) {
  return decodeGltf(Bytes(json.begin(), json.end()), ::testing::TempDir() + "model.gltf");
}
Result<Scene> decodedOdd(const Bytes& bytes) { return decodeGltf(bytes, ::testing::TempDir() + "model.glb"); }

/// A file is shown, without a remark.
void expectSilent(const Result<Scene>& scene) {
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(scene->warnings, IsEmpty());
  EXPECT_EQ(scene->meshes.at(0)->vertices.at(1).position, glm::vec3(1, 0, 0));
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// A .glb of parts, with wrong lengths where they are to be.
Bytes makeGlb(const std::string& json, const Bytes& binary, std::ptrdiff_t more_in_header = 0,
              std::ptrdiff_t more_in_binary = 0) {
  Bytes file = {'g', 'l', 'T', 'F'};
  const auto put = [&](std::size_t word) {
    for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<std::uint8_t>(word >> shift));
  };
  put(2);
  put(std::size_t(std::ptrdiff_t(12 + 8 + json.size() + 8 + binary.size()) + more_in_header));
  put(json.size());
  put(0x4E4F534A);
  file.insert(file.end(), json.begin(), json.end());
  put(std::size_t(std::ptrdiff_t(binary.size()) + more_in_binary));
  put(0x004E4942);
  file.insert(file.end(), binary.begin(), binary.end());
  return file;
}

const std::string kBinaryJson =
    R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
    R"("byteLength":36}],"buffers":[{"byteLength":36}]})";

Bytes places() {
  const auto bytes = bytesOf(std::span<const float>(kPlaces));
  return {bytes.begin(), bytes.end()};
}

// --- the container

TEST(GltfOddContainer, LengthsThatAreWrongDoNotMatter) {
  expectSilent(decodedOdd(makeGlb(kBinaryJson, places())));
  for (const std::ptrdiff_t more : {-12, 12, 1000}) expectSilent(decodedOdd(makeGlb(kBinaryJson, places(), more)));
  expectSilent(decodedOdd(makeGlb(kBinaryJson, places(), 0, 3)));  // padding is counted, and not there
  expectTold(decodedOdd(makeGlb(kBinaryJson, places(), 0, 1000)), "it is truncated, and what it lacks is left out");
  Bytes followed = makeGlb(kBinaryJson, places());
  followed.insert(followed.end(), 9, 'x');
  expectSilent(decodedOdd(followed));
}

TEST(GltfOddContainer, JsonMayBePaddedByZerosAndBlanksAndNotAtAll) {
  for (const std::string& padding :
       {std::string("\0\0\0", 3), std::string("\0", 1), std::string(" \n\t"), std::string()})
    expectSilent(decodedOdd(makeGlb(kBinaryJson + padding, places())));
  // Padded, which the chunk's length does not count.
  std::string json = kBinaryJson;
  while (json.size() % 4 != 1) json += ' ';
  Bytes file = makeGlb(json, places());
  file.insert(file.begin() + static_cast<std::ptrdiff_t>(20 + json.size()), 3, std::uint8_t{' '});
  expectSilent(decodedOdd(file));
}

TEST(GltfOddContainer, IsKnownByItsFirstBytesWhateverItsName) {
  const Bytes binary = triangleFile().glb(kPlain);
  expectSilent(decodeGltf(binary, "model.gltf"));
  const std::string text = triangleFile().gltf(kPlain);
  expectSilent(decodeGltf(Bytes(text.begin(), text.end()), "model.glb"));
}

TEST(GltfOddContainer, TheJsonMayBeginWithAByteOrderMark) {
  expectSilent(decodedOdd("\xEF\xBB\xBF" + triangleFile().gltf(kPlain)));
  expectSilent(decodedOdd(makeGlb("\xEF\xBB\xBF" + kBinaryJson, places())));
}

TEST(GltfOddContainer, DataMayBeWrittenInManyWays) {
  const std::string usual = "data:application/octet-stream;base64,";
  for (const char* type : {"data:;base64,", "data:application/gltf-buffer;base64,", "DATA:image/png;BASE64,",
                           "data:application/octet-stream;charset=utf-8;base64,"})
    expectSilent(decodedOdd(replaced(triangleFile().gltf(kPlain), usual, type)));
  std::string broken = replaced(triangleFile().gltf(kPlain), usual, usual + " \\n");
  const std::size_t at = broken.find(usual) + usual.size() + 10;
  expectSilent(decodedOdd(broken.insert(at, "\\r\\n  ")));

  std::string percents = "data:application/octet-stream,";
  for (const std::uint8_t byte : places()) {
    constexpr char kDigits[] = "0123456789abcdef";
    percents += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
  }
  expectSilent(
      decodedOdd(replaced(kBinaryJson, R"({"byteLength":36}]})", R"({"byteLength":36,"uri":")" + percents + "\"}]}")));

  // The alphabet of addresses: −1 is of bytes 0xBF 0x80 among which '+' and '/' are met.
  GltfMaker signs;
  signs.accessor(std::vector<std::int8_t>{-1, -1, -1, 0, -5, -2, 3, -65, -17, 0, 0, 0}, "VEC3");
  std::string other = signs.gltf(R"({"attributes":{"POSITION":0}})");
  const Scene wanted = decodedOdd(other).value();
  const std::size_t first = other.find(usual) + usual.size();
  for (std::size_t i = first; other[i] != '"'; ++i) {
    if (other[i] == '+') other[i] = '-';
    if (other[i] == '/') other[i] = '_';
  }
  EXPECT_EQ(decodedOdd(other).value().meshes.at(0)->vertices.at(1).position,
            wanted.meshes.at(0)->vertices.at(1).position);
}

// --- the JSON

TEST(GltfOddJson, OfNoVersionIsReadAndOfAnotherIsRefusedWithWhatHelps) {
  const std::string whole = triangleFile().gltf(kPlain), asset = R"("asset":{"version":"2.0"})";
  expectTold(decodedOdd(replaced(whole, asset, R"("asset":{})")), "names no version of glTF; it is read as glTF 2.0");
  expectTold(decodedOdd(replaced(whole, asset + ",", "")), "names no version");
  expectSilent(decodedOdd(replaced(whole, asset, R"("asset":{"version":"2"})")));
  expectSilent(decodedOdd(replaced(whole, asset, R"("asset":{"version":2.0})")));
  const Result<Scene> first = decodedOdd(replaced(whole, asset, R"("asset":{"version":"1.0"})"));
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().message,
            "asset.version is '1.0'; only glTF 2.0 is read, which gltf-pipeline makes of glTF 1.0");
  EXPECT_THAT(decodedOdd(replaced(whole, asset, R"("asset":{"version":"3.0"})")).error().message, HasSubstr("'3.0'"));
}

TEST(GltfOddJson, WhatIsNullIsNotThere) {
  expectSilent(decodedOdd(triangleFile().gltf(
      R"({"attributes":{"POSITION":0},"indices":null,"material":null,"targets":null})",
      R"("nodes":[{"mesh":0,"skin":null,"matrix":null,"name":null,"children":null}],"materials":null,"scene":null)")));
}

TEST(GltfOddJson, NumbersThatAreNoneAreRead) {
  for (const char* bounds :
       {R"([NaN,-Infinity,0])", "[nan,-inf,inf]", "[-nan(ind),nan,0]", "[, , ]", "[,,1.0]", "[1,2,3,]", "[1 , NaN , ]",
        "[1.#INF,-1.#IND,1.#QNAN]", "[1.#IND00,NAN,+INF]", "[1e+400,-1E400,0]"}) {
    GltfMaker maker;
    maker.accessor(kPlaces, "VEC3", R"(,"min":)" + std::string(bounds) + R"(,"max":[1,1,0])");
    expectTold(decodedOdd(maker.gltf(kPlain)),
               "numbers that are missing, NaN or infinite, and commas too many, are read as no value");
  }
  expectTold(decodedOdd(triangleFile().gltf(kPlain, R"("extras":{"a":,"b":1,})")), "commas too many");
  const Result<Scene> named =
      decodedOdd(triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0,"name":"NaN \" ,,] inf"}],"extras":[NaN])"));
  expectTold(named, "is not valid JSON at byte ");
  EXPECT_EQ(named->rig.nodes.at(0).name, "NaN \" ,,] inf");
  for (const char* broken : {"{\"a\":NaN", "NaN\"", "{\"a\":\"NaN\\", "[Infinity", ",", "]", "{\"a\",}", "-", "i",
                             "{//", "{/*", "/", "[1,/*", "{\"a\\", "[+]", "[.]"})
    EXPECT_THAT(decodedOdd(std::string(broken)).error().message, HasSubstr("is not valid JSON")) << broken;
}

// As C's printf and other languages' have them.
TEST(GltfOddJson, NumbersOfOtherLanguagesAreReadAsJsonHasThem) {
  const auto readPlace = [](const std::string& numbers) {
    const Result<Scene> scene = decodedOdd(
        triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0,"translation":)" + numbers + R"(,"scale":[01,1.,+1e0]}])"));
    expectTold(scene, "numbers written as '+1', '.5' or '01' are read as 1, 0.5 and 1");
    return scene ? scene->rig.nodes.at(0).place.translation : glm::dvec3(0.0);
  };
  EXPECT_EQ(readPlace("[+1,.5,02]"), glm::dvec3(1, 0.5, 2));
  EXPECT_EQ(readPlace("[-.5,3.,-03.250]"), glm::dvec3(-0.5, 3, -3.25));
  EXPECT_EQ(readPlace("[5.e-1,00,-00.5E+1]"), glm::dvec3(0.5, 0, -5));
}

TEST(GltfOddJson, CommentsArePassedOver) {
  const std::string commented = R"("extras":["a // b","/* c */",1, // d, "
2, /* e ] */ 3, /**/ // f
],)";
  const Result<Scene> scene = decodedOdd("/* made by hand */ " + triangleFile().gltf(kPlain, commented + R"("x":0)"));
  expectTold(scene, "is not valid JSON at byte 1 of it: ");
  expectTold(scene, "comments are passed over");
}

// Names as programs write them that put text together by hand.
TEST(GltfOddJson, StringsAreReadThatAreNotEncoded) {
  const auto readName = [](const std::string& name, const char* remark) {
    const Result<Scene> scene =
        decodedOdd(triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0,"name":")" + name + R"("}])"));
    expectTold(scene, remark);
    return scene ? scene->rig.nodes.at(0).name : "";
  };
  EXPECT_EQ(readName("B\xFC"
                     "chse \xC3\xA9",
                     "letters that are not of UTF-8 are read as Latin-1"),
            "B\xC3\xBC"
            "chse \xC3\xA9");
  const char* const as_letters = "control characters and '\\' in its strings are read as letters";
  EXPECT_EQ(readName("a\tb\nc\x01", as_letters), "a?b?c?") << "which do something on a terminal";
  EXPECT_EQ(readName(R"(C:\textures\Users\a \"b\")", as_letters), R"(C:\textures\Users\a "b")");
  EXPECT_EQ(readName(R"(cut \ud83d)", as_letters), R"(cut \ud83d)");
}

TEST(GltfOddJson, WhatLiesBehindItsEndIsLeftOut) {
  for (const char* behind : {"}", "\n}}", "garbage", ", \"x\":1"})
    expectTold(decodedOdd(triangleFile().gltf(kPlain) + behind), "what lies behind its end is left out");
}

/// A file with its buffer beside it.
Result<Scene> decodedBeside(std::string json, std::string_view buffer) {
  const std::string name = "gltf_oddity_place.bin";
  EXPECT_TRUE(writeFile(::testing::TempDir() + name, Bytes(buffer.begin(), buffer.end())));
  const std::size_t begin = json.find("data:"), end = json.find('"', begin);
  return decodedOdd(json.replace(begin, end - begin, name));
}

TEST(GltfOddContainer, WhatStandsInABuffersPlaceIsNamed) {
  const auto refusal = [](std::string_view text) {
    const Result<Scene> scene = decodedBeside(triangleFile().gltf(kPlain), text);
    return scene ? "" : scene.error().message;
  };
  EXPECT_EQ(refusal("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"),
            "buffers[0].uri 'gltf_oddity_place.bin' is a Git LFS pointer, which is not read; run `git lfs pull`, which "
            "fetches the file that it stands "
            "for");
  EXPECT_THAT(refusal("<!DOCTYPE html><html><body>Not found</body></html>"), HasSubstr("' is a web page"));
  EXPECT_THAT(refusal("\x1f\x8b\x08" + std::string(60, 'x')), HasSubstr("' is compressed by gzip"));
}

// The colour with which it begins is the mark of gzip. A pointer of Git LFS to 128 bytes has 128 itself.
TEST(GltfOddContainer, ABufferOfItsSizeIsNoArchive) {
  GltfMaker maker;
  maker.accessor(std::vector<std::uint8_t>{31, 139, 8, 255, 0, 0, 0, 255, 0, 0, 0, 255}, "VEC4",
                 R"(,"normalized":true)");
  maker.accessor(kPlaces, "VEC3");
  maker.view(std::vector<std::uint8_t>(80, 0));
  const std::string primitive = R"({"attributes":{"COLOR_0":0,"POSITION":1}})", json = maker.gltf(primitive);
  const Bytes binary = maker.glb(primitive);
  const std::string buffer(binary.end() - 128, binary.end());
  for (const std::size_t filled : {0, 3}) expectSilent(decodedBeside(json, buffer + std::string(filled, '\0')));
  EXPECT_THAT(decodedBeside(json, buffer.substr(0, 100)).error().message, HasSubstr("compressed by gzip"));
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, 'a') + "\nsize 128\n";
  ASSERT_EQ(pointer.size(), buffer.size());
  EXPECT_THAT(decodedBeside(json, pointer).error().message, HasSubstr("is a Git LFS pointer"));
}

TEST(GltfOddJson, RequiredExtensionsAreLeftOutIfThereIsSomethingToShow) {
  expectTold(decodedOdd(triangleFile().gltf(kPlain, R"("extensionsRequired":["KHR_texture_basisu","ADOBE_x"])")),
             "what it says by ADOBE_x and KHR_texture_basisu is left out");
  GltfMaker compressed;
  compressed.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3"})");
  const Result<Scene> refused = decodedOdd(compressed.gltf(kPlain, R"("extensionsRequired":["ACME_mesh_coding"])"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "extensionsRequired names 'ACME_mesh_coding', which this program cannot read; export the model without it");
}

// --- scenes and nodes

TEST(GltfOddScene, TheFirstSceneIsShownWhereNoneIsNamed) {
  const std::string nodes = R"("nodes":[{"mesh":0},{"mesh":0,"translation":[5,0,0]}],)";
  const auto shown = [&](const std::string& scenes) {
    const Result<Scene> scene = decodedOdd(triangleFile().gltf(kPlain, nodes + scenes));
    EXPECT_TRUE(scene) << scenes;
    return scene ? *scene : Scene{};
  };
  const Scene one = shown(R"("scenes":[{"nodes":[1]}])");
  ASSERT_EQ(one.instances.size(), 1u);
  EXPECT_EQ(one.instances[0].world_from_object[3].x, 5.0f);
  EXPECT_THAT(one.warnings, IsEmpty());
  const Scene first = shown(R"("scenes":[{"nodes":[1]},{"nodes":[0]}])");
  EXPECT_EQ(first.instances.at(0).world_from_object[3].x, 5.0f);
  EXPECT_THAT(first.warnings, ElementsAre(HasSubstr("does not say which of its 2 scenes is shown; it is the first")));
  const Scene missing = shown(R"("scene":7,"scenes":[{"nodes":[1]}])");
  EXPECT_EQ(missing.instances.at(0).world_from_object[3].x, 5.0f);
  EXPECT_THAT(missing.warnings, ElementsAre(HasSubstr("scene is 7, but there is 1 scene; the first is shown")));
  EXPECT_EQ(shown(R"("scenes":[])").instances.size(), 2u);
}

TEST(GltfOddScene, WhatIsNowhereIsLeftOutWithAllBelow) {
  const std::string nowhere[] = {R"("matrix":[null,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])", R"("translation":[0,NaN,0])",
                                 R"("scale":[1e40,1,1])"};
  for (const std::string& place : nowhere) {
    const Result<Scene> scene =
        decodedOdd(triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0,"children":[1],)" + place +
                                                   R"(},{"mesh":0},{"mesh":0,"children":[3]},{"name":"below"}])"));
    expectTold(scene, "; the node with all below it is left out");
    EXPECT_EQ(scene->instances.size(), 1u) << place;
    ASSERT_EQ(scene->rig.nodes.size(), 2u) << place;
    EXPECT_EQ(scene->rig.nodes[1].name, "below");
    EXPECT_EQ(scene->rig.nodes[1].parent, 0);
  }
}

// Early exporters of Blender, and others where an axis is scaled to nothing.
TEST(GltfOddScene, ARotationOfNanTurnsNothing) {
  for (const char* rotation : {"[null,null,null,null]", "[NaN,0,0,1]", "[0,0,0,0]"}) {
    const Result<Scene> scene = decodedOdd(triangleFile().gltf(
        kPlain, R"("nodes":[{"mesh":0,"translation":[2,0,0],"rotation":)" + std::string(rotation) + "}]"));
    expectTold(scene, "nodes[0].rotation has no direction; the rotation is left out");
    EXPECT_EQ(scene->instances.at(0).world_from_object[0], glm::vec4(1, 0, 0, 0)) << rotation;
    EXPECT_EQ(scene->instances[0].world_from_object[3], glm::vec4(2, 0, 0, 1)) << rotation;
  }
}

// As if it were written row by row, or has a perspective.
TEST(GltfOddScene, AMatrixIsAffine) {
  const Result<Scene> scene =
      decodedOdd(triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0,"matrix":[1,0,0,5,0,1,0,0,0,0,1,0,2,0,0,1]}])"));
  expectTold(scene,
             "nodes[0].matrix, which goes column by column, ends its columns with other numbers than 0, 0, 0 and "
             "1; the last row is left out");
  EXPECT_EQ(scene->instances.at(0).world_from_object, glm::translate(glm::mat4(1.0f), glm::vec3(2, 0, 0)));
}

TEST(GltfOddScene, LinesAloneAreRefusedByThatName) {
  const Result<Scene> scene = decodedOdd(triangleFile().gltf(R"({"attributes":{"POSITION":0},"mode":1})"));
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message,
            "its scene shows no triangles: meshes[0].primitives[0] is made of points or lines; the primitive is left "
            "out");
}

TEST(GltfOddContainer, ABufferMayHaveMoreBytesThanItSays) {
  const Result<Scene> scene = decodedOdd(
      replaced(triangleFile().gltf(kPlain), R"("buffers":[{"byteLength":36)", R"("buffers":[{"byteLength":32)"));
  expectTold(scene, "buffers[0]: has more bytes than its byteLength, and they are used");
  EXPECT_EQ(scene->meshes.at(0)->vertices.at(2).position, glm::vec3(0, 1, 0));
}

TEST(GltfOddMaterial, AnAlphaModeInAnyCaseIsReadAndAnotherIsTold) {
  const auto decodedMode = [](const std::string& mode) {
    return decodedOdd(triangleFile().gltf(R"({"attributes":{"POSITION":0},"material":0})",
                                          R"("materials":[{"alphaMode":")" + mode + R"("}])"));
  };
  EXPECT_EQ(decodedMode("blend")->materials.at(0).alpha_mode, AlphaMode::blend);
  EXPECT_EQ(decodedMode("Mask")->materials.at(0).alpha_mode, AlphaMode::mask);
  const Result<Scene> other = decodedMode("TRANSPARENT");
  expectTold(other, "materials[0].alphaMode is not OPAQUE, MASK or BLEND; the value is left out");
  EXPECT_EQ(other->materials.at(0).alpha_mode, AlphaMode::opaque);
}

TEST(GltfOddScene, ANodeWithoutVolumeIsLeftOutAndTold) {
  const Result<Scene> scene = decodedOdd(
      triangleFile().gltf(kPlain, R"("nodes":[{"mesh":0},{"mesh":0,"scale":[1,1,0]},{"mesh":0,"scale":[0,0,0]}])"));
  expectTold(scene, "nodes[1] has no volume by its scale; the mesh of such a node is left out, and so is another");
  EXPECT_EQ(scene->instances.size(), 1u);
}

TEST(GltfOddScene, AnAnimationFindsTheNodesBehindOnesThatAreNowhere) {
  GltfMaker maker = triangleFile();
  testing::AnimationMaker walk(maker);
  walk.move(R"("node":1,"path":"translation")", {0, 1}, {0, 0, 0, 2, 0, 0}, "VEC3")
      .move(R"("node":0,"path":"translation")", {0, 1}, {0, 0, 0, 9, 0, 0}, "VEC3");
  const Result<Scene> scene =
      decodedOdd(maker.gltf(kPlain, R"("nodes":[{"scale":[null,1,1]},{"mesh":0}],"animations":[)" + walk.json() + "]"));
  expectTold(scene, "nodes[0] has a transform that holds NaN");
  ASSERT_EQ(scene->rig.animations.at(0).channels.size(), 1u);
}

// --- meshes

TEST(GltfOddMesh, ADamagedPrimitiveIsLeftOutAndTheOthersAreShown) {
  GltfMaker maker = triangleFile();
  maker.rawAccessor(R"({"bufferView":0,"componentType":5126,"count":300,"type":"VEC3"})");
  const std::string damaged = R"(,{"attributes":{"POSITION":1}})";
  const Result<Scene> scene = decodedOdd(maker.gltf(kPlain + damaged + damaged));
  expectTold(scene,
             "accessors[1] reaches byte 3600 of bufferViews[0], which has 36; the damaged primitive is left out, "
             "and so is another");
  EXPECT_EQ(scene->meshes.size(), 1u);
  EXPECT_EQ(scene->warnings.size(), 1u);
}

TEST(GltfOddMesh, ABufferThatIsMissingAndNotUsedIsNoMatter) {
  const std::string json = replaced(triangleFile().gltf(kPlain), R"("buffers":[)", R"("x":0,"buffers":[)");
  std::string more = json.substr(0, json.rfind("]"));
  more += R"(,{"byteLength":99,"uri":"lost.bin"}]})";
  expectSilent(decodedOdd(more));
}

TEST(GltfOddMesh, TrianglesOfNoVertexAndOfNoPlaceAreLeftOut) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, INFINITY}, "VEC3");
  maker.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 1, 65535, 0, 1, 3, 1, 2, 3}, "SCALAR");
  const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0},"indices":1})"));
  expectTold(scene,
             "1 triangle names a vertex that is not there and is left out; 2 triangles reach NaN or infinity and "
             "are left out");
  EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
}

TEST(GltfOddMesh, IndicesOfSignedTypesAreRead) {
  GltfMaker maker = triangleFile();
  maker.accessor(std::vector<std::int16_t>{0, 1, 2}, "SCALAR");
  maker.accessor(std::vector<std::int8_t>{0, 1, 2}, "SCALAR");
  const int view = maker.view(std::vector<std::int32_t>{0, 1, 2});
  maker.rawAccessor(R"({"componentType":5124,"count":3,"type":"SCALAR","bufferView":)" + std::to_string(view) + "}");
  for (const char* indices : {"1", "2", "3"}) {
    const Result<Scene> scene =
        decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0},"indices":)" + std::string(indices) + "}"));
    expectSilent(scene);
    EXPECT_EQ(scene->meshes.at(0)->indices.size(), 3u);
  }
}

// The authors' normals lean by 30° from those of the triangles; a triangle without an area is beside.
TEST(GltfOddMesh, NormalsWithoutADirectionAreMadeForTheirVerticesAlone) {
  for (const float bad : {0.0f, kNan, INFINITY}) {
    GltfMaker maker;
    maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0.1f, 0, 0, 0.2f, 0, 0}, "VEC3");
    maker.accessor(std::vector<float>{0.5f, 0, 0.8660254f, bad, bad, bad, 0.5f, 0, 0.8660254f, bad, bad, bad, bad, bad,
                                      bad, bad, bad, bad},
                   "VEC3");
    const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"NORMAL":1}})"));
    expectTold(scene, "4 normals have no direction and are made from the triangles around");
    const std::vector<Vertex>& vertices = scene->meshes.at(0)->vertices;
    for (const std::size_t own : {0u, 2u})
      EXPECT_LT(glm::distance(vertices.at(own).normal, glm::vec3(0.5f, 0, 0.8660254f)), 1e-6f) << bad;
    EXPECT_EQ(vertices.at(1).normal, glm::vec3(0, 0, 1)) << bad;
  }
}

TEST(GltfOddMesh, TangentsWithoutADirectionAreMadeForTheirVerticesAlone) {
  for (const float bad : {0.0f, kNan}) {
    GltfMaker maker = triangleFile();
    maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    maker.accessor(std::vector<float>{0, 1, 0, -1, bad, bad, bad, 1, 0, 1, 0, -1}, "VEC4");
    maker.accessor(std::vector<float>{0, 1, 1, 1, 0, 0}, "VEC2");
    const Result<Scene> scene =
        decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3}})"));
    expectTold(scene, "1 tangent has no direction and is made from the triangles around");
    const std::vector<Vertex>& vertices = scene->meshes.at(0)->vertices;
    EXPECT_EQ(vertices.at(0).tangent, glm::vec4(0, 1, 0, -1));
    EXPECT_EQ(vertices.at(1).tangent, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(vertices.at(2).tangent, glm::vec4(0, 1, 0, -1));
  }
}

TEST(GltfOddMesh, OfFourCoordinatesTheFourthIsLeftOut) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1}, "VEC4");
  maker.accessor(std::vector<float>{0, 0.6f, 0.8f, 0, 0, 0.6f, 0.8f, 0, 0, 0.6f, 0.8f, 0}, "VEC4");
  const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"NORMAL":1}})"));
  expectTold(scene, "attributes.POSITION has 4 components; the fourth coordinate is left out, and so is another");
  EXPECT_EQ(scene->meshes.at(0)->vertices.at(1).position, glm::vec3(1, 0, 0));
  EXPECT_LT(glm::distance(scene->meshes[0]->vertices[2].normal, glm::vec3(0, 0.6f, 0.8f)), 1e-6f);
}

// As WebGL draws it: the strip begins anew, with its first triangle upright.
TEST(GltfOddMesh, TheGreatestIndexRestartsAStripOrAFan) {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{0, 1, 2, 255, 1, 3, 2, 255, 255, 0, 1}, "SCALAR");
  maker.accessor(std::vector<std::uint16_t>{0, 1, 2, 3, 65535, 1, 3, 2}, "SCALAR");
  const auto corners = [&](const std::string& more) {
    const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0},)" + more + "}"));
    EXPECT_TRUE(scene && scene->warnings.empty()) << more;
    std::vector<float> area_and_triangles{0, 0};
    for (std::size_t i = 0; scene && i < scene->meshes.at(0)->indices.size(); i += 3) {
      const auto place = [&](std::size_t k) {
        return scene->meshes[0]->vertices[scene->meshes[0]->indices[i + k]].position;
      };
      area_and_triangles[0] += 0.5f * glm::cross(place(1) - place(0), place(2) - place(0)).z;
      area_and_triangles[1] += 1;
    }
    return area_and_triangles;
  };
  EXPECT_THAT(corners(R"("mode":5,"indices":1)"), ElementsAre(1, 2));
  EXPECT_THAT(corners(R"("mode":5,"indices":2)"), ElementsAre(1.5f, 3));
  EXPECT_THAT(corners(R"("mode":6,"indices":1)"), ElementsAre(1, 2));
}

TEST(GltfOddMesh, OfThreeTextureCoordinatesTheThirdIsLeftOut) {
  GltfMaker maker = triangleFile();
  maker.accessor(std::vector<float>{0.25f, 0.5f, 9, 1, 0, 9, 0, 1, 9}, "VEC3");
  const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"TEXCOORD_0":1}})"));
  expectTold(scene, "meshes[0].primitives[0].attributes.TEXCOORD_0 has 3 components; the third coordinate is left out");
  EXPECT_EQ(scene->meshes.at(0)->vertices.at(0).uv[0], glm::vec2(0.25f, 0.5f));
  EXPECT_EQ(scene->meshes[0]->vertices[1].uv[0], glm::vec2(1, 0));
}

/// A triangle whose file has colours of vertices so.
template <typename Number>
Result<Scene> decodedColors(const std::vector<Number>& numbers, const std::string& type,
                            const std::string& extra = "") {
  GltfMaker maker = triangleFile();
  maker.accessor(numbers, type, extra);
  return decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"COLOR_0":1}})"));
}

const std::string kNotNormalized =
    "accessors[1]: is of colours in integers that are not 'normalized', and is read as if they were";

TEST(GltfOddMesh, ColoursInIntegersAreNormalizedWhetherOrNotTheySaySo) {
  const std::vector<std::uint8_t> bytes = {255, 51, 0, 255, 0, 0, 0, 102, 0, 0, 0, 0};
  const Result<Scene> of_bytes = decodedColors(bytes, "VEC4");
  expectTold(of_bytes, kNotNormalized);
  EXPECT_EQ(of_bytes->warnings.size(), 1u);
  EXPECT_EQ(of_bytes->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
  EXPECT_EQ(of_bytes->meshes[0]->vertices[1].color, glm::vec4(0, 0, 0, 0.4f));
  const Result<Scene> of_shorts = decodedColors(std::vector<std::uint16_t>{65535, 13107, 0, 0, 0, 0, 0, 0, 0}, "VEC3");
  expectTold(of_shorts, kNotNormalized);
  EXPECT_EQ(of_shorts->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
  const Result<Scene> sound = decodedColors(bytes, "VEC4", R"(,"normalized":true)");
  expectSilent(sound);
  EXPECT_EQ(sound->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
}

TEST(GltfOddMesh, ColoursInWholeNumbersUpTo255AreInPartsOfIt) {
  const std::string codes =
      "meshes[0].primitives[0].attributes.COLOR_0: holds whole numbers up to 255 for 0 to 1, and is read in parts of "
      "255";
  const Result<Scene> both = decodedColors(std::vector<float>{255, 51, 0, 255, 0, 0, 0, 51, 0, 0, 0, 0}, "VEC4");
  expectTold(both, codes);
  EXPECT_EQ(both->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
  EXPECT_EQ(both->meshes[0]->vertices[1].color, glm::vec4(0, 0, 0, 0.2f));
  const Result<Scene> share = decodedColors(std::vector<float>{255, 51, 0, 1, 0, 0, 0, 0.5f, kNan, 0, 0, 1}, "VEC4");
  expectTold(share, codes);
  EXPECT_EQ(share->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.2f, 0, 1));
  EXPECT_EQ(share->meshes[0]->vertices[1].color, glm::vec4(0, 0, 0, 0.5f));
  EXPECT_EQ(share->meshes[0]->vertices[2].color, glm::vec4(1.0f));
}

TEST(GltfOddMesh, ColoursBeyondTheirRangeAreCut) {
  for (const float beyond : {1.5f, 300.0f, 1e30f}) {
    const Result<Scene> scene = decodedColors(std::vector<float>{beyond, 0.5f, -1, 0, 0, 0, 0, 0, 0}, "VEC3");
    expectTold(scene, "COLOR_0: holds numbers beyond 0 to 1, and is cut to them");
    EXPECT_EQ(scene->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.5f, 0, 1)) << beyond;
  }
  const Result<Scene> rounded = decodedColors(std::vector<float>{1.0001f, 0.5f, -1e-6f, 0, 0, 0, 0, 0, 0}, "VEC3");
  expectSilent(rounded);
  EXPECT_EQ(rounded->meshes.at(0)->vertices.at(0).color, glm::vec4(1, 0.5f, 0, 1));
}

TEST(GltfOddMaterial, ColoursOfThreeNumbersForFourAndOfFourForThreeAreRead) {
  const auto decodedMaterial = [](const std::string& material) {
    return decodedOdd(
        triangleFile().gltf(R"({"attributes":{"POSITION":0},"material":0})", "\"materials\":[{" + material + "}]"));
  };
  const Result<Scene> scene =
      decodedMaterial(R"("alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0]},)"
                      R"("emissiveFactor":[0.25,0.5,1,1])");
  expectTold(scene,
             "has three numbers for four or four for three; its red, green and blue are read, and so is another");
  EXPECT_EQ(scene->warnings.size(), 1u);
  EXPECT_EQ(scene->materials.at(0).base_color, glm::vec3(0.5f, 0.25f, 0));
  EXPECT_EQ(scene->materials[0].opacity, 1.0f);
  EXPECT_EQ(scene->materials[0].emission, glm::vec3(0.25f, 0.5f, 1));
  const Result<Scene> older =
      decodedMaterial(R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.25,0],)"
                      R"("specularFactor":[0.25,0.5,1,1]}})");
  expectTold(older, "diffuseFactor: has three numbers for four or four for three");
  EXPECT_EQ(older->materials.at(0).base_color, glm::vec3(0.5f, 0.25f, 0));
  for (const char* numbers : {"[1,0]", "[]", "[1,0,0,1,1]", "0.5"}) {
    const Result<Scene> none =
        decodedMaterial(R"("pbrMetallicRoughness":{"baseColorFactor":)" + std::string(numbers) + "}");
    expectTold(none, "baseColorFactor");
    EXPECT_EQ(none->materials.at(0).base_color, glm::vec3(1.0f)) << numbers;
  }
}

TEST(GltfOddMesh, CoordinatesThatAreNoNumbersAre0) {
  GltfMaker maker = triangleFile();
  maker.accessor(std::vector<float>{kNan, 1, 1, 1, 0, 0}, "VEC2");
  const Result<Scene> scene = decodedOdd(maker.gltf(R"({"attributes":{"POSITION":0,"TEXCOORD_0":1}})"));
  expectTold(scene, "1 texture coordinate holds NaN or infinity and is read as 0");
  EXPECT_EQ(scene->meshes.at(0)->vertices.at(0).uv[0], glm::vec2(0.0f));
  EXPECT_EQ(scene->meshes[0]->vertices.at(1).uv[0], glm::vec2(1.0f));
}

}  // namespace
}  // namespace mirrorball
