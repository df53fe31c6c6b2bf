// What generated texture coordinates show: the properties that OpenGL's modes and matrices have.

#include "mirrorball/render/surface/texture_coordinates.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

constexpr int kSide = 48;  ///< pixels of a picture's height and width

/// As bright as its direction: smooth, and different everywhere.
Environment coordinateCompass() {
  return Environment([](glm::vec3 d) { return d * 0.5f + 0.5f; }, 128);
}

Scene mirrorSphere() { return meshScene(sphereMesh(64, 128), *materialNamed("mirror")); }

/// White without reflection: in white light it shows its base colour. Its picture is red to the right, green upwards.
Scene chalkWithPicture(Mesh mesh) {
  Material chalk;
  chalk.base_color = glm::vec3(1.0f);
  chalk.specular = 0.0f;
  chalk.base_color_map.texture = 0;
  Scene scene = meshScene(std::move(mesh), chalk);
  constexpr int kTexels = 256;
  Texture texture{.image = Image8(kTexels, kTexels, 4, 255)};
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x) {
      texture.image.edit().texel(x, y)[0] = static_cast<std::uint8_t>(x);
      texture.image.edit().texel(x, y)[1] = static_cast<std::uint8_t>(kTexels - 1 - y);
      texture.image.edit().texel(x, y)[2] = 0;
    }
  scene.textures.push_back(std::move(texture));
  return scene;
}

FrameSettings orthographic(float azimuth_deg = 0.0f, float elevation_deg = 0.0f) {
  FrameSettings frame;
  frame.size = {kSide, kSide};
  frame.samples = 1;
  frame.camera.orthographic_height = 2.0f;
  frame.camera.distance = 4.0f;
  frame.camera.target = glm::vec3(0.0f);
  frame.background = BackgroundKind::transparent;
  testing::aim(frame, azimuth_deg, elevation_deg);
  return frame;
}

/// Greatest difference of two pictures, where the unit sphere fills them and is not seen at too grazing an angle.
float greatestDifference(const Image& a, const Image& b) {
  float greatest = 0.0f;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec2 p = (glm::vec2(x, y) + 0.5f) * 2.0f / float(kSide) - 1.0f;
      if (glm::dot(p, p) > 0.8f) continue;
      const glm::vec3 difference = glm::abs(rgbAt(a, x, y) - rgbAt(b, x, y));
      greatest = std::max({greatest, difference.x, difference.y, difference.z});
    }
  return greatest;
}

/// The sphere's point in a pixel of an orthographic picture, from the camera's side.
glm::vec3 pointAt(int x, int y) {
  const glm::vec2 p((float(x) + 0.5f) * 2.0f / float(kSide) - 1.0f, 1.0f - (float(y) + 0.5f) * 2.0f / float(kSide));
  return {p, std::sqrt(std::max(1.0f - glm::dot(p, p), 0.0f))};
}

class TexgenTest : public gl::GlTest {
 protected:
  Image drawn(const Scene& scene, const FrameSettings& frame, const Environment& environment = coordinateCompass()) {
    auto renderer = testing::rendererOf(scene, environment, *testing::prepareOnce(environment));
    if (!renderer) return {};
    auto image = renderer->renderRadiance(frame);
    EXPECT_TRUE(image) << image.error().message;
    return image ? std::move(*image) : Image();
  }
};

MIRRORBALL_WITH_BOTH_APIS(TexgenTest);

constexpr float kSame = 2e-3f;     ///< half floats, and another order of multiplications
constexpr float kFacets = 0.015f;  ///< a sphere of flat triangles, or a sphere map's texels

TEST_P(TexgenTest, SphereIsTheSphereMappingWhereRaysAreParallelAndTheReflectionEverywhere) {
  FrameSettings frame = orthographic(40.0f, 20.0f);
  frame.texgen = Texgen::sphere;
  const Image generated = drawn(mirrorSphere(), frame);
  frame.texgen = Texgen::none;
  frame.mapping = Mapping::sphere;
  EXPECT_LT(greatestDifference(generated, drawn(mirrorSphere(), frame)), kFacets);

  FrameSettings near = orthographic(40.0f, 20.0f);
  near.camera.orthographic_height.reset();
  near.camera.fov_deg = 60.0f;
  near.camera.distance = 2.0f;
  const Image reflected = drawn(mirrorSphere(), near);
  near.texgen = Texgen::sphere;
  EXPECT_LT(greatestDifference(drawn(mirrorSphere(), near), reflected), kFacets);
  near.texgen = Texgen::none;
  near.mapping = Mapping::sphere;
  EXPECT_GT(greatestDifference(drawn(mirrorSphere(), near), reflected), 0.1f) << "by the normal it is not";
}

