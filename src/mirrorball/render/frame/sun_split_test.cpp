// Suns that stand apart from the map: FrameSettings::sun.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/light_edit/light_edit_testing.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball {
namespace {

using testing::addBall;
using testing::drawn;

const glm::vec3 kTowards = glm::normalize(glm::vec3(0.6f, 0.0f, 0.8f));
constexpr float kSky = 0.1f;
constexpr int kSide = 64;
constexpr int kRows = 32;
constexpr float kSunRadiance = 2e4f;

/// A dim even sky with a sun to the right of the eye and before it.
const Environment& sunnySky() {
  static const Environment sky(testing::mapOfSuns(
      {{kTowards, 1.2f, glm::vec3(kSunRadiance)}}, [](glm::vec3) { return glm::vec3(kSky); }, Projection::equirect,
      256));
  return sky;
}

Material matt() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.specular = 0.0f;
  material.perceptual_roughness = 1.0f;
  return material;
}

Material metal(float perceptual_roughness) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

Scene ballOf(const Material& material) {
  Scene scene;
  addBall(scene, glm::vec3(0.0f), 1.0f, material, kRows);
  return scene;
}

bool areSame(const Image& a, const Image& b) { return std::ranges::equal(a.samples(), b.samples()); }

class SunSplitFrame : public gl::GlTest {
 protected:
  /// From +Z, 2.4 world units wide.
  static FrameSettings frameOf(const Renderer& renderer, SunKind sun) {
    FrameSettings frame = testing::frontOf(renderer, kSide, 2.4f);
    frame.samples = 16;  // a mirror shows the sun in a few pixels
    frame.sun = sun;
    frame.background = BackgroundKind::transparent;
    return frame;
  }

  using Change = std::function<void(FrameSettings&)>;
  static Image imageOf(Scene scene, SunKind sun, const Change& change = {}) {
    Renderer renderer = testing::rendererFor(std::move(scene), sunnySky(), sun);
    FrameSettings frame = frameOf(renderer, sun);
    if (change) change(frame);
    return drawn(renderer, frame);
  }

  /// The light of a place that is seen.
  static float at(const Image& image, glm::vec2 place) {
    const glm::ivec2 pixel(glm::floor((0.5f + glm::vec2(place.x, -place.y) / 2.4f) * float(kSide)));
    return rgbaAt(image, pixel.x, pixel.y).y;
  }

  static float meanOf(const Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) sum += double(rgbaAt(image, x, y).y);
    return float(sum / (image.width() * image.height()));
  }

  /// How much more light a picture has with the sun apart.
  static float ratioOf(const Scene& scene, const Change& change = {}) {
    return meanOf(imageOf(scene, SunKind::split, change)) / meanOf(imageOf(scene, SunKind::map, change));
  }
};
MIRRORBALL_WITH_BOTH_APIS(SunSplitFrame);

TEST_P(SunSplitFrame, AMattBallIsLitAsByTheMap) {
  const Image map = imageOf(ballOf(matt()), SunKind::map);
  const Image split = imageOf(ballOf(matt()), SunKind::split);
  const float brightest = at(map, kTowards);
  EXPECT_GT(brightest, 1.0f);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      ASSERT_NEAR(rgbaAt(split, x, y).y, rgbaAt(map, x, y).y, 0.015f * brightest) << x << ", " << y;
}

TEST_P(SunSplitFrame, WhatIsInTheWayThrowsAShadow) {
  Scene scene = ballOf(matt());
  const float open = at(imageOf(scene, SunKind::split), kTowards);
  addBall(scene, 1.5f * kTowards, 0.2f, matt(), kRows);
  const Image shadowed = imageOf(scene, SunKind::split);
  EXPECT_NEAR(at(shadowed, kTowards), kSky, 0.02f);
  const glm::vec3 aside = glm::normalize(glm::vec3(0.1f, 0.5f, 0.8f));
  EXPECT_NEAR(at(shadowed, aside), at(imageOf(ballOf(matt()), SunKind::split), aside), 1e-3f);
  EXPECT_GT(open, 1.0f);
  // The edge of its shadow is soft, and no place is lit more than without.
  EXPECT_GT(at(imageOf(scene, SunKind::map), kTowards), 0.95f * open);
}

