#include "mirrorball/render/frame/cube_capture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

constexpr std::array<const char*, 6> kFaceNames{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

/// Calls `visit(face, texel, unit direction of its centre)` for each texel of a cube map.
void forEachTexel(const EnvironmentMap& map,
                  const std::function<void(int face, glm::ivec2 texel, glm::vec3 direction)>& visit) {
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < map.size(); ++y)
      for (int x = 0; x < map.size(); ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / static_cast<float>(map.size());
        visit(face, {x, y}, directionAt(map.projection(), {face, uv}));
      }
}

/// The greatest difference of any channel of any texel from what a function of the direction gives.
float maxError(const EnvironmentMap& map, const RadianceFunction& expected) {
  float max = 0.0f;
  forEachTexel(map, [&](int face, glm::ivec2 texel, glm::vec3 direction) {
    const glm::vec3 difference = glm::abs(rgbAt(map.face(face), texel.x, texel.y) - expected(direction));
    max = std::max({max, difference.x, difference.y, difference.z});
  });
  return max;
}

glm::vec3 black(glm::vec3) { return glm::vec3(0.0f); }
glm::vec3 white(glm::vec3) { return glm::vec3(1.0f); }

/// Shines by itself, and shows nothing of its environment.
Material shining(glm::vec3 radiance) {
  Material material;
  material.base_color = glm::vec3(0.0f);
  material.specular = 0.0f;
  material.emission = radiance;
  return material;
}

/// Where a ray from inside of the unit sphere meets it.
glm::vec3 onUnitSphere(glm::vec3 from, glm::vec3 direction) {
  const float along = glm::dot(from, direction);
  return from + direction * (std::sqrt(along * along + 1.0f - glm::dot(from, from)) - along);
}

/// The unit sphere from inside; its points have the colours of smoothRadiance in white light.
Scene paintedSphere() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.specular = 0.0f;
  material.double_sided = true;
  Mesh mesh = sphereMesh();
  for (Vertex& vertex : mesh.vertices) vertex.color = glm::vec4(testing::smoothRadiance(vertex.position), 1.0f);
  return meshScene(std::move(mesh), material);
}

/// A ball that shines in one colour.
struct Lamp {
  glm::vec3 center;
  glm::vec3 color;
};
constexpr float kLampRadius = 0.2f;

Scene lampScene(std::span<const Lamp> lamps) {
  Scene scene;
  for (const Lamp& lamp : lamps) {
    Mesh mesh = sphereMesh(64, 128);
    mesh.material = static_cast<int>(scene.materials.size());
    const glm::mat4 placed = glm::scale(glm::translate(glm::mat4(1.0f), lamp.center), glm::vec3(kLampRadius));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), placed});
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back(shining(lamp.color));
  }
  return scene;
}

/// A square that faces the origin from `center`, of a colour of which 0.4 is covered and the rest lets light through.
void addVeil(Scene& scene, glm::vec3 center, glm::vec3 color) {
  Material material = shining(color);
  material.opacity = 0.4f;
  material.alpha_mode = AlphaMode::blend;
  material.double_sided = true;
  Mesh mesh = planeMesh();
  mesh.material = static_cast<int>(scene.materials.size());
  const glm::vec3 towards = -glm::normalize(center);
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), towards));
  const glm::mat4 turned(glm::mat3(across, towards, glm::cross(across, towards)));
  scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::translate(glm::mat4(1.0f), center) * turned});
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(material);
}

class CubeCaptureTest : public gl::GlTest {
 protected:
  /// What fails becomes a test failure and a black map.
  EnvironmentMap capture(const Scene& scene, const Environment& environment, const CaptureSettings& settings) const {
    auto captured = tryCapture(scene, environment, settings, {});
    if (captured) return std::move(*captured);
    ADD_FAILURE() << captured.error().message;
    return *convert(Environment(black, 8), Projection::cube, settings.size);
  }

  Result<EnvironmentMap> tryCapture(const Scene& scene, const Environment& environment, const CaptureSettings& settings,
                                    const ProgressFunction& progress) const {
    MIRRORBALL_TRY(prepared, testing::prepareOnce(environment));
    MIRRORBALL_TRY(renderer, testing::rendererOf(scene, environment, prepared));
    return captureEnvironment(renderer, settings, progress);
  }
};

MIRRORBALL_WITH_BOTH_APIS(CubeCaptureTest);

CaptureSettings at(glm::vec3 position, int size = 64) { return {.position = position, .size = size}; }

