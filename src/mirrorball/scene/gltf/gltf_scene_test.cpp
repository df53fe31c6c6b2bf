// What a glTF file holds beside its meshes: variants of materials, cameras and lights.

#include <chrono>
#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/gltf/gltf_testing.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using testing::GltfMaker;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A triangle in a file with more members at its root.
Result<Scene> triangleWith(const std::string& rest, const std::string& more_of_primitive = "") {
  GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const std::string json = maker.gltf("{\"attributes\":{\"POSITION\":0}" + more_of_primitive + "}", rest);
  return decodeGltf(Bytes(json.begin(), json.end()), "model.gltf");
}

Scene read(const Result<Scene>& scene) {
  EXPECT_TRUE(scene) << scene.error().message;
  return scene ? *scene : Scene{};
}

Scene sceneRoundTrip(const Scene& scene) {
  const Result<EncodedScene> file = encodeGlb(scene);
  EXPECT_TRUE(file) << file.error().message;
  return read(decodeGltf(file->bytes, "scene.glb"));
}

void expectNear(glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z; }

// --- variants

const std::string kThreeVariants =
    R"("materials":[{"name":"plain"},{"name":"red"},{"name":"blue"}],)"
    R"("extensions":{"KHR_materials_variants":{"variants":[{"name":"Dawn"},{"name":"dusk light"},{"name":"Noon"}]}})";

std::string mappings(const std::string& list) {
  return R"(,"material":0,"extensions":{"KHR_materials_variants":{"mappings":)" + list + "}}";
}

std::string nameOfMaterial(const Scene& scene) {
  return scene.materials.at(std::size_t(scene.meshes.at(0)->material)).name;
}

TEST(GltfVariants, GiveAPrimitiveOtherMaterials) {
  Scene scene =
      read(triangleWith(kThreeVariants, mappings(R"([{"material":1,"variants":[0]},{"material":2,"variants":[1]}])")));
  EXPECT_THAT(scene.variants, ElementsAre("Dawn", "dusk light", "Noon"));
  for (const Scene& each : {scene, sceneRoundTrip(scene)}) {
    scene = each;
    EXPECT_EQ(nameOfMaterial(scene), "plain");
    ASSERT_TRUE(chooseVariant(scene, "dusk light"));
    EXPECT_EQ(nameOfMaterial(scene), "blue");
    ASSERT_TRUE(chooseVariant(scene, "DAWN"));
    EXPECT_EQ(nameOfMaterial(scene), "red");
    ASSERT_TRUE(chooseVariant(scene, "Noon"));
    EXPECT_EQ(nameOfMaterial(scene), "plain") << "which nothing maps";
  }
  EXPECT_THAT(chooseVariant(scene, "Dask").error().message,
              AllOf(HasSubstr("no variant is named 'Dask'"), HasSubstr("Dawn, dusk light, Noon")));
  Scene without = meshScene(sphereMesh());
  EXPECT_EQ(chooseVariant(without, "Dawn").error().code, ErrorCode::usage);
}

TEST(GltfVariants, WrongMappingsAreLeftOut) {
  testing::expectTold(triangleWith(kThreeVariants, mappings(R"([{"material":3,"variants":[0]}])")),
                      "mappings[0].material is 3, but there are 3 materials");
  testing::expectTold(triangleWith(kThreeVariants, mappings(R"([{"material":1,"variants":[9]}])")),
                      "mappings[0].variants is 9, but there are 3 variants");
  testing::expectTold(triangleWith(kThreeVariants, mappings(R"([{"variants":[0]}])")),
                      "mappings[0].material is missing");
  testing::expectTold(triangleWith(R"("extensions":{"KHR_materials_variants":{"variants":[{}]}})"),
                      "variants[0].name is missing");
}

// --- cameras

/// Two nodes: the triangle's, and another with more members.
std::string nodes(const std::string& members) { return R"("nodes":[{"mesh":0},{)" + members + "}]"; }

