// A material with more textures than texture units: those that are layers of an array, filtered by the shader, look as
// they do with a unit each, filtered by the driver.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/render/surface/brdf_texture.h"
#include "mirrorball/render/surface/surface_drawing.h"
#include "mirrorball/render/surface/surface_programs.h"
#include "mirrorball/render/surface/texture_units.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

constexpr int kSide_px = 96;

/// Bytes around the middle, where no map hides what another one does.
Texture noise(int width, int height, unsigned seed) {
  Texture texture;
  texture.image = Image8(width, height, 4);
  std::mt19937 random(seed);
  for (std::uint8_t& byte : texture.image.edit().samples()) byte = static_cast<std::uint8_t>(64 + random() % 128);
  return texture;
}

/// A texture of its own for each map, no two alike in size or in how they are read.
///
/// with_numbers   every other one that is not a colour holds floats
void giveEveryMapATexture(Scene& scene, float repeats, bool with_numbers = false) {
  for (std::size_t row = 0; row < materialMaps().size(); ++row) {
    const auto number = static_cast<int>(row);
    Texture texture = noise(3 + 5 * number % 16, 2 + 7 * number % 13, static_cast<unsigned>(row));
    texture.srgb = materialMaps()[row].srgb;
    if (with_numbers && !texture.srgb && number % 2 == 0) texture.image = fractionsFromCodes(texture.image.codes());
    texture.nearest = number % 4 == 1;
    texture.wrap_s = static_cast<Wrap>(number % 3);
    texture.wrap_t = static_cast<Wrap>(number / 3 % 3);
    TextureSlot& slot = scene.materials[0].*materialMaps()[row].slot;
    slot.texture = number;
    slot.scale = glm::vec2(repeats);
    slot.offset = glm::vec2(-0.5f * repeats);
    scene.textures.push_back(std::move(texture));
  }
}

/// Half of everything that maps multiply.
Material everything() {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.metallic = 0.5f;
  material.perceptual_roughness = 1.0f;
  material.transmission = 0.5f;
  material.emission = glm::vec3(1.0f);
  return material;
}

Environment layerCompass() {
  return Environment([](glm::vec3 d) { return (1.0f + d) / 2.0f; }, 32);
}

/// How far two pictures are apart.
struct Difference {
  float mean = 0.0f;
  float of_most = 0.0f;  ///< of all but one sample in a hundred
};

Difference differenceOf(const Image& a, const Image& b) {
  std::vector<float> off(a.samples().size());
  for (std::size_t i = 0; i < off.size(); ++i) off[i] = std::abs(a.samples()[i] - b.samples()[i]);
  std::ranges::sort(off);
  return {std::accumulate(off.begin(), off.end(), 0.0f) / static_cast<float>(off.size()), off[off.size() * 99 / 100]};
}

/// Draws one sample a pixel of the scene's only instance, in the light of the compass.
class Drawing {
 public:
  /// context   outlives it
  static Result<Drawing> make(const gl::Context& context) {
    MIRRORBALL_TRY(prepared, testing::prepareOnce(layerCompass()));
    MIRRORBALL_TRY(light, EnvironmentLight::make(prepared, context.filtersFloats()));
    MIRRORBALL_TRY(table, surfaceBrdfTable());
    MIRRORBALL_TRY(programs, SurfacePrograms::make(context.api(), table));
    MIRRORBALL_TRY(framebuffer, gl::Framebuffer::make(gl::Format::rgba32f, kSide_px, kSide_px, gl::Depths::alone));
    return Drawing(context, std::move(light), std::move(programs), std::move(framebuffer));
  }