// Half floats of light up to 2 and a cube's texels of a panorama 256 high leave less than 0.002.
TEST_P(CubeCaptureTest, OfNothingIsTheEnvironmentFromAnywhere) {
  const Environment light(testing::smoothRadiance, 256);
  for (const glm::vec3 position : {glm::vec3(0.0f), glm::vec3(0.3f, -20.0f, 7.0f), glm::vec3(1e6f, 2e5f, -3e6f)})
    for (const int size : {33, 64})
      EXPECT_LT(maxError(capture(Scene{}, light, at(position, size)), testing::smoothRadiance), 2e-3f) << size;
}

// A ray's direction must not come out as a small difference of places far away: that would be off by 1e-4.
TEST_P(CubeCaptureTest, OfNothingIsTheSameEverywhere) {
  const Environment light(testing::smoothRadiance, 256);
  const EnvironmentMap here = capture(Scene{}, light, at({0, 0, 0}));
  for (const glm::vec3 position : {glm::vec3(0.5f, -0.2f, 0.7f), glm::vec3(-0.3f, 0.8f, 0.1f)}) {
    const EnvironmentMap there = capture(Scene{}, light, at(position));
    forEachTexel(here, [&](int face, glm::ivec2 texel, glm::vec3) {
      const glm::vec3 moved = rgbAt(there.face(face), texel.x, texel.y) - rgbAt(here.face(face), texel.x, texel.y);
      ASSERT_LT(glm::length(moved), 1e-5f) << kFaceNames[std::size_t(face)] << " at " << texel.x << ", " << texel.y;
    });
  }
}

// A texel as large as a face, or as a quarter of it, is the mean over its area; four samples of it are near that.
TEST_P(CubeCaptureTest, EvenOneTexelAFaceIsTheMeanOfWhatItSees) {
  const Environment light(testing::smoothRadiance, 256);
  for (const int size : {1, 2}) {
    const EnvironmentMap captured = capture(Scene{}, light, at({0, 0, 0}, size));
    const EnvironmentMap converted = *convert(light, Projection::cube, size);
    const auto mean = [&](glm::vec3 direction) { return converted.radiance(direction); };
    EXPECT_LT(maxError(captured, mean), 0.05f) << size;
  }
}

TEST_P(CubeCaptureTest, TurnsAndDimsTheEnvironmentAsAPictureDoes) {
  CaptureSettings settings = at({0, 0, 0});
  settings.frame.env_rotation_deg.x = 90.0f;
  settings.frame.env_intensity = 0.5f;
  // +Z of the environment is seen towards +X.
  const auto turned = [](glm::vec3 d) { return 0.5f * testing::smoothRadiance({-d.z, d.y, d.x}); };
  EXPECT_LT(maxError(capture(Scene{}, Environment(testing::smoothRadiance, 256), settings), turned), 2e-3f);
}

// The labelled cube: a face in another's place, mirrored or turned is wrong in half of its texels and more.
TEST_P(CubeCaptureTest, OfNothingInUvIsUvFaceByFace) {
  const Environment uv = *builtinEnvironment("uv");
  const EnvironmentMap captured = capture(Scene{}, uv, at({1, 2, 3}, 128));
  const EnvironmentMap converted = *convert(uv, Projection::cube, 128);
  std::array<int, 6> wrong{};
  forEachTexel(captured, [&](int face, glm::ivec2 texel, glm::vec3) {
    const glm::vec3 difference =
        rgbAt(captured.face(face), texel.x, texel.y) - rgbAt(converted.face(face), texel.x, texel.y);
    if (glm::length(difference) > 0.2f) ++wrong[std::size_t(face)];
  });
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_LT(wrong[face], 128 * 128 / 100) << kFaceNames[face] << ": more than edges of the drawing differ";
}

// The light of a sun smaller than a texel is neither lost nor found twice where the faces are coarser than the map.
TEST_P(CubeCaptureTest, ACoarseCaptureKeepsTheFluxOfASmallSun) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.4f, 0.5f, -0.77f));
  const Environment sky([=](glm::vec3 d) { return glm::vec3(glm::dot(d, sun) > 0.9995f ? 1000.0f : 0.1f); }, 512);
  const double flux = testing::fluxOf(*convert(sky, Projection::cube, 256));
  for (const int samples : {1, 4, 16}) {
    CaptureSettings settings = at({0, 0, 0}, 16);
    settings.frame.samples = samples;
    EXPECT_NEAR(testing::fluxOf(capture(Scene{}, sky, settings)) / flux, 1.0, 0.1) << samples;
  }
}

