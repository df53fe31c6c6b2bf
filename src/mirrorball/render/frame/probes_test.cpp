// Objects that show each other. Where probes stand is tested in light/probe_places_test.cpp.

#include "mirrorball/render/frame/probes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/cube_capture.h"
#include "mirrorball/render/frame/frame_light.h"
#include "mirrorball/render/frame/glass_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

struct Ball {
  glm::vec3 middle;
  float radius;
  glm::vec3 color;  ///< of a mirror
};

Material coloredMirror(glm::vec3 color, float roughness = 0.0f) {
  Material material;
  material.base_color = color;
  material.metallic = 1.0f;
  material.perceptual_roughness = roughness;
  return material;
}

void addBall(Scene& scene, const Ball& ball, const Material& material, int rows = 96) {
  testing::addBall(scene, ball.middle, ball.radius, material, rows);
}

Scene sceneOfBalls(const std::vector<Ball>& balls) {
  Scene scene;
  for (const Ball& ball : balls) addBall(scene, ball, coloredMirror(ball.color));
  return scene;
}

/// What a ray sees among mirror balls, the truth, and how many of them it meets.
struct Seen {
  glm::vec3 light;
  int met;
};

Seen traced(const std::vector<Ball>& balls, const RadianceFunction& far, glm::vec3 origin, glm::vec3 d, int bounces) {
  float nearest = INFINITY;
  const Ball* met = nullptr;
  for (const Ball& ball : balls) {
    const glm::vec3 to = origin - ball.middle;
    const float along = glm::dot(to, d);
    const float root = along * along - glm::dot(to, to) + ball.radius * ball.radius;
    if (root < 0.0f) continue;
    const float distance = -along - std::sqrt(root);
    if (distance < 1e-4f || distance >= nearest) continue;
    nearest = distance;
    met = &ball;
  }
  if (!met) return {far(d), 0};
  if (bounces == 0) return {glm::vec3(0.0f), 0};
  const glm::vec3 place = origin + nearest * d;
  const glm::vec3 n = (place - met->middle) / met->radius;
  const glm::vec3 r = glm::reflect(d, n);
  // Schlick's metal, as the default material of this base colour is.
  const float grazing = std::pow(1.0f - std::max(-glm::dot(d, n), 0.0f), 5.0f);
  const glm::vec3 reflectance = met->color + (1.0f - met->color) * grazing;
  const Seen seen = traced(balls, far, place, r, bounces - 1);
  return {reflectance * seen.light, seen.met + 1};
}

const std::vector<Ball> kPair{{{-1.1f, 0.0f, 0.0f}, 1.0f, {1.0f, 0.75f, 0.35f}},
                              {{1.1f, 0.0f, 0.3f}, 1.0f, {0.6f, 0.8f, 1.0f}}};

constexpr const char* kProbeRoom = "box:-5,-5,-5,5,5,5";

class ProbesTest : public gl::GlTest {};
MIRRORBALL_WITH_BOTH_APIS(ProbesTest);

/// World units over which pictures look.
constexpr float kWide = 4.6f;
FrameSettings frontOf(const Renderer& renderer, int size) { return testing::frontOf(renderer, size, kWide); }

/// Of the pixels whose rays meet at least so many balls.
double psnrToTruth(const Image& image, const std::vector<Ball>& balls, int at_least) {
  double squares = 0.0;
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      glm::vec3 truth(0.0f);
      int least = 16;
      for (int sample = 0; sample < 16; ++sample) {
        const glm::vec2 within = (glm::vec2(sample % 4, sample / 4) + 0.5f) / 4.0f;
        const glm::vec2 across =
            ((glm::vec2(x, image.height() - 1 - y) + within) / float(image.width()) - 0.5f) * kWide;
        const Seen seen = traced(balls, testing::smoothRadiance, glm::vec3(across, 10.0f), glm::vec3(0, 0, -1), 16);
        truth += seen.light / 16.0f;
        least = std::min(least, seen.met);
      }
      if (least < at_least) continue;
      ++count;
      const glm::vec3 difference = rgbAt(image, x, y) - truth;
      squares += double(glm::dot(difference, difference)) / 3.0;
    }
  EXPECT_GT(count, 100) << at_least;
  return -10.0 * std::log10(squares / count);
}

