#include "mirrorball/scene/gltf/gltf.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/surface.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using testing::GltfMaker;
using ::testing::HasSubstr;

Result<Scene> decode(const std::string& json) {
  return decodeGltf(Bytes(json.begin(), json.end()), ::testing::TempDir() + "model.gltf");
}

Scene decoded(const std::string& json) {
  Result<Scene> scene = decode(json);
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene{};
}

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

/// "{"attributes":{"POSITION":0,…},…}"
std::string primitive(const std::string& more_attributes = "", const std::string& more = "") {
  return "{\"attributes\":{\"POSITION\":0" + more_attributes + "}" + more + "}";
}

TEST(Gltf, ReadsBothContainers) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  maker.accessor(std::vector<std::uint16_t>{2, 0, 1}, "SCALAR");
  const std::string indexed = primitive("", ",\"indices\":1");
  const Scene from_text = decoded(maker.gltf(indexed));
  const Result<Scene> from_binary = decodeGltf(maker.glb(indexed), "model.glb");
  ASSERT_TRUE(from_binary) << from_binary.error().message;
  for (const Scene* scene : {&from_text, &*from_binary}) {
    ASSERT_EQ(scene->meshes.size(), 1u);
    ASSERT_EQ(scene->meshes[0]->indices.size(), 3u);
    EXPECT_EQ(scene->meshes[0]->vertices[scene->meshes[0]->indices[0]].position, glm::vec3(0, 1, 0));
  }
}

TEST(Gltf, WithoutNormalsIsFlat) {
  GltfMaker maker;
  // Two triangles that share an edge, at right angles.
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 3, 1}, "SCALAR");
  const Scene scene = decoded(maker.gltf(primitive("", ",\"indices\":1")));
  const Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.vertices.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(mesh.vertices[i].normal, i < 3 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
}

TEST(Gltf, ReadsTheIndicesOfEveryType) {
  for (int type = 0; type < 3; ++type) {
    GltfMaker maker;
    maker.accessor(kTriangle, "VEC3");
    maker.accessor(std::vector<float>{0, 0, 2, 0, 0, 2, 0, 0, 2}, "VEC3");
    if (type == 0) maker.accessor(std::vector<std::uint8_t>{1, 2, 0}, "SCALAR");
    if (type == 1) maker.accessor(std::vector<std::uint16_t>{1, 2, 0}, "SCALAR");
    if (type == 2) maker.accessor(std::vector<std::uint32_t>{1, 2, 0}, "SCALAR");
    const Scene scene = decoded(maker.gltf(primitive(",\"NORMAL\":1", ",\"indices\":2")));
    EXPECT_THAT(scene.meshes.at(0)->indices, ElementsAre(1, 2, 0));
    EXPECT_EQ(scene.meshes[0]->vertices[0].normal, glm::vec3(0, 0, 1));  // made unit
  }
}

TEST(Gltf, TurnsStripsAndFansIntoTriangles) {
  GltfMaker maker;
  maker.accessor(kSquare, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  const auto indices = [&](int mode) {
    return decoded(maker.gltf(primitive(",\"NORMAL\":1", ",\"mode\":" + std::to_string(mode)))).meshes.at(0)->indices;
  };
  EXPECT_THAT(indices(4), ElementsAre(0, 1, 2));
  EXPECT_THAT(indices(5), ElementsAre(0, 1, 2, 1, 3, 2));
  EXPECT_THAT(indices(6), ElementsAre(1, 2, 0, 2, 3, 0));
}

TEST(Gltf, LeavesOutPointsAndLinesWithAWarning) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const Scene scene = decoded(maker.gltf(primitive() + "," + primitive("", ",\"mode\":0")));
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_THAT(scene.warnings,
              Contains(HasSubstr("meshes[0].primitives[1] is made of points or lines; the primitive is left out")));
}

TEST(Gltf, NamesEachExtensionThatItDoesNotReadOnce) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const std::string materials =
      R"("materials":[{"extensions":{"KHR_materials_diffuse_transmission":{},"KHR_materials_ior":{}}},)"
      R"({"extensions":{"KHR_materials_diffuse_transmission":{}}}])";
  EXPECT_THAT(
      decoded(maker.gltf(primitive(), R"("extensionsUsed":["MSFT_lod","KHR_materials_ior"],)" + materials)).warnings,
      ElementsAre(
          HasSubstr("model.gltf: what it says by KHR_materials_diffuse_transmission and MSFT_lod is left out")));
  std::string many = "\"extensionsUsed\":[\"A\\nB\",\"" + std::string(5000, 'C') + "\"";
  for (int i = 0; i < 100; ++i) many += ",\"D" + std::to_string(i) + "\"";
  const std::vector<std::string> warnings = decoded(maker.gltf(primitive(), many + "]")).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("A?B"));
  EXPECT_LT(warnings[0].size(), 400u);
}

