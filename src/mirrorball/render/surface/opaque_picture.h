#pragma once

#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture_target.h"

namespace mirrorball {

/// A copy of a picture of opaque surfaces with their nearness (render/surface/nearness_picture.h), for what is seen
/// through those that are drawn after them.
class OpaquePicture {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<OpaquePicture> make(gl::Api api);

  /// Copies them, of one size. The framebuffer is another one then.
  ///
  /// errors   too_large
  Result<void> take(const gl::Texture& picture, const gl::Texture& nearness);

  const gl::Texture& picture() const { return *picture_; }

 private:
  explicit OpaquePicture(gl::Program program) : program_(std::move(program)) {}

  gl::Program program_;
  std::optional<gl::Texture> picture_;  ///< with all mip levels
  gl::TextureTarget target_;
  gl::VertexArray screen_;
};

}  // namespace mirrorball
