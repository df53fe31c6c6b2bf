#include "mirrorball/render/frame/sample_sum.h"

#include <cassert>
#include <utility>

#include "formula/color.h"
#include "mirrorball/codec/color/coded_color.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/surface/display_program.h"
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
}

}  // namespace

Result<void> SampleSum::makePrograms(ToneMap curve) {
  if (programs_ && programs_->curve == curve) return {};
  MIRRORBALL_TRY(accumulate, loadDisplayProgram(api_, "accumulate.frag", curve));
  MIRRORBALL_TRY(tone_map, loadDisplayProgram(api_, "tone_map.frag", curve));
  programs_.emplace(Programs{curve, std::move(accumulate), std::move(tone_map)});
  mask_.reset();
  return {};
}

/// Of a display's light alone one can say what is no longer seen to change.
bool SampleSum::isAdaptive() const {
  return settings_.sampling == Sampling::adaptive && isDisplayed(settings_) &&
         settings_.samples > PixelMask::firstSamples(settings_.samples);
}

Result<void> SampleSum::begin(const FrameSettings& settings) {
  settings_ = settings;
  count_ = 0;
  MIRRORBALL_TRY_VOID(makePrograms(settings.display.tone_map));
  const gl::Depths depths = isAdaptive() ? gl::Depths::with_stencil : gl::Depths::alone;
  MIRRORBALL_TRY_VOID(gl::resize(sample_, gl::Format::rgba32f, settings.size, depths));
  if (settings.samples == 1) return {};
  MIRRORBALL_TRY_VOID(gl::resize(sum_, gl::Format::rgba32f, settings.size));
  if (!isAdaptive()) {
    counts_.reset();
    sum_->testNoDepths();
    return {};
  }
  if (!mask_) {
    MIRRORBALL_TRY(made, PixelMask::make(api_, settings.display.tone_map));
    mask_ = std::move(made);
  }
  mask_->begin();
  MIRRORBALL_TRY_VOID(gl::resize(counts_, gl::Format::r32f, settings.size));
  MIRRORBALL_TRY_VOID(sum_->testDepthsOf(*sample_));
  return counts_->testDepthsOf(*sample_);
}

void SampleSum::add() {
  const int count = ++count_;
  if (settings_.samples == 1) return;
  sum_->bind();
  gl::drawOverAll();
  if (isAdaptive()) mask_->limit();
  if (count > 1) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
  }
  sample_->color().bind(kFreeUnit);
  gl::Program& accumulate = programs_->accumulate;
  accumulate.set("picture", kFreeUnit);
  setDisplay(accumulate, settings_);
  accumulate.set("share", 1.0f / static_cast<float>(settings_.samples));
  screen_.draw(3);
  glDisable(GL_BLEND);
  if (!isAdaptive()) return;
  mask_->end();
  mask_->choose(*counts_, sample_->color(), sum_->color(), settings_.display.exposure(), count, settings_.samples);
}

glm::vec3 SampleSum::lastRadiance(glm::ivec2 pixel) const {
  sample_->bind();
  glm::vec4 texel(0.0f);
  glReadPixels(pixel.x, settings_.size.y - 1 - pixel.y, 1, 1, GL_RGBA, GL_FLOAT, &texel.x);
  return glm::vec3(texel);
}

void SampleSum::show(Dither dither) {
  gl::drawOverAll();
  gl::Program& tone_map = programs_->tone_map;
  result().color().bind(kFreeUnit);
  tone_map.set("picture", kFreeUnit);
  const bool has_counts = isAdaptive() && count_ >= PixelMask::firstSamples(settings_.samples);
  (has_counts ? *counts_ : result()).color().bind(kNextFreeUnit);  // what is bound must be floats, read or not
  tone_map.set("counts", kNextFreeUnit);
  tone_map.set("has_counts", has_counts ? 1.0f : 0.0f);
  tone_map.set("samples", settings_.samples > 1 ? static_cast<float>(settings_.samples) : 1.0f);
  tone_map.set("count", settings_.samples > 1 ? static_cast<float>(count_) : 1.0f);
  setDisplay(tone_map, settings_);
  tone_map.set("backdrop", backdropOf(settings_));
  tone_map.set("dithered_rows", dither == Dither::pattern ? settings_.size.y : 0);
  screen_.draw(3);
}

Image SampleSum::radiance() const {
  assert(!isDisplayed(settings_));
  Image image = result().readFloat();
  if (const glm::vec4 backdrop = backdropOf(settings_); backdrop.w > 0.0f) layOver(image, backdrop);
  return image;
}

Result<Image8> SampleSum::picture() {
  MIRRORBALL_TRY_VOID(gl::resize(display_, gl::Format::rgba8, settings_.size));
  display_->bind();
  show();
  return display_->readBytes();
}

Result<Image> SampleSum::displayedLight() {
  std::optional<gl::Framebuffer> encoded;
  MIRRORBALL_TRY_VOID(gl::resize(encoded, gl::Format::rgba32f, settings_.size));
  encoded->bind();
  show(Dither::none);
  Image light = encoded->readFloat();
  decodeColor(light, {.transfer = Transfer::srgb});
  return light;
}

}  // namespace mirrorball
