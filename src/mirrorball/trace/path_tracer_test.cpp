#include "mirrorball/trace/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using testing::lightOf;
using testing::matt;
using testing::meanOf;
using testing::shapeOf;
using testing::small;
using testing::traced;

// What absorbs nothing is as bright as its surroundings, and cannot be seen.
TEST(PathTracer, TheFurnaceIsWhite) {
  for (const float roughness : {0.0f, 0.3f, 1.0f}) {
    Material metal = matt(1.0f);
    metal.metallic = 1.0f;
    metal.perceptual_roughness = roughness;
    Material plastic = matt(1.0f);
    plastic.specular = 1.0f;
    plastic.perceptual_roughness = roughness;
    Material glass = plastic;
    glass.transmission = 1.0f;
    Material enamel = plastic;
    enamel.specular_color = glm::vec3(12.0f);
    Material milk_glass = plastic;
    milk_glass.transmission = 0.5f;
    for (const auto& [name, material] : {std::pair("metal", metal),
                                         {"plastic", plastic},
                                         {"enamel", enamel},
                                         {"glass", glass},
                                         {"milk glass", milk_glass}}) {
      TraceSettings settings = small(64);
      settings.bounces = 64;
      EXPECT_NEAR(meanOf(traced(shapeOf("sphere", material), lightOf(1.0f), settings)), 1.0f, 4e-3f)
          << name << " of roughness " << roughness;
    }
  }
}

// A matt sphere under light of the first band, 1 + z: irradiance / π is 1 + ⅔ n.z (Ramamoorthi & Hanrahan 2001).
TEST(PathTracer, AMattSphereUnderHarmonicsIsTheClosedForm) {
  TraceSettings settings = small(256);
  settings.bounces = 1;
  const Image image = traced(shapeOf("sphere", matt(0.5f)),
                             Environment([](glm::vec3 d) { return glm::vec3(1.0f + d.z); }, 64), settings);
  // The middle of the picture faces the camera on +Z.
  EXPECT_NEAR(image.texel(12, 12)[0], 0.5f * (1.0f + 2.0f / 3.0f), 0.03f);
}

// A mirror sphere shows the environment along the reflected ray, exactly.
TEST(PathTracer, AMirrorShowsWhatIsBehindTheCamera) {
  Material mirror = matt(1.0f);
  mirror.metallic = 1.0f;
  mirror.perceptual_roughness = 0.0f;
  const Image image =
      traced(shapeOf("sphere", mirror),
             Environment([](glm::vec3 d) { return glm::vec3(d.z > 0.9f ? 3.0f : 1.0f); }, 256), small(16));
  EXPECT_FLOAT_EQ(image.texel(12, 12)[1], 3.0f);
}

// Two bounces light more than one, and one that nothing blocks more than one that is blocked: a bowl's inside.
TEST(PathTracer, OcclusionDarkensAndBouncesBrighten) {
  const auto meanAt = [](int bounces, bool is_unoccluded) {
    TraceSettings settings = small(64);
    settings.bounces = bounces;
    settings.is_unoccluded = is_unoccluded;
    return meanOf(traced(shapeOf("knot", matt(0.8f)), lightOf(1.0f), settings));
  };
  const float unoccluded = meanAt(1, true), once = meanAt(1, false), often = meanAt(16, false);
  EXPECT_LT(once, unoccluded - 0.01f);
  EXPECT_GT(often, once + 0.01f);
  EXPECT_LT(often, unoccluded);
}

// Rays through Embree's tree and through ours: the same paths, but for rounding.
TEST(PathTracer, IsTheSameByEitherTreeOfTriangles) {
  if (fastestRayTracer() != RayTracer::embree) GTEST_SKIP() << "this build has no Embree";
  const Scene scene = *loadModel("showcase");
  const auto by = [&](RayTracer tracer) {
    const auto made = PathTracer::make(scene, lightOf(1.0f), {}, tracer);
    return made->render(makeCamera({}, boundingSphere(scene), 1.0f), small(16))->radiance;
  };
  const Image embree = by(RayTracer::embree), own = by(RayTracer::own);
  int differ = 0;
  for (int y = 0; y < embree.height(); ++y)
    for (int x = 0; x < embree.width(); ++x)
      if (glm::distance(rgbAt(embree, x, y), rgbAt(own, x, y)) > 1e-3f) ++differ;
  EXPECT_LE(differ, 5);
  EXPECT_NEAR(meanOf(own), meanOf(embree), 2e-3f);
}

TEST(PathTracer, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto image = [](int threads) {
    setThreadLimit(threads);
    return traced(shapeOf("teapot", matt(0.8f)), *builtinEnvironment("studio"), small(4));
  };
  const int before = threadLimit();
  const Image one = image(1), three = image(3);
  setThreadLimit(before);
  EXPECT_TRUE(std::ranges::equal(one.samples(), three.samples()));
}

