// Light that goes through whole bodies, traced or by the back faces that a picture shows: what must hold of it,
// whatever their shape.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/glass_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/faceted.h"

namespace mirrorball {
namespace {

using testing::add;
using testing::clearGlass;
using testing::greatestDifference;
using testing::meanDifference;
using testing::smoothLight;
using testing::withoutReflection;

constexpr std::array<RefractionKind, 2> kWholeBodies{RefractionKind::image_space, RefractionKind::traced};
std::string nameOf(RefractionKind kind) { return kind == RefractionKind::traced ? "traced" : "image-space"; }

class TracedBodies : public testing::GlassTest {};

TEST_F(TracedBodies, ClearGlassIsWhiteInTheFurnace) {
  frame_.background = BackgroundKind::transparent;
  testing::aim(frame_, 25, 20);
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  for (const int bounces : {1, 4, 9}) {
    frame_.inner_bounces = bounces;
    for (const float ior : {0.75f, 1.0f, 1.5f, 2.4f}) {
      Material glass = clearGlass(ior);
      const std::string what = std::to_string(ior) + " after " + std::to_string(bounces);
      testing::expectFurnaceWhite(radiance(meshScene(knotMesh(60, 12), glass), white), "knot " + what, 2e-3f);
      glass.perceptual_roughness = 0.4f;
      glass.dispersion = 1.0f;
      Scene nested = meshScene(sphereMesh(24, 48), glass);
      add(nested, cubeMesh(), clearGlass(1.0f), glm::vec3(0.2f, 0.0f, 0.0f), 0.5f);           // a bubble
      add(nested, sphereMesh(24, 48), clearGlass(1.33f), glm::vec3(0.0f, 0.9f, 0.0f), 0.5f);  // reaches out of it
      testing::expectFurnaceWhite(radiance(nested, white), "nested " + what, 2e-3f);
    }
  }
}

// Also where no back face is found, or one of another part of the body: a torus and a knot hide some of theirs.
TEST_F(TracedBodies, BackFacesOfClearGlassAreWhiteInTheFurnace) {
  frame_.refraction = RefractionKind::image_space;
  frame_.background = BackgroundKind::transparent;
  testing::aim(frame_, 25, 20);
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  for (const float ior : {0.75f, 1.0f, 1.5f, 2.4f})
    for (const float roughness : {0.0f, 0.4f}) {
      Material glass = clearGlass(ior);
      glass.perceptual_roughness = roughness;
      glass.dispersion = roughness;
      const std::string what = std::to_string(ior) + ", roughness " + std::to_string(roughness);
      testing::expectFurnaceWhite(radiance(meshScene(knotMesh(60, 12), glass), white), "knot " + what, 2e-3f);
      testing::expectFurnaceWhite(radiance(meshScene(cubeMesh(), glass), white), "cube " + what, 2e-3f);
    }
}

TEST_F(TracedBodies, AnIndexOfOneIsInvisibleAtAnyRoughness) {
  const Image nothing = inSmoothLight({});
  for (const RefractionKind kind : {RefractionKind::single, RefractionKind::image_space, RefractionKind::traced})
    for (const float roughness : {0.0f, 0.3f, 1.0f}) {
      frame_.refraction = kind;
      Material air = roughness > 0.0f ? withoutReflection(1.0f) : clearGlass(1.0f);
      air.perceptual_roughness = roughness;
      EXPECT_LT(greatestDifference(inSmoothLight(meshScene(torusMesh(48, 24), air)), nothing), 1.0 / 255.0)
          << roughness;
    }
}

// What is far away does not show that a slab shifts it.
TEST_F(TracedBodies, ASlabDoesNotTurnLight) {
  Scene slab = meshScene(cubeMesh(), withoutReflection(1.5f));
  slab.instances[0].world_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(30.0f, 30.0f, 0.3f));
  frame_.camera.orthographic_height.reset();
  frame_.camera.fov_deg = 60.0f;
  frame_.camera.distance = 0.2f;
  testing::aim(frame_, 20, 10);
  for (const RefractionKind kind : kWholeBodies) {
    frame_.refraction = kind;
    EXPECT_LT(greatestDifference(inSmoothLight(slab), inSmoothLight({})), 4e-3) << nameOf(kind);
  }
  frame_.refraction = RefractionKind::single;
  EXPECT_GT(greatestDifference(inSmoothLight(slab), inSmoothLight({})), 0.1);
}

// Nor does one that is thin, wherever the eye stands: a ray that began behind it would not leave it again.
TEST_F(TracedBodies, AThinSlabIsOneFromFarAwayToo) {
  Scene slab = meshScene(cubeMesh(), withoutReflection(1.5f));
  slab.instances[0].world_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(3.0f, 3.0f, 0.004f));
  frame_.camera.orthographic_height = 0.5f;
  testing::aim(frame_, 40, 20);
  for (const float distance : {2.0f, 2000.0f}) {
    frame_.camera.distance = distance;
    EXPECT_LT(greatestDifference(inSmoothLight(slab), inSmoothLight({})), 4e-3) << distance;
  }
}

