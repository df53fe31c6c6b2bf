#pragma once

#include <algorithm>

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
  /// tone_map   of the frames' display
  /// errors     unsupported (the driver does not compile a shader)
  static Result<PixelMask> make(gl::Api api, ToneMap tone_map);

  /// How many samples are drawn of all pixels of a frame: a quarter of them, at least two. They are whole pairs, whose
  /// means lie in the pixel's middle (formula::sampleOffset), and of an odd number the one in the middle before them.
  static int firstSamples(int samples) { return std::max(2, samples / 8 * 2) + samples % 2; }

  /// A frame begins: all pixels are drawn.
  void begin() { next_choice_ = 0, is_cleared_ = false; }

  /// Makes the framebuffer that is bound, which has a stencil, ready for a sample: clears the pixels that are drawn,
  /// and lets draws change no others until end().
  void clear(glm::vec4 page);
  /// Lets draws change the pixels alone that are drawn, of a framebuffer that tests the same stencil, until end().
  static void limit();
  static void end();

  /// Makes the framebuffer that is bound, which has a stencil of its own, ready for a drawing of all pixels that makes
  /// the test of limit(), until end().
  static void clearUnlimited(glm::vec4 page);

  /// Whether the mask wants to be told where something shows through surfaces: what is drawn between the next two
  /// calls, by whatever program, changes the mask alone.
  bool asksForWhatShowsThrough() const { return next_choice_ == 0; }
  void beginShowingThrough() const;
  void endShowingThrough() const;

  /// Takes the pixels out that have finished, after the first samples and each time there are twice as many.
  ///
  /// counts   gets the number of their samples; it tests the stencil, too
  /// last     the last sample's radiance
  /// sum      of all until now, each as the display shows it, divided by `samples`
  /// exposure factor on the radiance, as the display has it
  /// count    of all until now
  /// samples  of the frame
  void choose(const gl::Framebuffer& counts, const gl::Texture& last, const gl::Texture& sum, float exposure, int count,
              int samples);

 private:
  PixelMask(gl::Program page, gl::Program choice) : page_(std::move(page)), choice_(std::move(choice)) {}

  gl::Program page_;
  gl::Program choice_;
  gl::VertexArray screen_;
  bool is_cleared_ = false;  ///< the stencil, for the frame
  int next_choice_ = 0;      ///< after so many samples; 0: there has been none, and all pixels are drawn
};

}  // namespace mirrorball