TEST(Gltf, PutsSparseValuesIn) {
  GltfMaker maker;
  const int dense = maker.view(kTriangle);
  const int places = maker.view(std::vector<std::uint8_t>{2});
  const int values = maker.view(std::vector<float>{5, 6, 7});
  const std::string sparse =
      ",\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":" +
      std::to_string(places) + ",\"componentType\":5121},\"values\":{\"bufferView\":" + std::to_string(values) + "}}}";
  maker.rawAccessor("{\"bufferView\":" + std::to_string(dense) + sparse);
  const Scene scene = decoded(maker.gltf(primitive()));
  EXPECT_EQ(scene.meshes.at(0)->vertices.at(1).position, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.meshes[0]->vertices.at(2).position, glm::vec3(5, 6, 7));

  GltfMaker zeros;  // the same without dense values: all else is 0
  zeros.accessor(kTriangle, "VEC3");
  zeros.view(std::vector<std::uint8_t>{2});
  zeros.view(std::vector<float>{0.25f, 0.5f});
  zeros.rawAccessor(
      "{\"componentType\":5126,\"count\":3,\"type\":\"VEC2\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,"
      "\"componentType\":5121},\"values\":{\"bufferView\":2}}}");
  const Scene sparse_uv = decoded(zeros.gltf(primitive(",\"TEXCOORD_0\":1")));
  EXPECT_EQ(sparse_uv.meshes.at(0)->vertices.at(0).uv[0], glm::vec2(0));
  EXPECT_EQ(sparse_uv.meshes[0]->vertices.at(2).uv[0], glm::vec2(0.25f, 0.5f));
}

TEST(Gltf, ReadsColoursAndCoordinatesAsIntegersToo) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{255, 0, 51, 102, 0, 0, 0, 255, 0, 0, 0, 255}, "VEC4",
                 ",\"normalized\":true");
  maker.accessor(std::vector<std::uint16_t>{65535, 0, 0, 0, 0, 0}, "VEC2", ",\"normalized\":true");
  maker.accessor(std::vector<float>{0, 0, 0, 0, 0.5f, 0.75f}, "VEC2");
  const Scene scene = decoded(maker.gltf(primitive(",\"COLOR_0\":1,\"TEXCOORD_0\":2,\"TEXCOORD_1\":3")));
  const std::vector<Vertex>& vertices = scene.meshes.at(0)->vertices;
  EXPECT_EQ(vertices[0].color, glm::vec4(1.0f, 0.0f, 0.2f, 0.4f));
  EXPECT_EQ(vertices[0].uv[0], glm::vec2(1, 0));
  EXPECT_EQ(vertices[2].uv[1], glm::vec2(0.5f, 0.75f));

  GltfMaker three;
  three.accessor(kTriangle, "VEC3");
  three.accessor(std::vector<float>{0.5f, 0.25f, 1, 0, 0, 0, 0, 0, 0}, "VEC3");
  EXPECT_EQ(decoded(three.gltf(primitive(",\"COLOR_0\":1"))).meshes.at(0)->vertices[0].color,
            glm::vec4(0.5f, 0.25f, 1, 1));
}

TEST(Gltf, ReadsQuantizedPositions) {
  GltfMaker maker;
  maker.accessor(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 0, -32768, 0}, "VEC3", ",\"normalized\":true");
  const Scene scene = decoded(maker.gltf(primitive(), "\"extensionsRequired\":[\"KHR_mesh_quantization\"]"));
  EXPECT_EQ(scene.meshes.at(0)->vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.meshes[0]->vertices[2].position, glm::vec3(0, -1, 0));
}

