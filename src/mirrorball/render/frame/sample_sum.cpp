#include "mirrorball/render/frame/sample_sum.h"

#include <cassert>
#include <utility>

#include "formula/color.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/texture_units.h"

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

}  // namespace

Result<SampleSum> SampleSum::make(gl::Api api) {
  MIRRORBALL_TRY(accumulate, gl::Program::load(api, "screen.vert", "accumulate.frag"));
  MIRRORBALL_TRY(tone_map, gl::Program::load(api, "screen.vert", "tone_map.frag"));
  return SampleSum(std::move(accumulate), std::move(tone_map));
}

Result<void> SampleSum::begin(const FrameSettings& settings) {
  settings_ = settings;
  count_ = 0;
  MIRRORBALL_TRY_VOID(gl::resize(sample_, gl::Format::rgba32f, settings.size, true));
  if (settings.samples == 1) return {};
  return gl::resize(sum_, gl::Format::rgba32f, settings.size, false);
}

void SampleSum::add() {
  const bool is_first = count_++ == 0;
  if (settings_.samples == 1) return;
  sum_->bind();
  gl::drawOverAll();
  if (!is_first) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  }
  sample_->color().bind(kFreeUnit);
  accumulate_.set("picture", kFreeUnit);
  setDisplay(accumulate_, settings_);
  accumulate_.set("share", 1.0f / static_cast<float>(settings_.samples));
  screen_.draw(3);
  glDisable(GL_BLEND);
}

glm::vec3 SampleSum::lastRadiance(glm::ivec2 pixel) const {
  sample_->bind();
  glm::vec4 texel(0.0f);
  glReadPixels(pixel.x, settings_.size.y - 1 - pixel.y, 1, 1, GL_RGBA, GL_FLOAT, &texel.x);
  return glm::vec3(texel);
}

void SampleSum::show() {
  gl::drawOverAll();
  result().color().bind(kFreeUnit);
  tone_map_.set("picture", kFreeUnit);
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
  MIRRORBALL_TRY_VOID(gl::resize(display_, gl::Format::rgba8, settings_.size, false));
  display_->bind();
  show();
  return display_->readBytes();
}

}  // namespace mirrorball
