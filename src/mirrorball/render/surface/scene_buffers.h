#pragma once

#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A scene's meshes and textures on the GPU.
class SceneBuffers {
 public:
  /// errors   too_large: a texture is larger than the driver takes
  static Result<SceneBuffers> make(const Scene& scene);

  void drawMesh(int index) const;
  const gl::Texture& texture(int index) const { return textures_[std::size_t(index)]; }

 private:
  struct MeshBuffers {
    gl::VertexArray vertices;
    std::size_t index_count;
  };
  std::vector<MeshBuffers> meshes_;
  std::vector<gl::Texture> textures_;
};

}  // namespace mirrorball
