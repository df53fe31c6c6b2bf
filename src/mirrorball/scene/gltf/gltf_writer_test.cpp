#include "mirrorball/scene/gltf/gltf_writer.h"

#include <cmath>
#include <numeric>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

EncodedScene encoded(const Scene& scene, const std::optional<Camera>& camera = {}) {
  Result<EncodedScene> file = encodeGlb(scene, camera);
  EXPECT_TRUE(file) << file.error().message;
  return file ? std::move(*file) : EncodedScene{};
}

Scene decodedFile(const EncodedScene& file) {
  Result<Scene> scene = decodeGltf(file.bytes, "scene.glb");
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? std::move(*scene) : Scene{};
}

Scene roundTrip(const Scene& scene) { return decodedFile(encoded(scene)); }

/// The JSON's text: its length is the word behind the header's three.
std::string jsonOf(const EncodedScene& file) {
  const std::size_t length = file.bytes.at(12) | file.bytes.at(13) << 8 | file.bytes.at(14) << 16;
  return std::string(file.bytes.begin() + 20, file.bytes.begin() + 20 + static_cast<std::ptrdiff_t>(length));
}

/// The parameters that have a key in glTF, as --set writes them.
std::string parametersOf(const Material& material) {
  std::string all;
  for (const MaterialParameter& parameter : materialParameters())
    if (!parameter.gltf.empty()) all += std::string(parameter.text.name) + "=" + written(parameter, material) + " ";
  return all;
}

// Codes end at 1, and the factor holds what is brighter; normals longer than 1 keep their direction.
TEST(GltfWriter, FloatsBecomeCodes) {
  Scene scene = meshScene(sphereMesh());
  Image light(1, 1, 4, 1.0f), normal(1, 1, 4, 0.0f);
  for (int channel = 0; channel < 3; ++channel) light.texel(0, 0)[channel] = 50.0f;
  normal.texel(0, 0)[0] = 1.2f;
  normal.texel(0, 0)[2] = 1.6f;
  scene.textures = {{.image = std::move(light)}, {.image = std::move(normal)}};
  scene.materials[0].emission = glm::vec3(1.0f);
  scene.materials[0].emission_map.texture = 0;
  scene.materials[0].normal_map.texture = 1;
  scene.materials[0].normal_zero = 0.0f;
  const auto file = encodeGlb(scene);
  ASSERT_TRUE(file) << file.error().message;
  const auto again = decodeGltf(file->bytes, "floats.glb");
  ASSERT_TRUE(again) << again.error().message;
  const Material& material = again->materials[0];
  EXPECT_NEAR(material.emission.x, 50.0f, 1e-3f);
  EXPECT_EQ(again->textures[std::size_t(material.emission_map.texture)].image.at(0, 0).x, 1.0f);
  const glm::vec4 encoded = again->textures[std::size_t(material.normal_map.texture)].image.at(0, 0);
  EXPECT_LT(glm::distance(2.0f * glm::vec3(encoded) - 1.0f, glm::vec3(0.6f, 0.0f, 0.8f)), 0.01f);
  EXPECT_THAT(file->left_out, ::testing::Contains(::testing::HasSubstr("finer than 8 bits")));
}

/// A picture whose texels are all different.
Image8 picture(int width, int height, std::uint8_t first) {
  Image8 image(width, height, 4);
  std::iota(image.samples().begin(), image.samples().end(), first);
  return image;
}

TEST(GltfWriter, MeshesComeBackBitByBit) {
  Scene scene = meshScene(knotMesh());
  Vertex& vertex = scene.meshes[0].edit().vertices[7];
  vertex.color = {0.25f, 0.5f, 0.75f, 0.125f};
  vertex.uv[1] = {0.3f, -2.7f};
  const Scene found = roundTrip(scene);
  ASSERT_EQ(found.meshes.size(), 1u);
  EXPECT_EQ(found.meshes[0]->indices, scene.meshes[0]->indices);
  ASSERT_EQ(found.meshes[0]->vertices.size(), scene.meshes[0]->vertices.size());
  for (std::size_t i = 0; i < scene.meshes[0]->vertices.size(); ++i) {
    const Vertex& a = scene.meshes[0]->vertices[i];
    const Vertex& b = found.meshes[0]->vertices[i];
    ASSERT_EQ(a.position, b.position);
    ASSERT_LT(glm::distance(a.normal, b.normal), 1e-6f);
    ASSERT_LT(glm::distance(a.tangent, b.tangent), 1e-6f);
    ASSERT_EQ(a.uv[0], b.uv[0]);
    ASSERT_EQ(a.uv[1], b.uv[1]);
    ASSERT_EQ(a.color, b.color);
  }
}

