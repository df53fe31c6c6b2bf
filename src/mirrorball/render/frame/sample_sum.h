#pragma once

#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/render/surface/pixel_mask.h"

namespace mirrorball {

/// The samples of a frame's pixels: the picture that each is drawn into, of all or of some pixels, their mean, and that
/// mean as a display shows it.
class SampleSum {
 public:
  explicit SampleSum(gl::Api api) : api_(api) {}

  /// Begins a frame, of that size and with that many samples.
  ///
  /// errors   too_large; no_gl (the driver cannot draw floats); unsupported (it does not compile a shader)
  Result<void> begin(const FrameSettings& settings);

  /// The pixels that the next sample is drawn of; null: all.
  PixelMask* mask() { return isAdaptive() ? &*mask_ : nullptr; }
  /// What a sample is drawn into: 32-bit floats with depth.
  const gl::Framebuffer& sample() const { return *sample_; }
  /// Takes the picture that is in `sample()` into the mean.
  void add();
  /// Of the last sample that was drawn: of a pixel, row 0 at the top.
  glm::vec3 lastRadiance(glm::ivec2 pixel) const;
  int count() const { return count_; }  ///< of the samples that were added

  /// Tone maps the mean of the samples that there are into what is bound, of 8 bits unless it is not dithered.
  void show(Dither dither);
  void show() { show(settings_.display.dither); }
  /// The mean as linear radiance over its backdrop. Not of a frame whose mean is of a display's light.
  Image radiance() const;
  /// errors   as begin's
  Result<Image8> picture();
  /// The light of that picture before it is rounded to 8 bits: straight alpha.
  Result<Image> displayedLight();

 private:
  /// What knows the tone map of frames.
  struct Programs {
    ToneMap curve;
    gl::Program accumulate;
    gl::Program tone_map;
  };
  Result<void> makePrograms(ToneMap curve);
  bool isAdaptive() const;
  const gl::Framebuffer& result() const { return settings_.samples > 1 ? *sum_ : *sample_; }

  gl::Api api_;
  std::optional<Programs> programs_;
  gl::VertexArray screen_;
  std::optional<gl::Framebuffer> sample_;
  std::optional<PixelMask> mask_;          ///< made for the first frame of which some pixels may finish
  std::optional<gl::Framebuffer> sum_;     ///< when there is more than one sample
  std::optional<gl::Framebuffer> counts_;  ///< of the samples of the pixels that have finished, where some may
  std::optional<gl::Framebuffer> display_;
  FrameSettings settings_;
  int count_ = 0;
};

}  // namespace mirrorball
