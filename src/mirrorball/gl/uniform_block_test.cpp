#include "mirrorball/gl/uniform_block.h"

#include <array>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"

namespace mirrorball::gl {
namespace {

std::optional<std::string_view> findBlockShader(std::string_view name) {
  static const std::map<std::string_view, std::string_view> kTexts = {
      {"screen.vert",
       "void main() {\n"
       "  gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0, float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n"
       "}\n"},
      // vec3 before float, float before mat3, int before vec4[]: where std140 leaves gaps or not.
      {"block.frag",
       "struct Part { vec3 triple; float one; int whole; };\n"
       "layout(std140) uniform TestBlock {\n"
       "  Part part;\n"
       "  mat3 small;\n"
       "  float between;\n"
       "  mat4 large;\n"
       "  vec4 list[3];\n"
       "  float never_read;\n"
       "};\n"
       "out vec4 color;\n"
       "void main() {\n"
       "  color = vec4(part.triple.z + part.one + float(part.whole), small[2].x + between, large[3].y, list[2].w);\n"
       "}\n"},
  };
  const auto found = kTexts.find(name);
  if (found == kTexts.end()) return std::nullopt;
  return found->second;
}

class UniformBlockTest : public GlTest {
 protected:
  static Result<Program> build() {
    MIRRORBALL_TRY(vertex, shaderSource(GetParam(), "screen.vert", {}, findBlockShader));
    MIRRORBALL_TRY(fragment, shaderSource(GetParam(), "block.frag", {}, findBlockShader));
    return Program::build(vertex, fragment, "test");
  }

  /// The only pixel of what the program draws.
  static glm::vec4 drawn(Program& program) {
    auto framebuffer = Framebuffer::make(Format::rgba32f, 1, 1);
    EXPECT_TRUE(framebuffer);
    framebuffer->bind();
    program.use();
    VertexArray().draw(3);
    return rgbaAt(framebuffer->readFloat(), 0, 0);
  }
};

MIRRORBALL_WITH_BOTH_APIS(UniformBlockTest);

TEST_P(UniformBlockTest, EveryTypeArrivesAtItsPlace) {
  auto program = build();
  ASSERT_TRUE(program) << program.error().message;
  const auto layout = program->connect("TestBlock", 3);
  ASSERT_TRUE(layout);
  UniformBlock block(std::make_shared<BlockLayout>(*layout));
  block.set("part.triple", glm::vec3(9.0f, 9.0f, 1.0f));
  block.set("part.one", 2.0f);
  block.set("part.whole", 4);
  glm::mat3 small(0.0f);
  small[2].x = 8.0f;
  block.set("small", small);
  block.set("between", 16.0f);
  glm::mat4 large(0.0f);
  large[3].y = 32.0f;
  block.set("large", large);
  const std::array<glm::vec4, 3> list{glm::vec4(9.0f), glm::vec4(9.0f), glm::vec4(0.0f, 0.0f, 0.0f, 64.0f)};
  block.set("list", std::span<const glm::vec4>(list));
  block.set("never_read", 1.0f);
  block.bind(3);
  EXPECT_EQ(drawn(*program), glm::vec4(7.0f, 24.0f, 32.0f, 64.0f));

  block.set("between", 1.0f);
  block.bind(3);
  EXPECT_EQ(drawn(*program).y, 9.0f) << "what changed is sent";
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_P(UniformBlockTest, ManyLieInOneBufferAndOnlyWhatChangedIsSent) {
  auto program = build();
  ASSERT_TRUE(program) << program.error().message;
  const auto layout = program->connect("TestBlock", 3);
  ASSERT_TRUE(layout);
  constexpr std::size_t kBlocks = 50;
  UniformBlock blocks(std::make_shared<BlockLayout>(*layout), kBlocks);
  for (std::size_t i = 0; i < kBlocks; ++i) {
    blocks.at(i).set("part.one", float(i));
    blocks.set("between", 100.0f * float(i));
  }
  for (const std::size_t i : {std::size_t{7}, std::size_t{49}, std::size_t{0}}) {
    blocks.bind(3, i);
    const glm::vec4 pixel = drawn(*program);
    EXPECT_EQ(pixel.x, float(i));
    EXPECT_EQ(pixel.y, 100.0f * float(i));
  }
  const std::size_t all = blocks.bytesSent();
  EXPECT_GE(all, kBlocks * layout->size());
  blocks.at(20).set("part.one", 1.0f);
  blocks.bind(3, 20);
  EXPECT_EQ(drawn(*program).x, 1.0f);
  EXPECT_EQ(blocks.bytesSent() - all, all / kBlocks);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_P(UniformBlockTest, KnowsWhatThereIsNot) {
  auto program = build();
  ASSERT_TRUE(program);
  EXPECT_FALSE(program->connect("OtherBlock", 0));
  const auto layout = program->connect("TestBlock", 0);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->find("part.misspelt"), nullptr);
  EXPECT_NE(layout->find("part.whole"), nullptr);
}

}  // namespace
}  // namespace mirrorball::gl