TEST(GltfWriter, InstancesKeepTheirPlacesAndShareTheirMesh) {
  const Scene scene = *loadModel("showcase");
  Scene twice = scene;
  twice.instances.push_back({0, glm::scale(glm::mat4(1.0f), glm::vec3(2.0f))});
  const Scene found = roundTrip(twice);
  EXPECT_EQ(found.meshes.size(), scene.meshes.size());
  ASSERT_EQ(found.instances.size(), twice.instances.size());
  for (const Instance& wanted : twice.instances)
    EXPECT_TRUE(std::ranges::any_of(found.instances, [&](const Instance& instance) {
      return instance.world_from_object == wanted.world_from_object &&
             found.meshes[std::size_t(instance.mesh)]->indices == twice.meshes[std::size_t(wanted.mesh)]->indices;
    }));
}

// Each row of the table with a key in glTF, moved off glTF's default.
TEST(GltfWriter, EveryParameterOfTheTableComesBack) {
  for (const MaterialParameter& parameter : materialParameters()) {
    if (parameter.gltf.empty()) continue;
    Material material;
    const std::string name(parameter.text.name);
    const bool is_flag = std::holds_alternative<bool Material::*>(parameter.field);
    // Within the range of each, and not the middle, which may be a default.
    const double least = std::max(parameter.text.minimum, name == "ior" ? 1.0 : 0.0);
    const double value = least + 0.3 * (std::min(parameter.text.maximum, 5.0) - least);
    ASSERT_TRUE(setParameter(material, name + "=" + (is_flag ? "yes" : std::to_string(value)))) << name;
    material.alpha_mode = name == "alpha_cutoff" ? AlphaMode::mask : AlphaMode::opaque;
    Scene scene = meshScene(planeMesh(), material);
    scene.textures.push_back({.image = picture(2, 2, 0)});
    Material& own = scene.materials[0];
    own.normal_map.texture = own.occlusion_map.texture = own.clearcoat_normal_map.texture = 0;
    const EncodedScene file = encoded(scene);
    EXPECT_THAT(file.left_out, IsEmpty()) << name;
    EXPECT_EQ(parametersOf(decodedFile(file).materials.at(0)), parametersOf(material)) << name;
  }
}

TEST(GltfWriter, AThinWallComesBack) {
  for (const bool is_thin : {false, true}) {
    Material material;
    material.transmission = 1.0f;
    material.thin_walled = is_thin;
    EXPECT_EQ(decodedFile(encoded(meshScene(sphereMesh(), material))).materials.at(0).thin_walled, is_thin);
  }
}

TEST(GltfWriter, AnUnlitMaterialComesBackAndLooksMattElsewhere) {
  Material material = *materialNamed("gold");
  material.unlit = true;
  const EncodedScene file = encoded(meshScene(sphereMesh(), material));
  EXPECT_THAT(jsonOf(file), AllOf(HasSubstr("\"KHR_materials_unlit\":{}"), HasSubstr("\"metallicFactor\":0.0")));
  const Material found = decodedFile(file).materials.at(0);
  EXPECT_TRUE(found.unlit);
  EXPECT_EQ(found.base_color, material.base_color);
}

TEST(GltfWriter, DefaultsAreNotWritten) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = material.perceptual_roughness = 1.0f;
  const std::string json = jsonOf(encoded(meshScene(sphereMesh(), material)));
  EXPECT_THAT(json, AllOf(Not(HasSubstr("pbrMetallicRoughness")), Not(HasSubstr("extensions")),
                          Not(HasSubstr("COLOR_0")), Not(HasSubstr("matrix")), Not(HasSubstr("cameras"))));
}