// Positions and texture coordinates as whole numbers, which the node and the texture's transform scale back. Before
// there was an extension for them, gltfpack wrote them without one (meshoptimizer issue 58).
TEST(Gltf, ReadsEveryQuantizedAttribute) {
  GltfMaker maker;
  maker.accessor(std::vector<std::uint16_t>{0, 0, 0, 1000, 0, 0, 0, 500, 0}, "VEC3");
  maker.accessor(std::vector<std::int8_t>{0, 0, 127, 0, 0, 127, 0, 127, 0}, "VEC3", ",\"normalized\":true");
  maker.accessor(std::vector<std::int16_t>{32767, 0, 0, -32767, 32767, 0, 0, 32767, 32767, 0, 0, 32767}, "VEC4",
                 ",\"normalized\":true");
  maker.accessor(std::vector<std::int16_t>{0, 0, 4096, 0, 0, -2048}, "VEC2");
  for (const char* extension : {R"("extensionsRequired":["KHR_mesh_quantization"])", ""}) {
    const Scene scene = decoded(maker.gltf(primitive(",\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3"), extension));
    const std::vector<Vertex>& vertices = scene.meshes.at(0)->vertices;
    EXPECT_EQ(vertices[1].position, glm::vec3(1000, 0, 0));
    EXPECT_EQ(vertices[2].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(vertices[0].tangent, glm::vec4(1, 0, 0, -1));
    EXPECT_EQ(vertices[1].uv[0], glm::vec2(4096, 0));
    EXPECT_EQ(vertices[2].uv[0], glm::vec2(0, -2048));
  }
}

TEST(Gltf, MultipliesTheNodesTransforms) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const std::string nodes =
      "\"scene\":0,\"scenes\":[{\"nodes\":[1]}],\"nodes\":["
      "{\"mesh\":0,\"matrix\":[1,0,0,0, 0,1,0,0, 0,0,1,0, 10,0,0,1]},"
      "{\"children\":[0,2],\"translation\":[0,5,0],\"rotation\":[0,0,0.70710678,0.70710678],\"scale\":[2,2,2]},"
      "{\"mesh\":0,\"scale\":[0,0,0]},"
      "{\"mesh\":0}]";
  const Scene scene = decoded(maker.gltf(primitive(), nodes));
  ASSERT_EQ(scene.instances.size(), 1u);  // node 2 is scaled to nothing, node 3 is in no scene
  const glm::vec4 moved = scene.instances[0].world_from_object * glm::vec4(1, 0, 0, 1);
  EXPECT_LT(glm::distance(moved, glm::vec4(0, 27, 0, 1)), 1e-5f);  // (11, 0, 0) · 2, turned to +Y, and up by 5
}

TEST(Gltf, ShowsAllRootNodesWhereNoSceneIsNamed) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const Scene scene = decoded(
      maker.gltf(primitive(), "\"nodes\":[{\"mesh\":0},{\"children\":[2]},{\"mesh\":0,\"translation\":[1,0,0]}]"));
  EXPECT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.meshes.size(), 1u);  // which they share
}

TEST(Gltf, TurnsTheTrianglesOfMirroringNodes) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const Scene scene = decoded(maker.gltf(
      primitive(), "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"scale\":[-1,1,1]},{\"mesh\":0,\"scale\":[-1,2,1]}]"));
  ASSERT_EQ(scene.instances.size(), 3u);
  ASSERT_EQ(scene.meshes.size(), 2u);
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[std::size_t(instance.mesh)];
    const auto corner = [&](std::size_t i) {
      return glm::vec3(instance.world_from_object * glm::vec4(mesh.vertices[mesh.indices[i]].position, 1.0f));
    };
    const glm::vec3 facing = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    EXPECT_GT(facing.z, 0.0f);  // as its normals, which the mirror leaves
    const Vertex& vertex = mesh.vertices[0];
    const glm::mat3 linear(instance.world_from_object);
    const glm::vec3 tangent = linear * glm::vec3(vertex.tangent);
    const glm::vec3 bitangent = vertex.tangent.w * glm::cross(glm::vec3(0, 0, 1), tangent);
    const glm::vec3 in_object = glm::cross(vertex.normal, glm::vec3(vertex.tangent));
    EXPECT_GT(glm::dot(bitangent, linear * in_object), 0.0f);
  }
}