// A sun of 10⁵ over half a degree: no pixel is an outlier, on plastic or, by way of several facets, on rough metal.
// Chosen by the cosine alone, one path in 10⁵ would find it.
// The tree of triangles and the environment's table stay, and nothing of what was before is seen.
TEST(PathTracer, WhatIsReplacedIsAsMadeAnew) {
  Environment light = *builtinEnvironment("studio");
  const TraceSettings settings = small(4);
  const Camera camera = makeCamera({}, boundingSphere(shapeOf("cube", matt(0.5f))), 1.0f);
  const auto pictureOf = [&](const PathTracer& tracer) { return tracer.render(camera, settings)->radiance; };
  const auto anew = [&](const Scene& scene) { return pictureOf(*PathTracer::make(scene, light)); };
  auto tracer = PathTracer::make(shapeOf("cube", matt(0.5f)), light);
  ASSERT_TRUE(tracer);

  Material metal = matt(0.9f);
  metal.metallic = 1.0f;
  tracer->setMaterials({metal});
  EXPECT_TRUE(std::ranges::equal(pictureOf(*tracer).samples(), anew(shapeOf("cube", metal)).samples()));
  Scene turned = shapeOf("torus", matt(0.2f));
  turned.instances[0].world_from_object = glm::rotate(glm::mat4(1.0f), 1.0f, glm::vec3(1.0f, 0.0f, 0.0f));
  ASSERT_TRUE(tracer->setScene(turned));
  EXPECT_TRUE(std::ranges::equal(pictureOf(*tracer).samples(), anew(turned).samples()));
}

TEST(PathTracer, ASmallSunGivesNoFireflies) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.3f, 0.5f, 1.0f));
  const Environment environment(
      [=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > std::cos(0.00436f) ? 1e5f : 0.1f); }, 1024);
  Material plastic = matt(0.5f);
  plastic.specular = 1.0f;
  plastic.perceptual_roughness = 0.6f;
  Material metal = plastic;
  metal.metallic = 1.0f;
  metal.perceptual_roughness = 0.45f;
  for (const Material& material : {plastic, metal}) {
    TraceSettings settings = small(64);
    settings.bounces = 1;
    const Image few = traced(shapeOf("sphere", material), environment, settings);
    settings.samples = 1024;
    const Image many = traced(shapeOf("sphere", material), environment, settings);
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x)
        EXPECT_NEAR(few.texel(x, y)[1], many.texel(x, y)[1], 0.25f * many.texel(x, y)[1] + 0.15f) << x << ", " << y;
  }
}

/// A square in the plane y = height, seen from above, of half that side.
Mesh square(float half_side, float height, int material) {
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(-1, 1), glm::vec2(1, 1), glm::vec2(1, -1)})
    mesh.vertices.push_back({.position = {corner.x * half_side, height, corner.y * half_side}, .normal = {0, 1, 0}});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = material;
  return mesh;
}

/// What a floor sends upwards below a square of side 2 half a unit above it, of that material. The eye looks from below
/// the square.
float belowSquare(float floor_half_side, const Material& above, int samples = 64) {
  Scene scene;
  scene.materials = {matt(0.8f), above};
  scene.meshes = {square(floor_half_side, 0.0f, 0), square(1.0f, 0.5f, 1)};
  scene.instances = {{.mesh = 0}, {.mesh = 1}};
  const auto tracer = PathTracer::make(std::move(scene), lightOf(1.0f));
  const Camera camera =
      makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 5.0f, .distance = 0.9f, .target = glm::vec3(0.0f)},
                 {glm::vec3(0.0f), 1.0f}, 1.0f);
  TraceSettings settings = small(samples);
  settings.bounces = 1;
  return tracer->render(camera, settings)->radiance.texel(12, 13)[1];
}

// A square blocks light on its way to a floor below it, however large the floor is; one that has only a front, which
// faces away from the floor, blocks none (glTF: its back is culled).
TEST(PathTracer, WhatIsInTheWayCastsAShadow) {
  Material two_sided = matt(0.8f);
  two_sided.double_sided = true;
  const float expected = belowSquare(10.0f, two_sided);
  EXPECT_LT(expected, 0.4f);
  EXPECT_NEAR(belowSquare(10.0f, matt(0.8f)), 0.8f, 0.02f) << "of one side";
  EXPECT_NEAR(belowSquare(1e6f, two_sided), expected, 0.05f) << "over a large floor";
}

