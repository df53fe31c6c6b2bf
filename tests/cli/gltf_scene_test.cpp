// What a glTF file has beside its meshes, from outside: lights, cameras and variants, in both renderers.

#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "formula/constants.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class GltfSceneTest : public RenderCliTest {
 protected:
  void SetUp() override {
    RenderCliTest::SetUp();
    write("dark.exr", Image(8, 4, 3, 0.0f));
  }

  void writeModel(const std::string& name, const Scene& scene) const {
    const Result<EncodedScene> file = encodeGlb(scene);
    ASSERT_TRUE(file) << file.error().message;
    write(name, file->bytes);
  }
};

ModelLight lightOf(int kind, glm::vec3 color) {
  ModelLight light;
  light.kind = kind;
  light.color = color;
  return light;
}

/// A spot, a point and a direction around the built-in sphere.
std::vector<ModelLight> threeLights() {
  ModelLight spot = lightOf(formula::kLampSpot, {60, 45, 30});
  spot.position = {2, 3, 3};
  spot.direction = glm::normalize(-spot.position);
  spot.cosine_inner = std::cos(0.1f);
  spot.cosine_outer = std::cos(0.3f);
  ModelLight point = lightOf(formula::kLampPoint, {2, 8, 20});
  point.position = {-2, 1, 2};
  point.range = 4.0f;
  ModelLight sun = lightOf(formula::kLampDirectional, {0.5f, 0.2f, 0.3f});
  sun.direction = glm::normalize(glm::vec3(0.2f, 1.0f, -0.8f));
  return {spot, point, sun};
}

TEST_F(GltfSceneTest, LightsAreTheSameInBothRenderers) {
  for (const char* set : {"metallic=0 --set base_color=0.7,0.3,0.1", "metallic=1 --set base_color=0.9,0.6,0.3"}) {
    Scene scene = *loadModel("sphere");
    scene.lights = threeLights();
    writeModel("lit.glb", scene);
    const std::string line = std::string("render lit.glb -e dark.exr --set perceptual_roughness=0.4 --set ") + set +
                             " --light 0,5,5,0.2,0.1,0.1 --size 96x96 --samples 64 ";
    succeed(line + "-o drawn.exr");
    run(line + "--reference --bounces 1 --unoccluded -o traced.exr");
    EXPECT_GT(contentsOf(image("drawn.exr")).mean, 0.02);
    EXPECT_LT(meanDifference(image("drawn.exr"), image("traced.exr")), 2e-3) << set;
  }
}

// A matt surface that faces E lux sends E / π; a candela at 3 units is 1/9 lux.
TEST_F(GltfSceneTest, LightsHaveTheirUnits) {
  Scene scene = *loadModel("sphere");
  ModelLight sun = lightOf(formula::kLampDirectional, glm::vec3(2.0f));
  ModelLight point = lightOf(formula::kLampPoint, glm::vec3(18.0f));
  point.position = {0, 0, 4};
  const std::string how =
      " -e dark.exr --camera 0,0 --set specular=0 --set base_color=0.5 --size 33x33 --samples 4 -o ";
  for (const ModelLight& light : {sun, point}) {
    scene.lights = {light};
    writeModel("lit.glb", scene);
    for (const char* renderer : {"", " --reference"}) {
      run("render lit.glb" + how + "ball.exr" + renderer);
      EXPECT_NEAR(image("ball.exr").texel(16, 16)[1], 0.5f * 2.0f / formula::kPi, 2e-3f) << light.kind << renderer;
      run("render lit.glb --light-intensity 0.25" + how + "dim.exr" + renderer);
      EXPECT_NEAR(image("dim.exr").texel(16, 16)[1], 0.125f * 2.0f / formula::kPi, 1e-3f) << light.kind << renderer;
    }
  }
}

