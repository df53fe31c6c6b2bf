// Textures, vertex colours and alpha on surfaces. Every scene is made of squares that fill an orthographic picture, so
// that a pixel is one known place of a square and what it must show can be worked out by hand.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"

namespace mirrorball {
namespace {

/// Pictures are read in cells, by the pixel in the middle: it lies clear of the edges of texels as large as a cell, and
/// three pixels a texel are magnification, which reads the first mip level alone.
constexpr int kCellSide_px = 3;

/// Light up to 1 is kept in halves, off by 2⁻¹² at most; the same again for float arithmetic and for the cube's texels,
/// between which the compass is not quite linear.
constexpr float kExact = 5e-4f;
/// Half a step of an 8-bit texture: as far as a driver may take the sRGB curve for a polynomial.
constexpr float kSrgb = 0.5f / 255.0f;
/// Drivers weigh texels by 8-bit fractions, and may round the mean to 8 bits.
constexpr float kFiltered = 2.0f / 255.0f;
/// 8 bits leave a normal map's x, y and z half a step, 1/255, from what is meant. The reflected ray turns twice as far
/// as the normal, and the compass changes by half of that. A wrong normal is seen by a difference of 0.15 at least.
constexpr float kBentNormal = 0.01f;

constexpr float kQuarterTurn_rad = glm::half_pi<float>();
constexpr float kHalfTurn_rad = glm::pi<float>();

using Texel = std::array<std::uint8_t, 4>;
constexpr Texel kBlack{0, 0, 0, 255};
constexpr Texel kClear{255, 255, 255, 0};
constexpr Texel kRed{255, 0, 0, 255};
constexpr Texel kGreen{0, 255, 0, 255};
constexpr Texel kYellow{255, 255, 0, 255};
constexpr Texel kBlue{0, 0, 255, 255};
constexpr Texel kWhite{255, 255, 255, 255};

// Of normal maps: straight on, (0.6, 0, 0.8) and (0, 0.6, 0.8).
constexpr Texel kFlat{128, 128, 255, 255};
constexpr Texel kRightwards{204, 128, 230, 255};
constexpr Texel kUpwards{128, 204, 230, 255};

/// A texture of linear bytes whose texels show as squares, which it repeats; rows from the top.
Texture textureOfTexels(int width, const std::vector<Texel>& texels) {
  Texture texture;
  texture.image = Image8(width, static_cast<int>(texels.size()) / width, 4);
  auto out = texture.image.edit().samples().begin();
  for (const Texel& texel : texels) out = std::copy(texel.begin(), texel.end(), out);
  texture.nearest = true;
  return texture;
}

/// [−1, 1]² at a depth, facing +Z, with the whole of a texture upright on it: u grows along +X, v along −Y.
Mesh square(float z = 0.0f) {
  Mesh mesh;
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)}) {
    Vertex vertex;
    vertex.position = glm::vec3(2.0f * uv.x - 1.0f, 1.0f - 2.0f * uv.y, z);
    vertex.uv[0] = vertex.uv[1] = uv;
    mesh.vertices.push_back(vertex);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// White and without reflection, so that in white light it shows its base colour whatever its roughness.
Material chalk(glm::vec3 base_color = glm::vec3(1.0f)) {
  Material material;
  material.base_color = base_color;
  material.specular = 0.0f;
  return material;
}

/// A square of a material with a texture in one of its slots.
Scene texturedSquare(Material material, TextureSlot Material::*slot, Texture texture) {
  (material.*slot).texture = 0;
  Scene scene = meshScene(square(), std::move(material));
  scene.textures.push_back(std::move(texture));
  return scene;
}

/// Turned about +Y until its back is in front.
glm::mat4 turnedRound() { return glm::rotate(glm::mat4(1.0f), kHalfTurn_rad, glm::vec3(0, 1, 0)); }

Environment whiteLight() {
  return Environment([](glm::vec3) { return glm::vec3(1.0f); }, 8);
}

/// Light whose colour tells its direction, (1 + d) / 2. A mirror shows that of the reflected ray. Chalk of normal n
/// shows 1/2 + n/3: the cosine lobe leaves 2/3 of what light varies linearly (Ramamoorthi & Hanrahan 2001, A1 / A0).
Environment compass() {
  return Environment([](glm::vec3 d) { return (1.0f + d) / 2.0f; }, 128);
}
constexpr glm::vec4 kChalkTowardsCamera(0.5f, 0.5f, 5.0f / 6.0f, 1.0f);
constexpr glm::vec4 kMirrorTowardsCamera(0.5f, 0.5f, 1.0f, 1.0f);
constexpr glm::vec4 kNothing(0.0f);

struct View {
  int cells = 1;                             ///< a side of the picture
  float azimuth_deg = 0.0f;                  ///< 0 looks along −Z, 180 at the back of everything
  std::optional<glm::vec3> background = {};  ///< transparent without one
};

FrameSettings settingsOf(const View& view, const Scene& scene) {
  FrameSettings settings;
  settings.size = glm::ivec2(view.cells * kCellSide_px);
  settings.samples = 1;
  settings.resolve = Resolve::radiance;
  settings.background = view.background ? BackgroundKind::radiance : BackgroundKind::transparent;
  settings.background_color = view.background.value_or(glm::vec3(0.0f));
  settings.camera.azimuth_deg = view.azimuth_deg;
  settings.camera.elevation_deg = 0.0f;
  settings.camera.target = glm::vec3(0.0f);
  settings.camera.orthographic_height = 2.0f / boundingSphere(scene).radius;
  return settings;
}

/// The middle of a cell, counted from the top left.
glm::vec4 cell(const Image& image, int column, int row) {
  return rgbaAt(image, column * kCellSide_px + 1, row * kCellSide_px + 1);
}

/// Draws with each API, as WebGL 2 is the second one.
class SurfaceTextureTest : public ::testing::TestWithParam<gl::Api> {
 protected:
  void SetUp() override {
    auto made = gl::Context::createHeadless(GetParam());
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }

  /// The radiance of squares, premultiplied by alpha; what fails becomes a test failure and a black picture.
  Image drawn(const Scene& scene, const Environment& environment, const View& view = {}) const {
    const FrameSettings settings = settingsOf(view, scene);
    Result<Image> image = radiance(scene, environment, settings);
    if (image) return std::move(*image);
    ADD_FAILURE() << image.error().message;
    return Image(settings.size.x, settings.size.y, 4);
  }

  /// The same of a square that looks alike everywhere.
  glm::vec4 seen(const Scene& scene, const Environment& environment, const View& view = {}) const {
    return cell(drawn(scene, environment, view), 0, 0);
  }

 private:
  Result<Image> radiance(const Scene& scene, const Environment& environment, const FrameSettings& settings) const {
    MIRRORBALL_TRY(prepared, testing::prepareOnce(environment));
    MIRRORBALL_TRY(renderer, testing::rendererOf(scene, environment, prepared));
    return renderer.renderRadiance(settings);
  }

  std::optional<gl::Context> context_;
};
MIRRORBALL_WITH_BOTH_APIS(SurfaceTextureTest);

/// Names the colours of all cells by letters, K for black, row by row with a space between.
std::string lettersOf(const Image& image) {
  const int cells = image.width() / kCellSide_px;
  std::string letters;
  for (int row = 0; row < cells; ++row) {
    if (row > 0) letters += ' ';
    for (int column = 0; column < cells; ++column) {
      const glm::ivec4 bits(glm::greaterThan(cell(image, column, row), glm::vec4(0.5f)));
      letters += "KRGYBMCW"[bits.x + 2 * bits.y + 4 * bits.z];
    }
  }
  return letters;
}

void expectNear(glm::vec4 shown, glm::vec4 expected, float tolerance, const std::string& what) {
  for (int channel = 0; channel < 4; ++channel)
    EXPECT_NEAR(shown[channel], expected[channel], tolerance) << what << ", channel " << channel;
}

TEST_P(SurfaceTextureTest, ABaseColorTextureIsDecodedFromSrgbAndMultipliesTheBaseColor) {
  Scene scene = texturedSquare(chalk({0.5f, 0.25f, 1.0f}), &Material::base_color_map,
                               textureOfTexels(1, {Texel{188, 255, 128, 255}}));
  // Bytes of linear light are what they are.
  expectNear(seen(scene, whiteLight()), {188 / 255.0f * 0.5f, 0.25f, 128 / 255.0f, 1.0f}, kExact, "linear");
  // ((188/255 + 0.055) / 1.055)^2.4 = 0.5029, and 0.2159 of 128.
  scene.textures[0].srgb = true;
  expectNear(seen(scene, whiteLight()), {0.5029f * 0.5f, 0.25f, 0.2159f, 1.0f}, kSrgb, "sRGB");
}

TEST_P(SurfaceTextureTest, UGrowsToTheRightAndVDownwards) {
  const Scene scene =
      texturedSquare(chalk(), &Material::base_color_map, textureOfTexels(2, {kRed, kGreen, kBlue, kWhite}));
  EXPECT_EQ(lettersOf(drawn(scene, whiteLight(), {.cells = 2})), "RG BW");
}

// Three periods of two texels, the middle one being the texture itself.
TEST_P(SurfaceTextureTest, EachAxisWrapsAsItIsTold) {
  Scene scene = texturedSquare(chalk(), &Material::base_color_map, textureOfTexels(2, {kRed, kGreen, kBlue, kWhite}));
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] = vertex.uv[0] * 3.0f - 1.0f;
  const auto letters_of = [&](Wrap s, Wrap t) {
    scene.textures[0].wrap_s = s;
    scene.textures[0].wrap_t = t;
    return lettersOf(drawn(scene, whiteLight(), {.cells = 6}));
  };
  EXPECT_EQ(letters_of(Wrap::repeat, Wrap::mirrored_repeat), "BWBWBW RGRGRG RGRGRG BWBWBW BWBWBW RGRGRG");
  EXPECT_EQ(letters_of(Wrap::mirrored_repeat, Wrap::clamp_to_edge), "GRRGGR GRRGGR GRRGGR WBBWWB WBBWWB WBBWWB");
  EXPECT_EQ(letters_of(Wrap::clamp_to_edge, Wrap::repeat), "RRRGGG BBBWWW RRRGGG BBBWWW RRRGGG BBBWWW");
}