// Half of the light passes a surface of opacity ½; none is left of a surface that is cut away.
TEST(PathTracer, OpacityLetsLightThrough) {
  Material veil = matt(0.0f);
  veil.double_sided = true;
  veil.alpha_mode = AlphaMode::blend;
  veil.opacity = 0.5f;
  Material cut = veil;
  cut.alpha_mode = AlphaMode::mask;
  cut.alpha_cutoff = 0.75f;
  Material solid = veil;
  solid.alpha_mode = AlphaMode::opaque;
  const float lit = belowSquare(10.0f, cut, 1024), dark = belowSquare(10.0f, solid, 1024);
  EXPECT_NEAR(lit, 0.8f, 0.02f);
  EXPECT_NEAR(belowSquare(10.0f, veil, 1024), 0.5f * (lit + dark), 0.03f);
}

// Turned by 90°, the light of +X comes from where +Z was.
TEST(PathTracer, TheEnvironmentTurns) {
  const Environment environment([](glm::vec3 d) { return glm::max(d, glm::vec3(0.0f)); }, 64);
  TraceSettings settings = small(4);
  // Rows are the axes of the environment in the world's.
  settings.environment_from_world = glm::transpose(glm::mat3({0, 0, 1}, {0, 1, 0}, {-1, 0, 0}));
  const auto tracer = PathTracer::make({}, environment);
  ASSERT_TRUE(tracer);
  const auto image = tracer->render(makeCamera({.azimuth_deg = 180.0f, .elevation_deg = 0.0f}, {}, 1.0f), settings);
  ASSERT_TRUE(image);
  const glm::vec3 middle = rgbAt(image->radiance, 12, 12);
  EXPECT_GT(middle.x, 0.9f) << "towards +Z the environment's +X is seen";
  EXPECT_LT(middle.z, 0.1f);
}

TEST(PathTracer, BrokenTrianglesAreLeftOut) {
  Scene scene = shapeOf("sphere", matt(1.0f));
  Mesh& mesh = scene.meshes[0].edit();
  mesh.vertices[0].position.x = std::numeric_limits<float>::quiet_NaN();
  mesh.vertices[1].position.y = std::numeric_limits<float>::infinity();
  mesh.indices.insert(mesh.indices.end(), {5, 5, 5});
  TraceSettings settings = small(4);
  const auto tracer = PathTracer::make(std::move(scene), lightOf(1.0f));
  ASSERT_TRUE(tracer);
  const Camera camera = makeCamera({}, {glm::vec3(0.0f), 1.0f}, 1.0f);
  const auto image = tracer->render(camera, settings);
  ASSERT_TRUE(image);
  for (const float sample : image->radiance.samples()) ASSERT_TRUE(std::isfinite(sample));
}

TEST(PathTracer, StopsWhenItsProgressSaysSo) {
  const auto tracer = PathTracer::make(shapeOf("sphere", matt(1.0f)), lightOf(1.0f));
  ASSERT_TRUE(tracer);
  const auto image = tracer->render(makeCamera({}, {glm::vec3(0.0f), 1.0f}, 1.0f), small(4),
                                    {.progress = [](std::size_t done, std::size_t) { return done < 30; }});
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::interrupted);
}

// Light, surfaces and both find the same: their differences in each pixel are as large as their standard errors say.
TEST(PathTracer, StrategiesAgreeInEachPixel) {
  Material metal = matt(0.9f);
  metal.metallic = 1.0f;
  metal.perceptual_roughness = 0.5f;
  Material plastic = matt(0.5f);
  plastic.specular = 1.0f;
  plastic.perceptual_roughness = 0.4f;
  for (const Material& material : {metal, plastic}) {
    std::vector<TracedPicture> pictures;
    const auto tracer = PathTracer::make(shapeOf("knot", material), *builtinEnvironment("studio"));
    ASSERT_TRUE(tracer);
    const Camera camera = makeCamera({}, boundingSphere(tracer->scene()), 1.0f);
    for (const LightStrategy strategy : {LightStrategy::both, LightStrategy::light, LightStrategy::surface}) {
      TraceSettings settings{.size = {16, 16}, .samples = 256};
      settings.strategy = strategy;
      settings.wants_layers = true;
      pictures.push_back(*tracer->render(camera, settings));
    }
    for (std::size_t other = 1; other < pictures.size(); ++other) {
      double squares = 0.0;
      int compared = 0;
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
          const double variance = double(pictures[0].layers->variance.texel(x, y)[1]) +
                                  double(pictures[other].layers->variance.texel(x, y)[1]);
          const double difference =
              double(pictures[0].radiance.texel(x, y)[1]) - double(pictures[other].radiance.texel(x, y)[1]);
          if (variance <= 0.0) continue;
          EXPECT_LT(std::abs(difference), 6.0 * std::sqrt(variance) + 1e-3) << x << ", " << y << ", " << other;
          squares += difference * difference / variance;
          ++compared;
        }
      ASSERT_GT(compared, 180);
      // Points that are spread evenly have less error than the variance of independent ones says.
      EXPECT_LT(squares / compared, 1.2) << other;
    }
  }
}