TEST_P(TexgenTest, ReflectionAndNormalAreTheMappings) {
  FrameSettings frame = orthographic(-70.0f, 30.0f);
  frame.env_rotation_deg = {50.0f, 10.0f, 0.0f};
  for (const auto& [texgen, mapping] :
       {std::pair(Texgen::reflection, Mapping::reflection), std::pair(Texgen::normal, Mapping::normal)}) {
    frame.texgen = texgen;
    frame.mapping = Mapping::reflection;
    const Image generated = drawn(mirrorSphere(), frame);
    frame.texgen = Texgen::none;
    frame.mapping = mapping;
    EXPECT_EQ(greatestDifference(generated, drawn(mirrorSphere(), frame)), 0.0f);
  }
}

// The environment is wrapped around the object: each point shows the light of its own direction.
TEST_P(TexgenTest, ObjectLinearTurnsWithTheObjectAndEyeLinearStaysInTheEyesFrame) {
  Scene scene = mirrorSphere();
  for (const float turn_deg : {0.0f, 75.0f}) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(turn_deg), glm::vec3(0, 1, 0));
    scene.instances[0].world_from_object = turn;
    FrameSettings frame = orthographic();
    frame.env_rotation_deg.x = 3.0f * turn_deg;  // of no effect on either
    frame.texgen = Texgen::object_linear;
    const Image object = drawn(scene, frame);
    frame.texgen = Texgen::eye_linear;
    const Image eye = drawn(scene, frame);
    for (const int x : {8, 24, 39})
      for (const int y : {12, 24, 36}) {
        const glm::vec3 world = pointAt(x, y);
        const glm::vec3 own = glm::transpose(glm::mat3(turn)) * world;
        const glm::vec3 before_eye = glm::normalize(world - glm::vec3(0.0f, 0.0f, 4.0f));
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(rgbAt(object, x, y)[i], own[i] * 0.5f + 0.5f, kFacets) << x << ", " << y << ": " << turn_deg;
          EXPECT_NEAR(rgbAt(eye, x, y)[i], before_eye[i] * 0.5f + 0.5f, kFacets) << x << ", " << y;
        }
      }
  }
  // Another eye sees the same before it.
  FrameSettings frame = orthographic();
  frame.texgen = Texgen::eye_linear;
  const Image here = drawn(mirrorSphere(), frame);
  testing::aim(frame, 140.0f, 35.0f);
  EXPECT_LT(greatestDifference(here, drawn(mirrorSphere(), frame)), kFacets);
}

// The picture of a model that turns in a room, drawn as a camera that turns around it (turned()).
TEST_P(TexgenTest, ATextureMatrixThatTurnsIsATurnedEnvironmentAlsoOnATurningObject) {
  for (const Texgen texgen : {Texgen::none, Texgen::reflection, Texgen::normal}) {
    FrameSettings by_option = orthographic(20.0f, 25.0f);
    by_option.texgen = texgen;
    FrameSettings by_matrix = by_option;
    by_option.env_rotation_deg = {65.0f, 30.0f, -15.0f};
    by_matrix.texture_matrix = glm::mat4(by_option.environmentFromWorld());
    for (const float angle_deg : {0.0f, 130.0f}) {
      const Image expected = drawn(mirrorSphere(), turned(by_option, Turn::model, angle_deg, {}));
      const Image found = drawn(mirrorSphere(), turned(by_matrix, Turn::model, angle_deg, {}));
      EXPECT_LT(greatestDifference(expected, found), kSame) << int(texgen) << " at " << angle_deg;
    }
  }
}