// Black and white side by side in eight cells: their centres lie at -3/8, -1/8, 1/8 … 11/8 from the black texel's
// centre, the white one's being 1.
TEST_P(SurfaceTextureTest, MagnifiedTexelsAreInterpolatedUnlessNearest) {
  Scene scene = texturedSquare(chalk(), &Material::base_color_map, textureOfTexels(2, {kBlack, kWhite}));
  scene.textures[0].wrap_s = Wrap::clamp_to_edge;
  const Image squares = drawn(scene, whiteLight(), {.cells = 8});
  scene.textures[0].nearest = false;
  const Image ramp = drawn(scene, whiteLight(), {.cells = 8});
  for (int i = 0; i < 8; ++i) {
    const float position = static_cast<float>(i) / 4.0f - 0.375f;
    EXPECT_NEAR(cell(squares, i, 3).x, i < 4 ? 0.0f : 1.0f, kExact) << i;
    EXPECT_NEAR(cell(ramp, i, 3).x, glm::clamp(position, 0.0f, 1.0f), kFiltered) << i;
  }
}

// The example in KHR_texture_transform's text: "only the lower left quadrant of the source image, rotated clockwise
// 90°". The other way round, the upper right one would be seen.
TEST_P(SurfaceTextureTest, ATextureTurnsClockwiseAsItsCoordinatesTurnCounterClockwise) {
  Scene scene = texturedSquare(chalk(), &Material::base_color_map,
                               textureOfTexels(4, {kBlack, kBlack, kBlack, kBlack,  //
                                                   kBlack, kBlack, kBlack, kBlack,  //
                                                   kRed, kGreen, kBlack, kBlack,    //
                                                   kBlue, kWhite, kBlack, kBlack}));
  TextureSlot& slot = scene.materials[0].base_color_map;
  slot.offset = {0.0f, 1.0f};
  slot.rotation_rad = kQuarterTurn_rad;
  slot.scale = {0.5f, 0.5f};
  EXPECT_EQ(lettersOf(drawn(scene, whiteLight(), {.cells = 2})), "BR WG");
}