// Phong's light on a matt surface: albedo times cosine; none behind what is in the way.
TEST(PathTracer, APointLightLightsWhatItSees) {
  TraceSettings settings = small(16);
  settings.lights = {{.position = {0.0f, 0.0f, 50.0f}, .color = glm::vec3(2.0f)}};
  const Image image = traced(shapeOf("sphere", matt(0.5f)), lightOf(0.0f), settings);
  EXPECT_NEAR(image.texel(12, 12)[1], 0.5f * 2.0f, 0.02f) << "it faces the light";
  const auto below = [&](float height) {
    Scene scene;
    scene.materials = {matt(0.8f)};
    scene.materials[0].double_sided = true;
    scene.meshes = {square(10.0f, 0.0f, 0), square(1.0f, height, 0)};
    scene.instances = {{.mesh = 0}, {.mesh = 1}};
    TraceSettings lit = small(16);
    lit.bounces = 1;
    lit.lights = {{.position = {0.0f, 5.0f, 0.0f}, .color = glm::vec3(1.0f)}};
    const Camera camera =
        makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 5.0f, .distance = 0.9f, .target = glm::vec3(0.0f)},
                   {glm::vec3(0.0f), 1.0f}, 1.0f);
    return PathTracer::make(std::move(scene), lightOf(0.0f))->render(camera, lit)->radiance.texel(12, 13)[1];
  };
  EXPECT_EQ(below(0.5f), 0.0f) << "in the shadow";
  EXPECT_GT(below(6.0f), 0.7f) << "what is beyond the light casts none";
}

// What denoisers are given, on a sphere whose front faces the eye.
TEST(PathTracer, LayersAreThoseOfTheFirstSurface) {
  TraceSettings settings = small(64);
  settings.wants_layers = true;
  Material metal = matt(0.5f);
  metal.metallic = 1.0f;
  metal.base_color = {0.9f, 0.6f, 0.3f};
  const auto tracer = PathTracer::make(shapeOf("sphere", metal), *builtinEnvironment("studio"));
  const auto picture = tracer->render(
      makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 0.0f}, boundingSphere(tracer->scene()), 1.0f), settings);
  ASSERT_TRUE(picture && picture->layers);
  EXPECT_NEAR(glm::distance(rgbAt(picture->layers->normal, 12, 12), glm::vec3(0, 0, 1)), 0.0f, 0.1f);
  EXPECT_NEAR(glm::distance(rgbAt(picture->layers->albedo, 12, 12), metal.base_color), 0.0f, 1e-5f);
  EXPECT_EQ(rgbAt(picture->layers->albedo, 0, 0), glm::vec3(0.0f)) << "the background";
  EXPECT_GT(picture->layers->variance.texel(12, 12)[1], 0.0f);
}

// A map of all directions of a place where nothing is is the environment; a body shows where it is.
TEST(PathTracer, CapturesWhatIsAround) {
  Scene scene = shapeOf("sphere", matt(0.0f));
  scene.instances[0].world_from_object[3] = glm::vec4(5.0f, 0.0f, 0.0f, 1.0f);
  const Environment environment([](glm::vec3 d) { return glm::vec3(1.0f) + 0.5f * d; }, 64);
  const auto tracer = PathTracer::make(std::move(scene), environment);
  ASSERT_TRUE(tracer);
  for (const Projection projection : {Projection::cube, Projection::sphere, Projection::equirect}) {
    const auto traced_map = tracer->capture({.projection = projection, .size = 64}, {.samples = 16});
    ASSERT_TRUE(traced_map);
    const EnvironmentMap& map = traced_map->map;
    EXPECT_EQ(map.faces(), faceCount(projection));
    const auto one_path = tracer->capture({.projection = projection, .size = 32}, {.samples = 1});
    for (int face = 0; face < one_path->map.faces(); ++face)
      for (const float sample : one_path->map.face(face).samples()) ASSERT_TRUE(std::isfinite(sample));
    for (const glm::vec3 d : {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::normalize(glm::vec3(-1, 0.2f, 0.4f))})
      EXPECT_NEAR(glm::distance(map.radiance(d), glm::vec3(1.0f) + 0.5f * d), 0.0f, 0.05f) << nameOf(projection);
    EXPECT_NEAR(map.radiance({1, 0, 0}).x, 0.0f, 1e-3f) << nameOf(projection) << ": the black ball";
  }
}

}  // namespace
}  // namespace mirrorball
