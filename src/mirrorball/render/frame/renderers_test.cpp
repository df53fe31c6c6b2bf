// Several renderers in one thread, each on a context of its own or on one that it was given.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

Environment litFromAbove() {
  return Environment([](glm::vec3 d) { return glm::vec3(1.0f + d.y, 1.0f, 0.5f); }, 32);
}

Scene shape(const std::string& name) { return *loadModel(name); }

FrameSettings smallFrame() { return {.size = {24, 24}, .samples = 2, .resolve = Resolve::radiance}; }

Result<Renderer> rendererOn(gl::Context context, const std::string& name) {
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(context)));
  const Environment light = litFromAbove();
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(light, *testing::prepareOnce(light)));
  MIRRORBALL_TRY_VOID(renderer.setScene(shape(name)));
  return renderer;
}

std::vector<float> pictureOf(Renderer& renderer) {
  const Image image = testing::drawn(renderer, smallFrame());
  return {image.samples().begin(), image.samples().end()};
}

class RenderersTest : public ::testing::TestWithParam<gl::Api> {
 protected:
  void SetUp() override {
    if (const auto context = gl::Context::createHeadless(GetParam()); !context)
      MIRRORBALL_END_WITHOUT_GL(context.error().message);
  }
  static Renderer make(const std::string& name) { return *rendererOn(*gl::Context::createHeadless(GetParam()), name); }
};

MIRRORBALL_WITH_BOTH_APIS(RenderersTest);

TEST_P(RenderersTest, DrawInTurnsWhatEachDrawsAlone) {
  const auto alone = [](const std::string& name) {
    Renderer renderer = make(name);
    return pictureOf(renderer);
  };
  const std::vector<float> of_knot = alone("knot"), of_cube = alone("cube");
  Renderer knot = make("knot");
  {
    Renderer cube = make("cube");
    EXPECT_EQ(pictureOf(knot), of_knot);
    EXPECT_EQ(pictureOf(cube), of_cube);
    ASSERT_TRUE(knot.begin(smallFrame()));
    ASSERT_TRUE(cube.begin(smallFrame()));
    for (int sample = 1; sample <= 2; ++sample) {
      EXPECT_EQ(*knot.drawSample(), sample);
      EXPECT_EQ(*cube.drawSample(), sample);
    }
    EXPECT_TRUE(std::ranges::equal(knot.radiance()->samples(), of_knot));
    EXPECT_TRUE(std::ranges::equal(cube.radiance()->samples(), of_cube));
    ASSERT_TRUE(knot.setScene(shape("cube")));
    EXPECT_EQ(pictureOf(knot), of_cube);
    ASSERT_TRUE(knot.setScene(shape("knot")));
  }
  EXPECT_EQ(pictureOf(knot), of_knot) << "the other one's end takes nothing of it away";
  knot = make("cube");
  EXPECT_EQ(pictureOf(knot), of_cube);
}

TEST_P(RenderersTest, OnAContextThatIsNotCurrentSaySoAndTouchNoOther) {
  const auto owner = gl::Context::createHeadless(GetParam());
  ASSERT_TRUE(owner);
  std::optional<Renderer> renderer(*rendererOn(*gl::Context::adoptCurrent(), "cube"));
  const std::vector<float> picture = pictureOf(*renderer);

  const auto other = gl::Context::createHeadless(GetParam());
  ASSERT_TRUE(other);
  std::array<GLuint, 200> buffers{};
  glGenBuffers(GLsizei(buffers.size()), buffers.data());
  for (const GLuint buffer : buffers) glBindBuffer(GL_ARRAY_BUFFER, buffer);
  const auto drawn = renderer->draw(smallFrame());
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().code, ErrorCode::no_gl);
  EXPECT_THAT(drawn.error().message, ::testing::HasSubstr("not current"));
  EXPECT_FALSE(renderer->setScene(shape("knot")));
  EXPECT_FALSE(renderer->radiance());

  ASSERT_TRUE(owner->makeCurrent());
  EXPECT_EQ(pictureOf(*renderer), picture);
  ASSERT_TRUE(other->makeCurrent());
  renderer.reset();
  for (const GLuint buffer : buffers) EXPECT_EQ(glIsBuffer(buffer), GL_TRUE) << buffer;
  glDeleteBuffers(GLsizei(buffers.size()), buffers.data());
}

// What a renderer keeps of the kinds of frames that it has drawn changes none of them, however often they take turns.
TEST_P(RenderersTest, KindsOfFramesTakeTurns) {
  std::vector<FrameSettings> kinds;
  for (const auto& [option, value] : {std::pair("refraction", "single"),
                                      {"refraction", "image-space"},
                                      {"refraction", "traced"},
                                      {"mapping", "sphere"},
                                      {"probes", "1"},
                                      {"light", "1,2,3,5,5,5"},
                                      {"light", "0,3,0,9,1,1"}}) {
    FrameSettings& settings = kinds.emplace_back(smallFrame());
    settings.samples = 1;
    testing::set(settings, option, value);
  }
  Scene scene = shape("cube");
  scene.materials[0].transmission = 0.5f;
  testing::addBall(scene, {0.0f, 0.0f, 1.5f}, 0.5f, Material(), 12);
  scene.materials.back().metallic = 1.0f;
  const auto make = [&] {
    Renderer renderer = RenderersTest::make("cube");
    EXPECT_TRUE(renderer.setScene(scene));
    return renderer;
  };
  Renderer renderer = make();
  std::vector<Image> first;
  for (const FrameSettings& settings : kinds) {
    Renderer fresh = make();
    first.push_back(testing::drawn(fresh, settings));
  }
  for (int turn = 0; turn < 2; ++turn)
    for (std::size_t i = 0; i < kinds.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(testing::drawn(renderer, kinds[i]).samples(), first[i].samples()))
          << "kind " << i << " in turn " << turn;
}

