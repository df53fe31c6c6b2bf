#include "mirrorball/gl/context_state.h"

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/platform/platform.h"
#include "mirrorball/gl/texture.h"

namespace mirrorball::gl {
namespace {

constexpr GLuint kUnits = Texture::kUnits + 1;  // and the one to work on textures
constexpr GLuint kBlocks = 12;                  // that OpenGL ES promises for a shader

void resetDrawing(Api api) {
  for (const GLenum capability :
       {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL,
        GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD})
    glDisable(capability);
  glEnable(GL_DITHER);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glStencilFunc(GL_ALWAYS, 0, ~0u);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glStencilMask(~0u);
  glDepthRangef(0.0f, 1.0f);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ZERO);
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepthf(1.0f);
  glClearStencil(0);
  resetPlatform(api);
}

void resetPixels(GLint alignment) {
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
  for (const GLenum parameter :
       {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS,
        GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES})
    glPixelStorei(parameter, 0);
}

}  // namespace

void setOurState(Api api) {
  resetDrawing(api);
  resetPixels(1);
  for (GLuint unit = 0; unit < kUnits; ++unit) glBindSampler(unit, 0);
  if (api == Api::es30) return;  // which always filters and encodes so
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glEnable(GL_FRAMEBUFFER_SRGB);
}

void setInitialState(Api api) {
  resetDrawing(api);
  resetPixels(4);
  glUseProgram(0);
  glBindVertexArray(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  for (GLuint block = 0; block < kBlocks; ++block) glBindBufferBase(GL_UNIFORM_BUFFER, block, 0);
  for (GLuint unit = kUnits; unit-- > 0;) {
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum target : {GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_2D_ARRAY}) glBindTexture(target, 0);
  }
  if (api == Api::es30) return;
  glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace mirrorball::gl
