// Light through bodies: in one another, absorbing, dispersing.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using testing::expectWhite;
using testing::lightOf;
using testing::matt;
using testing::meanOf;
using testing::small;
using testing::traced;

Material clear(float ior) {
  Material material = matt(1.0f);
  material.specular = 1.0f;
  material.perceptual_roughness = 0.0f;
  material.transmission = 1.0f;
  material.ior = ior;
  return material;
}

/// Balls about the origin, each of a radius and a material.
Scene balls(const std::vector<std::pair<float, Material>>& parts) {
  Scene scene;
  const Scene ball = *loadModel("sphere");
  for (const auto& [radius, material] : parts) {
    Mesh mesh = ball.meshes[0];
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    glm::mat4 world_from_object(radius);
    world_from_object[3] = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), world_from_object});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

float greatestDifference(const Image& a, const Image& b) {
  float greatest = 0.0f;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    greatest = std::max(greatest, std::abs(a.samples()[i] - b.samples()[i]));
  return greatest;
}

TEST(Transmission, ABodyOfIndexOneIsInvisible) {
  const Environment smooth([](glm::vec3 d) { return glm::vec3(1.0f) + 0.5f * d; }, 64);
  EXPECT_LT(greatestDifference(traced(balls({{1.0f, clear(1.0f)}}), smooth, small(16)), traced({}, smooth, small(16))),
            1e-4f);
}

// Lambert and Beer: the middle of a ball of radius 1 is 2 thick.
TEST(Transmission, ABodyAbsorbsByTheLengthOfThePath) {
  Material blue = clear(1.0f);
  blue.attenuation_color = {0.25f, 0.5f, 1.0f};
  blue.attenuation_distance = 4.0f;
  const Image image = traced(balls({{1.0f, blue}}), lightOf(1.0f), small(64));
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(image.texel(12, 12)[channel], std::sqrt(blue.attenuation_color[channel]), 0.01f) << channel;
}

// Inside of a body of greater priority, the surfaces of others are not there.
TEST(Transmission, TheGreaterPriorityHidesSurfaces) {
  Material outer = clear(1.5f), inner = clear(2.4f);
  outer.priority = 1;
  const Environment studio = *builtinEnvironment("studio");
  const Image alone = traced(balls({{1.0f, outer}}), studio, small(16));
  EXPECT_EQ(greatestDifference(alone, traced(balls({{1.0f, outer}, {0.5f, inner}}), studio, small(16))), 0.0f);
  inner.priority = 1;
  EXPECT_GT(greatestDifference(alone, traced(balls({{1.0f, outer}, {0.5f, inner}}), studio, small(16))), 0.1f)
      << "among equals the inner one is there";
}

// A ball of the same index is invisible in another one; one of air is not: indices are those of both sides.
TEST(Transmission, IndicesAreRelativeToWhatIsAround) {
  const Environment smooth([](glm::vec3 d) { return glm::vec3(1.0f) + 0.5f * d; }, 64);
  const Image alone = traced(balls({{1.0f, clear(1.5f)}}), smooth, small(256));
  const auto with = [&](float ior) {
    return traced(balls({{1.0f, clear(1.5f)}, {0.6f, clear(ior)}}), smooth, small(256));
  };
  // Rounding moves the paths a little, and with them which of them are reflected.
  EXPECT_LT(greatestDifference(with(1.5f), alone), 0.05f);
  EXPECT_GT(greatestDifference(with(1.0f), alone), 0.1f);
}

// Nothing is absorbed: all is white, from outside and from under water.
TEST(Transmission, WhiteStaysWhiteInBodiesInBodies) {
  Material rough = clear(1.5f);
  rough.perceptual_roughness = 0.5f;
  Material flint = clear(1.7f);
  flint.dispersion = 1.0f;
  Material pane = clear(2.0f);
  pane.thin_walled = true;
  pane.dispersion = 1.0f;
  Material thinner = clear(1.2f);  // than the water around it
  thinner.dispersion = 1.0f;
  Material water = clear(1.333f);
  water.dispersion = 0.3f;
  const auto cases = {
      std::pair("air", clear(1.0f)), {"diamond", clear(2.4f)}, {"rough", rough}, {"flint", flint}, {"pane", pane},
      {"thinner", thinner}};
  for (const auto& [name, ball] : cases) {
    TraceSettings settings = small(48);
    settings.bounces = 128;
    expectWhite(traced(balls({{1.0f, ball}}), lightOf(1.0f), settings), 0.02, name);
    expectWhite(traced(balls({{1.0f, water}, {0.7f, ball}}), lightOf(1.0f), settings), 0.02,
                std::string(name) + " in water");
    // The camera of `traced` stands some 4 radii of the scene away: within the water of radius 20.
    const auto tracer = PathTracer::make(balls({{1.0f, ball}, {20.0f, clear(1.333f)}}), lightOf(1.0f));
    ASSERT_TRUE(tracer);
    const Camera camera = makeCamera({}, {glm::vec3(0.0f), 1.0f}, 1.0f);
    expectWhite(tracer->render(camera, settings)->radiance, 0.02, std::string(name) + " from under water");
  }
}