  /// units   that the material has
  Result<Image> of(const Scene& scene, int units, TextureFilter filter = TextureFilter::trilinear) {
    MIRRORBALL_TRY(buffers, SceneBuffers::make(scene, units));
    buffers.filterMaps(scene, filter, 1.0f);
    FrameUniforms frame;
    frame.light.prefiltered = {&light_.prefiltered(), 1};
    frame.sample.camera = makeCamera({}, boundingSphere(scene), 1.0f);
    frame.light.proxy = &far_away_;
    FrameSettings settings;
    settings.samples = 1;
    settings.texture_filter = filter;
    SurfaceDrawing surfaces;
    MIRRORBALL_TRY_VOID(
        surfaces.begin(programs_, {*context_, framebuffer_}, scene, buffers, 1, light_, frame, settings));
    framebuffer_.bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    surfaces.draw(scene, 0, buffers, settings);
    return framebuffer_.readFloat();
  }

 private:
  Drawing(const gl::Context& context, EnvironmentLight light, SurfacePrograms programs, gl::Framebuffer framebuffer)
      : context_(&context),
        light_(std::move(light)),
        programs_(std::move(programs)),
        framebuffer_(std::move(framebuffer)) {}

  const gl::Context* context_;
  EnvironmentLight light_;
  SurfacePrograms programs_;
  ProxyUniforms far_away_;
  gl::Framebuffer framebuffer_;
};

class MapLayersTest : public gl::GlTest {};
MIRRORBALL_WITH_BOTH_APIS(MapLayersTest);

// Drivers weigh texels by 8-bit fractions and take a short way to the mip level. Where texels show as squares, the last
// bit decides to which of two a pixel on their edge belongs: that is the one sample in a hundred.
TEST_P(MapLayersTest, LookAsWithUnitsOfTheirOwn) {
  auto drawing = Drawing::make(context());
  ASSERT_TRUE(drawing) << drawing.error().message;
  for (const float repeats : {1.5f, 40.0f})
    for (const bool with_numbers : {false, true}) {
      Scene scene = meshScene(sphereMesh(), everything());
      giveEveryMapATexture(scene, repeats, with_numbers);
      const auto alone = drawing->of(scene, kUnitsOfMaterial);
      const auto in_layers = drawing->of(scene, 3);
      ASSERT_TRUE(alone && in_layers);
      const Difference difference = differenceOf(*alone, *in_layers);
      EXPECT_LT(difference.mean, 2e-3f) << repeats << " times around";
      EXPECT_LT(difference.of_most, 0.02f) << repeats << " times around";
    }
}

// The same numbers, as codes or as floats, look the same.
TEST_P(MapLayersTest, NumbersLookAsCodesDo) {
  auto drawing = Drawing::make(context());
  ASSERT_TRUE(drawing) << drawing.error().message;
  for (const int units : {kUnitsOfMaterial, 3}) {
    std::vector<Image> images;
    for (const bool with_numbers : {false, true}) {
      Scene scene = meshScene(sphereMesh(), everything());
      giveEveryMapATexture(scene, 1.5f, with_numbers);
      auto image = drawing->of(scene, units);
      ASSERT_TRUE(image);
      images.push_back(std::move(*image));
    }
    const Difference difference = differenceOf(images[0], images[1]);
    EXPECT_LT(difference.mean, 2e-3f) << units << " units";
    EXPECT_LT(difference.of_most, 0.02f) << units << " units";
  }
}

// Which reads make an anisotropic one, drivers are free to choose: it is not compared.
TEST_P(MapLayersTest, AreFilteredAsTheDriverFilters) {
  auto drawing = Drawing::make(context());
  ASSERT_TRUE(drawing) << drawing.error().message;
  Scene scene = meshScene(sphereMesh(), everything());
  giveEveryMapATexture(scene, 10.0f);
  const auto usual = drawing->of(scene, kUnitsOfMaterial);
  ASSERT_TRUE(usual);
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
    const auto alone = drawing->of(scene, kUnitsOfMaterial, filter);
    const auto in_layers = drawing->of(scene, 3, filter);
    ASSERT_TRUE(alone && in_layers);
    const float apart = differenceOf(*alone, *in_layers).mean;
    EXPECT_LT(apart, 2e-3f) << static_cast<int>(filter);
    EXPECT_LT(2.0f * apart, differenceOf(*usual, *in_layers).mean) << static_cast<int>(filter);
  }
}

}  // namespace
}  // namespace mirrorball