TEST_P(SunSplitFrame, HolesAndGlassLetItThrough) {
  const auto behind = [](const std::function<void(Material&, Scene&)>& change) {
    Scene scene = ballOf(matt());
    addBall(scene, 1.5f * kTowards, 0.2f, matt(), kRows);
    change(scene.materials[1], scene);
    return at(imageOf(scene, SunKind::split), kTowards);
  };
  const auto mask = [](float opacity) {
    return [opacity](Material& material, Scene&) {
      material.alpha_mode = AlphaMode::mask;
      material.opacity = opacity;
    };
  };
  EXPECT_LT(behind(mask(0.9f)), 2.0f * kSky);
  EXPECT_GT(behind(mask(0.1f)), 1.0f);
  const auto leaf = [](std::uint8_t alpha) {
    return [alpha](Material& material, Scene& scene) {
      scene.textures = {{.image = Image8(4, 4, 4, alpha)}};
      material.alpha_mode = AlphaMode::mask;
      material.base_color_map.texture = 0;
    };
  };
  EXPECT_LT(behind(leaf(200)), 2.0f * kSky) << "it does not shine through a leaf";
  EXPECT_GT(behind(leaf(20)), 1.0f);
  EXPECT_GT(behind([](Material& material, Scene&) { material.transmission = 1.0f; }), 1.0f);
}

TEST_P(SunSplitFrame, NoLightIsLostOrSeenTwice) {
  for (const float roughness : {0.0f, 0.1f, 0.25f, 0.5f, 1.0f})
    EXPECT_NEAR(ratioOf(ballOf(metal(roughness))), 1.0f, 0.08f) << "metal of roughness " << roughness;
  Material coated = matt();
  coated.specular = 1.0f;
  coated.clearcoat = 1.0f;
  coated.clearcoat_roughness = 0.2f;
  EXPECT_NEAR(ratioOf(ballOf(coated)), 1.0f, 0.05f) << "coat";
  Material cloth = matt();
  cloth.sheen_color = glm::vec3(1.0f);
  cloth.sheen_roughness = 0.5f;
  EXPECT_NEAR(ratioOf(ballOf(cloth)), 1.0f, 0.05f) << "cloth";
  Material brushed = metal(0.3f);
  brushed.anisotropy = 0.7f;
  EXPECT_NEAR(ratioOf(ballOf(brushed)), 1.0f, 0.08f) << "brushed metal";
  for (const float roughness : {0.0f, 0.3f}) {
    Material glass = matt();
    glass.specular = 1.0f;
    glass.transmission = 1.0f;
    glass.perceptual_roughness = roughness;
    const auto seen = [](FrameSettings& frame) { frame.env_rotation_deg.x = 170.0f; };
    EXPECT_NEAR(ratioOf(ballOf(glass), seen), 1.0f, 0.1f) << "glass of roughness " << roughness;
  }
}

TEST_P(SunSplitFrame, EveryLookUpSeesIt) {
  const auto with = [](const char* option, const char* value) {
    return [option, value](FrameSettings& frame) { testing::set(frame, option, value); };
  };
  const Scene polished = ballOf(metal(0.2f));
  for (const char* value : {"gpu", "mip", "cone"})
    EXPECT_NEAR(ratioOf(polished, with("blur", value)), 1.0f, 0.15f) << value;
  EXPECT_NEAR(ratioOf(polished, with("lookup", "flat")), 1.0f, 0.08f);
  // A probe of few texels would show the sun too large.
  const Change probe = with("probes", "1");
  EXPECT_NEAR(meanOf(imageOf(polished, SunKind::split, probe)) / meanOf(imageOf(polished, SunKind::split)), 1.0f,
              0.02f);
  EXPECT_NEAR(ratioOf(polished, with("env-intensity", "3")), 1.0f, 0.08f);
}

