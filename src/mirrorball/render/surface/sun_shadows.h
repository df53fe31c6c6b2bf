#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "formula/sun.h"
#include "mirrorball/base/result.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/scene_buffers.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How near a scene is to each sun, in a picture: what is farther away lies in shadow (Williams 1978, "Casting curved
/// shadows on curved surfaces").
class SunShadows {
 public:
  /// errors   unsupported (the driver does not compile a shader)
  static Result<SunShadows> make(gl::Api api);

  /// Draws all suns' pictures side by side. Glass throws no shadow, nor what is blended and less than half opaque; of
  /// surfaces that have a front alone, that is what throws it.
  ///
  /// suns     in the world, at least one
  /// bounds   of the scene
  /// side_px  of each picture
  /// errors   too_large; no_gl
  /// cost     one pass over the scene's triangles for each sun
  Result<void> draw(const Scene& scene, SceneBuffers& buffers, std::span<const formula::Sun> suns,
                    const BoundingSphere& bounds, int side_px);

  const gl::Texture& picture() const { return framebuffer_->depth(); }
  /// Of each sun three rows (shaders/surface/suns_shadowed.glsl).
  const std::vector<glm::vec4>& rows() const { return rows_; }

 private:
  explicit SunShadows(gl::Program program) : program_(std::move(program)) {}
  void drawFrom(const Scene& scene, SceneBuffers& buffers, const glm::mat4& clip_from_world);
  void setHoles(const SceneBuffers& buffers, const Material& material);

  gl::Program program_;
  std::optional<gl::Framebuffer> framebuffer_;
  std::vector<glm::vec4> rows_;
};

/// The side of each sun's picture for a picture of that size: of one, a scene that fills it has texels smaller than its
/// pixels.
///
/// longest   side of a texture that the driver takes
int sunShadowSide(glm::ivec2 size_px, std::size_t suns, int longest);

}  // namespace mirrorball