// Each of its rays is bent twice by the same angle: in from the axis and out again, by Snell's law.
TEST_F(TracedBodies, ABallBendsLightTwiceAndInverts) {
  const float ior = 1.5f;
  for (const RefractionKind kind : kWholeBodies) {
    frame_.refraction = kind;
    const Image image = inSmoothLight(meshScene(sphereMesh(256, 512), withoutReflection(ior)));
    for (const int x : {8, 20, 31, 40, 55}) {
      const float offset = (static_cast<float>(x) + 0.5f - 32.0f) / 64.0f * 2.2f;
      const float y = 0.5f / 64.0f * 2.2f;
      const float from_axis = std::hypot(offset, y);
      const float turn = 2.0f * (std::asin(from_axis) - std::asin(from_axis / ior));
      const glm::vec3 towards_axis(-offset / from_axis, -y / from_axis, 0.0f);
      const glm::vec3 d = std::cos(turn) * glm::vec3(0, 0, -1) + std::sin(turn) * towards_axis;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(rgbAt(image, x, 31)[channel], smoothLight(d)[channel], 0.01f) << nameOf(kind) << " at " << x;
    }
  }
}

// Of a body without hollows the back faces are all that tracing to one surface finds, where the eye sees them: all that
// light from a ball's front meets. A part of the picture is the same as in the whole, although light leaves beside it.
TEST_F(TracedBodies, TheBackFacesOfABallAreWhatTracingToOneSurfaceFinds) {
  Material wine = clearGlass(1.5f);
  wine.attenuation_color = {0.9f, 0.5f, 0.25f};
  wine.attenuation_distance = 1.0f;
  wine.dispersion = 1.0f;
  const Scene ball = meshScene(sphereMesh(128, 256), wine);
  frame_.camera.orthographic_height.reset();
  frame_.camera.distance = 3.0f;
  frame_.inner_bounces = 1;
  for (const float fov_deg : {40.0f, 15.0f}) {
    frame_.camera.fov_deg = fov_deg;
    frame_.refraction = RefractionKind::traced;
    const Image traced = inSmoothLight(ball);
    frame_.refraction = RefractionKind::image_space;
    const Image seen = inSmoothLight(ball);
    // At the rim texels of the picture are farther apart on the surface than beams are wide.
    EXPECT_LT(meanDifference(seen, traced), 5e-4) << fov_deg;
    EXPECT_LT(greatestDifference(seen, traced), 0.05) << fov_deg;
  }
}

// A cube whose edge points at the eye: a ray that enters by one side meets the one beside it past the critical angle,
// if the index is above √2, and leaves by the side opposite to that by which it came.
TEST_F(TracedBodies, LightIsReflectedTotallyPastTheCriticalAngle) {
  Scene scene = meshScene(cubeMesh(), withoutReflection(1.5f));
  const glm::mat4 edge_first = glm::rotate(glm::mat4(1.0f), glm::radians(45.0f), glm::vec3(0.0f, 1.0f, 0.0f));
  scene.instances[0].world_from_object = edge_first;
  const glm::vec3 eye(0, 0, -1), right = glm::normalize(glm::vec3(1, 0, 1)),
                                 far_right = glm::normalize(glm::vec3(1, 0, -1));
  const glm::vec3 inside = formula::refractedDirection(eye, right, 1.5f);
  ASSERT_EQ(glm::refract(inside, -far_right, 1.5f), glm::vec3(0.0f));
  // Reflected at the right, it leaves by the side across from where it came in.
  const glm::vec3 reflected = glm::reflect(inside, far_right);
  const glm::vec3 out = glm::refract(reflected, right, 1.5f);
  const Image image = inSmoothLight(scene);
  const float half_diagonal = std::sqrt(2.0f / 3.0f);
  const int near_corner = static_cast<int>(32.0f + 64.0f / 2.2f * 0.9f * half_diagonal);
  EXPECT_LT(glm::distance(rgbAt(image, near_corner, 31), smoothLight(out)), 0.02f);
}