// A plane under the ball: in its shadow nothing is lit, but the renderer knows no shadows.
TEST_F(GltfSceneTest, OnlyTheReferenceCastsShadows) {
  Scene scene = *loadModel("sphere");
  const Scene plane = *loadModel("plane");
  scene.meshes.push_back(plane.meshes[0]);
  scene.instances.push_back({1, glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(4.0f)), glm::vec3(0, -0.5f, 0))});
  scene.lights = {lightOf(formula::kLampDirectional, glm::vec3(1.0f))};
  scene.lights[0].direction = {0, -1, 0};
  scene.cameras = {{.name = "below", .fov_rad = 0.3f, .nearest = 0.1f}};
  scene.cameras[0].world_from_view =
      glm::inverse(glm::lookAt(glm::vec3(0, -1.2f, 9), glm::vec3(0, -2, 0), glm::vec3(0, 1, 0)));
  for (Material& material : scene.materials) material.double_sided = true;
  writeModel("shadow.glb", scene);
  const std::string line =
      "render shadow.glb -e dark.exr --camera below --size 64x64 --samples 16 --set specular=0 -o ";
  succeed(line + "drawn.exr");
  run(line + "traced.exr --reference --bounces 1");
  run(line + "free.exr --reference --bounces 1 --unoccluded");
  const Image drawn = image("drawn.exr"), traced = image("traced.exr"), free = image("free.exr");
  EXPECT_GT(drawn.texel(32, 32)[1], 0.05f);
  EXPECT_NEAR(free.texel(32, 32)[1], drawn.texel(32, 32)[1], 1e-3f);
  EXPECT_EQ(traced.texel(32, 32)[1], 0.0f);
}

// What `export` writes as the picture's camera shows the same picture, by its name.
TEST_F(GltfSceneTest, TheExportedCameraShowsTheSamePicture) {
  for (const char* how : {"--camera 40,20,3 --fov 50", "--camera 200,-30 --orthographic 2.5"}) {
    const std::string line = std::string("teapot --size 64x48 ") + how;
    succeed("export " + line + " -o pot.glb");
    for (const char* renderer : {"", " --reference --bounces 1"}) {
      run("render " + line + " -e studio --samples 8 -o wanted.exr" + renderer);
      run(std::string("render pot.glb --camera camera --size 64x48 -e studio --samples 8 -o found.exr") + renderer);
      EXPECT_GT(contentsOf(image("wanted.exr")).mean, 0.05);
      EXPECT_LT(meanDifference(image("wanted.exr"), image("found.exr")), 2e-3) << how << renderer;
    }
  }
}

// A camera for pictures of 2:1 shows all of its width in a square one, and no less in a wider one.
TEST_F(GltfSceneTest, ACameraShowsAllThatItIsMadeFor) {
  Scene scene = *loadModel("sphere");
  scene.cameras = {{.name = "wide", .fov_rad = 0.5f, .aspect = 2.0f, .nearest = 0.1f},
                   {.name = "flat", .orthographic = true, .height = 3.0f, .aspect = 2.0f}};
  for (ModelCamera& camera : scene.cameras) camera.world_from_view[3] = {0, 0, 5, 1};
  writeModel("ball.glb", scene);
  const auto covered = [&](const std::string& camera, const std::string& size) {
    succeed("render ball.glb -e white --background transparent --camera " + camera + " --size " + size +
            " -o ball.exr");
    return contentsOf(image("ball.exr")).texels;
  };
  for (const std::string camera : {"wide", "flat"}) {
    const double as_made = covered(camera, "96x48");
    EXPECT_NEAR(covered(camera, "96x96"), as_made, 0.06 * as_made) << "as wide, and higher";
    EXPECT_NEAR(covered(camera, "192x48"), as_made, 0.06 * as_made) << "as high, and wider";
  }
}

// What is nearer than the camera's near plane is cut away, in both.
TEST_F(GltfSceneTest, ACameraSeesFromItsNearPlaneOn) {
  Scene scene = *loadModel("sphere");
  for (Material& material : scene.materials) material.double_sided = true;
  scene.cameras = {{.name = "cut", .fov_rad = 0.5f, .nearest = 5.0f}};
  scene.cameras[0].world_from_view[3] = {0, 0, 5, 1};
  writeModel("ball.glb", scene);
  const std::string line =
      "render ball.glb --camera cut -e uv --size 48x48 --material mirror --set double_sided=yes --samples 16 -o ";
  succeed(line + "drawn.exr");
  run(line + "traced.exr --reference --bounces 1 --unoccluded");
  // The inside of the far half: a concave mirror, which shows the light behind the camera from its middle.
  EXPECT_LT(meanDifference(image("drawn.exr"), image("traced.exr")), 0.02);
}

