#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

class WideLobesTest : public gl::GlTest {};
MIRRORBALL_WITH_BOTH_APIS(WideLobesTest);

/// A material whose roughness a white map multiplies by 1: of maps it is not known that they are nowhere dark.
Scene withWhiteMap(Scene scene) {
  Image8 white(1, 1, 4);
  std::ranges::fill(white.samples(), std::uint8_t{255});
  scene.textures.emplace_back().image = std::move(white);
  for (Material& material : scene.materials) material.roughness_map.texture = 0;
  return scene;
}

// Without the environment beside its chain a rough surface looks the same.
TEST_P(WideLobesTest, LookTheSameAsThoseOfAMap) {
  const Environment light = testing::coarseBuiltin("studio");
  const PreparedEnvironment prepared = *testing::prepareOnce(light);
  for (const float clearcoat : {0.0f, 1.0f})
    for (const TextureFilter filter : {TextureFilter::trilinear, TextureFilter::anisotropic}) {
      Scene scene = *loadModel("teapot");
      for (Material& material : scene.materials) {
        material.metallic = 1.0f;
        material.perceptual_roughness = 0.9f;
        material.clearcoat = clearcoat;
        material.clearcoat_roughness = 0.9f;
      }
      const auto pictureOf = [&](Scene drawn) {
        Renderer renderer = *testing::rendererOf(std::move(drawn), light, prepared);
        return *renderer.render({.size = {60, 40}, .samples = 2, .texture_filter = filter});
      };
      const Image8 plain = pictureOf(scene), mapped = pictureOf(withWhiteMap(scene));
      int most = 0;
      for (std::size_t i = 0; i < plain.samples().size(); ++i)
        most = std::max(most, std::abs(int(plain.samples()[i]) - int(mapped.samples()[i])));
      EXPECT_LE(most, 1) << "coat " << clearcoat << ", filter " << static_cast<int>(filter);
      EXPECT_GT(*std::ranges::max_element(plain.samples()), 20);
    }
}

}  // namespace
}  // namespace mirrorball