TEST_F(TracedBodies, LightIsAbsorbedByTheLengthOfItsWay) {
  Material wine = withoutReflection(1.2f);
  wine.attenuation_color = {0.9f, 0.5f, 0.25f};
  wine.attenuation_distance = 0.4f;
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  const glm::vec3 expected = glm::pow(wine.attenuation_color, glm::vec3(2.0f / std::sqrt(3.0f) / 0.4f));
  for (const RefractionKind kind : kWholeBodies) {
    frame_.refraction = kind;
    const Image image = radiance(meshScene(cubeMesh(), wine), white);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(rgbAt(image, 32, 32)[channel], expected[channel], 2e-3f) << nameOf(kind);
  }
}

// Two slabs one behind the other: light that has left the first enters the second, as long as surfaces are counted.
TEST_F(TracedBodies, LightThatHasLeftMeetsAnotherBody) {
  Material red = withoutReflection(1.5f);
  red.attenuation_color = {0.8f, 0.3f, 0.1f};
  Scene slabs = meshScene(cubeMesh(), withoutReflection(1.5f));
  red.attenuation_distance = 0.25f * 2.0f * glm::abs(slabs.meshes[0]->vertices[0].position.z);
  add(slabs, cubeMesh(), red);
  const auto slabAt = [](float z) {
    return glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, z)), glm::vec3(1.0f, 1.0f, 0.25f));
  };
  slabs.instances[0].world_from_object = slabAt(0.6f);
  slabs.instances[1].world_from_object = slabAt(-0.6f);
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 16);
  for (const auto& [surfaces, expected] :
       {std::pair(1, glm::vec3(1.0f)), std::pair(2, glm::vec3(1.0f)), std::pair(3, red.attenuation_color)}) {
    frame_.inner_bounces = surfaces;
    const Image image = radiance(slabs, white);
    EXPECT_LT(glm::length(rgbAt(image, 32, 32) - expected), 2e-3f) << surfaces;
  }
}

// A glass ball behind a slab, and between the two a cube that is not of glass.
TEST_F(TracedBodies, WhatIsBetweenBodiesHidesThoseBehind) {
  Scene scene = meshScene(cubeMesh(), withoutReflection(1.5f));
  scene.instances[0].world_from_object =
      glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 1.2f)), glm::vec3(1.0f, 1.0f, 0.1f));
  Material lamp;
  lamp.unlit = true;
  lamp.base_color = {0.0f, 0.5f, 0.0f};
  Scene hidden = scene;
  add(hidden, cubeMesh(), lamp, glm::vec3(0.0f), 0.3f);
  add(hidden, sphereMesh(24, 48), clearGlass(1.5f), glm::vec3(0.0f, 0.0f, -1.5f), 0.5f);
  frame_.behind = BehindKind::screen;
  frame_.inner_bounces = 8;
  const glm::vec3 seen = rgbAt(inSmoothLight(hidden), 32, 32);
  EXPECT_LT(glm::length(seen - lamp.base_color), 0.02f) << seen.x << " " << seen.y << " " << seen.z;
}

TEST_F(TracedBodies, WhatHasTheIndexOfItsSurroundingsIsNotSeenInThem) {
  const Material glass = clearGlass(1.5f);
  const Scene whole = meshScene(sphereMesh(64, 128), glass);
  Scene nested = whole;
  add(nested, torusMesh(48, 24), glass, glm::vec3(0.1f, 0.1f, 0.0f), 0.5f);
  frame_.inner_bounces = 8;
  const Image expected = inSmoothLight(whole), image = inSmoothLight(nested);
  // Rays that use the two more surfaces up end elsewhere: the last of their light is a hundredth.
  EXPECT_LT(greatestDifference(image, expected), 0.02);
  nested.materials[1].ior = 1.0f;
  EXPECT_GT(greatestDifference(inSmoothLight(nested), expected), 0.2) << "a bubble is seen";
}

