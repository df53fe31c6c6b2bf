// Bumps of heights, by normals in tangent or object space, and by slopes: the same surface in the same light.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "formula/surface.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/bumpy_pair_testing.h"

namespace mirrorball {
namespace {

using testing::BumpForm;

constexpr glm::ivec2 kHillsSize_px{192, 96};  // three pixels for two texels of the hills

Material bumpyMirror() { return *materialNamed("mirror"); }

/// Light whose colour tells its direction.
Environment compass() {
  return Environment([](glm::vec3 d) { return (1.0f + d) / 2.0f; }, 128);
}

/// The compass as a mirror of that normal shows it, seen from +Z.
glm::vec3 mirrored(glm::vec3 n) { return (1.0f + glm::reflect(glm::vec3(0, 0, -1), n)) / 2.0f; }

/// How far pixels are from their mean.
float scatterOf(const Image& image) {
  glm::vec3 sum(0.0f);
  float squares = 0.0f;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3 shown = rgbAt(image, x, y);
      sum += shown;
      squares += glm::dot(shown, shown);
    }
  const float count = static_cast<float>(image.width() * image.height());
  return std::sqrt(std::max(squares / count - glm::dot(sum, sum) / (count * count), 0.0f));
}

class BumpMapsTest : public gl::GlTest {
 protected:
  /// Of a scene that fills the picture, seen from +Z in parallel projection.
  static Image drawn(Scene scene, FrameSettings settings = {}, const Environment& environment = compass()) {
    settings.size = kHillsSize_px;
    settings.samples = 1;
    settings.background = BackgroundKind::transparent;
    testing::aim(settings, 0.0f, 0.0f);
    settings.camera.target = glm::vec3(0.0f);
    settings.camera.orthographic_height = 1.0f / boundingSphere(scene).radius;
    auto renderer = testing::rendererOf(std::move(scene), environment, *testing::prepareOnce(environment));
    EXPECT_TRUE(renderer);
    auto image = renderer->renderRadiance(settings);
    EXPECT_TRUE(image) << image.error().message;
    return std::move(*image);
  }

  static glm::vec2 placeOf(int x, int y) {
    return {(static_cast<float>(x) + 0.5f) / 96.0f - 1.0f, 0.5f - (static_cast<float>(y) + 0.5f) / 96.0f};
  }

  static glm::vec3 middle(const Image& image) { return rgbAt(image, image.width() / 4, image.height() / 2); }
};
MIRRORBALL_WITH_BOTH_APIS(BumpMapsTest);

// Left and right of the middle the texture is mirrored.
TEST_P(BumpMapsTest, HeightsNormalsAndSlopesShowTheSameHills) {
  for (const BumpForm form : testing::kEveryBumpForm) {
    const Image image = drawn(testing::bumpyPair(form, bumpyMirror()));
    float farthest = 0.0f;
    for (int y = 1; y < image.height() - 1; ++y)
      for (int x = 1; x < image.width() - 1; ++x)
        farthest =
            std::max(farthest, glm::distance(rgbAt(image, x, y), mirrored(testing::normalOfPair(placeOf(x, y)))));
    EXPECT_LT(farthest, 2.0f * testing::toleranceOf(form)) << testing::nameOf(form);
  }
}

// What is as gentle as the bowl of a mirror that people look into: 8 bits, with steps of half a degree, would show.
TEST_P(BumpMapsTest, FineNormalMapsReflectWithinATwentiethOfADegree) {
  constexpr float kTilt = 0.0192f;  // 1.1 degrees
  constexpr float kGain = 10.0f;    // of light about +Z, so that half floats tell directions finely
  const Environment slope(
      [](glm::vec3 d) { return glm::vec3(0.5f + kGain * glm::vec2(d) / std::max(d.z, 0.5f), 0.5f); }, 128);
  const auto normalAt = [](glm::vec2 uv) {
    const glm::vec2 angle = glm::two_pi<float>() * uv;
    return glm::normalize(glm::vec3(kTilt * std::sin(angle.x), kTilt * std::cos(angle.y), 1.0f));
  };
  for (const float zero : {0.0f, 127.5f}) {
    Image numbers(64, 64, 4, 1.0f);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const glm::vec3 stored = formula::encodedNormal(normalAt((glm::vec2(x, y) + 0.5f) / 64.0f), zero);
        for (int channel = 0; channel < 3; ++channel) numbers.texel(x, y)[channel] = stored[channel];
      }
    Material material = bumpyMirror();
    material.normal_zero = zero;
    Scene scene = meshScene(testing::mirroredPair(), material);
    scene.textures.push_back({.image = std::move(numbers)});
    scene.materials[0].normal_map.texture = 0;
    const Image image = drawn(std::move(scene), {}, slope);
    std::vector<float> degrees;
    for (int y = 1; y < image.height() - 1; ++y)
      for (int x = 1; x < image.width() / 2 - 1; ++x) {
        const glm::vec3 n = normalAt(testing::uvOfPair(placeOf(x, y)));
        const glm::vec3 right = glm::reflect(glm::vec3(0, 0, -1), glm::vec3(n.x, n.y, n.z));
        const glm::vec2 shown = (glm::vec2(rgbAt(image, x, y)) - 0.5f) / kGain;
        degrees.push_back(glm::degrees(glm::distance(shown, glm::vec2(right) / right.z)));
      }
    std::sort(degrees.begin(), degrees.end());
    EXPECT_LT(degrees[degrees.size() / 2], 0.02f) << zero;
    EXPECT_LT(degrees.back(), 0.05f) << zero;
  }
}