// Translation · rotation · scale, with sine 0.6 and cosine 0.8:
//   u' = 0.8 · 0.4 u + 0.6 · 0.2 v + 0.28,  v' = −0.6 · 0.4 u + 0.8 · 0.2 v + 0.5.
// Red grows with u' from 0 at 1/4 to 1 at 3/4, green with v'.
TEST_P(SurfaceTextureTest, ATextureTransformScalesThenRotatesThenShifts) {
  Scene scene = texturedSquare(chalk(), &Material::base_color_map, textureOfTexels(2, {kBlack, kRed, kGreen, kYellow}));
  scene.textures[0].nearest = false;
  TextureSlot& slot = scene.materials[0].base_color_map;
  slot.scale = {0.4f, 0.2f};
  slot.rotation_rad = std::atan2(0.6f, 0.8f);
  slot.offset = {0.28f, 0.5f};
  const Image image = drawn(scene, whiteLight(), {.cells = 4});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const glm::vec2 uv = (glm::vec2(column, row) + 0.5f) / 4.0f;
      const glm::vec2 moved(0.32f * uv.x + 0.12f * uv.y + 0.28f, -0.24f * uv.x + 0.16f * uv.y + 0.5f);
      expectNear(cell(image, column, row), glm::vec4(moved * 2.0f - 0.5f, 0.0f, 1.0f), kFiltered,
                 "column " + std::to_string(column) + ", row " + std::to_string(row));
    }
}