// The lecture's sphere map of a picture: normals are the texture coordinates, the matrix scales them to [0, 1].
TEST_P(TexgenTest, NormalsTimesTheLecturesMatrixAreASphereMapsCoordinates) {
  FrameSettings frame = orthographic(110.0f, -20.0f);
  frame.texgen = Texgen::normal;
  frame.texture_matrix = glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(1.0f));
  const Environment white = *builtinEnvironment("white");
  const Scene sphere = chalkWithPicture(sphereMesh(64, 128));
  const Image by_normal = drawn(sphere, frame, white);
  frame.texgen = Texgen::sphere;
  frame.texture_matrix = glm::mat4(1.0f);
  const Image by_ball = drawn(sphere, frame, white);
  EXPECT_LT(greatestDifference(by_normal, by_ball), kFacets) << "of an orthographic ball";
  for (const int x : {10, 24, 37}) {
    const glm::vec3 p = pointAt(x, 20);
    EXPECT_NEAR(rgbAt(by_normal, x, 20).x, p.x * 0.5f + 0.5f, kFacets);
    EXPECT_NEAR(rgbAt(by_normal, x, 20).y, p.y * 0.5f + 0.5f, kFacets);
  }
}

// White chalk in white light shows its picture, as a surface without light does.
TEST_P(TexgenTest, AnUnlitSurfaceTakesTheSameCoordinates) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 8);
  Scene chalk = chalkWithPicture(sphereMesh(64, 128));
  Scene unlit = chalk;
  unlit.materials[0].unlit = true;
  for (const Texgen texgen : {Texgen::none, Texgen::object_linear, Texgen::eye_linear, Texgen::normal})
    for (const ReflectAt reflect_at : {ReflectAt::fragment, ReflectAt::vertex}) {
      FrameSettings frame = orthographic(20.0f, 10.0f);
      frame.texgen = texgen;
      frame.reflect_at = reflect_at;
      frame.texture_matrix[3][0] = 0.125f;
      EXPECT_LT(greatestDifference(drawn(unlit, frame, white), drawn(chalk, frame, white)), kSame)
          << static_cast<int>(texgen);
    }
}

TEST_P(TexgenTest, CoordinatesAreDividedByQ) {
  const Environment white = *builtinEnvironment("white");
  const Scene sphere = chalkWithPicture(sphereMesh(64, 128));
  for (const Texgen texgen : {Texgen::none, Texgen::object_linear}) {
    FrameSettings frame = orthographic();
    frame.texgen = texgen;
    frame.texture_matrix = glm::scale(glm::mat4(1.0f), glm::vec3(0.25f));
    const Image scaled = drawn(sphere, frame, white);
    frame.texture_matrix = glm::mat4(1.0f);
    frame.texture_matrix[3][3] = 4.0f;
    EXPECT_LT(greatestDifference(scaled, drawn(sphere, frame, white)), kSame);
    frame.texture_matrix[3][3] = 1.0f;
    EXPECT_GT(greatestDifference(scaled, drawn(sphere, frame, white)), 0.1f);
  }
}

// A square of side √2 in the plane y = 0, lit from above at the height 2: the picture just covers the sphere around it,
// so that its edges are 1 / √(1 − ¼) = 1.1547 from the middle there.
TEST_P(TexgenTest, ALightProjectsThePictureOnceAndForwardsOnly) {
  const Environment white = *builtinEnvironment("white");
  Scene plane = chalkWithPicture(planeMesh());
  FrameSettings frame = orthographic(0.0f, 90.0f);
  frame.texgen = Texgen::light;
  frame.lights = {{glm::vec3(0.0f, 2.0f, 0.0f), glm::vec3(0.0f)}};
  const Image lit = drawn(plane, frame, white);
  for (const int x : {12, 24, 35}) {
    const glm::vec3 p = pointAt(x, 18);  // world: (x, 0, −y)
    EXPECT_NEAR(rgbAt(lit, x, 18).x, 0.5f + p.x / 1.1547f / 2.0f, 0.01f);
    EXPECT_NEAR(rgbAt(lit, x, 18).y, 0.5f + p.y / 1.1547f / 2.0f, 0.01f);
  }
  frame.texture_matrix = glm::translate(glm::mat4(1.0f), glm::vec3(0.6f, 0.0f, 0.0f));  // times q
  const Image moved = drawn(plane, frame, white);
  EXPECT_NEAR(rgbAt(moved, 10, 18).z, 0.0f, 0.01f) << "the picture, which has no blue";
  EXPECT_NEAR(rgbAt(moved, 24, 18).z, 1.0f, 0.01f) << "beside it the base colour";
  frame.texture_matrix = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f));
  frame.texture_matrix[3][3] = -1.0f;  // the same place in the picture, behind the projector
  EXPECT_NEAR(rgbAt(drawn(plane, frame, white), 24, 18).z, 1.0f, 0.01f);
}

