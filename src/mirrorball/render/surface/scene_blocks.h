#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "mirrorball/gl/uniform_block.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The uniform blocks of a scene's instances and materials, one each, side by side. What changes is sent alone.
class SceneBlocks {
 public:
  using Layout = std::shared_ptr<const gl::BlockLayout>;

  /// Makes those whose layout some program has told, once.
  void make(const Scene& scene, const Layout& of_instances, const Layout& of_materials);

  // Must be called when one has become another.
  void instanceChanged(const Scene& scene, std::size_t index);
  void materialChanged(const Scene& scene, std::size_t index);

  /// Makes them what programs read at those points, as far as some program does.
  void bind(int instance, unsigned instance_point, int material, unsigned material_point);

  /// That were sent until now.
  std::size_t bytesSent() const;

 private:
  std::optional<gl::UniformBlock> instances_;
  std::optional<gl::UniformBlock> materials_;
};

}  // namespace mirrorball
