// What objects hide from themselves and show to themselves, drawn, against paths.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/metric/image_error.h"
#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/interreflection.h"
#include "mirrorball/scene/shapes/revolution.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {
namespace {

class SelfOcclusion : public testing::HeadlessTest {
 protected:
  static Image drawn(Scene scene, const Environment& environment, const FrameSettings& frame, bool refines = true) {
    const auto draw = [&]() -> Result<Image> {
      MIRRORBALL_TRY_VOID(findOcclusionOnce(scene, {.rays = 24, .finds_materials = true, .refines = refines}, {}));
      MIRRORBALL_TRY(prepared, testing::prepareOnce(environment));
      MIRRORBALL_TRY(renderer, testing::rendererOf(std::move(scene), environment, prepared));
      return renderer.renderRadiance(frame);
    };
    return valueOf(draw());
  }

  static Image traced(const Scene& scene, const Environment& environment, const FrameSettings& frame) {
    const auto trace = [&]() -> Result<Image> {
      MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), frame.camera, frame.size));
      MIRRORBALL_TRY(tracer, PathTracer::make(scene, environment));
      MIRRORBALL_TRY(picture, tracer.render(camera, tracedFrame(frame, {.samples = 64})));
      return std::move(picture.radiance);
    };
    return valueOf(trace());
  }

  static double rmse(const Image& a, const Image& b) { return std::sqrt(imageError(a, b).mean_square); }
  /// The root of relMSE: what lies in the sun counts as much as what lies in its shadow.
  static double relativeError(const Image& a, const Image& b) {
    return std::sqrt(imageError(a, b).relative_mean_square);
  }

 private:
  static Image valueOf(Result<Image> image) {
    if (image) return std::move(*image);
    ADD_FAILURE() << image.error().message;
    return Image(1, 1, 4);
  }
};

/// Into a bowl from above.
FrameSettings shotIntoBowl() {
  FrameSettings frame;
  frame.size = {48, 48};
  frame.samples = 16;
  testing::aim(frame, 30.0f, 50.0f);
  return frame;
}

FrameSettings with(FrameSettings frame, OcclusionKind occlusion, bool reflects) {
  frame.occlusion = occlusion;
  frame.self_reflection = reflects;
  return frame;
}

Environment studioLight() { return *builtinEnvironment("studio"); }

// Of what it sees, the inside of the bowl sees more than half of itself.
TEST_F(SelfOcclusion, ABowlIsNearerToThePathsByAFactor) {
  const Environment light = studioLight();
  const FrameSettings frame = shotIntoBowl();
  const Image truth = traced(bowlScene(), light, frame);
  const double without = rmse(drawn(bowlScene(), light, with(frame, OcclusionKind::none, false)), truth);
  const double known = rmse(drawn(bowlScene(), light, with(frame, OcclusionKind::vertex, false)), truth);
  EXPECT_LT(known, 0.4 * without) << known << " after " << without;
}

TEST_F(SelfOcclusion, MirrorsThatReflectEachOtherAreNearerToThePaths) {
  const Environment light = studioLight();
  FrameSettings frame = shotIntoBowl();
  testing::aim(frame, 30.0f, 15.0f);
  const Image truth = traced(spheresScene(), light, frame);
  const double without = rmse(drawn(spheresScene(), light, with(frame, OcclusionKind::none, false)), truth);
  const double known = rmse(drawn(spheresScene(), light, with(frame, OcclusionKind::vertex, false)), truth);
  const double reflected = rmse(drawn(spheresScene(), light, with(frame, OcclusionKind::vertex, true)), truth);
  EXPECT_LT(known, 1.02 * without) << "what vertices know must not harm a mirror";
  EXPECT_LT(reflected, 0.5 * without) << reflected << " after " << without;
}

TEST_F(SelfOcclusion, RoughMetalReflectsItself) {
  const Environment light = studioLight();
  const FrameSettings frame = shotIntoBowl();
  Scene bowl = bowlScene();
  bowl.materials[0] = *materialNamed("gold");
  bowl.materials[0].perceptual_roughness = 0.5f;
  const Image truth = traced(bowl, light, frame);
  const double without = rmse(drawn(bowl, light, with(frame, OcclusionKind::none, false)), truth);
  const double reflected = rmse(drawn(bowl, light, with(frame, OcclusionKind::vertex, true)), truth);
  EXPECT_LT(reflected, 0.6 * without) << reflected << " after " << without;
}

