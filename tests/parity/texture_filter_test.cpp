/// The formula of texture filtering reads a texture as the OpenGL driver does.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "formula/surface.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"
#include "parity/formula_files.h"

namespace mirrorball::parity {
namespace {

/// Drivers weigh texels by fractions of 8 bits, across and down, and may round the mean to 8 bits.
constexpr float kFilteredByDriver = 3.0f / 255.0f;

constexpr std::string_view kFilterVertexShader =
    "void main() {\n"
    "  gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0, float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n"
    "}\n";
// Five maps across and down, the middle one being the map itself: what the driver shows, and in alpha how far off the
// formula is.
constexpr std::string_view kFragmentShader =
    "#include \"filter_kind.glsl\"\n"
    "#include \"texture_wrap.glsl\"\n"
    "#include \"texture_filter.glsl\"\n"
    "uniform sampler2D map;\n"
    "uniform float lod;\n"
    "uniform vec3 sampling;\n"
    "out vec4 fragment;\n"
    "void main() {\n"
    "  vec2 uv = gl_FragCoord.xy / 96.0 * 5.0 - 2.0;\n"
    "  MapSampling how = MapSampling(int(sampling.x), int(sampling.y), sampling.z > 0.5);\n"
    "  vec4 shown = textureLod(map, uv, lod);\n"
    "  vec4 off = abs(filteredMap(map, uv, lod, how) - shown);\n"
    "  fragment = vec4(shown.xyz, max(max(off.x, off.y), max(off.z, off.w)));\n"
    "}\n";

/// Noise of 5 × 3 texels, with mip levels of noise.
Result<gl::Texture> noise() {
  MIRRORBALL_TRY(texture, gl::Texture::make2d(gl::Format::rgba8, 5, 3, gl::Texture::kAllLevels));
  std::mt19937 random(12);
  for (const glm::ivec3 size : {glm::ivec3(5, 3, 0), glm::ivec3(2, 1, 1), glm::ivec3(1, 1, 2)}) {
    Image8 image(size.x, size.y, 4);
    for (std::uint8_t& byte : image.samples()) byte = static_cast<std::uint8_t>(random());
    texture.upload(size.z, 0, image);
  }
  return Result<gl::Texture>(std::move(texture));
}

/// Of a picture that kFragmentShader drew: the ends of its red, and the largest alpha.
std::array<float, 3> extremes(const Image& image) {
  std::array<float, 3> found{1.0f, 0.0f, 0.0f};
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4 texel = rgbaAt(image, x, y);
      found = {std::min(found[0], texel.x), std::max(found[1], texel.x), std::max(found[2], texel.w)};
    }
  return found;
}

class TextureFilterTest : public gl::GlTest {};
MIRRORBALL_WITH_BOTH_APIS(TextureFilterTest);

// At whole levels: between them drivers are free to hurry (Mesa's mixes only half of the way).
TEST_P(TextureFilterTest, ReadsAsTheDriverDoes) {
  const auto find = [](std::string_view name) -> std::optional<std::string_view> {
    if (name == "filter.vert") return kFilterVertexShader;
    if (name == "filter.frag") return kFragmentShader;
    return findParityText(name);
  };
  const auto vertex = gl::shaderSource(GetParam(), "filter.vert", {}, find);
  const auto fragment = gl::shaderSource(GetParam(), "filter.frag", {}, find);
  ASSERT_TRUE(vertex && fragment);
  auto program = gl::Program::build(*vertex, *fragment, "filter");
  ASSERT_TRUE(program) << program.error().message;
  auto framebuffer = gl::Framebuffer::make(gl::Format::rgba32f, 96, 96);
  ASSERT_TRUE(framebuffer) << framebuffer.error().message;
  auto texture = noise();
  ASSERT_TRUE(texture) << texture.error().message;
  texture->bind(0);
  program->set("map", 0);
  const gl::VertexArray triangle;
  using Wrap = gl::Sampling::Wrap;
  constexpr std::array<Wrap, 3> kWraps{Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge};  // by formula::kWrap…
  for (int how = 0; how < 6; ++how) {
    const int s = how % 3;
    const int t = (s + 1) % 3;
    const bool nearest = how >= 3;
    texture->setSampling(
        {.magnify_nearest = nearest, .wrap_s = kWraps[std::size_t(s)], .wrap_t = kWraps[std::size_t(t)]});
    program->set("sampling", glm::vec3(s, t, nearest));
    for (const float lod : {0.0f, 1.0f, 2.0f}) {
      framebuffer->bind();
      program->set("lod", lod);
      triangle.draw(3);
      const auto [darkest, brightest, off] = extremes(framebuffer->readFloat());
      EXPECT_EQ(brightest - darkest > 0.5f, lod < 2.0f) << "level 2 is one texel, the others are noise";
      EXPECT_LE(off, kFilteredByDriver) << "wrap " << s << ", " << t << (nearest ? ", nearest" : "") << ", level "
                                        << lod;
    }
  }
}

}  // namespace
}  // namespace mirrorball::parity
