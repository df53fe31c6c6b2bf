// Normal maps whose texels a pixel averages away widen what it reflects: as far as they are bumpy, and no farther.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/bumpy_plane_testing.h"

namespace mirrorball {
namespace {

using testing::BumpForm;

constexpr glm::ivec2 kSize_px{32, 18};

class NormalFilterTest : public testing::HeadlessTest {
 protected:
  void SetUp() override {
    HeadlessTest::SetUp();
    if (IsSkipped()) return;
    const Environment studio = *builtinEnvironment("studio");
    auto renderer = testing::rendererOf({}, studio, *testing::prepareOnce(studio));
    ASSERT_TRUE(renderer);
    renderer_.emplace(std::move(*renderer));
  }

  /// Draws a plane from so far away that a pixel is that many texels of its map wide.
  Image drawn(Scene scene, float texels_a_pixel, int samples) {
    EXPECT_TRUE(renderer_->setScene(std::move(scene)));
    const FrameSettings settings{.size = kSize_px, .samples = samples, .resolve = Resolve::radiance};
    EXPECT_TRUE(renderer_->draw(testing::cameraOverPlane(texels_a_pixel, kSize_px), settings));
    return *renderer_->radiance();
  }

 private:
  std::optional<Renderer> renderer_;
};

/// Of green that is clipped at 1.
float errorOf(const Image& found, const Image& truth) {
  float sum = 0.0f;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const float difference = std::min(rgbAt(found, x, y).y, 1.0f) - std::min(rgbAt(truth, x, y).y, 1.0f);
      sum += difference * difference;
    }
  return std::sqrt(sum / static_cast<float>(truth.width() * truth.height()));
}

float farthest(const Image& a, const Image& b) {
  float most = 0.0f;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) most = std::max(most, glm::distance(rgbAt(a, x, y), rgbAt(b, x, y)));
  return most;
}

/// The same without a spread of normals: they are also those of a map that is not looked at.
Scene withoutSpread(Scene scene) {
  Material& material = scene.materials.front();
  material.occlusion_map.texture = 0;
  material.occlusion_strength = 0.0f;
  return scene;
}

Material whiteMirror() { return testing::whiteMetal(0.0f); }

/// A plane with one normal everywhere, in tangent space: of 8 bits.
Scene flatPlane(glm::vec3 normal) {
  Material material = whiteMirror();
  material.normal_map.texture = 0;
  Scene scene = meshScene(testing::tiledPlane(), std::move(material));
  Image normals(testing::kTileSide, testing::kTileSide, 3);
  for (int y = 0; y < normals.height(); ++y)
    for (int x = 0; x < normals.width(); ++x) std::copy_n(&normal.x, 3, normals.texel(x, y));
  scene.textures.push_back(testing::textureOfNormals(normals));
  return scene;
}

TEST_F(NormalFilterTest, ADistantBumpyMirrorIsARoughOne) {
  const Scene bricks = testing::bumpyPlane(HeightKind::brick, BumpForm::normal_map, testing::whiteMetal(0.1f));
  const Image truth = drawn(bricks, 8.0f, 256);
  EXPECT_LT(errorOf(drawn(bricks, 8.0f, 4), truth), 0.6f * errorOf(drawn(withoutSpread(bricks), 8.0f, 4), truth));
}

TEST_F(NormalFilterTest, AFlatMapLeavesAMirrorAsItIs) {
  for (const glm::vec3 normal : {glm::vec3(0.0f, 0.0f, 1.0f), glm::normalize(glm::vec3(0.13f, -0.21f, 1.0f))}) {
    const Scene flat = flatPlane(normal);
    EXPECT_EQ(farthest(drawn(flat, 32.0f, 1), drawn(withoutSpread(flat), 32.0f, 1)), 0.0f);
  }
}

// Between two texels the filter shortens a normal, which is no roughness.
TEST_F(NormalFilterTest, ASmoothMapSeenFromNearbyLeavesAMirrorAsItIs) {
  const Scene waves = testing::bumpyPlane(HeightKind::waves, BumpForm::normal_map, whiteMirror());
  EXPECT_EQ(farthest(drawn(waves, 0.2f, 1), drawn(withoutSpread(waves), 0.2f, 1)), 0.0f);
}

// Whose alpha is not a spread of normals.
TEST_F(NormalFilterTest, APictureThatIsAlsoAnotherMapKeepsItsAlpha) {
  Scene shared = testing::bumpyPlane(HeightKind::waves, BumpForm::normal_map, testing::whiteMetal(0.1f));
  shared.materials.front().metallic = 0.0f;
  Image8& picture = shared.textures.front().image.edit();
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) picture.texel(x, y)[3] = 128;
  shared.materials.front().specular_map.texture = 0;
  Scene apart = shared;
  apart.textures.push_back(apart.textures.front());
  apart.materials.front().specular_map.texture = 1;
  EXPECT_LT(farthest(drawn(shared, 0.2f, 1), drawn(apart, 0.2f, 1)), 1e-5f);
}

/// Black but for its coat.
Material coated(float roughness_below) {
  Material material;
  material.base_color = glm::vec3(0.0f);
  material.specular = 0.0f;
  material.perceptual_roughness = roughness_below;
  material.clearcoat = 1.0f;
  return material;
}

TEST_F(NormalFilterTest, TheNormalMapOfACoatWidensItsLobe) {
  Scene bricks = testing::bumpyPlane(HeightKind::brick, BumpForm::normal_map, coated(0.5f));
  Material& material = bricks.materials.front();
  std::swap(material.normal_map, material.clearcoat_normal_map);
  material.clearcoat_roughness = 0.1f;
  const Image truth = drawn(bricks, 32.0f, 256);
  EXPECT_LT(errorOf(drawn(bricks, 32.0f, 4), truth), 0.8f * errorOf(drawn(withoutSpread(bricks), 32.0f, 4), truth));
}

// However rough the coat is beside what is below it.
TEST_F(NormalFilterTest, ACoatIsSmoothOverBumpsThatAPixelHides) {
  for (const BumpForm form : testing::kEveryBumpForm) {
    Material material = coated(0.1f);
    material.clearcoat_roughness = 0.3f;
    const Image smooth = drawn(meshScene(testing::tiledPlane(), material), 32.0f, 1);
    const Image bumpy = drawn(testing::bumpyPlane(HeightKind::brick, form, material), 32.0f, 1);
    EXPECT_LT(farthest(smooth, bumpy), 1e-5f) << testing::nameOf(form);
  }
}

}  // namespace
}  // namespace mirrorball
