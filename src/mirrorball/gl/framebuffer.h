#pragma once

#include <memory>
#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/texture.h"

namespace mirrorball::gl {

/// The depths that a framebuffer has beside its colours.
enum class Depths { none, alone, with_stencil };

/// A picture to draw into: one colour texture, and a texture of 24-bit depths if wanted, with a stencil of 8 bits or
/// without.
class Framebuffer {
 public:
  /// levels   of the colour texture (Texture::make2d), of which the first is drawn into
  /// errors   too_large; no_gl: this driver cannot draw into such a format (floats in OpenGL ES need the extension
  ///          EXT_color_buffer_float)
  static Result<Framebuffer> make(Format color, int width, int height, Depths depths = Depths::none, int levels = 1);

  /// Draws into this one, which has no depths, test those and the stencil of another one of the same size until
  /// testNoDepths(); the other lives as long.
  ///
  /// errors   no_gl: this driver cannot
  Result<void> testDepthsOf(const Framebuffer& other) const;
  void testNoDepths() const;

  /// Draws go here from now on, over the whole picture.
  void bind() const;

  /// The colour texture, filtered linearly, and between its levels if it has more than one; row 0 is the picture's
  /// bottom, as OpenGL draws.
  const Texture& color() const { return color_; }
  /// Filters the colour linearly even where it has single floats, which OpenGL ES cannot.
  void filterSingleFloats() { color_.setSampling({.filter = Sampling::Filter::linear}); }
  /// Makes its further levels of the first, each texel the mean of four.
  void makeLevels() { color_.makeLevels(); }

  /// The depths, 0 the nearest; of a framebuffer that has them.
  const Texture& depth() const { return *depth_; }
  Depths depths() const;

  /// OpenGL's name of it.
  unsigned name() const { return handle_.name(); }
  int width() const { return color_.width(); }
  int height() const { return color_.height(); }

  /// The picture as floats: 4 channels, row 0 at the TOP, sRGB decoded.
  Image readFloat() const;

  /// The picture of an 8-bit format as its bytes: 4 channels, row 0 at the TOP.
  Image8 readBytes() const;

  /// Replaces the picture of an 8-bit format by bytes as they are.
  ///
  /// picture   of its size, 3 or 4 channels, row 0 at the TOP
  void upload(Image8 picture);

 private:
  static void destroyFramebuffer(unsigned name);
  void attachDepths(const Texture* depths) const;
  explicit Framebuffer(Texture color) : color_(std::move(color)) {}

  Texture color_;
  Handle<destroyFramebuffer> handle_;
  std::unique_ptr<Texture> depth_;
};

/// Makes a framebuffer of that size and with such depths, unless there is one; all else is to be the same at each call.
///
/// errors   as Framebuffer::make's
Result<void> resize(std::optional<Framebuffer>& framebuffer, Format color, glm::ivec2 size,
                    Depths depths = Depths::none, int levels = 1);

/// From now on all that is drawn counts: without depth test, blending and culling.
void drawOverAll();

/// From now on what is drawn is laid over what is there by its alpha, and leaves the depths as they are; or, not
/// blended, replaces both.
void setBlending(bool is_blended);

}  // namespace mirrorball::gl