TEST_P(CubeCaptureTest, ALampIsSeenInItsDirectionAndNowhereElse) {
  // None in the middle of a face, so that a mirrored or a turned one would show.
  const std::array<Lamp, 6> lamps{{{{2.0f, 0.7f, 0.4f}, {1, 0, 0}},
                                   {{-2.0f, 0.5f, 0.9f}, {0, 1, 1}},
                                   {{0.6f, 2.0f, -0.8f}, {0, 1, 0}},
                                   {{0.9f, -2.0f, -0.3f}, {1, 0, 1}},
                                   {{-0.8f, 0.4f, 2.0f}, {0, 0, 1}},
                                   {{0.5f, 0.9f, -2.0f}, {1, 1, 0}}}};
  const Scene scene = lampScene(lamps);
  // From the middle, and from beside it: then each lamp has moved, the nearer the more.
  for (const glm::vec3 position : {glm::vec3(0.0f), glm::vec3(0.8f, -0.6f, 0.5f)}) {
    const EnvironmentMap map = capture(scene, Environment(black, 8), at(position));
    std::array<int, 6> seen{};
    forEachTexel(map, [&](int face, glm::ivec2 texel, glm::vec3 direction) {
      glm::vec3 expected(0.0f);
      for (std::size_t i = 0; i < lamps.size(); ++i) {
        const glm::vec3 way = lamps[i].center - position;
        const float off = std::acos(std::clamp(glm::dot(direction, glm::normalize(way)), -1.0f, 1.0f));
        const float rim = std::asin(kLampRadius / glm::length(way));
        // A texel is at most 1/32 rad wide, and 1/22 across.
        if (std::abs(off - rim) < 0.025f) return;
        if (off > rim) continue;
        expected = lamps[i].color;
        ++seen[i];
      }
      EXPECT_EQ(rgbAt(map.face(face), texel.x, texel.y), expected)
          << kFaceNames[std::size_t(face)] << " at " << texel.x << ", " << texel.y;
    });
    for (const int texels : seen) EXPECT_GT(texels, 5);
  }
}

// The ball is a polyhedron of 128 × 256, whose facets lie up to 1e-4 inside: from a tenth of a radius off it, the place
// that is seen is off by less than 1e-3. A texel's mean of smooth light is off its centre's by as much.
TEST_P(CubeCaptureTest, AnEnclosingSphereIsSeenAtTheRightPlacesAndWithoutASeam) {
  const Scene scene = paintedSphere();
  for (const glm::vec3 position : {glm::vec3(0.0f), glm::vec3(0.5f, -0.3f, 0.4f), glm::vec3(-0.1f, 0.9f, 0.0f)}) {
    const auto expected = [&](glm::vec3 d) { return testing::smoothRadiance(onUnitSphere(position, d)); };
    const auto everywhere = [](glm::vec3) { return true; };
    const EnvironmentMap exact = *convert(Environment(expected, 256), Projection::cube, 64);
    const float largest_step = testing::largestStep(exact, everywhere);
    // Odd and even numbers of samples lie otherwise in a pixel, wherever it looks from.
    for (const int samples : position == glm::vec3(0.0f) ? std::vector{1, 4, 5} : std::vector{4}) {
      CaptureSettings settings = at(position);
      settings.frame.samples = samples;
      const EnvironmentMap map = capture(scene, Environment(white, 8), settings);
      EXPECT_LT(maxError(map, expected), 5e-3f) << samples;
      // A jump over an edge would be a step many times as large as those of the exact map.
      EXPECT_LT(testing::largestStep(map, everywhere), 1.2f * largest_step) << samples;
    }
  }
}

// Each of two faces would put another of these veils in front, were it to sort them by their depths.
TEST_P(CubeCaptureTest, WhatShinesThroughIsInTheSameOrderOnBothSidesOfAnEdge) {
  Scene scene;
  addVeil(scene, glm::normalize(glm::vec3(1.0f, 0.0f, 0.6f)) * 2.0f, {1, 0, 0});
  addVeil(scene, glm::normalize(glm::vec3(0.6f, 0.0f, 1.0f)) * 2.2f, {0, 1, 0});
  const EnvironmentMap map = capture(scene, Environment(black, 8), at({0, 0, 0}, 65));
  // The edge between +X (s = 0) and +Z (s = 1).
  const glm::vec3 on_x = rgbAt(map.face(0), 0, 32);
  const glm::vec3 on_z = rgbAt(map.face(4), 64, 32);
  EXPECT_LT(glm::length(on_x - on_z), 1e-4f);
  EXPECT_LT(glm::length(on_x - glm::vec3(0.4f, 0.6f * 0.4f, 0.0f)), 1e-4f) << "the farther one behind";
}