TEST(GltfWriter, ExtensionsThatAreUsedAreNamed) {
  Material material;
  material.ior = 1.25f;
  material.emission = {8.0f, 4.0f, 0.0f};
  const EncodedScene file = encoded(meshScene(sphereMesh(), material));
  EXPECT_THAT(jsonOf(file),
              HasSubstr("\"extensionsUsed\":[\"KHR_materials_emissive_strength\",\"KHR_materials_ior\"]"));
  EXPECT_EQ(decodedFile(file).materials.at(0).emission, material.emission);
}

TEST(GltfWriter, AlphaComesBack) {
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
    Material material;
    material.base_color = glm::vec3(1.0f);
    material.opacity = 0.25f;
    material.alpha_mode = mode;
    const Material found = roundTrip(meshScene(sphereMesh(), material)).materials.at(0);
    EXPECT_EQ(found.alpha_mode, mode);
    EXPECT_EQ(found.opacity, 0.25f);
    EXPECT_EQ(found.base_color, material.base_color);
  }
}

TEST(GltfWriter, TexturesComeBackTexelByTexel) {
  Scene scene = meshScene(planeMesh());
  Image8 opaque = picture(5, 3, 7);
  for (std::size_t i = 3; i < opaque.samples().size(); i += 4) opaque.samples()[i] = 255;
  scene.textures = {{.image = picture(4, 2, 0), .srgb = true, .wrap_s = Wrap::mirrored_repeat, .nearest = true},
                    {.image = opaque, .wrap_t = Wrap::clamp_to_edge}};
  const TextureSlot moved{
      .texture = 0, .uv_set = 1, .offset = {0.1f, 0.2f}, .scale = {3.0f, 4.0f}, .rotation_rad = 0.5f};
  scene.materials[0].base_color_map = moved;
  scene.materials[0].normal_map.texture = 1;
  const Scene found = roundTrip(scene);
  const TextureSlot& slot = found.materials.at(0).base_color_map;
  EXPECT_EQ(slot.uv_set, 1);
  EXPECT_EQ(slot.offset, moved.offset);
  EXPECT_EQ(slot.scale, moved.scale);
  EXPECT_EQ(slot.rotation_rad, moved.rotation_rad);
  const auto expectSame = [&](int index, const Texture& wanted) {
    const Texture& texture = found.textures.at(std::size_t(index));
    EXPECT_THAT(texture.image.samples(), ::testing::ElementsAreArray(wanted.image.samples()));
    EXPECT_EQ(texture.srgb, wanted.srgb);
    EXPECT_EQ(texture.wrap_s, wanted.wrap_s);
    EXPECT_EQ(texture.wrap_t, wanted.wrap_t);
    EXPECT_EQ(texture.nearest, wanted.nearest);
  };
  expectSame(slot.texture, scene.textures[0]);
  expectSame(found.materials[0].normal_map.texture, scene.textures[1]);
}

// glTF has metallic and roughness in one texture.
TEST(GltfWriter, TwoTexturesBecomeOne) {
  Scene scene = meshScene(planeMesh());
  scene.textures = {{.image = picture(4, 2, 0)}, {.image = picture(4, 2, 100)}};
  scene.materials[0].metallic_map.texture = 0;
  scene.materials[0].roughness_map.texture = 1;
  const Scene both = roundTrip(scene);
  ASSERT_EQ(both.textures.size(), 1u);
  EXPECT_EQ(both.textures[0].image.texel(1, 0)[1], 105);
  EXPECT_EQ(both.textures[0].image.texel(1, 0)[2], 6);

  scene.materials[0].roughness_map.texture = -1;
  const Scene metallic = roundTrip(scene);
  EXPECT_EQ(metallic.textures[0].image.texel(1, 0)[1], 255) << "roughness must stay as it is";
  EXPECT_EQ(metallic.textures[0].image.texel(1, 0)[2], 6);

  scene.materials[0].roughness_map.texture = 1;
  scene.textures[1].image = picture(2, 2, 100);
  EXPECT_THAT(encoded(scene).left_out, ElementsAre(HasSubstr("metallic_map")));
}

