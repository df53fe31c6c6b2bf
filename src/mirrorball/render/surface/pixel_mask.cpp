#include "mirrorball/render/surface/pixel_mask.h"

#include <algorithm>
#include <utility>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/display_program.h"

namespace mirrorball {
namespace {

enum MaskUnit { kLast, kSum };

// Bits of the stencil. A pixel without any is finished.
constexpr GLuint kShowsThrough = 1;
constexpr GLuint kChanges = 2;

/// Begins a drawing of all pixels.
///
/// buffers   beside the colours and depths
void clearAll(glm::vec4 page, GLbitfield buffers) {
  glClearColor(page.x, page.y, page.z, page.w);
  glClearStencil(kChanges);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | buffers);
}

}  // namespace

Result<PixelMask> PixelMask::make(gl::Api api, ToneMap tone_map) {
  MIRRORBALL_TRY(page, gl::Program::load(api, "screen.vert", "page.frag"));
  MIRRORBALL_TRY(choice, loadDisplayProgram(api, "finished.frag", tone_map));
  choice.set("last", kLast);
  choice.set("sum", kSum);
  return PixelMask(std::move(page), std::move(choice));
}

void PixelMask::limit() {
  // The same for all samples: drivers make programs anew for another test.
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NOTEQUAL, 0, kShowsThrough | kChanges);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

void PixelMask::clearUnlimited(glm::vec4 page) { clearAll(page, GL_STENCIL_BUFFER_BIT); }

void PixelMask::clear(glm::vec4 page) {
  if (next_choice_ == 0) {
    clearAll(page, is_cleared_ ? 0u : GL_STENCIL_BUFFER_BIT);
    is_cleared_ = true;
    return;
  }
  limit();  // glClear asks no stencil
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  page_.set("page", page);
  page_.use();
  screen_.draw(3);
}

void PixelMask::beginShowingThrough() const {
  glStencilFunc(GL_ALWAYS, kShowsThrough, kShowsThrough);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glStencilMask(kShowsThrough);
  glDepthMask(GL_FALSE);
}

void PixelMask::endShowingThrough() const {
  glDepthMask(GL_TRUE);
  glStencilMask(~0u);
  limit();
}

void PixelMask::end() { glDisable(GL_STENCIL_TEST); }

void PixelMask::choose(const gl::Framebuffer& counts, const gl::Texture& last, const gl::Texture& sum, float exposure,
                       int count, int samples) {
  if (count != std::max(next_choice_, firstSamples(samples)) || count == samples) return;
  counts.bind();
  gl::drawOverAll();
  if (next_choice_ == 0) {
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, kChanges, kChanges | kShowsThrough);
  glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
  glStencilMask(kChanges);
  last.bind(kLast);
  sum.bind(kSum);
  choice_.set("mean_of_sum", static_cast<float>(samples) / static_cast<float>(count));
  choice_.set("count", static_cast<float>(count));
  choice_.set("exposure", exposure);
  choice_.use();
  screen_.draw(3);
  glStencilMask(~0u);
  end();
  next_choice_ = 2 * count;
}

}  // namespace mirrorball