/// What a host may leave behind: all that would change a drawing or an upload.
void setHostsState(gl::Api api) {
  for (const GLenum capability : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE,
                                  GL_POLYGON_OFFSET_FILL, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD})
    glEnable(capability);
  glScissor(3, 3, 5, 5);
  glStencilFunc(GL_NEVER, 1, 1);
  glStencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
  glStencilMask(0);
  glClearStencil(7);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_NEVER);
  glDepthRangef(0.7f, 0.2f);
  glCullFace(GL_FRONT_AND_BACK);
  glFrontFace(GL_CW);
  glBlendEquation(GL_FUNC_SUBTRACT);
  glClearDepthf(0.1f);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
  glPixelStorei(GL_PACK_SKIP_ROWS, 1);
  GLuint sampler = 0;
  glGenSamplers(1, &sampler);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
  for (GLuint unit = 0; unit < 16; ++unit) glBindSampler(unit, sampler);
  if (api == gl::Api::es30) return;
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
  for (GLenum i = 0; i < 8; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
  if (epoxy_has_gl_extension("GL_ARB_clip_control")) glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

/// Numbers of the state that a host would find.
std::vector<GLint> stateOf(gl::Api api) {
  std::vector<GLint> state;
  for (const GLenum capability : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE,
                                  GL_POLYGON_OFFSET_FILL, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD, GL_DITHER})
    state.push_back(glIsEnabled(capability));
  for (const GLenum name : {GL_COLOR_WRITEMASK,
                            GL_DEPTH_WRITEMASK,
                            GL_DEPTH_FUNC,
                            GL_DEPTH_RANGE,
                            GL_STENCIL_FUNC,
                            GL_STENCIL_REF,
                            GL_STENCIL_FAIL,
                            GL_STENCIL_PASS_DEPTH_PASS,
                            GL_STENCIL_WRITEMASK,
                            GL_STENCIL_CLEAR_VALUE,
                            GL_CULL_FACE_MODE,
                            GL_FRONT_FACE,
                            GL_BLEND_EQUATION_RGB,
                            GL_BLEND_SRC_RGB,
                            GL_BLEND_DST_RGB,
                            GL_BLEND_DST_ALPHA,
                            GL_DEPTH_CLEAR_VALUE,
                            GL_COLOR_CLEAR_VALUE,
                            GL_UNPACK_ALIGNMENT,
                            GL_UNPACK_ROW_LENGTH,
                            GL_PACK_ALIGNMENT,
                            GL_PACK_SKIP_ROWS,
                            GL_CURRENT_PROGRAM,
                            GL_VERTEX_ARRAY_BINDING,
                            GL_DRAW_FRAMEBUFFER_BINDING,
                            GL_READ_FRAMEBUFFER_BINDING,
                            GL_ARRAY_BUFFER_BINDING,
                            GL_UNIFORM_BUFFER_BINDING,
                            GL_ACTIVE_TEXTURE}) {
    std::array<GLint, 4> numbers{};
    glGetIntegerv(name, numbers.data());
    state.insert(state.end(), numbers.begin(), numbers.end());
  }
  if (api == gl::Api::desktop43)
    for (const GLenum capability : {GL_FRAMEBUFFER_SRGB, GL_TEXTURE_CUBE_MAP_SEAMLESS})
      state.push_back(glIsEnabled(capability));
  for (GLenum unit = 0; unit < 16; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum binding : {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_2D_ARRAY})
      glGetIntegerv(binding, &state.emplace_back());
  }
  glActiveTexture(GL_TEXTURE0);
  return state;
}

TEST_P(RenderersTest, AHostsStateAndOursStayApart) {
  const auto owner = gl::Context::createHeadless(GetParam());
  ASSERT_TRUE(owner);
  ASSERT_TRUE(gl::Context::adoptCurrent()->leave());
  const std::vector<GLint> new_context = stateOf(GetParam());
  GLint alignment = 0;
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &alignment);
  EXPECT_EQ(alignment, 4);
  Renderer renderer = *rendererOn(*gl::Context::adoptCurrent(), "knot");
  const std::vector<float> picture = pictureOf(renderer);
  setHostsState(GetParam());
  ASSERT_TRUE(renderer.setScene(shape("knot")));
  setHostsState(GetParam());
  EXPECT_EQ(pictureOf(renderer), picture);
  setHostsState(GetParam());
  ASSERT_TRUE(renderer.render({.size = {24, 24}, .samples = 8}));  // of some pixels, by a stencil
  ASSERT_TRUE(renderer.leave());
  EXPECT_EQ(stateOf(GetParam()), new_context);
  {
    Renderer ended = *rendererOn(*gl::Context::adoptCurrent(), "cube");
    pictureOf(ended);
  }
  EXPECT_EQ(stateOf(GetParam()), new_context) << "a renderer's end gives the state back";
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace mirrorball
