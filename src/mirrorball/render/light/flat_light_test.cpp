#include "mirrorball/render/light/flat_light.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "formula/projection.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "shaders/embedded_text.h"

namespace mirrorball {
namespace {

constexpr int kSide = 16;  ///< texels of a face
constexpr int kLevels = 5;

constexpr std::string_view kVertexShader =
    "void main() { gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0, float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, "
    "1.0); "
    "}\n";

/// A cube whose texels have nothing to do with each other.
ImageSet noise() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  ImageSet cube(kLevels, 6);
  for (int level = 0; level < kLevels; ++level)
    for (int face = 0; face < 6; ++face) {
      Image image(levelSide(kSide, level), levelSide(kSide, level), 3);
      std::ranges::generate(image.samples(), [&] { return unit(random); });
      cube.at(level, face) = std::move(image);
    }
  return cube;
}

std::vector<glm::vec3> directions() {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  std::vector<glm::vec3> all;
  while (all.size() < 4000) {
    const glm::vec3 d(coordinate(random), coordinate(random), coordinate(random));
    if (glm::dot(d, d) > 0.01f) all.push_back(glm::normalize(d));
  }
  return all;
}

/// How far a direction is from the lines between the centres of texels, and between texels, in texels of level 0;
/// below 0 in the half texel along a face's edge.
struct Distances {
  float from_border;
  float within_face;
};

Distances distancesOf(glm::vec3 d) {
  const glm::vec2 place = formula::cubeCoordinates(formula::cubeFace(d), d) * float(kSide);
  const glm::vec2 from_border = 0.5f - glm::abs(glm::fract(place) - 0.5f);
  const glm::vec2 from_edge = float(kSide) / 2.0f - 0.5f - glm::abs(place - float(kSide) / 2.0f);
  return {std::min(from_border.x, from_border.y), std::min(from_edge.x, from_edge.y)};
}

class FlatLightTest : public gl::GlTest {
 protected:
  /// An expression of the direction d, with the samplers `cube` and `flat_cube`, for all directions.
  Image evaluated(const std::string& expression, const gl::Texture& cube, const gl::Texture& flat_cube,
                  const std::vector<glm::vec3>& all) {
    const std::string text =
        "#include \"cube.glsl\"\n#include \"flat_cube.glsl\"\n"
        "uniform sampler2D directions;\nuniform samplerCube cube;\nuniform sampler2D flat_cube;\nout vec4 result;\n"
        "void main() {\n  vec3 d = texelFetch(directions, ivec2(int(gl_FragCoord.x), 0), 0).xyz;\n  result = " +
        expression + ";\n}\n";
    const gl::FindText find = [&](std::string_view name) -> std::optional<std::string_view> {
      return name == "flat.vert" ? kVertexShader : name == "flat.frag" ? std::string_view(text) : embeddedText(name);
    };
    auto vertex = gl::shaderSource(GetParam(), "flat.vert", {}, find);
    auto fragment = gl::shaderSource(GetParam(), "flat.frag", {}, find);
    auto program = gl::Program::build(*vertex, *fragment, "flat");
    EXPECT_TRUE(program) << program.error().message;
    const int count = static_cast<int>(all.size());
    Image image(count, 1, 4);
    for (int x = 0; x < count; ++x) std::copy_n(&all[std::size_t(x)].x, 3, image.texel(x, 0));
    auto inputs = gl::Texture::make2d(gl::Format::rgba32f, count, 1);
    inputs->upload(0, 0, image);
    auto target = gl::Framebuffer::make(gl::Format::rgba32f, count, 1);
    target->bind();
    inputs->bind(0);
    cube.bind(1);
    flat_cube.bind(2);
    program->set("directions", 0);
    if (expression.find("(cube,") != std::string::npos) program->set("cube", 1);
    if (expression.find("(flat_cube,") != std::string::npos) program->set("flat_cube", 2);
    program->use();
    gl::VertexArray().draw(3);
    return target->readFloat();
  }
};

MIRRORBALL_WITH_BOTH_APIS(FlatLightTest);

TEST_P(FlatLightTest, HoldsEveryTexelOfEveryLevel) {
  const ImageSet images = noise();
  const auto cube = gl::Texture::fromImages(gl::Format::rgba16f, images);
  ASSERT_TRUE(cube);
  const auto flat = flattened(*cube);
  ASSERT_TRUE(flat) << flat.error().message;
  for (int level = 0; level < kLevels; ++level) {
    const Image picture = flat->read(level);
    const int side = levelSide(kSide, level);
    for (int face = 0; face < 6; ++face) {
      const Image of_face = cube->read(level, face);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          ASSERT_EQ(rgbAt(picture, face % 3 * side + x, face / 3 * side + y), rgbAt(of_face, x, y));
    }
  }
}

TEST_P(FlatLightTest, TheNearestTexelIsTheCubeSamplers) {
  auto cube = gl::Texture::fromImages(gl::Format::rgba16f, noise());
  ASSERT_TRUE(cube);
  cube->setSampling({.filter = gl::Sampling::Filter::nearest});
  const auto flat = flattened(*cube);
  ASSERT_TRUE(flat);
  const std::vector<glm::vec3> all = directions();
  const Image expected = evaluated("sampleLod(cube, d, 0.0)", *cube, *flat, all);
  const Image found = evaluated("flatNearestLod(flat_cube, d, 0.0)", *cube, *flat, all);
  int compared = 0;
  for (int x = 0; x < found.width(); ++x) {
    if (distancesOf(all[std::size_t(x)]).from_border < 0.01f) continue;
    ++compared;
    ASSERT_EQ(rgbAt(found, x, 0), rgbAt(expected, x, 0)) << x;
  }
  EXPECT_GT(compared, 3000);
}

// Where a texel beyond an edge has a say, the cube sampler takes it from the neighbouring face, and the flat look-up
// has none.
TEST_P(FlatLightTest, TheFourTexelsAreTheCubeSamplersButAlongTheEdges) {
  auto cube = gl::Texture::fromImages(gl::Format::rgba16f, noise());
  ASSERT_TRUE(cube);
  cube->setSampling({.filter = gl::Sampling::Filter::trilinear});
  const auto flat = flattened(*cube);
  ASSERT_TRUE(flat);
  const std::vector<glm::vec3> all = directions();
  for (const char* lod : {"0.0", "1.5", "9.0"}) {
    const Image expected = evaluated(std::string("sampleLod(cube, d, ") + lod + ")", *cube, *flat, all);
    const Image found = evaluated(std::string("flatTrilinear(flat_cube, d, ") + lod + ")", *cube, *flat, all);
    float within = 0.0f, along_edges = 0.0f;
    for (int x = 0; x < found.width(); ++x) {
      const glm::vec3 apart = glm::abs(rgbAt(found, x, 0) - rgbAt(expected, x, 0));
      // Half a texel of the coarser level, in those of level 0.
      const float margin = lod[0] == '0' ? 0.0f : lod[0] == '1' ? 1.5f : float(kSide);
      const bool is_within = distancesOf(all[std::size_t(x)]).within_face > margin;
      float& greatest = is_within ? within : along_edges;
      greatest = std::max({greatest, apart.x, apart.y, apart.z});
    }
    EXPECT_LT(within, 0.01f) << "drivers weigh texels by 8-bit fractions; lod " << lod;
    EXPECT_GT(along_edges, 0.1f) << "the seams; lod " << lod;
    EXPECT_LT(along_edges, 1.0f) << lod;
  }
}

TEST_P(FlatLightTest, DrawsWhatTheCubeSamplerDraws) {
  const Environment environment([](glm::vec3 d) { return d * 0.5f + 0.5f; }, 128);
  for (const char* roughness : {"0", "0.5"}) {
    Material metal = *materialNamed("mirror");
    ASSERT_TRUE(setParameter(metal, std::string("perceptual_roughness=") + roughness));
    auto renderer =
        testing::rendererOf(meshScene(sphereMesh(64, 128), metal), environment, *testing::prepareOnce(environment));
    ASSERT_TRUE(renderer) << renderer.error().message;
    FrameSettings frame;
    frame.size = {64, 64};
    frame.samples = 1;
    frame.camera.orthographic_height = 2.0f;
    const auto meanDifference = [&](LightLookUp look_up, BlurKind blur) {
      frame.blur = blur;
      frame.look_up = LightLookUp::cube;
      const Image by_sampler = *renderer->renderRadiance(frame);
      frame.look_up = look_up;
      const Image by_shader = *renderer->renderRadiance(frame);
      double sum = 0.0;
      for (std::size_t i = 0; i < by_shader.samples().size(); ++i)
        sum += std::abs(double(by_shader.samples()[i]) - double(by_sampler.samples()[i]));
      return sum / double(by_shader.samples().size());
    };
    // On average: along the edges, and at the rim, where texels are coarse, it is more.
    const bool is_rough = roughness[1] != '\0';
    for (const BlurKind blur : {BlurKind::exact, BlurKind::gpu, BlurKind::mip, BlurKind::cone}) {
      // By a mip level it reads two texels a face.
      const double bound = !is_rough ? 1e-4 : blur == BlurKind::mip ? 0.03 : 1.5e-3;
      EXPECT_LT(meanDifference(LightLookUp::flat, blur), bound) << roughness << " " << int(blur);
    }
    const double nearest = meanDifference(LightLookUp::flat_nearest, BlurKind::exact);
    EXPECT_GT(nearest, is_rough ? 4e-3 : 1e-3) << "its texels are squares";
    EXPECT_LT(nearest, is_rough ? 0.02 : 6e-3) << roughness;
  }
}

}  // namespace
}  // namespace mirrorball