TEST(Gltf, ReadsEveryFieldOfAMaterial) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  Image8 picture(2, 1, 3, 0);
  picture.texel(1, 0)[0] = 200;
  const std::string path = ::testing::TempDir() + "gltf picture.png";
  ASSERT_TRUE(savePicture(path, picture));
  const Result<Bytes> png = readFile(path);
  ASSERT_TRUE(png);
  const int view = maker.view(*png);
  const std::string rest =
      "\"extensionsRequired\":[\"KHR_texture_transform\"],"
      "\"images\":[{\"bufferView\":" +
      std::to_string(view) +
      ",\"mimeType\":\"image/png\"},"
      "{\"uri\":\"gltf%20picture.png\"},{\"uri\":\"data:image/png;base64," +
      GltfMaker::base64(*png) +
      "\"},"
      "{\"uri\":\"unused-and-missing.png\"}],"
      "\"samplers\":[{\"wrapS\":33071,\"wrapT\":33648,\"magFilter\":9728}],"
      "\"textures\":[{\"source\":0,\"sampler\":0},{\"source\":1},{\"source\":2},{\"source\":3}],"
      "\"materials\":[{\"name\":\"unused\",\"emissiveTexture\":{\"index\":3}},{\"name\":\"all\","
      "\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.1,0.2,0.3,0.4],\"metallicFactor\":0.5,\"roughnessFactor\":0.25,"
      "\"baseColorTexture\":{\"index\":0,\"texCoord\":1,\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.5,0."
      "25],"
      "\"scale\":[2,3],\"rotation\":1.5,\"texCoord\":0}}},\"metallicRoughnessTexture\":{\"index\":1,\"texCoord\":1}},"
      "\"normalTexture\":{\"index\":1,\"scale\":0.75},\"occlusionTexture\":{\"index\":1,\"strength\":0.5},"
      "\"emissiveTexture\":{\"index\":2},\"emissiveFactor\":[1,0.5,0],\"alphaMode\":\"MASK\",\"alphaCutoff\":0.3,"
      "\"doubleSided\":true,\"extensions\":{\"KHR_materials_ior\":{\"ior\":1.33},\"KHR_materials_transmission\":"
      "{\"transmissionFactor\":0.9,\"transmissionTexture\":{\"index\":2}},\"KHR_materials_emissive_strength\":{"
      "\"emissiveStrength\":4},"
      "\"KHR_materials_specular\":{\"specularFactor\":0.6,\"specularTexture\":{\"index\":1,\"texCoord\":1}},\"KHR_"
      "materials_dispersion\":{\"dispersion\":0.1},\"KHR_materials_volume\":{\"thicknessFactor\":0.2,"
      "\"attenuationDistance\":3,\"attenuationColor\":[0.5,0.25,1]}}}]";
  const Scene scene = decoded(maker.gltf(primitive("", ",\"material\":1"), rest));
  ASSERT_EQ(scene.materials.size(), 1u);
  const Material& material = scene.materials[0];
  EXPECT_EQ(material.name, "all");
  EXPECT_EQ(material.base_color, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(material.opacity, 0.4f);
  EXPECT_EQ(material.metallic, 0.5f);
  EXPECT_EQ(material.perceptual_roughness, 0.25f);
  EXPECT_EQ(material.emission, glm::vec3(4, 2, 0));
  EXPECT_EQ(material.ior, 1.33f);
  EXPECT_EQ(material.transmission, 0.9f);
  EXPECT_FALSE(material.thin_walled);
  EXPECT_EQ(material.attenuation_distance, 3.0f);
  EXPECT_EQ(material.attenuation_color, glm::vec3(0.5f, 0.25f, 1.0f));
  EXPECT_EQ(material.specular, 0.6f);
  EXPECT_EQ(material.dispersion, 0.1f);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.3f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.normal_scale, 0.75f);
  EXPECT_EQ(material.occlusion_strength, 0.5f);

  std::string without_thickness = rest;
  without_thickness.replace(rest.find("0.2,\"att"), 3, "0.0");
  EXPECT_TRUE(decoded(maker.gltf(primitive("", ",\"material\":1"), without_thickness)).materials[0].thin_walled);

  const TextureSlot& color = material.base_color_map;
  EXPECT_EQ(color.uv_set, 0);  // the transform's own texCoord wins
  EXPECT_EQ(color.offset, glm::vec2(0.5f, 0.25f));
  EXPECT_EQ(color.scale, glm::vec2(2, 3));
  EXPECT_EQ(color.rotation_rad, 1.5f);
  EXPECT_EQ(material.metallic_map.uv_set, 1);
  EXPECT_EQ(material.roughness_map.uv_set, 1);
  EXPECT_EQ(material.specular_map.texture, material.occlusion_map.texture);
  EXPECT_EQ(material.specular_map.uv_set, 1);
  ASSERT_EQ(scene.textures.size(), 5u) << "normals are filtered otherwise than numbers";
  const auto texture = [&](const TextureSlot& slot) { return scene.textures.at(std::size_t(slot.texture)); };
  EXPECT_TRUE(texture(color).srgb);
  EXPECT_TRUE(texture(color).nearest);
  EXPECT_EQ(texture(color).wrap_s, Wrap::clamp_to_edge);
  EXPECT_EQ(texture(color).wrap_t, Wrap::mirrored_repeat);
  EXPECT_FALSE(texture(material.normal_map).srgb);
  EXPECT_TRUE(texture(material.normal_map).image.isSameAs(texture(material.occlusion_map).image));
  EXPECT_TRUE(texture(material.emission_map).srgb);
  EXPECT_FALSE(texture(material.transmission_map).srgb) << "the same picture, here as numbers";
  for (const Texture& each : scene.textures) {
    ASSERT_EQ(each.image.width(), 2);
    EXPECT_EQ(each.image.texel(1, 0)[0], 200);
  }
}

