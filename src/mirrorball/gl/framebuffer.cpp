#include "mirrorball/gl/framebuffer.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/read_pixels.h"

namespace mirrorball::gl {
namespace {

/// OpenGL's first row is the bottom, an image's is the top.
template <typename Sample>
void flipRows(ImageOf<Sample>& image) {
  for (int y = 0; y < image.height() / 2; ++y) {
    const auto row = image.row(y);
    std::swap_ranges(row.begin(), row.end(), image.row(image.height() - 1 - y).begin());
  }
}

}  // namespace

Result<Framebuffer> Framebuffer::make(Format color, int width, int height, Depths depths, int levels) {
  MIRRORBALL_TRY(texture, Texture::make2d(color, width, height, levels));
  texture.setSampling({.filter = color == Format::rgba32f || color == Format::r32f ? Sampling::Filter::nearest
                                 : texture.levels() > 1                            ? Sampling::Filter::trilinear
                                                                                   : Sampling::Filter::linear});
  Framebuffer framebuffer(std::move(texture));
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  framebuffer.handle_ = Handle<destroyFramebuffer>(name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, framebuffer.color_.name(), 0);
  if (depths != Depths::none) {
    const Format format = depths == Depths::alone ? Format::depth24 : Format::depth24_stencil8;
    MIRRORBALL_TRY(made, Texture::make2d(format, width, height));
    framebuffer.depth_ = std::make_unique<Texture>(std::move(made));
    framebuffer.attachDepths(framebuffer.depth_.get());
  }
  if (glGetError() == GL_OUT_OF_MEMORY) {
    return fail(ErrorCode::too_large, "a picture of " + std::to_string(width) + " × " + std::to_string(height) +
                                          " pixels does not fit into the graphics memory");
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return fail(ErrorCode::no_gl,
                "the graphics driver cannot draw into a picture of this format (floats in OpenGL "
                "ES need its extension EXT_color_buffer_float)");
  }
  return framebuffer;
}

Result<void> resize(std::optional<Framebuffer>& framebuffer, Format color, glm::ivec2 size, Depths depths, int levels) {
  if (framebuffer && framebuffer->width() == size.x && framebuffer->height() == size.y &&
      framebuffer->depths() == depths)
    return {};
  MIRRORBALL_TRY(made, Framebuffer::make(color, size.x, size.y, depths, levels));
  framebuffer = std::move(made);
  return {};
}

void drawOverAll() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

void setBlending(bool is_blended) {
  if (is_blended) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
  } else {
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
}

void Framebuffer::destroyFramebuffer(unsigned name) { glDeleteFramebuffers(1, &name); }

Depths Framebuffer::depths() const {
  if (!depth_) return Depths::none;
  return depth_->format() == Format::depth24 ? Depths::alone : Depths::with_stencil;
}

/// depths   null: none
void Framebuffer::attachDepths(const Texture* depths) const {
  glBindFramebuffer(GL_FRAMEBUFFER, handle_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, 0, 0);  // of another, earlier
  if (!depths) return;
  const bool has_stencil = depths->format() == Format::depth24_stencil8;
  glFramebufferTexture2D(GL_FRAMEBUFFER, has_stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                         depths->name(), 0);
}

Result<void> Framebuffer::testDepthsOf(const Framebuffer& other) const {
  attachDepths(other.depth_.get());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return {};
  return fail(ErrorCode::no_gl, "the graphics driver cannot draw floats beside a stencil");
}

void Framebuffer::testNoDepths() const { attachDepths(nullptr); }

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, handle_.name());
  glViewport(0, 0, width(), height());
}

Image Framebuffer::readFloat() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, handle_.name());
  Image image = readPixelFloats(color_.format(), width(), height());
  flipRows(image);
  return image;
}

Image8 Framebuffer::readBytes() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, handle_.name());
  Image8 image = readPixelBytes(width(), height());
  flipRows(image);
  return image;
}

void Framebuffer::upload(Image8 picture) {
  flipRows(picture);
  color_.upload(picture);
}

}  // namespace mirrorball::gl