// Water that reaches into the wall of its glass is what the glass leaves of it.
TEST_F(TracedBodies, ThePriorityOfBodiesDecides) {
  const Scene alone = meshScene(sphereMesh(64, 128), clearGlass(1.5f));
  Scene both = alone;
  add(both, cubeMesh(), clearGlass(1.2f), glm::vec3(0.0f), 0.6f);
  both.materials[0].priority = 1;
  EXPECT_LT(greatestDifference(inSmoothLight(both), inSmoothLight(alone)), 1e-3) << "the ball fills it all";
  both.materials[0].priority = -1;
  EXPECT_GT(greatestDifference(inSmoothLight(both), inSmoothLight(alone)), 0.1);
}

// An open mesh, one whose triangles are turned inside out, one of no area: all is finite.
TEST_F(TracedBodies, MeshesThatAreNotBodiesGiveSanePictures) {
  Mesh open = sphereMesh(24, 48);
  open.indices.resize(open.indices.size() / 2 / 3 * 3);
  Mesh inside_out = torusMesh(24, 12);
  for (std::size_t i = 0; i + 2 < inside_out.indices.size(); i += 3)
    std::swap(inside_out.indices[i], inside_out.indices[i + 1]);
  Mesh point = sphereMesh(8, 16);
  for (Vertex& vertex : point.vertices) vertex.position = glm::vec3(0.0f);
  testing::aim(frame_, 20, 35);
  for (const RefractionKind kind : kWholeBodies)
    for (const Mesh& mesh : {open, inside_out, point, planeMesh()}) {
      frame_.refraction = kind;
      Material glass = clearGlass(1.5f);
      glass.double_sided = true;
      const Image image = inSmoothLight(meshScene(mesh, glass));
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          for (int channel = 0; channel < 3; ++channel) {
            ASSERT_GE(image.texel(x, y)[channel], 0.0f) << nameOf(kind);
            ASSERT_LE(image.texel(x, y)[channel], 2.5f) << nameOf(kind);
          }
    }
}

// Two ways in one frame, whose pictures of bodies and of back faces take one texture unit in turns.
TEST_F(TracedBodies, FewTrianglesAreTracedAndManyByTheirBackFaces) {
  Scene scene = meshScene(brilliantMesh(), clearGlass(2.4f));
  scene.instances[0].world_from_object = glm::translate(glm::mat4(1.0f), glm::vec3(-1.2f, 0.0f, 0.0f));
  add(scene, sphereMesh(48, 96), clearGlass(1.5f), glm::vec3(1.2f, 0.0f, 0.0f));
  frame_.camera.orthographic_height = 4.6f;
  const auto drawn = [&](RefractionKind kind) {
    frame_.refraction = kind;
    return inSmoothLight(scene);
  };
  const Image both = drawn(RefractionKind::automatic);
  const Image traced = drawn(RefractionKind::traced);
  const Image by_back_faces = drawn(RefractionKind::image_space);
  double of_left = 0.0, of_right = 0.0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const Image& expected = x < 32 ? traced : by_back_faces;
      const Image& other = x < 32 ? by_back_faces : traced;
      EXPECT_EQ(rgbAt(both, x, y), rgbAt(expected, x, y)) << x << ", " << y;
      (x < 32 ? of_left : of_right) += double(glm::distance(rgbAt(both, x, y), rgbAt(other, x, y)));
    }
  EXPECT_GT(of_left, 1.0) << "the two ways look alike: nothing was told apart";
  EXPECT_GT(of_right, 1.0);
}

TEST(BodiesInBothApis, AreTheSamePicture) {
  for (const RefractionKind kind : kWholeBodies) {
    Image pictures[2];
    for (const gl::Api api : {gl::Api::desktop43, gl::Api::es30}) {
      MIRRORBALL_NEEDS_GL(context, api);
      const Environment environment(smoothLight, 128);
      auto renderer = testing::rendererOf(meshScene(torusMesh(96, 48), clearGlass(1.5f)), environment,
                                          *testing::prepareOnce(environment));
      ASSERT_TRUE(renderer) << renderer.error().message;
      FrameSettings frame;
      frame.size = {64, 48};
      frame.samples = 1;
      frame.refraction = kind;
      pictures[api == gl::Api::es30] = *renderer->renderRadiance(frame);
    }
    ASSERT_FALSE(pictures[0].empty());
    EXPECT_LT(meanDifference(pictures[0], pictures[1]), 1e-3) << nameOf(kind);
  }
}

}  // namespace
}  // namespace mirrorball