TEST_P(ProbesTest, TwoMirrorBallsShowEachOther) {
  Renderer renderer = testing::rendererFor(sceneOfBalls(kPair), Environment(testing::smoothRadiance, 256));
  FrameSettings settings = frontOf(renderer, 96);
  const Image without = testing::drawn(renderer, settings);
  testing::set(settings, "probes", "auto");
  testing::set(settings, "probe-size", "128");
  testing::set(settings, "probe-bounces", "1");
  const Image once = testing::drawn(renderer, settings);
  testing::set(settings, "probe-bounces", "2");
  const Image twice = testing::drawn(renderer, settings);
  EXPECT_LT(psnrToTruth(without, kPair, 0), 23.0);
  EXPECT_GT(psnrToTruth(once, kPair, 0), 31.5) << "23.0 if what a probe sees is infinitely far away";
  EXPECT_GT(psnrToTruth(twice, kPair, 0), 32.4);
  // Where the balls show each other in each other.
  EXPECT_LT(psnrToTruth(without, kPair, 2), 5.0);
  EXPECT_GT(psnrToTruth(once, kPair, 2), 15.0);
  EXPECT_GT(psnrToTruth(twice, kPair, 2), psnrToTruth(once, kPair, 2) + 1.0);
}

// A wall behind the eye that is cut away by its alpha: a mirror ball shows what is far away.
TEST_P(ProbesTest, WhatIsCutAwayIsNotNearEither) {
  const auto drawnWith = [](float opacity) {
    Scene scene = sceneOfBalls({{{0.4f, 0.2f, 0.0f}, 0.5f, {1.0f, 1.0f, 1.0f}}});
    Material cut;
    cut.alpha_mode = AlphaMode::mask;
    cut.double_sided = true;
    cut.opacity = opacity;
    cut.perceptual_roughness = 1.0f;
    testing::add(scene, cubeMesh(), cut);
    scene.instances.back().world_from_object =
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 2.0f)), glm::vec3(4.0f, 4.0f, 0.1f));
    Renderer renderer = testing::rendererFor(std::move(scene), Environment(testing::smoothRadiance, 256));
    FrameSettings settings = frontOf(renderer, 96);
    testing::set(settings, "probes", opacity > 0.0f ? "auto" : "0");
    testing::set(settings, "probe-size", "128");
    return testing::drawn(renderer, settings);
  };
  EXPECT_LT(testing::greatestDifference(drawnWith(0.3f), drawnWith(0.0f)), 0.02);
}

/// A frame on a stage of its own, as far as its probes.
struct Begun {
  Device device = *Device::on(*gl::Context::adoptCurrent());
  Stage stage{device};
  SceneDrawing drawing{device.state()};
  FrameLight light{device.state(), stage.state().light};
  Probes probes = {};
  FrameUniforms frame = {};

  void begin(const FrameSettings& settings) {
    drawing.show(*stage.state().formFor(settings));
    frame.light = *light.begin(drawing.staged(), settings, frame.sample.camera, {});
    frame.scene = *drawing.begin(settings, frame.sample, *frame.light.proxy);
    frame.probes = *probes.begin(device.state().context.api(), drawing, light.light(), 1, settings, frame);
  }
};

// Of a scene without the object that the probe stands in: the same picture but for half floats.
TEST_P(ProbesTest, AProbeIsWhatCaptureCaptures) {
  const Environment light(testing::smoothRadiance, 256);
  const auto prepared = testing::prepareOnce(light);
  Begun begun;
  ASSERT_TRUE(begun.stage.setEnvironment(light, *prepared));
  Scene seen_from_inside = sceneOfBalls(kPair);
  for (Material& material : seen_from_inside.materials) material.double_sided = true;
  ASSERT_TRUE(begun.stage.setScene(std::move(seen_from_inside)));
  FrameSettings settings;
  testing::set(settings, "probes", "2");
  testing::set(settings, "probe-size", "32");
  testing::set(settings, "probe-bounces", "1");
  testing::set(settings, "proxy", kProbeRoom);
  begun.begin(settings);
  const FrameUniforms& frame = begun.frame;
  ASSERT_NE(frame.probes, nullptr);
  ASSERT_EQ(frame.probes->lights.size(), 2u);

  for (std::size_t own = 0; own < 2; ++own) {
    const SurfaceLight& probe = frame.probes->lights[std::size_t(frame.probes->light_of_instance[own])];
    CaptureSettings at{.position = kPair[own].middle, .size = 32};
    at.frame.samples = 1;
    testing::set(at.frame, "proxy", kProbeRoom);
    Renderer renderer = testing::rendererFor(sceneOfBalls({kPair[1 - own]}), light);
    const auto captured = captureEnvironment(renderer, at);
    ASSERT_TRUE(captured) << captured.error().message;
    for (int face = 0; face < 6; ++face) {
      const Image made = probe.environment->read(0, face);
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
          ASSERT_LT(glm::distance(rgbAt(made, x, y), rgbAt(captured->face(face), x, y)), 2e-3f)
              << "ball " << own << " face " << face << " at " << x << ", " << y;
    }
  }
}