TEST(GltfCameras, StandWhereTheirNodesAreWithoutTheirScale) {
  const Scene scene = read(triangleWith(
      R"("cameras":[{"type":"perspective","name":"lens","perspective":{"yfov":0.5,"aspectRatio":2,"znear":0.25}},)"
      R"({"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0,"zfar":10}}],)"
      R"("nodes":[{"mesh":0},{"camera":0,"translation":[1,2,3],"rotation":[0,0.70710678,0,0.70710678],)"
      R"("scale":[5,2,-7]},{"name":"top","camera":1},{"name":"top","camera":1}])"));
  ASSERT_EQ(scene.cameras.size(), 3u);
  const auto camera = [&](const std::string& name) {
    for (const ModelCamera& each : scene.cameras)
      if (each.name == name) return each;
    ADD_FAILURE() << name;
    return ModelCamera{};
  };
  const ModelCamera lens = camera("lens");
  expectNear(glm::vec3(lens.world_from_view[3]), {1, 2, 3});
  // Turned by 90° about +Y, −Z goes to −X; that the scale mirrors it turns it round.
  expectNear(glm::vec3(lens.world_from_view[2]), {-1, 0, 0});
  expectNear(glm::vec3(lens.world_from_view[1]), {0, 1, 0});
  EXPECT_NEAR(glm::determinant(lens.world_from_view), 1.0f, 1e-5f);
  EXPECT_EQ(lens.fov_rad, 0.5f);
  EXPECT_EQ(lens.aspect, 2.0f);
  EXPECT_EQ(lens.nearest, 0.25f);
  EXPECT_TRUE(camera("top").orthographic);
  EXPECT_EQ(camera("top").height, 4.0f);
  EXPECT_EQ(camera("top 2").aspect, 1.5f);
}

TEST(GltfCameras, ComeBack) {
  Scene scene = meshScene(sphereMesh());
  scene.cameras.push_back({.name = "a", .fov_rad = 0.7f, .aspect = 1.25f, .nearest = 0.01f});
  scene.cameras.push_back({.name = "b", .orthographic = true, .height = 3.0f, .aspect = 0.5f, .nearest = 1.0f});
  scene.cameras[1].world_from_view[3] = {4, 5, 6, 1};
  const Scene found = sceneRoundTrip(scene);
  ASSERT_EQ(found.cameras.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const ModelCamera& wanted = scene.cameras[i];
    const auto is_named = [&](const ModelCamera& each) { return each.name == wanted.name; };
    const auto camera = std::ranges::find_if(found.cameras, is_named);
    ASSERT_NE(camera, found.cameras.end());
    EXPECT_EQ(camera->world_from_view, wanted.world_from_view);
    EXPECT_EQ(camera->orthographic, wanted.orthographic);
    EXPECT_FLOAT_EQ(wanted.orthographic ? camera->height : camera->fov_rad,
                    wanted.orthographic ? wanted.height : wanted.fov_rad);
    EXPECT_FLOAT_EQ(camera->aspect, wanted.aspect);
    EXPECT_EQ(camera->nearest, wanted.nearest);
  }
}

TEST(GltfCameras, ThatShowNothingAreLeftOut) {
  for (const std::string lens :
       {R"("type":"perspective","perspective":{"yfov":0,"znear":1})",
        R"("type":"perspective","perspective":{"yfov":3.2,"znear":1})", R"("type":"perspective","perspective":{})",
        R"("type":"orthographic","orthographic":{"xmag":0,"ymag":1})",
        R"("type":"orthographic","orthographic":{"xmag":1e-30,"ymag":1e30})", R"("type":"fisheye")"}) {
    const Scene scene = read(triangleWith(R"("cameras":[{)" + lens + "}]," + nodes(R"("camera":0)")));
    EXPECT_THAT(scene.cameras, IsEmpty()) << lens;
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the camera of nodes[1], which shows nothing, is left out")));
  }
  const std::string right = R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}}],)";
  EXPECT_THAT(read(triangleWith(right + nodes(R"("camera":0,"scale":[1,0,1])"))).cameras, IsEmpty());
  testing::expectTold(triangleWith(right + nodes(R"("camera":1)")), "nodes[1].camera is 1, but there is 1 camera");
  testing::expectTold(triangleWith(R"("cameras":[{"type":"perspective"}])"), "cameras[0].perspective is missing");
  testing::expectTold(triangleWith(R"("cameras":[{}])"), "cameras[0].type is missing");
}