/// A slot of a material, and what the compass lights when the left or the right of two texels is read.
struct SlotCase {
  std::string name;
  TextureSlot Material::*slot;
  Material material;
  Texel left;
  Texel right;
  glm::vec4 shows_left;
  glm::vec4 shows_right;
};

std::vector<SlotCase> slotCases() {
  Material metal = chalk();
  metal.metallic = 1.0f;
  metal.perceptual_roughness = 0.0f;
  Material lamp = chalk();
  lamp.emission = glm::vec3(1.0f);
  Material coat = chalk(glm::vec3(0.0f));
  coat.specular = 1.0f;
  coat.perceptual_roughness = 0.0f;
  coat.ior = 10.0f;  // reflects ((10 - 1) / (10 + 1))² of what comes straight on
  const float reflected = 81.0f / 121.0f;
  Material window = chalk();
  window.transmission = 1.0f;
  window.perceptual_roughness = 0.0f;
  window.ior = 1.0f;  // so that what is behind is seen, along −Z
  const glm::vec4 behind(0.5f, 0.5f, 0.0f, 1.0f);
  const glm::vec4 tilted(0.5f + 0.2f, 0.5f, 0.5f + 0.8f / 3.0f, 1.0f);
  const glm::vec4 bright = kChalkTowardsCamera + glm::vec4(1, 1, 1, 0);
  const glm::vec4 black(0, 0, 0, 1);
  return {
      {"base colour", &Material::base_color_map, chalk(), kBlack, kWhite, black, kChalkTowardsCamera},
      {"metallic", &Material::metallic_map, metal, kBlack, kBlue, kChalkTowardsCamera, kMirrorTowardsCamera},
      {"normal", &Material::normal_map, chalk(), kFlat, kRightwards, kChalkTowardsCamera, tilted},
      {"occlusion", &Material::occlusion_map, chalk(), kWhite, kBlack, kChalkTowardsCamera, black},
      {"emission", &Material::emission_map, lamp, kBlack, kWhite, kChalkTowardsCamera, bright},
      {"specular",
       &Material::specular_map,
       coat,
       kClear,
       kBlack,
       black,
       {0.5f * reflected, 0.5f * reflected, reflected, 1.0f}},
      {"transmission", &Material::transmission_map, window, kBlack, kRed, kChalkTowardsCamera, behind},
  };
}