/// A floor of two triangles, 8 long, its normal upwards.
Mesh floorMesh() {
  Mesh mesh;
  for (const glm::vec2 at : {glm::vec2(-4, -4), glm::vec2(-4, 4), glm::vec2(4, 4), glm::vec2(4, -4)})
    mesh.vertices.push_back({.position = {at.x, 0.0f, at.y}, .normal = {0, 1, 0}});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

Material matt() {
  Material material;
  material.base_color = glm::vec3(0.7f);
  material.perceptual_roughness = 0.6f;
  return material;
}

/// A mesh of another material on that floor.
Scene onFloor(Mesh mesh, float height) {
  Scene scene = meshScene(floorMesh(), matt());
  scene.materials.push_back(matt());
  scene.materials[1].base_color = glm::vec3(0.8f, 0.5f, 0.3f);
  mesh.material = 1;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = 1});
  scene.instances[1].world_from_object[3] = glm::vec4(0.0f, height, 0.0f, 1.0f);
  return scene;
}

/// A bottle whose flank is of triangles as long as itself: its foot sees less of the sky than its shoulder.
Mesh bottleMesh() {
  constexpr glm::dvec2 kUp(0, 1), kOut(1, 0), kDown(0, -1);
  const std::vector<ProfilePoint> profile{{{0.0, 3.4}, kUp},   {{0.2, 3.4}, kUp},  {{0.2, 3.4}, kOut},
                                          {{0.2, 2.8}, kOut},  {{0.6, 2.4}, kOut}, {{0.6, 0.0}, kOut},
                                          {{0.6, 0.0}, kDown}, {{0.0, 0.0}, kDown}};
  return revolvedMesh(profile, 24);
}

/// A ball with two thin ears, whose smooth normals at the rim lie across both sides.
Mesh headMesh() {
  Mesh head = sphereMesh(24, 48);
  for (const float side : {-1.0f, 1.0f}) {
    Mesh ear = sphereMesh(4, 12);
    const auto first = static_cast<std::uint32_t>(head.vertices.size());
    for (Vertex vertex : ear.vertices) {
      vertex.position = vertex.position * glm::vec3(0.8f, 0.8f, 0.02f) + glm::vec3(side * 1.2f, 0.9f, 0.0f);
      head.vertices.push_back(vertex);
    }
    for (const std::uint32_t index : ear.indices) head.indices.push_back(first + index);
  }
  computeNormals(head);
  return head;
}

// What vertices know must not darken what is between them, nor miss it.
TEST_F(SelfOcclusion, LargeTrianglesAreNearerToThePaths) {
  struct Shown {
    const char* name;
    Scene scene;
    double of_uncut;  // the share of the error that is left of that without cuts; ears are small enough without
  };
  const Shown scenes[] = {{"a ball on a floor of two triangles", onFloor(sphereMesh(24, 48), 1.0f), 0.98},
                          {"a bottle of long triangles", onFloor(bottleMesh(), 0.0f), 0.98},
                          {"a head with thin ears", onFloor(headMesh(), 1.0f), 1.02}};
  for (const Environment& light : {studioLight(), *builtinEnvironment("sky")})
    for (const auto& [name, scene, of_uncut] : scenes) {
      const FrameSettings frame = shotIntoBowl();
      const FrameSettings with_occlusion = with(frame, OcclusionKind::vertex, false);
      const Image truth = traced(scene, light, frame);
      const double without = relativeError(drawn(scene, light, with(frame, OcclusionKind::none, false)), truth);
      const double known = relativeError(drawn(scene, light, with_occlusion), truth);
      const double uncut = relativeError(drawn(scene, light, with_occlusion, false), truth);
      EXPECT_LT(known, 0.92 * without) << name << ": " << known << " after " << without;
      EXPECT_LT(known, of_uncut * uncut) << name << ": " << known << ", uncut " << uncut;
    }
}

// A knob hides a small part of the sky from the lid around it, which mirrors the rest in its coat.
TEST_F(SelfOcclusion, HighlightsBesideASmallHiderStay) {
  Scene pot = *loadModel("teapot");
  pot.materials[0] = *materialNamed("car-paint");
  FrameSettings frame;
  frame.size = {64, 48};
  frame.samples = 16;
  const Environment light = *builtinEnvironment("sunset");
  const Image truth = traced(pot, light, frame);
  const double without = rmse(drawn(pot, light, with(frame, OcclusionKind::none, false)), truth);
  const double known = rmse(drawn(pot, light, with(frame, OcclusionKind::vertex, false)), truth);
  EXPECT_LT(known, without);
}

