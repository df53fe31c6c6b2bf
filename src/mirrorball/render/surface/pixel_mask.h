#pragma once

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/settings/frame_settings.h"

namespace mirrorball {

/// Which pixels of a frame further samples are drawn of, in the stencil of the framebuffer that they are drawn into:
/// those where the picture still changes from sample to sample or from pixel to pixel, and those that show something
/// through a surface. The others keep their colours and depths. Drivers test the stencil before a pixel is lit, where
/// they can.
class PixelMask {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<PixelMask> make(gl::Api api);

  /// How many samples are drawn of all pixels of a frame: the first pair, whose mean lies in the pixel's middle
  /// (formula::sampleOffset), and before it the one in the middle if there is one.
  static int firstSamples(int samples) { return 2 + samples % 2; }

  /// A frame begins: all pixels are drawn.
  void begin() { next_choice_ = 0; }

  /// Clears the pixels that are drawn, of a framebuffer with a stencil that is bound, and lets draws change no others
  /// until end().
  void clear(glm::vec4 page);
  void end() const;

  /// Whether what shows something through itself is to be drawn once more between these two, by whatever program: what
  /// is drawn changes the mask alone.
  bool asksForWhatShowsThrough() const { return next_choice_ == 0; }
  void beginShowingThrough() const;
  void endShowingThrough() const;

  /// Takes the pixels out that have finished, after the first samples and each time there are twice as many.
  ///
  /// counts   shares the stencil: gets the number of their samples
  /// last     the last sample, as clear() was told of it
  /// sum      of all until now, each as a display shows it, divided by `samples`
  /// count    of all until now
  /// samples  of the frame
  void choose(const gl::Framebuffer& counts, const gl::Texture& last, const gl::Texture& sum, const Display& display,
              int count, int samples);

  /// Lets draws into a framebuffer that shares the stencil change the pixels alone that are drawn, until end().
  void limit() const;

 private:
  PixelMask(gl::Program page, gl::Program choice) : page_(std::move(page)), choice_(std::move(choice)) {}

  gl::Program page_;
  gl::Program choice_;
  gl::VertexArray screen_;
  int next_choice_ = 0;  ///< after so many samples; 0: there has been none, and all pixels are drawn
};

}  // namespace mirrorball
