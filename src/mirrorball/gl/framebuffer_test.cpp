#include "mirrorball/gl/framebuffer.h"

#include <optional>

#include <gtest/gtest.h>

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"

namespace mirrorball::gl {
namespace {

class FramebufferTest : public GlTest {};

MIRRORBALL_WITH_BOTH_APIS(FramebufferTest);

/// Fills the lower left quarter of the picture with a colour; elsewhere it stays black.
void fillLowerLeft(const Framebuffer& framebuffer, glm::vec4 color) {
  framebuffer.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, framebuffer.width() / 2, framebuffer.height() / 2);
  glClearColor(color.r, color.g, color.b, color.a);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

TEST_P(FramebufferTest, FirstRowReadIsTheTop) {
  for (Format format : {Format::rgba8, Format::srgb8_alpha8, Format::rgba16f, Format::rgba32f}) {
    auto framebuffer = Framebuffer::make(format, 4, 6, Depths::alone);
    ASSERT_TRUE(framebuffer) << framebuffer.error().message;
    fillLowerLeft(*framebuffer, {1.0f, 0.5f, 0.25f, 0.75f});
    const Image image = framebuffer->readFloat();
    ASSERT_EQ(image.width(), 4);
    ASSERT_EQ(image.height(), 6);
    EXPECT_EQ(image.texel(0, 0)[0], 0.0f);
    EXPECT_EQ(image.texel(3, 5)[0], 0.0f);
    EXPECT_EQ(image.texel(1, 2)[0], 0.0f);
    EXPECT_EQ(image.texel(1, 3)[0], 1.0f);
    EXPECT_NEAR(image.texel(0, 5)[1], 0.5f, 0.005f);
    EXPECT_NEAR(image.texel(0, 5)[2], 0.25f, 0.005f);
    EXPECT_NEAR(image.texel(0, 5)[3], 0.75f, 0.005f);
  }
}

TEST_P(FramebufferTest, BytesAreEncodedAsTheFormatSays) {
  auto linear = Framebuffer::make(Format::rgba8, 2, 2);
  auto srgb = Framebuffer::make(Format::srgb8_alpha8, 2, 2);
  ASSERT_TRUE(linear && srgb);
  fillLowerLeft(*linear, glm::vec4(0.5f));
  fillLowerLeft(*srgb, glm::vec4(0.5f));
  EXPECT_NEAR(linear->readBytes().texel(0, 1)[0], 127.5, 1.0);
  EXPECT_NEAR(srgb->readBytes().texel(0, 1)[0], 188.0, 1.0);
  EXPECT_NEAR(srgb->readBytes().texel(0, 1)[3], 127.5, 1.0);
  EXPECT_EQ(srgb->readBytes().texel(0, 0)[0], 0);
}

TEST_P(FramebufferTest, KeepsLightAboveOne) {
  auto framebuffer = Framebuffer::make(Format::rgba16f, 2, 2);
  ASSERT_TRUE(framebuffer) << framebuffer.error().message;
  fillLowerLeft(*framebuffer, glm::vec4(1000.0f));
  EXPECT_EQ(framebuffer->readFloat().texel(0, 1)[0], 1000.0f);
}

// OpenGL ES filters no such floats, and reads black from textures that ask for it.
TEST_P(FramebufferTest, DoesNotFilterSingleFloats) {
  for (Format format : {Format::rgba32f, Format::r32f}) {
    auto framebuffer = Framebuffer::make(format, 2, 2);
    ASSERT_TRUE(framebuffer) << framebuffer.error().message;
    glBindTexture(GL_TEXTURE_2D, framebuffer->color().name());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      GLint kind = 0;
      glGetTexParameteriv(GL_TEXTURE_2D, filter, &kind);
      EXPECT_EQ(kind, GL_NEAREST);
    }
  }
}

TEST_P(FramebufferTest, TestsTheStencilOfAnother) {
  auto marked = Framebuffer::make(Format::rgba32f, 2, 2, Depths::with_stencil);
  auto other = Framebuffer::make(Format::r32f, 2, 2);
  ASSERT_TRUE(marked && other);
  ASSERT_TRUE(other->testDepthsOf(*marked));
  marked->bind();
  glClearStencil(0);
  glClear(GL_STENCIL_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 2);
  glClearStencil(1);
  glClear(GL_STENCIL_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glClearStencil(0);

  const auto leftHalf = [&](bool tests) {
    auto program = Program::build(*shaderSource(GetParam(), "screen.vert"), *shaderSource(GetParam(), "page.frag"), "");
    EXPECT_TRUE(program);
    program->set("page", glm::vec4(1.0f));
    program->use();
    other->bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (tests) glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 1);
    VertexArray().draw(3);
    glDisable(GL_STENCIL_TEST);
    const Image drawn = other->readFloat();
    EXPECT_EQ(drawn.texel(0, 0)[0], 1.0f);
    return drawn.texel(1, 0)[0] == 0.0f;
  };
  EXPECT_TRUE(leftHalf(true));
  EXPECT_FALSE(leftHalf(false));
  other->testNoDepths();
  EXPECT_FALSE(leftHalf(true)) << "without a stencil all passes";
}

constexpr std::string_view kVertex =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 color_in;\n"
    "out vec3 color;\n"
    "void main() { color = color_in; gl_Position = vec4(position, 1.0); }\n";
constexpr std::string_view kFragment =
    "in vec3 color;\n"
    "out vec4 pixel;\n"
    "void main() { pixel = vec4(color, 1.0); }\n";

TEST_P(FramebufferTest, NearerTrianglesHideThoseBehind) {
  const auto find = [](std::string_view name) -> std::optional<std::string_view> {
    return name == "v" ? kVertex : kFragment;
  };
  const auto vertex = shaderSource(GetParam(), "v", {}, find);
  const auto fragment = shaderSource(GetParam(), "f", {}, find);
  ASSERT_TRUE(vertex && fragment);
  auto program = Program::build(*vertex, *fragment, "triangles");
  ASSERT_TRUE(program) << program.error().message;

  struct Corner {
    glm::vec3 position;
    glm::vec3 color;
  };
  // The near triangle is green and covers the left half, the far one is red and covers all.
  const std::vector<Corner> corners = {
      {{-3.0f, -1.0f, -0.5f}, {0.0f, 1.0f, 0.0f}}, {{0.0f, -1.0f, -0.5f}, {0.0f, 1.0f, 0.0f}},
      {{0.0f, 9.0f, -0.5f}, {0.0f, 1.0f, 0.0f}},   {{-1.0f, -1.0f, 0.5f}, {1.0f, 0.0f, 0.0f}},
      {{3.0f, -1.0f, 0.5f}, {1.0f, 0.0f, 0.0f}},   {{-1.0f, 3.0f, 0.5f}, {1.0f, 0.0f, 0.0f}}};
  const std::vector<std::uint32_t> indices = {0, 1, 2, 3, 4, 5};
  const std::array<Attribute, 2> kAttributes = {{{0, 3, offsetof(Corner, position)}, {1, 3, offsetof(Corner, color)}}};
  const VertexArray triangles(Buffer{corners}, sizeof(Corner), kAttributes, Buffer{indices});

  auto framebuffer = Framebuffer::make(Format::rgba8, 4, 4, Depths::alone);
  ASSERT_TRUE(framebuffer);
  framebuffer->bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  program->use();
  triangles.drawIndexed(indices.size());
  const Image8 picture = framebuffer->readBytes();
  EXPECT_EQ(picture.texel(0, 3)[0], 0);
  EXPECT_EQ(picture.texel(0, 3)[1], 255);
  EXPECT_EQ(picture.texel(3, 3)[0], 255);
  EXPECT_EQ(picture.texel(3, 3)[1], 0);
}

}  // namespace
}  // namespace mirrorball::gl