// glTF 2.0, section 3.9.5, and KHR_materials_volume: doubleSided counts for sheets, whose backs the eye passes.
TEST(Transmission, ASheetWithAFrontAloneIsPassedFromBehind) {
  Material sheet = clear(1.5f);
  sheet.thin_walled = true;
  sheet.specular = 0.0f;
  sheet.base_color = glm::vec3(0.5f);
  const auto middle = [&](bool double_sided) {
    sheet.double_sided = double_sided;
    const Image image = traced(balls({{1.0f, sheet}}), lightOf(1.0f), small(16));
    return image.texel(image.width() / 2, image.height() / 2)[0];
  };
  EXPECT_NEAR(middle(false), 0.5f, 1e-3f);
  EXPECT_NEAR(middle(true), 0.25f, 1e-3f);
}

// A rough body of the index of what is around it is nothing, however its light is found.
TEST(Transmission, ARoughBodyOfIndexOneIsInvisible) {
  Material rough = clear(1.0f);
  rough.perceptual_roughness = 0.5f;
  for (const LightStrategy strategy : {LightStrategy::both, LightStrategy::light, LightStrategy::surface}) {
    TraceSettings settings = small(16);
    settings.strategy = strategy;
    expectWhite(traced(balls({{1.0f, rough}}), lightOf(1.0f), settings), 1e-3, "index 1");
  }
}

// Parts of one mesh that run into each other are one body; a body ends at its holes too.
TEST(Transmission, ABodyIsWhatIsWithinItsSurface) {
  Material grey = clear(1.0f);
  grey.base_color = glm::vec3(0.5f);
  Scene scene = balls({{1.0f, grey}});
  Mesh& mesh = scene.meshes[0].edit();
  const Mesh ball = mesh;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (Vertex vertex : ball.vertices) {
    vertex.position.z += 0.5f;
    mesh.vertices.push_back(vertex);
  }
  for (const std::uint32_t index : ball.indices) mesh.indices.push_back(first + index);
  EXPECT_NEAR(traced(scene, lightOf(1.0f), small(16)).texel(12, 12)[1], 0.25f, 1e-3f) << "two crossings";

  Material veil = clear(1.0f);
  veil.attenuation_color = glm::vec3(0.25f);
  veil.attenuation_distance = 2.0f;
  veil.alpha_mode = AlphaMode::blend;
  veil.opacity = 0.5f;
  EXPECT_NEAR(traced(balls({{1.0f, veil}}), lightOf(1.0f), small(256)).texel(12, 12)[1], 0.25f, 0.01f)
      << "through holes, the way in the body is as long";
}

// Light of lamps is absorbed on its way through a body.
TEST(Transmission, AbsorptionDimsLamps) {
  Material dim = clear(1.0f);
  dim.attenuation_color = glm::vec3(0.5f);
  dim.attenuation_distance = 10.0f;
  const auto lit = [&](float distance) {
    const auto tracer = PathTracer::make(balls({{1.0f, matt(0.5f)}, {200.0f, dim}}), lightOf(0.0f));
    TraceSettings settings = small(16);
    settings.lights = {{.position = {0.0f, 0.0f, 1.0f + distance}, .color = glm::vec3(1.0f)}};
    const Camera camera = makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 0.0f}, {glm::vec3(0.0f), 1.0f}, 1.0f);
    return tracer->render(camera, settings)->radiance.texel(12, 12)[1];
  };
  EXPECT_NEAR(lit(40.0f) / lit(20.0f), 0.25f, 0.01f);
}