TEST_P(SunSplitFrame, TheBackgroundShowsIt) {
  const Scene elsewhere = ballOf(matt());
  for (const BackgroundKind kind : {BackgroundKind::environment, BackgroundKind::blur}) {
    const auto look = [kind](FrameSettings& frame) {
      frame.background = kind;
      frame.camera = {.azimuth_deg = 216.9f, .elevation_deg = 0.0f, .distance = 30.0f, .target = glm::vec3(0, 100, 0)};
      frame.camera.fov_deg = 20.0f;
    };
    EXPECT_NEAR(ratioOf(elsewhere, look), 1.0f, 0.1f) << int(kind);
  }
}

TEST_P(SunSplitFrame, WhereItIsNoDirectionItStaysInTheMap) {
  for (const auto& [option, value] : {std::pair{"proxy", "box:-3,-3,-3,3,3,3"},
                                      {"mapping", "normal"},
                                      {"mapping", "sphere"},
                                      {"reflect-at", "vertex"}}) {
    const auto change = [&, name = option, text = value](FrameSettings& frame) { testing::set(frame, name, text); };
    EXPECT_TRUE(areSame(imageOf(ballOf(metal(0.3f)), SunKind::split, change),
                        imageOf(ballOf(metal(0.3f)), SunKind::map, change)))
        << option << " " << value;
  }
  // Out of the ground it would shine through it.
  const auto below = [](FrameSettings& frame) {
    frame.proxy.kind = ProxyKind::ground;
    frame.env_rotation_deg = {0.0f, 90.0f, 30.0f};
  };
  EXPECT_TRUE(
      areSame(imageOf(ballOf(metal(0.3f)), SunKind::split, below), imageOf(ballOf(metal(0.3f)), SunKind::map, below)));
}

TEST_P(SunSplitFrame, ReliefLiesInNoShadowOfItsMesh) {
  Material cobbles = matt();
  cobbles.height = HeightKind::cobbles;
  cobbles.height_scale = 0.05f;
  cobbles.height_frequency = 2.0f;
  for (const ReliefKind kind : {ReliefKind::steep, ReliefKind::exact}) {
    Scene scene = ballOf(cobbles);
    ASSERT_TRUE(prepareRelief(scene, kind));
    const float ratio = ratioOf(scene, [kind](FrameSettings& frame) { frame.relief = kind; });
    // Heights throw shadows, which the map's light does not.
    EXPECT_GT(ratio, 0.7f) << int(kind);
    EXPECT_LT(ratio, 1.05f) << int(kind);
  }
}

TEST_P(SunSplitFrame, BumpsThatHideInAPixelKeepTheirHighlight) {
  Material pits = materialNamed("orange").value();
  pits.base_color = glm::vec3(0.0f);
  Scene scene = ballOf(pits);
  ASSERT_TRUE(prepareRelief(scene, ReliefKind::steep));
  const auto imageBy = [&](int samples) {
    return imageOf(scene, SunKind::split, [samples](FrameSettings& frame) {
      frame.relief = ReliefKind::steep;
      frame.samples = samples;
    });
  };
  const auto highlightOf = [](const Image& image) {
    const glm::vec3 facing = glm::normalize(kTowards + glm::vec3(0.0f, 0.0f, 1.0f));
    float sum = 0.0f;
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) sum += at(image, glm::vec2(facing) + 0.04f * glm::vec2(x, y));
    return sum;
  };
  const Image few = imageBy(4);
  const Image many = imageBy(128);  // of which each sees a pit as it is
  EXPECT_NEAR(highlightOf(few) / highlightOf(many), 1.0f, 0.1f);
  EXPECT_NEAR(meanOf(few) / meanOf(many), 1.0f, 0.04f);
}

TEST_P(SunSplitFrame, AStageShowsBothInTurns) {
  Renderer renderer = testing::rendererFor(ballOf(metal(0.3f)), sunnySky());
  const Image map = drawn(renderer, frameOf(renderer, SunKind::map));
  const Image split = drawn(renderer, frameOf(renderer, SunKind::split));
  EXPECT_FALSE(areSame(map, split));
  EXPECT_TRUE(areSame(drawn(renderer, frameOf(renderer, SunKind::map)), map));
  EXPECT_TRUE(areSame(drawn(renderer, frameOf(renderer, SunKind::split)), split));
}

}  // namespace
}  // namespace mirrorball