TEST_P(CubeCaptureTest, ASurfaceRightBesideThePointIsSeen) {
  const auto shareBelow = [&](const CaptureSettings& settings) {
    Scene scene = meshScene(planeMesh(), shining({1, 1, 1}));
    scene.instances[0].world_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(100.0f));
    return testing::fluxOf(capture(scene, Environment(black, 8), settings)) / (4.0 * glm::radians(180.0));
  };
  // The plane reaches 71 to each side: seen from 0.03, all but the 4e-4 of directions nearest to the horizon.
  EXPECT_NEAR(shareBelow(at({0.0f, 0.03f, 0.0f})), 0.5, 0.02);
  EXPECT_NEAR(shareBelow(at({0.0f, -0.03f, 0.0f})), 0.0, 1e-6) << "it has no back";
  CaptureSettings beyond = at({0.0f, 0.03f, 0.0f});
  beyond.nearest = 0.05f;
  EXPECT_LT(shareBelow(beyond), 0.4) << "cut away by the near plane";
}

TEST_P(CubeCaptureTest, AnObjectFarAwayIsNotCutAway) {
  const Lamp lamp{{0, 0, 0}, {1, 1, 1}};
  const Scene scene = lampScene(std::span(&lamp, 1));
  const EnvironmentMap map = capture(scene, Environment(black, 8), at({-30.0f, 0.0f, 0.0f}, 129));
  // Its disc has a radius of 1/150, and the texel in the middle a side of 1/64.
  EXPECT_GT(rgbAt(map.face(0), 64, 64).x, 0.2f);
}

TEST_P(CubeCaptureTest, TellsItsProgressAndStopsWhenAsked) {
  CaptureSettings settings = at({0, 0, 0}, 8);
  settings.frame.samples = 3;
  std::size_t calls = 0;
  const auto count = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(done, ++calls);
    EXPECT_EQ(total, 18u);
    return true;
  };
  EXPECT_TRUE(tryCapture(Scene{}, Environment(white, 8), settings, count));
  EXPECT_EQ(calls, 18u);
  const auto stop = [](std::size_t done, std::size_t) { return done < 7; };
  const auto stopped = tryCapture(Scene{}, Environment(white, 8), settings, stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

TEST_P(CubeCaptureTest, IsConvertedToAnotherProjection) {
  const Environment light(testing::smoothRadiance, 256);
  CaptureSettings settings = at({0, 0, 0}, 64);
  settings.to = Projection::equirect;
  settings.frame.samples = 2;
  std::size_t steps = 0;
  auto map = tryCapture(Scene{}, light, settings, [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 14u);
    EXPECT_GE(done, steps);
    steps = done;
    return true;
  });
  ASSERT_TRUE(map);
  EXPECT_EQ(map->projection(), Projection::equirect);
  EXPECT_EQ(map->face(0).height(), 64);
  EXPECT_EQ(steps, 14u);
  const Environment captured(std::move(*map));
  for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(0.2f, 0.9f, -0.4f), glm::vec3(-0.7f, -0.5f, 0.3f)}) {
    const glm::vec3 unit = glm::normalize(direction);
    EXPECT_LT(glm::length(captured.radiance(unit) - testing::smoothRadiance(unit)), 0.01f);
  }
}

TEST(CapturePlaces, FarOutsideOfTheSceneAreDoubted) {
  const BoundingSphere scene{{1.0f, 0.0f, 0.0f}, 2.0f};
  EXPECT_EQ(doubtOfPlace({1.0f, 20.0f, 0.0f}, scene), std::nullopt);
  EXPECT_EQ(doubtOfPlace({1.0f, 20.1f, 0.0f}, scene),
            "1,20.1,0 is far outside of the scene, which lies within 2 units of 1,0,0; the map hardly shows it");
}

TEST_P(CubeCaptureTest, MoreThanTheDriverDrawsIsRefused) {
  const auto captured = tryCapture(Scene{}, Environment(white, 8), at({0, 0, 0}, 32768), {});
  ASSERT_FALSE(captured);
  EXPECT_EQ(captured.error().code, ErrorCode::too_large);
}

}  // namespace
}  // namespace mirrorball