// All of a square has the left texel's centre for its first texture coordinates and the right one's for its second.
TEST_P(SurfaceTextureTest, EverySlotHasItsOwnTextureCoordinatesAndTransform) {
  for (const SlotCase& slot_case : slotCases()) {
    Scene scene =
        texturedSquare(slot_case.material, slot_case.slot, textureOfTexels(2, {slot_case.left, slot_case.right}));
    for (Vertex& vertex : scene.meshes[0].edit().vertices) {
      vertex.uv[0] = {0.25f, 0.5f};
      vertex.uv[1] = {0.75f, 0.5f};
    }
    const auto expect_shown = [&](const TextureSlot& slot, glm::vec4 expected, const char* what) {
      scene.materials[0].*slot_case.slot = slot;
      expectNear(seen(scene, compass()), expected, kBentNormal, slot_case.name + ": " + what);
    };
    expect_shown({.texture = 0}, slot_case.shows_left, "as it is");
    expect_shown({.texture = 0, .uv_set = 1}, slot_case.shows_right, "second set");
    expect_shown({.texture = 0, .offset = {0.5f, 0.0f}}, slot_case.shows_right, "offset");
    expect_shown({.texture = 0, .scale = {3.0f, 1.0f}}, slot_case.shows_right, "scale");
    expect_shown({.texture = 0, .rotation_rad = kHalfTurn_rad}, slot_case.shows_right, "half a turn");
  }
}

// A surface may have all of them at once, each on its own texture unit.
TEST_P(SurfaceTextureTest, AllSlotsTogetherKeepTheirTextures) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.transmission = 1.0f;
  material.emission = glm::vec3(1.0f);
  Scene scene = meshScene(square(), material);
  const auto put = [&](TextureSlot Material::*slot, const Texel& texel) {
    (scene.materials[0].*slot).texture = static_cast<int>(scene.textures.size());
    scene.textures.push_back(textureOfTexels(1, {texel}));
  };
  put(&Material::base_color_map, {102, 204, 255, 255});
  put(&Material::metallic_map, kBlue);
  put(&Material::roughness_map, kGreen);
  put(&Material::normal_map, kRightwards);
  put(&Material::occlusion_map, {51, 0, 0, 255});
  put(&Material::emission_map, {0, 0, 51, 255});
  put(&Material::specular_map, kClear);
  put(&Material::transmission_map, kBlue);
  // (0.4, 0.8, 1) of the light on the bent normal, of which a fifth arrives, and 0.2 more in blue.
  const glm::vec4 expected(0.4f * 0.7f * 0.2f, 0.8f * 0.5f * 0.2f, (0.5f + 0.8f / 3.0f) * 0.2f + 0.2f, 1.0f);
  expectNear(seen(scene, compass()), expected, kBentNormal, "all");
}

TEST_P(SurfaceTextureTest, VertexColorsAreInterpolatedAndMultiplyTheBaseColor) {
  Scene scene = texturedSquare(chalk({1.0f, 0.5f, 0.5f}), &Material::base_color_map,
                               textureOfTexels(1, {Texel{255, 255, 51, 255}}));
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.color = {vertex.uv[0].x, 0.5f, 1.0f, 1.0f};
  const Image image = drawn(scene, whiteLight(), {.cells = 4});
  for (int column = 0; column < 4; ++column)
    expectNear(cell(image, column, 1), {(static_cast<float>(column) + 0.5f) / 4.0f, 0.25f, 0.1f, 1.0f}, kExact,
               "column " + std::to_string(column));
}

TEST_P(SurfaceTextureTest, RoughnessIsInGreenAndMetallicInBlue) {
  Material metal = chalk();
  metal.metallic = 1.0f;
  metal.perceptual_roughness = 1.0f;
  Scene mirror = texturedSquare(metal, &Material::metallic_map, textureOfTexels(1, {Texel{255, 0, 255, 0}}));
  mirror.materials[0].roughness_map = mirror.materials[0].metallic_map;
  expectNear(seen(mirror, compass()), kMirrorTowardsCamera, kExact, "a mirror");

  // Between the ends: the same as the products of texture and factors without a texture, whatever they look like.
  Material partial;
  partial.metallic = 0.5f;
  partial.perceptual_roughness = 0.5f;
  Scene textured = texturedSquare(partial, &Material::metallic_map, textureOfTexels(1, {Texel{255, 51, 102, 0}}));
  textured.materials[0].roughness_map = textured.materials[0].metallic_map;
  partial.perceptual_roughness = 0.1f;
  partial.metallic = 0.2f;
  expectNear(seen(textured, compass()), seen(meshScene(square(), partial), compass()), kExact, "products");
}