// A thousand cameras of one name, which is long and differs at its end: comparing each with all others took hours.
TEST(GltfCameras, OfOneNameAreToldApartInLittleTime) {
  const std::string name(10'000, 'c');
  std::string many = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < 1500; ++i) many += R"(,{"camera":0})";
  const auto begin = std::chrono::steady_clock::now();
  const Scene scene = read(triangleWith(R"("cameras":[{"type":"perspective","name":")" + name +
                                        R"(","perspective":{"yfov":1,"znear":1}}],)" + many + "]"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  ASSERT_EQ(scene.cameras.size(), 1000u);
  std::set<std::string> names;
  for (const ModelCamera& camera : scene.cameras) names.insert(camera.name);
  EXPECT_EQ(names.size(), 1000u);
  EXPECT_EQ(scene.cameras[999].name, name + " 1000");
}

TEST(GltfCameras, AreFoundByTheirNames) {
  Scene scene = meshScene(sphereMesh());
  const auto named = [&](const std::string& name) {
    return framedCamera(scene, boundingSphere(scene), {.name = name}, {64, 32});
  };
  EXPECT_THAT(named("Left").error().message, HasSubstr("the model has no cameras"));
  scene.cameras = {{.name = "Left"}, {.name = "Right"}};
  scene.cameras[1].world_from_view[3] = {0, 0, 5, 1};
  ASSERT_TRUE(named("right"));
  EXPECT_EQ(named("right")->position, glm::vec3(0, 0, 5));
  EXPECT_THAT(named("Lift").error().message, AllOf(HasSubstr("did you mean 'Left'"), HasSubstr("Left, Right")));
}

// --- lights

std::string lights(const std::string& list) {
  return R"("extensions":{"KHR_lights_punctual":{"lights":[)" + list + "]}},";
}

std::string lightNode(const std::string& more = "") {
  return nodes(R"("extensions":{"KHR_lights_punctual":{"light":0}})" + more);
}

TEST(GltfLights, AreReadWithTheirUnits) {
  const auto light = [](const std::string& json) {
    const Scene scene = read(triangleWith(
        lights(json) + lightNode(R"(,"name":"lamp","translation":[1,2,3],"rotation":[-0.70710678,0,0,0.70710678])")));
    EXPECT_EQ(scene.lights.size(), 1u);
    return scene.lights.empty() ? ModelLight{} : scene.lights[0];
  };
  const ModelLight sun = light(R"({"type":"directional","intensity":1000,"color":[1,0.5,0.25]})");
  EXPECT_EQ(sun.kind, formula::kLampDirectional);
  EXPECT_EQ(sun.color, glm::vec3(1000, 500, 250));
  expectNear(sun.direction, {0, -1, 0});  // −Z turned by −90° about +X
  EXPECT_EQ(sun.name, "lamp");
  const ModelLight bulb = light(R"({"type":"point","name":"bulb","range":7})");
  EXPECT_EQ(bulb.kind, formula::kLampPoint);
  EXPECT_EQ(bulb.color, glm::vec3(1.0f));
  EXPECT_EQ(bulb.position, glm::vec3(1, 2, 3));
  EXPECT_EQ(bulb.range, 7.0f);
  EXPECT_EQ(bulb.name, "bulb");
  const ModelLight spot = light(R"({"type":"spot","spot":{"innerConeAngle":0.2,"outerConeAngle":0.5}})");
  EXPECT_FLOAT_EQ(spot.cosine_inner, std::cos(0.2f));
  EXPECT_FLOAT_EQ(spot.cosine_outer, std::cos(0.5f));
  const ModelLight usual = light(R"({"type":"spot","spot":{}})");
  EXPECT_FLOAT_EQ(usual.cosine_inner, 1.0f);
  EXPECT_FLOAT_EQ(usual.cosine_outer, std::cos(formula::kPi / 4.0f));
}