TEST(GltfWriter, WhatGltfHasNotIsToldAndApproximated) {
  Material gold = *materialNamed("gold");
  gold.base_color = glm::vec3(0.0f);  // which its complex index hides
  Material orange = *materialNamed("orange");
  orange.name = "peel";
  Scene scene = meshScene(sphereMesh(), gold);
  scene.meshes.push_back(sphereMesh());
  scene.meshes[1].edit().material = 1;
  scene.materials.push_back(orange);
  glm::mat4 sheared(1.0f);
  sheared[1][0] = 0.5f;
  scene.instances.push_back({1, sheared});
  const EncodedScene file = encoded(scene);
  EXPECT_THAT(file.left_out, ElementsAre(HasSubstr("nodes[1]: its transform has shear"), HasSubstr("complex index"),
                                         "materials[1] (peel): height, height_scale and height_frequency are "
                                         "left out"));
  const glm::vec3 wanted = formula::fresnelConductor(1.0f, gold.conductor_n, gold.conductor_k);
  const Scene found = decodedFile(file);
  const auto is_gold = [&](const Material& m) { return glm::distance(m.base_color, wanted) < 1e-6f; };
  EXPECT_TRUE(std::ranges::any_of(found.materials, is_gold));
}

// glTF's normals are in tangent space, and it has no slopes.
TEST(GltfWriter, MapsThatGltfHasNotAreLeftOutAndTold) {
  Material material;
  material.normal_map.texture = 0;
  material.normal_space = NormalSpace::object;
  material.slope_texture = 0;
  Scene scene = meshScene(planeMesh(), material);
  scene.textures.push_back({.image = picture(2, 2, 0)});
  scene.slope_textures.push_back(Image(1, 1, 3));
  const EncodedScene file = encoded(scene);
  EXPECT_THAT(file.left_out, ElementsAre(AllOf(HasSubstr("normal_map"), HasSubstr("derivative_map"))));
  EXPECT_EQ(decodedFile(file).materials.at(0).normal_map.texture, -1);
}

// The depths at which a camera clips: what it sees at −1 and at 1 lies there.
TEST(GltfWriter, CamerasOfBothKindsAreWritten) {
  const Scene scene = meshScene(sphereMesh());
  CameraOptions options{.azimuth_deg = 0.0f, .elevation_deg = 0.0f, .distance = 3.0f, .fov_deg = 60.0f};
  const auto json = [&] { return jsonOf(encoded(scene, makeCamera(options, boundingSphere(scene), 2.0f))); };
  EXPECT_THAT(json(), HasSubstr("{\"name\":\"Camera\",\"camera\":0,\"matrix\":["));
  EXPECT_THAT(json(), ::testing::ContainsRegex("\"aspectRatio\":(2.0|1.99999)"));
  EXPECT_THAT(json(), ::testing::ContainsRegex("\"yfov\":1.0471"));
  EXPECT_THAT(json(), ::testing::ContainsRegex("\"znear\":1.9[89]"));
  EXPECT_THAT(json(), ::testing::ContainsRegex("\"zfar\":4.0[01]"));
  options.orthographic_height = 4.0f;
  options.distance = 0.5f;  // inside, where a parallel projection sees what is behind the camera too
  EXPECT_THAT(json(), ::testing::ContainsRegex("\"xmag\":4.0,\"ymag\":2.0,\"znear\":0.0,\"zfar\":2.0[12]"));
  EXPECT_THAT(json(), ::testing::ContainsRegex("0.0,0.0,1.0[01][0-9]*,1.0\\]")) << "moved back until all is before it";
}

TEST(GltfWriter, ASceneWithoutTrianglesIsRefused) {
  EXPECT_EQ(encodeGlb(Scene{}).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(encodeGlb(meshScene(Mesh{})).error().code, ErrorCode::bad_shape);
}

}  // namespace
}  // namespace mirrorball