TEST_P(SurfaceTextureTest, SpecularIsInAlphaAndTransmissionInRed) {
  Material glass;
  glass.perceptual_roughness = 0.2f;
  glass.specular = 0.75f;
  glass.transmission = 0.5f;
  Scene textured = texturedSquare(glass, &Material::specular_map, textureOfTexels(1, {Texel{51, 255, 0, 102}}));
  textured.materials[0].transmission_map = textured.materials[0].specular_map;
  glass.specular = 0.3f;
  glass.transmission = 0.1f;
  expectNear(seen(textured, compass()), seen(meshScene(square(), glass), compass()), kExact, "products");
}

TEST_P(SurfaceTextureTest, OcclusionInRedDarkensDiffuseLightOnly) {
  Material material = chalk();
  material.emission = {0.0f, 0.0f, 0.25f};
  Scene scene = texturedSquare(material, &Material::occlusion_map, textureOfTexels(1, {Texel{51, 255, 255, 255}}));
  // glTF: 1 + strength (occluded − 1), with 51/255 = 0.2.
  for (const auto& [strength, expected] : {std::pair(1.0f, 0.2f), std::pair(0.5f, 0.6f), std::pair(0.0f, 1.0f)}) {
    scene.materials[0].occlusion_strength = strength;
    expectNear(seen(scene, whiteLight()), {expected, expected, expected + 0.25f, 1.0f}, kExact,
               "strength " + std::to_string(strength));
  }
  const Scene mirror = texturedSquare(*materialNamed("mirror"), &Material::occlusion_map,
                                      textureOfTexels(1, {Texel{51, 255, 255, 255}}));
  expectNear(seen(mirror, whiteLight()), {1, 1, 1, 1}, kExact, "a mirror");
}

TEST_P(SurfaceTextureTest, AnEmissionTextureMultipliesTheEmission) {
  Material lamp = chalk({0.0f, 0.0f, 0.5f});
  lamp.emission = {4.0f, 2.0f, 0.0f};
  Scene scene = texturedSquare(lamp, &Material::emission_map, textureOfTexels(1, {Texel{188, 188, 188, 255}}));
  scene.textures[0].srgb = true;
  // 188 is 0.5029 in linear light.
  expectNear(seen(scene, whiteLight()), {4.0f * 0.5029f, 2.0f * 0.5029f, 0.5f, 1.0f}, 4.0f * kSrgb, "lamp");
}

/// A normal map's texel on a mirror, and where the mirror then looks.
struct NormalCase {
  const char* what;
  Texel texel;
  glm::vec3 looks;
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};
  float scale = 1.0f;
  glm::mat4 world_from_object{1.0f};
};

