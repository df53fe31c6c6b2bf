#include "mirrorball/gl/program.h"

#include <array>
#include <map>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::gl {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::optional<std::string_view> findProgramShader(std::string_view name) {
  static const std::map<std::string_view, std::string_view> kTexts = {
      {"screen.vert",
       "out vec2 written_as_pair;\n"
       "void main() {\n"
       "  written_as_pair = vec2(1.0);\n"
       "  gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0,\n"
       "                     float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n"
       "}\n"},
      {"uniforms.frag",
       "uniform float one;\n"
       "uniform int two;\n"
       "uniform vec2 pair;\n"
       "uniform vec3 triple;\n"
       "uniform vec4 four;\n"
       "uniform mat3 small;\n"
       "uniform mat4 large;\n"
       "uniform vec4 list[3];\n"
       "uniform float unused;\n"
       "out vec4 color;\n"
       "void main() {\n"
       "  color = vec4(one + float(two) + pair.y, triple.z + four.w,\n"
       "               small[2].x + large[3].y, list[0].x + list[2].z);\n"
       "}\n"},
      {"broken.glsl", "// fine\n// fine\nFN float broken() { return nowhere; }\n"},
      {"broken.frag", "#include \"broken.glsl\"\nout vec4 color;\nvoid main() {}\n"},
      {"late.frag", "#include \"empty.glsl\"\nout vec4 color;\nvoid main() {\n  color = late;\n}\n"},
      {"empty.glsl", "\n\n\n"},
      {"unlinked.frag",
       "in vec3 written_as_pair;\nout vec4 color;\n"
       "void main() { color = vec4(written_as_pair, 1.0); }\n"},
  };
  const auto found = kTexts.find(name);
  if (found == kTexts.end()) return std::nullopt;
  return found->second;
}

class ProgramTest : public GlTest {
 protected:
  static Result<Program> build(std::string_view fragment_entry) {
    MIRRORBALL_TRY(vertex, shaderSource(GetParam(), "screen.vert", {}, findProgramShader));
    MIRRORBALL_TRY(fragment, shaderSource(GetParam(), fragment_entry, {}, findProgramShader));
    return Program::build(vertex, fragment, "test");
  }
};

MIRRORBALL_WITH_BOTH_APIS(ProgramTest);

TEST_P(ProgramTest, TakesUniformsOfEveryType) {
  auto program = build("uniforms.frag");
  ASSERT_TRUE(program) << program.error().message;
  program->set("one", 1.0f);
  program->set("two", 2);
  program->set("pair", glm::vec2(9.0f, 4.0f));
  program->set("triple", glm::vec3(9.0f, 9.0f, 8.0f));
  program->set("four", glm::vec4(9.0f, 9.0f, 9.0f, 16.0f));
  glm::mat3 small(0.0f);
  small[2].x = 32.0f;
  program->set("small", small);
  glm::mat4 large(0.0f);
  large[3].y = 64.0f;
  program->set("large", large);
  const std::array<glm::vec4, 3> kList = {glm::vec4(128.0f, 9.0f, 9.0f, 9.0f), glm::vec4(9.0f),
                                          glm::vec4(9.0f, 9.0f, 256.0f, 9.0f)};
  program->set("list", kList);
  program->set("unused", 1.0f);

  auto framebuffer = Framebuffer::make(Format::rgba32f, 1, 1);
  ASSERT_TRUE(framebuffer) << framebuffer.error().message;
  framebuffer->bind();
  VertexArray().draw(3);
  EXPECT_EQ(rgbaAt(framebuffer->readFloat(), 0, 0), glm::vec4(7.0f, 24.0f, 96.0f, 384.0f));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_P(ProgramTest, ErrorsNameFileAndLine) {
  const auto included = build("broken.frag");
  ASSERT_FALSE(included);
  EXPECT_THAT(included.error().message, StartsWith("test: "));
  EXPECT_THAT(included.error().message, HasSubstr("broken.glsl:3:"));
  EXPECT_THAT(included.error().message, HasSubstr("nowhere"));
  const auto after_include = build("late.frag");
  ASSERT_FALSE(after_include);
  EXPECT_THAT(after_include.error().message, HasSubstr("late.frag:4:"));
}

TEST_P(ProgramTest, SaysWhyItDoesNotLink) {
  const auto program = build("unlinked.frag");
  ASSERT_FALSE(program);
  EXPECT_THAT(program.error().message, HasSubstr("cannot link"));
  EXPECT_THAT(program.error().message, HasSubstr("written_as_pair"));
}

TEST_P(ProgramTest, IsNoLongerInUseWhenItIsDeleted) {
  {
    auto program = build("uniforms.frag");
    ASSERT_TRUE(program) << program.error().message;
    program->use();
  }
  GLint in_use = -1;
  glGetIntegerv(GL_CURRENT_PROGRAM, &in_use);
  EXPECT_EQ(in_use, 0);
}

TEST_P(ProgramTest, LoadNamesAMissingEntry) {
  const auto program = Program::load(GetParam(), "no_such.vert", "no_such.frag");
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace mirrorball::gl