/// The material of a triangle, by its JSON.
Material materialOf(const std::string& json, const std::string& rest = "") {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  return decoded(maker.gltf(primitive("", ",\"material\":0"), "\"materials\":[" + json + "]" + rest)).materials.at(0);
}

TEST(Gltf, ReadsTheColourOfReflections) {
  const std::string path = ::testing::TempDir() + "gltf_specular.png";
  ASSERT_TRUE(savePicture(path, Image8(1, 1, 3, 9)));
  const Material material = materialOf(R"({"extensions":{"KHR_materials_specular":{"specularColorFactor":[2,0.5,-1],)"
                                       R"("specularColorTexture":{"index":0}}}})",
                                       R"(,"images":[{"uri":"gltf_specular.png"}],"textures":[{"source":0}])");
  EXPECT_EQ(material.specular_color, glm::vec3(2.0f, 0.5f, 0.0f));
  EXPECT_EQ(material.specular_color_map.texture, 0);
}

// An infinite index: the specular colour is all that is left of the reflectance along the normal.
TEST(Gltf, AnIndexOf0LeavesTheSpecularColour) {
  formula::Surface surface;
  surface.material = materialOf(
      R"({"extensions":{"KHR_materials_ior":{"ior":0},"KHR_materials_specular":{"specularColorFactor":[1,0.8,0.3]}}})");
  EXPECT_LT(glm::distance(formula::smoothDielectric(surface.material, 1.0f), glm::vec3(1.0f, 0.8f, 0.3f)), 1e-6f);
  EXPECT_LT(glm::distance(formula::smoothDielectric(surface.material, 0.0f), glm::vec3(1.0f)), 1e-6f);
  EXPECT_EQ(materialOf(R"({"extensions":{"KHR_materials_ior":{"ior":0.5}}})").ior, 1.5f) << "which is not allowed";
}