// A ray along −Z that meets a normal n leaves in the direction (2 nx nz, 2 ny nz, 2 nz² − 1): (0.96, 0, 0.28) for the
// normal (0.6, 0, 0.8).
TEST_P(SurfaceTextureTest, ANormalMapBendsWhereAMirrorLooks) {
  const glm::mat4 quarter = glm::rotate(glm::mat4(1.0f), kQuarterTurn_rad, glm::vec3(0, 0, 1));
  const NormalCase cases[] = {
      {"flat", kFlat, {0.0f, 0.0f, 1.0f}},
      {"+X along the tangent", kRightwards, {0.96f, 0.0f, 0.28f}},
      {"+Y up along the bitangent", kUpwards, {0.0f, 0.96f, 0.28f}},
      {"the bitangent's sign", kUpwards, {0.0f, -0.96f, 0.28f}, {1.0f, 0.0f, 0.0f, -1.0f}},
      {"a mirrored texture, +X", kRightwards, {-0.96f, 0.0f, 0.28f}, {-1.0f, 0.0f, 0.0f, -1.0f}},
      {"a mirrored texture, +Y", kUpwards, {0.0f, 0.96f, 0.28f}, {-1.0f, 0.0f, 0.0f, -1.0f}},
      {"no strength", kRightwards, {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f, 1.0f}, 0.0f},
      // (0.3, 0, 0.8) / √0.73
      {"half the strength", kRightwards, {0.48f / 0.73f, 0.0f, 1.28f / 0.73f - 1.0f}, {1.0f, 0.0f, 0.0f, 1.0f}, 0.5f},
      {"a square turned by 90°", kRightwards, {0.0f, 0.96f, 0.28f}, {1.0f, 0.0f, 0.0f, 1.0f}, 1.0f, quarter},
      // The back's tangent points to −X and so does the normal before it is turned to the viewer.
      {"the back, +X", kRightwards, {0.96f, 0.0f, 0.28f}, {1.0f, 0.0f, 0.0f, 1.0f}, 1.0f, turnedRound()},
      {"the back, +Y", kUpwards, {0.0f, -0.96f, 0.28f}, {1.0f, 0.0f, 0.0f, 1.0f}, 1.0f, turnedRound()},
  };
  for (const NormalCase& normal_case : cases) {
    Scene scene =
        texturedSquare(*materialNamed("mirror"), &Material::normal_map, textureOfTexels(1, {normal_case.texel}));
    scene.materials[0].normal_scale = normal_case.scale;
    scene.materials[0].double_sided = true;
    for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.tangent = normal_case.tangent;
    scene.instances[0].world_from_object = normal_case.world_from_object;
    expectNear(seen(scene, compass()), glm::vec4((1.0f + normal_case.looks) / 2.0f, 1.0f), kBentNormal,
               normal_case.what);
  }
}

/// Alpha 0.6 · 0.7 · 0.8 = 0.336 from texture, opacity and vertex colours.
Scene partlyOpaque(AlphaMode mode) {
  Material material = chalk({1.0f, 0.5f, 0.0f});
  material.opacity = 0.7f;
  material.alpha_mode = mode;
  Scene scene = texturedSquare(material, &Material::base_color_map, textureOfTexels(1, {Texel{255, 255, 255, 153}}));
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.color.w = 0.8f;
  return scene;
}

TEST_P(SurfaceTextureTest, AMaskShowsAllOrNothing) {
  Material material = chalk();
  material.alpha_mode = AlphaMode::mask;
  const Scene stencil = texturedSquare(material, &Material::base_color_map,
                                       textureOfTexels(2, {Texel{255, 255, 255, 127}, Texel{255, 255, 255, 128}}));
  const Image image = drawn(stencil, whiteLight(), {.cells = 2});
  expectNear(cell(image, 0, 0), kNothing, kExact, "127 is below a cutoff of one half");
  expectNear(cell(image, 1, 0), {1, 1, 1, 1}, kExact, "128 is above it");

  // Without one of the three factors alpha would be above 0.4.
  Scene scene = partlyOpaque(AlphaMode::mask);
  scene.materials[0].alpha_cutoff = 0.4f;
  expectNear(seen(scene, whiteLight()), kNothing, kExact, "0.336 is below a cutoff of 0.4");
  scene.materials[0].alpha_cutoff = 0.3f;
  expectNear(seen(scene, whiteLight()), {1.0f, 0.5f, 0.0f, 1.0f}, kExact, "and above one of 0.3");
}

TEST_P(SurfaceTextureTest, BlendMixesByAlphaAndOpaqueIgnoresIt) {
  const Scene blended = partlyOpaque(AlphaMode::blend);
  expectNear(seen(blended, whiteLight()), {0.336f, 0.168f, 0.0f, 0.336f}, kExact, "over nothing");
  expectNear(seen(blended, whiteLight(), {.background = glm::vec3(0, 0, 1)}), {0.336f, 0.168f, 0.664f, 1.0f}, kExact,
             "over blue");
  expectNear(seen(partlyOpaque(AlphaMode::opaque), whiteLight()), {1.0f, 0.5f, 0.0f, 1.0f}, kExact, "opaque");
}

