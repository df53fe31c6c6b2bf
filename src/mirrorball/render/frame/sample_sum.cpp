#include "mirrorball/render/frame/sample_sum.h"

#include <cassert>
#include <utility>

#include <epoxy/gl.h>

#include "formula/color.h"
#include "mirrorball/render/surface/surface_program.h"

namespace mirrorball {
namespace {

/// What is behind all that is drawn: a display's colour, or nothing.
glm::vec4 backdropOf(const FrameSettings& settings) {
  return settings.background == BackgroundKind::display_color ? glm::vec4(settings.background_color, 1.0f)
                                                              : glm::vec4(0.0f);
}

/// Whether the mean of the samples is of a display's light. One sample is kept as radiance:
/// there is nothing to average.
bool isDisplayed(const FrameSettings& settings) { return settings.resolve == Resolve::display && settings.samples > 1; }

/// How a display shows radiance, for shaders/accumulate.frag and tone_map.frag.
void setDisplay(gl::Program& program, const FrameSettings& settings) {
  program.set("as_displayed", isDisplayed(settings) ? 1.0f : 0.0f);
  program.set("exposure", settings.display.exposure());
  program.set("tone_map", static_cast<int>(settings.display.tone_map));
}

bool hasSize(const std::optional<gl::Framebuffer>& framebuffer, glm::ivec2 size) {
  return framebuffer && framebuffer->width() == size.x && framebuffer->height() == size.y;
}

void drawNothingBehind() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

}  // namespace

Result<SampleSum> SampleSum::make(gl::Api api) {
  MIRRORBALL_TRY(accumulate, gl::Program::load(api, "screen.vert", "accumulate.frag"));
  MIRRORBALL_TRY(tone_map, gl::Program::load(api, "screen.vert", "tone_map.frag"));
  return SampleSum(std::move(accumulate), std::move(tone_map));
}

Result<void> SampleSum::begin(const FrameSettings& settings) {
  settings_ = settings;
  count_ = 0;
  const glm::ivec2 size = settings.size;
  if (!hasSize(sample_, size)) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba32f, size.x, size.y, true));
    sample_ = std::move(made);
    sum_.reset();
  }
  if (settings.samples > 1 && !sum_) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba32f, size.x, size.y, false));
    sum_ = std::move(made);
  }
  return {};
}

void SampleSum::add() {
  const bool is_first = count_++ == 0;
  if (settings_.samples == 1) return;
  sum_->bind();
  drawNothingBehind();
  if (is_first) {
    glDisable(GL_BLEND);
  } else {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  }
  sample_->color().bind(TextureUnit::picture);
  accumulate_.set("picture", TextureUnit::picture);
  setDisplay(accumulate_, settings_);
  accumulate_.set("share", 1.0f / static_cast<float>(settings_.samples));
  screen_.draw(3);
  glDisable(GL_BLEND);
}

void SampleSum::show() {
  drawNothingBehind();
  glDisable(GL_BLEND);
  result().color().bind(TextureUnit::picture);
  tone_map_.set("picture", TextureUnit::picture);
  tone_map_.set("share",
                settings_.samples > 1 ? static_cast<float>(settings_.samples) / static_cast<float>(count_) : 1.0f);
  setDisplay(tone_map_, settings_);
  tone_map_.set("backdrop", backdropOf(settings_));
  screen_.draw(3);
}

Image SampleSum::radiance() const {
  assert(!isDisplayed(settings_));
  Image image = result().readFloat();
  if (const glm::vec4 backdrop = backdropOf(settings_); backdrop.w > 0.0f) layOver(image, backdrop);
  return image;
}

Result<Image8> SampleSum::picture() {
  const glm::ivec2 size = settings_.size;
  if (!hasSize(display_, size)) {
    MIRRORBALL_TRY(made, gl::Framebuffer::make(gl::Format::rgba8, size.x, size.y, false));
    display_ = std::move(made);
  }
  display_->bind();
  show();
  return display_->readBytes();
}

}  // namespace mirrorball