TEST(GltfLights, ComeBack) {
  Scene scene = meshScene(sphereMesh());
  ModelLight spot;
  spot.name = "spot";
  spot.kind = formula::kLampSpot;
  spot.position = {1, 2, 3};
  spot.direction = glm::normalize(glm::vec3(-1, -2, 0.5f));
  spot.color = {30, 60, 15};
  spot.range = 20.0f;
  spot.cosine_inner = 0.96f;
  spot.cosine_outer = 0.9f;
  ModelLight sun;
  sun.kind = formula::kLampDirectional;
  sun.direction = {0, -1, 0};
  ModelLight dark;
  dark.color = glm::vec3(0.0f);
  scene.lights = {spot, sun, dark};
  const Scene found = sceneRoundTrip(scene);
  ASSERT_EQ(found.lights.size(), 3u);
  for (const ModelLight& wanted : scene.lights) {
    const auto is_of_kind = [&](const ModelLight& each) { return each.kind == wanted.kind; };
    const auto light = std::ranges::find_if(found.lights, is_of_kind);
    ASSERT_NE(light, found.lights.end());
    EXPECT_EQ(light->name, wanted.name);
    expectNear(light->position, wanted.position);
    expectNear(light->direction, wanted.direction);
    expectNear(light->color / 60.0f, wanted.color / 60.0f);
    EXPECT_EQ(light->range, wanted.range);
    EXPECT_NEAR(light->cosine_inner, wanted.cosine_inner, 1e-6f);
    EXPECT_NEAR(light->cosine_outer, wanted.cosine_outer, 1e-6f);
  }
}

TEST(GltfLights, ThatAreDamagedAreTold) {
  const Scene unknown = read(triangleWith(lights(R"({"type":"area"})") + lightNode()));
  EXPECT_THAT(unknown.lights, IsEmpty());
  EXPECT_THAT(unknown.warnings, ElementsAre(HasSubstr("the light of nodes[1], which has no kind or no direction,")));
  const std::string bulb = R"({"type":"point"})";
  EXPECT_THAT(read(triangleWith(lights(bulb) + lightNode(R"(,"scale":[1,1,0])"))).lights, IsEmpty());
  testing::expectTold(triangleWith(lights(bulb) + nodes(R"("extensions":{"KHR_lights_punctual":{"light":1}})")),
                      "nodes[1].extensions.KHR_lights_punctual.light is 1, but there is 1 light");
  testing::expectTold(triangleWith(lights("{}") + lightNode()), "lights[0].type is missing");
  const Scene wild = read(triangleWith(lights(R"({"type":"spot","intensity":-5,"color":[1e300,1,1],"range":-1,)"
                                              R"("spot":{"innerConeAngle":9,"outerConeAngle":-9}})") +
                                       lightNode()));
  EXPECT_EQ(wild.lights.at(0).color, glm::vec3(0.0f));
  EXPECT_EQ(wild.lights[0].range, 0.0f);
  EXPECT_GE(wild.lights[0].cosine_inner, wild.lights[0].cosine_outer);
}

TEST(GltfLights, BeyondTheFirst32AreToldOnce) {
  std::string many = R"("nodes":[{"mesh":0})";
  for (int i = 0; i < 40; ++i) many += R"(,{"extensions":{"KHR_lights_punctual":{"light":0}}})";
  const Scene scene = read(triangleWith(lights(R"({"type":"point"})") + many + "]"));
  EXPECT_EQ(scene.lights.size(), Scene::kMaxLights);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("all of its light but 32 lamps is left out")));
}

}  // namespace
}  // namespace mirrorball