// Of one mesh, so that nothing sorts them: the nearer layer is drawn first, and depth must not keep the other one out.
TEST_P(SurfaceTextureTest, LayersOfABlendedMeshDoNotHideEachOther) {
  Mesh layers = square(0.5f);
  const Mesh farther = square(-0.5f);
  layers.vertices.insert(layers.vertices.end(), farther.vertices.begin(), farther.vertices.end());
  for (const std::uint32_t index : farther.indices) layers.indices.push_back(index + 4);
  Material material = chalk();
  material.opacity = 0.5f;
  material.alpha_mode = AlphaMode::blend;
  expectNear(seen(meshScene(layers, material), whiteLight()), glm::vec4(0.75f), kExact, "a half and a quarter");
}

/// Two half transparent squares: red at those depths of its mesh and its instance, green behind at their opposites.
Scene redBeforeGreen(float mesh_depth, float instance_depth) {
  Scene scene;
  for (const float side : {1.0f, -1.0f}) {
    const int index = static_cast<int>(scene.meshes.size());
    Material material = chalk(side > 0.0f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
    material.opacity = 0.5f;
    material.alpha_mode = AlphaMode::blend;
    material.double_sided = true;
    scene.materials.push_back(material);
    scene.meshes.push_back(square(side * mesh_depth));
    scene.meshes.back().edit().material = index;
    scene.instances.push_back({index, glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, side * instance_depth))});
  }
  return scene;
}

TEST_P(SurfaceTextureTest, BlendedSurfacesAreDrawnFarthestFirst) {
  // The nearer gives a half, the farther a quarter, the blue background the rest.
  const glm::vec4 red_nearer(0.5f, 0.25f, 0.25f, 1.0f);
  const glm::vec4 green_nearer(0.25f, 0.5f, 0.25f, 1.0f);
  const auto expect_seen = [&](const Scene& scene, glm::vec4 front, glm::vec4 back, const std::string& what) {
    View view{.background = glm::vec3(0, 0, 1)};
    expectNear(seen(scene, whiteLight(), view), front, kExact, what + ", from the front");
    view.azimuth_deg = 180.0f;
    expectNear(seen(scene, whiteLight(), view), back, kExact, what + ", from the back");
  };
  expect_seen(redBeforeGreen(0.0f, 0.5f), red_nearer, green_nearer, "apart as instances");
  Scene scene = redBeforeGreen(0.5f, 0.0f);
  expect_seen(scene, red_nearer, green_nearer, "apart in their meshes");
  std::swap(scene.instances[0], scene.instances[1]);
  expect_seen(scene, red_nearer, green_nearer, "listed the other way round");
  for (Instance& instance : scene.instances) instance.world_from_object = turnedRound();
  expect_seen(scene, green_nearer, red_nearer, "turned round");
  expect_seen(redBeforeGreen(0.5f, -0.75f), green_nearer, red_nearer, "moved past each other");

  scene = redBeforeGreen(0.5f, 0.0f);
  scene.materials[0].alpha_mode = AlphaMode::opaque;
  expect_seen(scene, {1, 0, 0, 1}, {0.5f, 0.5f, 0.0f, 1.0f}, "red opaque");
}

TEST_P(SurfaceTextureTest, OnlyADoubleSidedSurfaceHasABack) {
  Scene scene = meshScene(square(), chalk());
  for (const bool double_sided : {false, true}) {
    scene.materials[0].double_sided = double_sided;
    scene.instances[0].world_from_object = glm::mat4(1.0f);
    expectNear(seen(scene, compass()), kChalkTowardsCamera, kExact, "front");
    scene.instances[0].world_from_object = turnedRound();
    // With a normal that points away from the viewer, blue would be 1/6.
    expectNear(seen(scene, compass()), double_sided ? kChalkTowardsCamera : kNothing, kExact, "back");
  }
}

TEST_P(SurfaceTextureTest, AnOpacityThatIsSetLetsTheBackgroundThrough) {
  Scene scene = meshScene(square(), chalk({1.0f, 0.5f, 0.0f}));
  ASSERT_TRUE(setParameter(scene.materials[0], "opacity=0.25"));
  expectNear(seen(scene, whiteLight()), {0.25f, 0.125f, 0.0f, 0.25f}, kExact, "over nothing");
  expectNear(seen(scene, whiteLight(), {.background = glm::vec3(0, 0, 1)}), {0.25f, 0.125f, 0.75f, 1.0f}, kExact,
             "over blue");
}

}  // namespace
}  // namespace mirrorball