// As is written beside the charts of a map: the surface keeps its normal there.
TEST_P(BumpMapsTest, ATexelWithoutADirectionChangesNothing) {
  for (const bool has_floats : {false, true}) {
    Material material = bumpyMirror();
    material.normal_zero = has_floats ? 0.0f : 128.0f;
    Scene scene = meshScene(testing::mirroredPair(), material);
    if (has_floats)
      scene.textures.push_back({.image = Image(4, 4, 4, 0.0f)});
    else
      scene.textures.push_back({.image = Image8(4, 4, 4, 128)});
    scene.materials[0].normal_map.texture = 0;
    EXPECT_LT(glm::distance(middle(drawn(std::move(scene))), mirrored({0, 0, 1})), 2e-3f) << has_floats;
  }
}

// The picture is its own mirror image, and so is the compass, but for red.
TEST_P(BumpMapsTest, MirroredCoordinatesShadeWithoutASeam) {
  for (const BumpForm form : testing::kEveryBumpForm) {
    const Image image = drawn(testing::bumpyPair(form, bumpyMirror()));
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width() / 2; ++x) {
        const glm::vec3 left = rgbAt(image, x, y);
        const glm::vec3 right = rgbAt(image, image.width() - 1 - x, y);
        ASSERT_LT(glm::distance(glm::vec3(1.0f - left.x, left.y, left.z), right), 3e-3f)
            << testing::nameOf(form) << " at (" << x << ", " << y << ")";
      }
  }
}

TEST_P(BumpMapsTest, SlopesAreScaledAndTurnedOver) {
  const auto shown = [&](float scale, float slope) {
    Material material = bumpyMirror();
    material.slope_texture = 0;
    material.derivative_scale = scale;
    Scene scene = meshScene(testing::mirroredPair(), material);
    scene.slope_textures.push_back(Image(1, 1, 3));
    scene.slope_textures[0].edit().texel(0, 0)[0] = slope;
    return middle(drawn(std::move(scene)));
  };
  const auto expectNear = [](glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::distance(a, b), 2e-3f); };
  expectNear(shown(1.0f, 0.75f), mirrored({-0.6f, 0.0f, 0.8f}));
  expectNear(shown(-1.0f, 0.75f), mirrored({0.6f, 0.0f, 0.8f}));
  expectNear(shown(0.5f, 1.5f), mirrored({-0.6f, 0.0f, 0.8f}));
  expectNear(shown(0.0f, 1e4f), mirrored({0.0f, 0.0f, 1.0f}));
  expectNear(shown(1.0f, 0.0f), mirrored({0.0f, 0.0f, 1.0f}));
}