// An open sheet above the camera does not make its place a body; and a capture that begins outside of one is.
TEST(Transmission, TheEyeIsWhereItsRaysBegin) {
  Material dark = clear(1.0f);
  dark.attenuation_color = glm::vec3(1e-3f);
  dark.attenuation_distance = 1.0f;
  Scene sheet;
  sheet.materials = {dark, matt(0.0f)};
  sheet.materials[1].emission = glm::vec3(1.0f);
  Mesh quad, wall;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)}) {
    quad.vertices.push_back({.position = {corner.x * 500.0f, 50.0f, corner.y * 500.0f}, .normal = {0, 1, 0}});
    wall.vertices.push_back({.position = {corner.x, corner.y, -10.0f}, .normal = {0, 0, 1}});
  }
  quad.indices = {0, 1, 2, 0, 2, 3};
  wall.indices = {0, 2, 1, 0, 3, 2};
  wall.material = 1;
  sheet.meshes = {quad, wall};
  sheet.instances = {{.mesh = 0}, {.mesh = 1}};
  const auto below = PathTracer::make(sheet, lightOf(0.0f));
  const auto map = below->capture({.projection = Projection::cube, .size = 9}, {.samples = 4});
  EXPECT_NEAR(map->map.radiance({0, 0, -1}).y, 1.0f, 1e-3f);

  const auto within = PathTracer::make(balls({{1.0f, dark}}), lightOf(1.0f));
  const auto outwards = within->capture({.projection = Projection::cube, .size = 4, .nearest = 1.5f}, {.samples = 4});
  EXPECT_NEAR(outwards->map.radiance({0, 0, -1}).y, 1.0f, 1e-3f);
}

// Under water, the world above is seen in a circle of 48.6°; beyond it the water's surface is a mirror.
TEST(Transmission, UnderWaterTheCriticalAngleIsSnells) {
  Scene scene;
  scene.materials = {clear(1.333f)};
  Mesh sea;
  for (const float side : {1.0f, -1.0f})
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)})
      sea.vertices.push_back({.position = {corner.x * 500.0f, side, corner.y * 500.0f}, .normal = {0, side, 0}});
  sea.indices = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6};
  scene.meshes = {sea};
  scene.instances = {{.mesh = 0}};
  const Environment sky([](glm::vec3 d) { return glm::vec3(d.y > 0.0f ? 1.0f : 0.0f); }, 64);
  const auto tracer = PathTracer::make(std::move(scene), sky);
  ASSERT_TRUE(tracer);
  TraceSettings settings;
  settings.samples = 64;
  const auto map = tracer->capture({.position = {0, 0, 0}, .projection = Projection::equirect, .size = 90}, settings);
  ASSERT_TRUE(map);
  const auto at = [&](float from_zenith_deg) {
    const float angle = glm::radians(from_zenith_deg);
    return map->map.radiance({std::sin(angle), std::cos(angle), 0.0f}).y;
  };
  EXPECT_GT(at(45.0f), 0.5f);
  EXPECT_NEAR(at(54.0f), 0.0f, 1e-3f) << "it shows the dark below";
  // The radiance counts over the square of the index, so that it is not 1.777 times as bright in water.
  float mean = 0.0f;
  for (int i = 0; i < 20; ++i) mean += at(5.0f + float(i)) / 20.0f;
  EXPECT_NEAR(mean, 0.979f, 0.006f);
}

// White light stays white in the mean, and becomes coloured at edges; what does not disperse has no colour at all.
TEST(Transmission, DispersionColoursAndKeepsWhite) {
  const Environment edge([](glm::vec3 d) { return glm::vec3(d.x > 0.0f ? 2.0f : 0.0f); }, 256);
  Material glass = clear(1.5f), flint = glass;
  flint.dispersion = 1.0f;
  const auto colourOf = [&](const Material& material) {
    const Image image = traced(balls({{1.0f, material}}), edge, small(256));
    double colour = 0.0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) colour += double(std::abs(image.texel(x, y)[0] - image.texel(x, y)[2]));
    return colour / (24.0 * 24.0);
  };
  EXPECT_LT(colourOf(glass), 1e-6);
  EXPECT_GT(colourOf(flint), 0.005);
  const Image white = traced(balls({{1.0f, flint}}), lightOf(1.0f), small(256));
  expectWhite(white, 0.01, "flint");
}

}  // namespace
}  // namespace mirrorball