// A small bright lamp over rough metal fills little of what that reflects. Of radiance, what is above 3, as of the lamp
// itself, is left out.
TEST_F(SelfOcclusion, ASmallLampMakesNoRoughMetalGlow) {
  const Environment light = *builtinEnvironment("white");
  for (const float roughness : {0.3f, 0.6f, 1.0f}) {
    Mesh ball = sphereMesh(12, 24);
    for (Vertex& vertex : ball.vertices) vertex.position *= 0.02f;
    Scene scene = onFloor(std::move(ball), 0.3f);
    // Of many vertices: the lamp is too small for a floor of two triangles to be cut below it.
    scene.meshes[0] = sphereMesh(64, 128);
    for (Vertex& vertex : scene.meshes[0].edit().vertices)
      vertex.position = 0.5f * vertex.position - glm::vec3(0, 0.5f, 0);
    scene.materials[0].metallic = 1.0f;
    scene.materials[0].perceptual_roughness = roughness;
    scene.materials[1].emission = glm::vec3(400.0f);
    const FrameSettings frame = shotIntoBowl();
    const auto meanOf = [](const Image& picture) {
      double sum = 0.0;
      for (const float sample : picture.samples()) sum += std::min(sample, 3.0f);
      return sum / static_cast<double>(picture.samples().size());
    };
    const double truth = meanOf(traced(scene, light, frame));
    const double known = meanOf(drawn(scene, light, with(frame, OcclusionKind::vertex, false)));
    EXPECT_NEAR(known, truth, 0.05 * truth) << roughness;
  }
}

// Rays show what is reflected; what is seen through comes from the probe, as it does without them.
TEST_F(SelfOcclusion, GlassThatIsSeenThroughByProbesKeepsItsProbe) {
  Scene scene = onFloor(sphereMesh(24, 48), 1.2f);
  scene.materials[0].emission = {2.0f, 0.0f, 0.0f};
  scene.materials[1] = *materialNamed("glass");
  FrameSettings frame = shotIntoBowl();
  frame.samples = 1;
  testing::aim(frame, 0.0f, 89.0f);
  testing::set(frame, "refraction", "single");
  testing::set(frame, "behind", "probes");
  testing::set(frame, "probes", "1");
  testing::set(frame, "probe-size", "64");
  frame.camera.target = glm::vec3(0.0f, 1.2f, 0.0f);
  frame.camera.orthographic_height = 0.5f;
  const Environment dark([](glm::vec3) { return glm::vec3(0.05f); }, 64);
  const float without_rays = drawn(scene, dark, with(frame, OcclusionKind::vertex, false)).texel(24, 24)[0];
  const float with_rays = drawn(scene, dark, with(frame, OcclusionKind::vertex, true)).texel(24, 24)[0];
  EXPECT_GT(without_rays, 1.5f) << "the floor";
  EXPECT_NEAR(with_rays, without_rays, 0.1f);
}

// The light of a bowl that reflects all of it has nowhere else to go.
TEST_F(SelfOcclusion, AWhiteBowlIsWhiteInTheFurnace) {
  const Environment white = *builtinEnvironment("white");
  for (const float metallic : {0.0f, 1.0f})
    for (const float roughness : {0.0f, 0.6f})
      for (const bool reflects : {false, true}) {
        Scene bowl = bowlScene();
        bowl.materials[0] = Material{};
        bowl.materials[0].base_color = glm::vec3(1.0f);
        bowl.materials[0].metallic = metallic;
        bowl.materials[0].perceptual_roughness = roughness;
        FrameSettings frame = with(shotIntoBowl(), OcclusionKind::vertex, reflects);
        frame.background = BackgroundKind::transparent;
        frame.samples = 1;
        testing::expectFurnaceWhite(drawn(bowl, white, frame),
                                    "metallic " + std::to_string(metallic) + " roughness " + std::to_string(roughness) +
                                        (reflects ? " reflecting itself" : ""),
                                    4e-3f);
      }
}

// A frame that asks for what nobody has found gets it.
TEST_F(SelfOcclusion, WhatNobodyHasFoundIsFoundForTheFrame) {
  const Environment light = studioLight();
  const FrameSettings frame = with(shotIntoBowl(), OcclusionKind::vertex, true);
  const auto draw = [&](Scene scene) {
    const auto prepared = testing::prepareOnce(light);
    auto renderer = testing::rendererOf(std::move(scene), light, *prepared);
    return *renderer->renderRadiance(frame);
  };
  Scene found = bowlScene();
  ASSERT_TRUE(findOcclusionOnce(found, {.finds_materials = true, .refines = true}, {}));
  EXPECT_EQ(rmse(draw(bowlScene()), draw(found)), 0.0);
}

// The shaders are the same text, and ES 3.0 has room for what vertices tell; only the drivers' arithmetic may differ.
TEST_F(SelfOcclusion, Es30DrawsTheSameAsDesktop) {
  Image pictures[2];
  for (const gl::Api api : {gl::Api::desktop43, gl::Api::es30}) {
    MIRRORBALL_NEEDS_GL(context, api);
    FrameSettings frame = with(shotIntoBowl(), OcclusionKind::vertex, true);
    frame.samples = 1;
    pictures[api == gl::Api::es30] = drawn(bowlScene(), studioLight(), frame);
  }
  EXPECT_LT(rmse(pictures[0], pictures[1]), 1e-3);
}

}  // namespace
}  // namespace mirrorball
