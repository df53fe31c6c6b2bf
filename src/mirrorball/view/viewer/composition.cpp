#include "mirrorball/view/viewer/composition.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/gl/gl_api.h"

namespace mirrorball {
namespace {

/// Restricts what is drawn to columns of the part.
void keepColumns(const FramebufferPart& part, int begin, int end) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.corner.x + begin, part.corner.y, end - begin, part.size_px.y);
}

void stretch(const gl::Framebuffer& picture, const FramebufferPart& part) {
  const glm::ivec2 end = part.corner + part.size_px;
  const bool is_as_large = glm::ivec2(picture.width(), picture.height()) == part.size_px;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, part.framebuffer);
  glBlitFramebuffer(0, 0, picture.width(), picture.height(), part.corner.x, part.corner.y, end.x, end.y,
                    GL_COLOR_BUFFER_BIT, is_as_large ? GL_NEAREST : GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, part.framebuffer);
}

/// What it draws is encoded already.
template <typename Draw>
void withoutEncoding(const gl::Context& context, const Draw& draw) {
  const bool encodes = context.api() == gl::Api::desktop43;
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  draw();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace

void showNothing(const FramebufferPart& part) {
  glBindFramebuffer(GL_FRAMEBUFFER, part.framebuffer);
  keepColumns(part, 0, part.size_px.x);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

void showPicture(const gl::Context& context, const gl::Framebuffer& picture, const FramebufferPart& part) {
  withoutEncoding(context, [&] { stretch(picture, part); });
}

void showBeside(const gl::Context& context, const gl::Framebuffer& first, const gl::Framebuffer& second, float divider,
                const FramebufferPart& part) {
  const int width = part.size_px.x;
  const int line = std::clamp(static_cast<int>(std::lround(divider * static_cast<float>(width))), 0, width);
  withoutEncoding(context, [&] {
    keepColumns(part, 0, line);
    stretch(first, part);
    keepColumns(part, line, width);
    stretch(second, part);
    keepColumns(part, std::max(line - 1, 0), std::min(line + 1, width));
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
  });
}

}  // namespace mirrorball