/// What the probes of two mirror balls see with a ball of glass between them, face by face.
std::vector<Image> facesAroundGlass(const std::string& behind, const std::string& refraction) {
  const Environment light(testing::smoothRadiance, 64);
  Begun begun;
  EXPECT_TRUE(begun.stage.setEnvironment(light, *testing::prepareOnce(light)));
  Scene scene = sceneOfBalls({{{-1.6f, 0.0f, 0.0f}, 0.7f, {1.0f, 0.75f, 0.35f}}, {{1.6f, 0.0f, 0.3f}, 0.7f, {}}});
  Material glass;
  glass.base_color = glm::vec3(1.0f);
  glass.transmission = 1.0f;
  glass.perceptual_roughness = 0.0f;
  addBall(scene, {{0.0f, 0.0f, 0.1f}, 0.7f, {}}, glass);
  EXPECT_TRUE(begun.stage.setScene(std::move(scene)));
  FrameSettings settings;
  testing::set(settings, "probes", "2");
  testing::set(settings, "probe-size", "32");
  testing::set(settings, "proxy", kProbeRoom);
  testing::set(settings, "behind", behind);
  testing::set(settings, "refraction", refraction);
  begun.begin(settings);
  std::vector<Image> faces;
  for (const SurfaceLight& probe : begun.frame.probes->lights)
    for (int face = 0; face < 6; ++face) faces.push_back(probe.environment->read(0, face));
  return faces;
}

// A face does not show what is beside it. So through glass it shows probes, also where the frame shows the screen.
TEST_P(ProbesTest, AProbeSeesNoScreenThroughGlass) {
  for (const char* refraction : {"image-space", "traced"}) {
    const std::vector<Image> with_screen = facesAroundGlass("screen", refraction);
    const std::vector<Image> with_probes = facesAroundGlass("probes", refraction);
    ASSERT_EQ(with_screen.size(), with_probes.size());
    for (std::size_t face = 0; face < with_probes.size(); ++face)
      EXPECT_LT(testing::greatestDifference(with_screen[face], with_probes[face]), 2e-3)
          << refraction << ", face " << face << ": half floats differ by as much";
  }
}

TEST_P(ProbesTest, AreCapturedAgainOnlyIfWhatTheySeeHasChanged) {
  Renderer renderer = testing::rendererFor(sceneOfBalls(kPair), Environment(testing::smoothRadiance, 64));
  FrameSettings settings = frontOf(renderer, 16);
  settings.samples = 1;
  const auto capturesOf = [&](const FrameSettings& changed) {
    const int before = renderer.probeCaptures();
    testing::drawn(renderer, changed);
    return renderer.probeCaptures() - before;
  };
  EXPECT_EQ(capturesOf(settings), 0) << "none was asked for";
  testing::set(settings, "probes", "auto");
  EXPECT_EQ(capturesOf(settings), 4) << "two, for two bounces";
  EXPECT_EQ(capturesOf(settings), 0);
  testing::aim(settings, 70.0f, 20.0f);
  settings.display.exposure_ev = 1.0f;
  settings.background = BackgroundKind::transparent;
  settings.samples = 2;
  EXPECT_EQ(capturesOf(settings), 0) << "the eye has moved, and not what they see";
  testing::set(settings, "env-rotation", "30");
  EXPECT_EQ(capturesOf(settings), 4);
  const Image before = testing::drawn(renderer, settings);
  std::vector<Instance> instances = renderer.scene().instances;
  instances[1].world_from_object[3].y += 0.5f;
  ASSERT_TRUE(renderer.moveInstances(instances));
  EXPECT_EQ(capturesOf(settings), 4);
  Scene scene = renderer.scene();
  ASSERT_TRUE(renderer.setScene(scene));
  EXPECT_EQ(capturesOf(settings), 0) << "the same scene";
  scene.meshes[0].edit().vertices[0].position *= 1.01f;
  ASSERT_TRUE(renderer.setScene(scene));
  EXPECT_EQ(capturesOf(settings), 4) << "another scene";
  const Environment light(testing::smoothRadiance, 64);
  ASSERT_TRUE(renderer.setEnvironment(light, *testing::prepareOnce(light)));
  EXPECT_EQ(capturesOf(settings), 4) << "another environment";
}

// What is moved is as if it had been made there: in its own picture, and in that of the other ball.
TEST_P(ProbesTest, AMovedBallIsSeenWhereItIs) {
  const Environment light(testing::smoothRadiance, 64);
  std::vector<Ball> moved = kPair;
  moved[1].middle = {0.4f, 1.9f, -0.2f};
  Renderer renderer = testing::rendererFor(sceneOfBalls(kPair), light);
  Renderer there = testing::rendererFor(sceneOfBalls(moved), light);
  FrameSettings settings = frontOf(renderer, 48);
  settings.camera.orthographic_height.reset();
  settings.camera.distance = 3.0f;
  testing::set(settings, "probes", "2");
  testing::set(settings, "proxy", kProbeRoom);
  testing::drawn(renderer, settings);
  ASSERT_TRUE(renderer.moveInstances(there.scene().instances));
  const Image image = testing::drawn(renderer, settings);
  const Image expected = testing::drawn(there, settings);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) ASSERT_EQ(rgbaAt(image, x, y), rgbaAt(expected, x, y)) << x << ", " << y;
}

