#include "parity/evaluation.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/file.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/shader_source.h"
#include "mirrorball/gl/texture.h"
#include "parity/formula_files.h"

namespace mirrorball::parity {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kVertexShader =
    "void main() {\n"
    "  gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0,\n"
    "                     float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n"
    "}\n";

/// A fragment shader that evaluates an expression at input number x in the pixel of column x.
std::string fragmentShader(const std::string& before, const std::string& expression) {
  return before +
         "uniform sampler2D inputs;\n"
         "out vec4 result;\n"
         "void main() {\n"
         "  int column = int(gl_FragCoord.x);\n"
         "  vec4 p = texelFetch(inputs, ivec2(column, 0), 0);\n"
         "  vec4 q = texelFetch(inputs, ivec2(column, 1), 0);\n"
         "  vec4 r = texelFetch(inputs, ivec2(column, 2), 0);\n"
         "  result = " +
         expression + ";\n}\n";
}

Image imageOf(const std::vector<Input>& inputs) {
  Image image(static_cast<int>(inputs.size()), 3, 4);
  for (int x = 0; x < image.width(); ++x) {
    const Input& input = inputs[static_cast<std::size_t>(x)];
    const std::array<glm::vec4, 3> rows = {input.p, input.q, input.r};
    for (int y = 0; y < 3; ++y) {
      for (int channel = 0; channel < 4; ++channel) {
        image.texel(x, y)[channel] = rows[static_cast<std::size_t>(y)][channel];
      }
    }
  }
  return image;
}

}  // namespace

Result<Image> evaluate(gl::Api api, const std::string& before, const std::string& expression, const std::string& name,
                       const std::vector<Input>& inputs, const std::function<void(gl::Program&)>& set) {
  const std::string fragment_text = fragmentShader(before, expression);
  const auto find = [&](std::string_view file) -> std::optional<std::string_view> {
    if (file == "parity.vert") return kVertexShader;
    if (file == "parity.frag") return fragment_text;
    return findParityText(file);
  };
  MIRRORBALL_TRY(vertex, gl::shaderSource(api, "parity.vert", {}, find));
  MIRRORBALL_TRY(fragment, gl::shaderSource(api, "parity.frag", {}, find));
  MIRRORBALL_TRY(program, gl::Program::build(vertex, fragment, name));
  const int count = static_cast<int>(inputs.size());
  MIRRORBALL_TRY(texture, gl::Texture::make2d(gl::Format::rgba32f, count, 3));
  MIRRORBALL_TRY(framebuffer, gl::Framebuffer::make(gl::Format::rgba32f, count, 1));
  texture.upload(0, 0, imageOf(inputs));
  texture.bind(0);
  framebuffer.bind();
  program.set("inputs", 0);
  if (set) set(program);
  gl::VertexArray().draw(3);
  return framebuffer.readFloat();
}

bool hasGlslang() { return std::system("glslangValidator --version > /dev/null 2>&1") == 0; }

void expectGlslangTakes(const std::vector<GlslFile>& files, gl::Api api) {
  constexpr std::size_t kAtOnce = 64;
  // CTest runs the cases of this program at the same time, each in a process of its own.
  const fs::path folder = fs::path(::testing::TempDir()) / (std::to_string(::getpid()) + "_shaders");
  fs::create_directories(folder);
  for (std::size_t first = 0; first < files.size(); first += kAtOnce) {
    std::string command = "cd '" + folder.string() + "' && glslangValidator";
    for (std::size_t i = first; i < std::min(first + kAtOnce, files.size()); ++i) {
      const auto& [name, text] = files[i];
      const auto written =
          writeFile(folder / name, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
      ASSERT_TRUE(written) << written.error().message;
      command += " '" + name + "'";
    }
    EXPECT_EQ(std::system((command + " > log").c_str()), 0) << "as " << gl::nameOf(api) << "\n"
                                                            << std::ifstream(folder / "log").rdbuf();
  }
  fs::remove_all(folder);
}

}  // namespace mirrorball::parity