// "For a vertex v": what is interpolated over coarse triangles differs, the less the finer they are.
TEST_P(TexgenTest, AtTheVerticesItDiffersTheMoreTheCoarserTheMesh) {
  const auto differenceOf = [&](int rings, FrameSettings frame) {
    const Scene sphere = meshScene(sphereMesh(rings, 2 * rings), *materialNamed("mirror"));
    const Image at_fragments = drawn(sphere, frame);
    frame.reflect_at = ReflectAt::vertex;
    return greatestDifference(at_fragments, drawn(sphere, frame));
  };
  FrameSettings frame = orthographic(15.0f, 10.0f);
  for (const Mapping mapping : {Mapping::reflection, Mapping::sphere}) {
    frame.mapping = mapping;
    // On a sphere map an interpolated normal, which is shorter, lies nearer to the middle.
    const float coarse = differenceOf(6, frame), fine = differenceOf(48, frame);
    EXPECT_GT(coarse, 0.02f) << int(mapping);
    EXPECT_LT(fine, 0.25f * coarse) << int(mapping);
  }
  frame.mapping = Mapping::normal;
  EXPECT_LT(differenceOf(6, frame), kSame) << "a direction may have any length";
  frame.texgen = Texgen::object_linear;
  EXPECT_LT(differenceOf(6, frame), kSame) << "what is linear is the same";
}

TEST(TextureCoordinates, FromALightNeedALight) {
  FrameSettings frame;
  frame.texgen = Texgen::light;
  const auto matrices = coordinateMatrices({}, {}, {}, frame);
  ASSERT_FALSE(matrices);
  EXPECT_THAT(matrices.error().message, HasSubstr("need a light"));
}

TEST(TextureCoordinates, AMatrixMayNotTakeAllOfThem) {
  FrameSettings frame;
  frame.texture_matrix = glm::mat4(0.0f);
  EXPECT_THAT(coordinateMatrices({}, {}, {}, frame).error().message, HasSubstr("q 0 everywhere"));
  frame.texture_matrix[3][3] = 1.0f;
  EXPECT_THAT(coordinateMatrices({}, {}, {}, frame).error().message, HasSubstr("no direction"));
  EXPECT_TRUE(coordinateMatrices(chalkWithPicture(planeMesh()), {}, {}, frame)) << "one texel of a picture";
}

// A light in the middle of the scene, above it and within it: the matrix is finite.
TEST(TextureCoordinates, AProjectorMayBeAnywhere) {
  const Scene scene = chalkWithPicture(planeMesh());
  for (const glm::vec3 place : {glm::vec3(0.0f), glm::vec3(0, 1e6f, 0), glm::vec3(0, -3, 0), glm::vec3(0.1f, 0, 0)}) {
    FrameSettings frame;
    frame.texgen = Texgen::light;
    frame.lights = {{place, glm::vec3(1.0f)}};
    const auto matrices = coordinateMatrices(scene, {}, {}, frame);
    ASSERT_TRUE(matrices);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(matrices->picture[column][row]));
  }
}

TEST(TextureCoordinates, WrapPicturesWhereThereAreAny) {
  FrameSettings frame;
  frame.texgen = Texgen::normal;
  frame.mapping = Mapping::sphere;
  const CoordinateChoice environment = coordinateChoice(mirrorSphere(), frame);
  EXPECT_EQ(environment.look_up, Generated::normal);
  EXPECT_FALSE(environment.is_sphere_map) << "texgen takes the place of mapping";
  const CoordinateChoice picture = coordinateChoice(chalkWithPicture(planeMesh()), frame);
  EXPECT_TRUE(picture.is_sphere_map);
  EXPECT_EQ(picture.picture_from, PictureFrom::generated);
  EXPECT_EQ(picture.picture, Generated::normal);
}

}  // namespace
}  // namespace mirrorball