TEST_F(GltfSceneTest, NamesThatTheModelHasNotAreListed) {
  Scene scene = *loadModel("spheres");
  scene.cameras = {{.name = "Left"}, {.name = "Right"}};
  scene.variants = {"day", "night"};
  scene.meshes[0].edit().material_of_variant = {0, 0};
  writeModel("pair.glb", scene);
  for (const std::string renderer : {"", " --reference"}) {
    EXPECT_THAT(refuse(2, "render pair.glb --camera Lefd -o a.png" + renderer),
                AllOf(HasSubstr("did you mean 'Left'"), HasSubstr("(there are: Left, Right)")));
    EXPECT_THAT(refuse(2, "render pair.glb --variant dawn -o a.png" + renderer),
                HasSubstr("no variant is named 'dawn' (there are: day, night)"));
    EXPECT_THAT(refuse(2, "render sphere --camera Left -o a.png" + renderer), HasSubstr("no cameras of its own"));
    EXPECT_THAT(refuse(2, "render sphere --variant day -o a.png" + renderer), HasSubstr("no variants"));
  }
  EXPECT_THAT(refuse(2, "render pair.glb --camera Left --fov 30 -o a.png"), HasSubstr("--fov: the camera 'Left'"));
  EXPECT_THAT(refuse(2, "render pair.glb --camera Left --frames 3 -o a.png"), HasSubstr("stands still"));
  EXPECT_THAT(refuse(2, "export pair.glb --camera Left --target 0,0,0 -o a.glb"), HasSubstr("--target: the camera"));
  EXPECT_THAT(refuse(2, "render sphere --camera 30 -o a.png"), HasSubstr("camera")) << "which is no name";
}

TEST_F(GltfSceneTest, AVariantIsShownAndExported) {
  Scene scene = *loadModel("sphere");
  Material red;
  red.base_color = {1, 0, 0};
  red.unlit = true;
  scene.materials.push_back(red);
  scene.variants = {"plain", "red"};
  scene.meshes[0].edit().material_of_variant = {0, 1};
  writeModel("ball.glb", scene);
  const std::string how = " --size 16x16 -e white --samples 1 -o ball.exr";
  succeed("render ball.glb --variant red" + how);
  EXPECT_EQ(rgbAt(image("ball.exr"), 8, 8), glm::vec3(1, 0, 0));
  succeed("export ball.glb --variant red -o red.glb");
  succeed("render red.glb" + how);
  EXPECT_EQ(rgbAt(image("ball.exr"), 8, 8), glm::vec3(1, 0, 0));
  succeed("render red.glb --variant plain" + how);
  EXPECT_GT(rgbAt(image("ball.exr"), 8, 8).y, 0.1f);
}

TEST_F(GltfSceneTest, InfoListsWhatTheModelHas) {
  Scene scene = *loadModel("spheres");
  scene.lights = threeLights();
  scene.lights[0].name = "key";
  scene.cameras = {{.name = "Left"}};
  scene.variants = {"day", "night"};
  writeModel("model.glb", scene);
  EXPECT_THAT(succeed("info model.glb"),
              AllOf(HasSubstr("format       glTF\n"), HasSubstr("variants     day, night\n"),
                    HasSubstr("cameras      Left (perspective, "), HasSubstr("key (spot, 60 45 30 cd)")));
  const auto json = nlohmann::json::parse(succeed("info model.glb --json"));
  EXPECT_EQ(json["kind"], "model");
  EXPECT_EQ(json["variants"], nlohmann::json::array({"day", "night"}));
  EXPECT_EQ(json["cameras"][0]["name"], "Left");
  EXPECT_EQ(json["lights"][0]["candela"], nlohmann::json::array({60, 45, 30}));
  EXPECT_EQ(json["lights"][2]["type"], "directional");
  EXPECT_THAT(refuse(1, "info model.glb --direction 0,0,1"), HasSubstr("is a glTF model, no map"));
  scene.materials.resize(1);
  for (Shared<Mesh>& mesh : scene.meshes) mesh.edit().material = 0;
  scene.materials[0] = Material();
  scene.materials[0].base_color = glm::vec3(0.0f);
  scene.materials[0].metallic = 0.5f;
  writeModel("black.glb", scene);
  EXPECT_THAT(succeed("info black.glb"), AllOf(HasSubstr("metallic 0.5"), HasSubstr("all base colours are black")));
  const auto black = nlohmann::json::parse(succeed("info black.glb --json"));
  EXPECT_EQ(black["material_facts"][0]["parameters"]["metallic"], "0.5");
}

}  // namespace
}  // namespace mirrorball::testing
