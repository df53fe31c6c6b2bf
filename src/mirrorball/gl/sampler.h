#pragma once

#include <compare>

#include "mirrorball/gl/handle.h"

namespace mirrorball::gl {

/// How a texture is read between texels and beyond its edges.
struct Sampling {
  enum class Filter {
    nearest,    ///< level 0 only
    linear,     ///< level 0 only, bilinear
    trilinear,  ///< bilinear, and linear between the mip levels
  };
  enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

  Filter filter = Filter::trilinear;
  bool magnify_nearest = false;  ///< shows the texels as squares where they are larger than pixels
  Wrap wrap_s = Wrap::clamp_to_edge;
  Wrap wrap_t = Wrap::clamp_to_edge;
  /// Reads along a pixel's longer side, at most: 1 to Context::largestAnisotropy().
  float anisotropy = 1.0f;

  auto operator<=>(const Sampling&) const = default;
};

/// A way to read textures, apart from them: so the same one is read in several ways, by several frames.
class Sampler {
 public:
  /// Of textures that are no cubes, or of cubes, which are clamped to their edges whatever it says.
  explicit Sampler(const Sampling& sampling);

  unsigned name() const { return handle_.name(); }

 private:
  static void destroy(unsigned name);
  Handle<destroy> handle_;
};

}  // namespace mirrorball::gl
