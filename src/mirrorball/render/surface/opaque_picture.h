#pragma once

#include <optional>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture_target.h"
#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// A copy of a picture of opaque surfaces with how near they are, 1 / distance from the camera's place, for what is
/// seen through those that are drawn after them.
class OpaquePicture {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<OpaquePicture> make(gl::Api api);

  /// Makes the copy that large, with those levels, unless it is.
  ///
  /// levels   of the copy: kAllLevels for rough surfaces, 1 where none is
  /// errors   too_large
  Result<void> resize(glm::ivec2 size, int levels);

  /// Copies what has been drawn. The framebuffer is another one then.
  ///
  /// picture  with depths, of the camera, of the copy's size
  /// unit     of length, in world units
  void take(const gl::Framebuffer& picture, const Camera& camera, float unit);

  /// After resize().
  const gl::Texture& picture() const { return *picture_; }

 private:
  explicit OpaquePicture(gl::Program program) : program_(std::move(program)) {}

  gl::Program program_;
  std::optional<gl::Texture> picture_;
  int levels_ = 0;  ///< as was asked for
  gl::TextureTarget target_;
  gl::VertexArray screen_;
};

}  // namespace mirrorball