TEST_P(ProbesTest, WithoutProbesNothingChanges) {
  Renderer renderer = testing::rendererFor(sceneOfBalls(kPair), Environment(testing::smoothRadiance, 64));
  FrameSettings settings = frontOf(renderer, 32);
  const Image before = testing::drawn(renderer, settings);
  testing::set(settings, "probes", "1");
  testing::drawn(renderer, settings);
  testing::set(settings, "probes", "0");
  const Image after = testing::drawn(renderer, settings);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) ASSERT_EQ(rgbaAt(before, x, y), rgbaAt(after, x, y)) << x << ", " << y;
}

TEST_P(ProbesTest, TheFurnaceIsWhite) {
  Scene scene;
  addBall(scene, kPair[0], coloredMirror(glm::vec3(1.0f)), 16);
  addBall(scene, kPair[1], coloredMirror(glm::vec3(1.0f), 0.4f), 16);
  Material glass;
  glass.base_color = glm::vec3(1.0f);
  glass.transmission = 1.0f;
  glass.perceptual_roughness = 0.0f;
  addBall(scene, {{0.0f, 1.8f, 0.0f}, 0.8f, {}}, glass, 16);
  Material glossy;
  glossy.base_color = glm::vec3(1.0f);
  glossy.perceptual_roughness = 0.3f;
  addBall(scene, {{0.0f, -1.8f, 0.0f}, 0.8f, {}}, glossy, 16);
  Renderer renderer =
      testing::rendererFor(std::move(scene), Environment([](glm::vec3) { return glm::vec3(1.0f); }, 64));
  FrameSettings settings = frontOf(renderer, 32);
  settings.background = BackgroundKind::transparent;
  testing::set(settings, "probe-size", "16");
  for (const char* probes : {"auto", "2"})
    for (const char* refraction : {"single", "image-space", "traced"}) {
      testing::set(settings, "probes", probes);
      testing::set(settings, "refraction", refraction);
      testing::expectFurnaceWhite(testing::drawn(renderer, settings), std::string(probes) + " " + refraction, 4e-3f);
    }
}

// A blend is the sum of its shares: on a ball without a probe amid two, what they show at the same direction.
TEST_P(ProbesTest, AnObjectWithoutOneReadsABlendOfTheNearest) {
  const Environment light(testing::smoothRadiance, 64);
  const auto prepared = testing::prepareOnce(light);
  Begun begun;
  ASSERT_TRUE(begun.stage.setEnvironment(light, *prepared));
  std::vector<Ball> balls = kPair;
  balls.push_back({{-0.8f, 1.6f, 0.0f}, 0.3f, glm::vec3(1.0f)});
  ASSERT_TRUE(begun.stage.setScene(sceneOfBalls(balls)));
  FrameSettings settings;
  testing::set(settings, "probes", "2");
  testing::set(settings, "probe-size", "16");
  begun.begin(settings);
  const FrameUniforms& frame = begun.frame;
  ASSERT_NE(frame.probes, nullptr);
  ASSERT_EQ(frame.probes->lights.size(), 3u);
  const ReflectiveObject small{balls[2].middle, 0.3f, {}};
  const std::vector<float> shares = probeShares(
      small, {{frame.probes->lights[0].captured_from, 1.0f, {}}, {frame.probes->lights[1].captured_from, 1.0f, {}}});
  const SurfaceLight& blend = frame.probes->lights[std::size_t(frame.probes->light_of_instance[2])];
  EXPECT_EQ(blend.nearness, nullptr);
  using Cube = const gl::Texture* SurfaceLight::*;
  for (const Cube cube : {&SurfaceLight::environment, &SurfaceLight::prefiltered, &SurfaceLight::irradiance})
    for (int face = 0; face < 6; ++face) {
      const int level = (blend.*cube)->levels() - 1;
      const Image a = (frame.probes->lights[0].*cube)->read(level, face);
      const Image b = (frame.probes->lights[1].*cube)->read(level, face);
      const glm::vec3 expected = shares[0] * rgbAt(a, 0, 0) + shares[1] * rgbAt(b, 0, 0);
      EXPECT_LT(glm::distance(rgbAt((blend.*cube)->read(level, face), 0, 0), expected), 3e-3f) << face;
    }
}

}  // namespace
}  // namespace mirrorball