// c_diff = diffuse · (1 − max(specular)) and f0 = specular, as the extension has it; its textures too.
TEST(Gltf, ReadsSpecularAndGlossinessWithoutLoss) {
  formula::Surface surface;
  const std::string numbers =
      R"("diffuseFactor":[0.2,0.4,0.6,0.5],"specularFactor":[0.1,0.7,0.3],"glossinessFactor":0.75)";
  Material material = materialOf(R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"metallicFactor":1},)"
                                 R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{)" +
                                 numbers + "}}}");
  EXPECT_EQ(material.perceptual_roughness, 0.25f);
  EXPECT_EQ(material.opacity, 0.5f);
  surface.material = material;
  surface.normal = {0.0f, 0.0f, 1.0f};
  surface.environment_brdf = glm::vec3(0.0f);
  EXPECT_LT(glm::distance(formula::smoothDielectric(surface.material, 1.0f), glm::vec3(0.1f, 0.7f, 0.3f)), 1e-6f);
  surface.material.perceptual_roughness = 0.0f;
  EXPECT_LT(glm::distance(formula::seenAlong(surface, {0.0f, 0.0f, -1.0f}).diffuse_albedo,
                          glm::vec3(0.2f, 0.4f, 0.6f) * 0.3f),
            1e-6f);

  Image8 picture(1, 1, 4, 100);
  picture.texel(0, 0)[3] = 204;  // glossiness 0.8
  ASSERT_TRUE(savePicture(::testing::TempDir() + "gltf_gloss.png", picture));
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const Scene scene =
      decoded(maker.gltf(primitive("", ",\"material\":0"),
                         R"("images":[{"uri":"gltf_gloss.png"}],"textures":[{"source":0}],"materials":[{"extensions":)"
                         R"({"KHR_materials_pbrSpecularGlossiness":{)" +
                             numbers + R"(,"diffuseTexture":{"index":0},"specularGlossinessTexture":{"index":0}}}}])"));
  material = scene.materials.at(0);
  const auto texture = [&](const TextureSlot& slot) { return scene.textures.at(std::size_t(slot.texture)); };
  EXPECT_TRUE(texture(material.specular_color_map).srgb);
  EXPECT_TRUE(texture(material.base_color_map).srgb);
  EXPECT_EQ(texture(material.specular_color_map).image.texel(0, 0)[0], 100);
  EXPECT_FALSE(texture(material.roughness_map).srgb);
  EXPECT_EQ(material.perceptual_roughness, 1.0f);
  EXPECT_EQ(texture(material.roughness_map).image.texel(0, 0)[1], 102) << "1 − 0.75 · 0.8";
  EXPECT_EQ(material.metallic_map.texture, -1);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Gltf, OfAnUnlitMaterialOnlyItsColourCounts) {
  const Material material = materialOf(
      R"({"pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":1},"emissiveFactor":[1,1,1],)"
      R"("alphaMode":"BLEND","doubleSided":true,"extensions":{"KHR_materials_unlit":{},)"
      R"("KHR_materials_transmission":{"transmissionFactor":1}}})");
  EXPECT_TRUE(material.unlit);
  EXPECT_EQ(material.base_color, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(material.opacity, 0.4f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.transmission, 0.0f);
  EXPECT_EQ(material.emission, glm::vec3(0.0f));
}

TEST(Gltf, ReadsOnePictureForBothKindsOfColour) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const std::string path = ::testing::TempDir() + "gltf_both.png";
  ASSERT_TRUE(savePicture(path, Image8(1, 1, 3, 9)));
  const Scene scene = decoded(maker.gltf(
      primitive("", ",\"material\":0"),
      "\"images\":[{\"uri\":\"gltf_both.png\"}],\"textures\":[{\"source\":0}],\"materials\":[{\"emissiveTexture\":"
      "{\"index\":0},\"normalTexture\":{\"index\":0}}]"));
  ASSERT_EQ(scene.textures.size(), 2u);
  for (const Texture& texture : scene.textures) EXPECT_EQ(texture.image.texel(0, 0)[2], 9);
}

TEST(Gltf, WithoutAMaterialHasTheFormatsDefault) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  const Material material = decoded(maker.gltf(primitive())).materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec3(1.0f));
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.perceptual_roughness, 1.0f);
}

TEST(Gltf, ComputesTangentsAlongTheNormalMapsCoordinates) {
  GltfMaker maker;
  maker.accessor(kTriangle, "VEC3");
  maker.accessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  maker.accessor(std::vector<float>{0, 1, 1, 1, 0, 0}, "VEC2");  // u along +X
  maker.accessor(std::vector<float>{0, 0, 0, 1, 1, 0}, "VEC2");  // u along +Y
  const std::string path = ::testing::TempDir() + "gltf_normal.png";
  ASSERT_TRUE(savePicture(path, Image8(1, 1, 3, 128)));
  const auto tangent = [&](int set) {
    return decoded(maker.gltf(primitive(",\"NORMAL\":1,\"TEXCOORD_0\":2,\"TEXCOORD_1\":3", ",\"material\":0"),
                              "\"images\":[{\"uri\":\"gltf_normal.png\"}],\"textures\":[{\"source\":0}],\"materials\":["
                              "{\"normalTexture\":{\"index\":0,\"texCoord\":" +
                                  std::to_string(set) + "}}]"))
        .meshes.at(0)
        ->vertices.at(0)
        .tangent;
  };
  EXPECT_EQ(tangent(0), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(tangent(1), glm::vec4(0, 1, 0, 1));
}

}  // namespace
}  // namespace mirrorball