// Far away, what a pixel averages away makes the mirror rough: it does not sparkle.
TEST_P(BumpMapsTest, SlopesThatAPixelAveragesAwayBlur) {
  Material material = bumpyMirror();
  material.slope_texture = 0;
  Scene scene = meshScene(testing::mirroredPair(), material);
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] *= 64.0f;
  scene.slope_textures.push_back(*derivativesFromHeights(testing::hills(), {.scale = 0.5f}));
  const Image image = drawn(scene);
  EXPECT_LT(middle(image).z, mirrored({0.0f, 0.0f, 1.0f}).z - 0.05f);
  EXPECT_LT(scatterOf(image), 0.25f * scatterOf(drawn(scene, {.texture_filter = TextureFilter::bilinear})));
}

TEST_P(BumpMapsTest, AnObjectSpaceMapTurnsWithItsInstance) {
  const auto shown = [&](const glm::mat4& world_from_object, float scale) {
    Material material = bumpyMirror();
    material.normal_map.texture = 0;
    material.normal_space = NormalSpace::object;
    material.normal_scale = scale;
    Scene scene = meshScene(testing::mirroredPair(), material);
    Image normals(1, 1, 3);
    normals.texel(0, 0)[0] = 0.6f;
    normals.texel(0, 0)[2] = 0.8f;
    scene.textures.push_back(testing::textureOfNormals(normals));
    scene.instances[0].world_from_object = world_from_object;
    return rgbAt(drawn(std::move(scene)), kHillsSize_px.x / 2, kHillsSize_px.y / 2);
  };
  const auto expectNear = [](glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::distance(a, b), 0.012f); };
  const glm::mat4 still(1.0f);
  expectNear(shown(still, 1.0f), mirrored({0.6f, 0.0f, 0.8f}));
  expectNear(shown(still, 0.0f), mirrored({0.0f, 0.0f, 1.0f}));
  const glm::mat4 quarter = glm::rotate(still, glm::half_pi<float>(), glm::vec3(0, 0, 1));
  expectNear(shown(quarter, 1.0f), mirrored({0.0f, 0.6f, 0.8f}));
  // Twice as wide: a normal leans half as far.
  const glm::mat4 wide = glm::scale(still, glm::vec3(2.0f, 1.0f, 1.0f));
  expectNear(shown(wide, 1.0f), mirrored(glm::normalize(glm::vec3(0.3f, 0.0f, 0.8f))));
}

TEST_P(BumpMapsTest, HillsOfEveryFormAreWhiteInTheFurnace) {
  const Environment white([](glm::vec3) { return glm::vec3(1.0f); }, 8);
  Material metal = bumpyMirror();
  metal.perceptual_roughness = 0.4f;
  for (const BumpForm form : testing::kEveryBumpForm)
    testing::expectFurnaceWhite(drawn(testing::bumpyPair(form, metal), {}, white), testing::nameOf(form), 2e-3f);
}

// Without coordinates there is no direction along which a slope could be told.
TEST_P(BumpMapsTest, SlopesOnAMeshWithoutCoordinatesLeaveItSmooth) {
  Scene scene = testing::bumpyPair(BumpForm::derivative_map, bumpyMirror());
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] = glm::vec2(0.0f);
  EXPECT_LT(glm::distance(middle(drawn(std::move(scene))), mirrored({0.0f, 0.0f, 1.0f})), 2e-3f);
}

// Heights come first, and where they are not shown the slopes do.
TEST_P(BumpMapsTest, SlopesGiveWayToHeights) {
  Scene both = testing::bumpyPair(BumpForm::heights, bumpyMirror());
  both.materials[0].slope_texture = 0;
  both.slope_textures.push_back(Image(1, 1, 3));
  both.slope_textures[0].edit().texel(0, 0)[0] = 0.75f;
  const glm::vec3 of_heights = middle(drawn(testing::bumpyPair(BumpForm::heights, bumpyMirror())));
  EXPECT_LT(glm::distance(middle(drawn(both)), of_heights), 1e-5f);
  FrameSettings settings;
  settings.relief = ReliefKind::none;
  EXPECT_LT(glm::distance(middle(drawn(both, settings)), mirrored({-0.6f, 0.0f, 0.8f})), 2e-3f);
}

}  // namespace
}  // namespace mirrorball
