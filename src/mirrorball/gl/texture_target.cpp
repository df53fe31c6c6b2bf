#include "mirrorball/gl/texture_target.h"

#include <cassert>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball::gl {

TextureTarget::TextureTarget() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  handle_ = Handle<destroy>(name);
}

void TextureTarget::bind(const Texture& texture, int level, int face) const {
  assert(level >= 0 && level < texture.levels());
  const GLenum image =
      texture.isCube() ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GLenum{GL_TEXTURE_2D};
  glBindFramebuffer(GL_FRAMEBUFFER, handle_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, image, texture.name(), level);
  glViewport(0, 0, levelSide(texture.width(), level), levelSide(texture.height(), level));
}

bool TextureTarget::isComplete() const {
  glBindFramebuffer(GL_FRAMEBUFFER, handle_.name());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void TextureTarget::destroy(unsigned name) { glDeleteFramebuffers(1, &name); }

}  // namespace mirrorball::gl
