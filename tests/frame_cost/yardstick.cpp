#include "frame_cost/yardstick.h"

#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/shader_source.h"

namespace mirrorball::testing {
namespace {

constexpr std::string_view kFragment = R"(uniform samplerCube cube;
in vec2 screen;
out vec4 color;

void main() {
  vec3 direction = normalize(vec3(screen, 1.0));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 24; ++i) {
    sum += exp2(-sum) * textureLod(cube, direction, 2.0 + sin(float(i))).xyz;
    direction = normalize(reflect(direction, normalize(sum - vec3(0.3, 0.2, 0.1) * float(i))));
  }
  color = vec4(sum, 1.0);
}
)";
constexpr int kSide = 320;      // pixels of the picture
constexpr int kCubeSide = 256;  // texels of a face

std::optional<std::string_view> fragmentNamed(std::string_view name) {
  return name == "yardstick.frag" ? std::optional(kFragment) : std::nullopt;
}

/// Values that change from texel to texel, so that no filter is spared its work.
Result<gl::Texture> patternedCube() {
  MIRRORBALL_TRY(cube, gl::Texture::makeCube(gl::Format::rgba16f, kCubeSide, gl::Texture::kAllLevels));
  Image face(kCubeSide, kCubeSide, 3);
  for (std::size_t i = 0; i < face.samples().size(); ++i)
    face.samples()[i] = static_cast<float>(i * 7919 % 1009) / 1009.0f;
  for (int side = 0; side < 6; ++side) cube.upload(0, side, face);
  cube.makeLevels();
  return cube;
}

}  // namespace

Result<Yardstick> Yardstick::make() {
  MIRRORBALL_TRY(vertex, gl::shaderSource(gl::Api::desktop43, "screen.vert"));
  MIRRORBALL_TRY(fragment, gl::shaderSource(gl::Api::desktop43, "yardstick.frag", {}, fragmentNamed));
  MIRRORBALL_TRY(program, gl::Program::build(vertex, fragment, "the yardstick"));
  MIRRORBALL_TRY(cube, patternedCube());
  MIRRORBALL_TRY(picture, gl::Framebuffer::make(gl::Format::rgba16f, kSide, kSide));
  return Yardstick(std::move(program), std::move(cube), std::move(picture));
}

void Yardstick::run() {
  picture_.bind();
  gl::drawOverAll();
  program_.set("cube", 0);
  cube_.bind(0);
  vertices_.draw(3);
  glFinish();
}

}  // namespace mirrorball::testing
