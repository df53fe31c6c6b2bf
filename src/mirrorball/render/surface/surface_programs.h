#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/gl/uniform_block.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/light/proxy_uniforms.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/render/surface/surface_variant.h"
#include "mirrorball/render/surface/texture_units.h"

namespace mirrorball {

/// The shader programs for surfaces, one for each variant that some frame has needed, and the BRDF table that they
/// read: the same for all scenes and views of a device.
class SurfacePrograms {
 public:
  /// The binding points of the uniform blocks.
  enum BlockPoint : unsigned { frame_point, instance_point, material_point, light_point, block_points };
  struct Program {
    gl::Program program;
    TextureUnits units;
  };
  struct Entry {
    std::optional<gl::PendingProgram> submitted = {};
    std::optional<Program> made = {};
  };
  using Programs = std::map<SurfaceVariant, Entry>;

  /// brdf_table   surfaceBrdfTable(): cloth is added where a material needs it
  /// errors       too_large (for this driver)
  static Result<SurfacePrograms> make(gl::Api api, const Image& brdf_table);

  gl::Api api() const { return api_; }

  /// Whether a variant's program is made.
  bool has(const SurfaceVariant& variant) const {
    const auto found = programs_.find(variant);
    return found != programs_.end() && found->second.made;
  }
  /// Gives a variant's program to the driver when it is first asked for. The entry stays where it is.
  ///
  /// errors   not_found (surfaceShaders)
  Result<Programs::pointer> submit(const SurfaceVariant& variant);
  /// The same in two steps, of which the first may be taken in several threads, each with a context that shares.
  ///
  /// shaders   surfaceShaders() of the variant
  static gl::PendingProgram compile(SurfaceShaders shaders);
  /// Makes what finish() makes for such a variant beside its program, which threads would wait for.
  ///
  /// errors   too_large (for this driver)
  Result<void> prepare(const SurfaceVariant& variant);
  Programs::reference add(const SurfaceVariant& variant, gl::PendingProgram submitted);
  /// Waits until that is made.
  ///
  /// proxy    connected to it
  /// errors   unsupported (the driver does not compile a shader)
  Result<void> finish(Programs::reference entry, ProxyUniforms& proxy);

  /// All that were submitted.
  Programs& programs() { return programs_; }

  /// How a block lies in memory; null: no program that was made has it.
  const std::shared_ptr<const gl::BlockLayout>& layout(BlockPoint point) const { return layouts_[point]; }

  void bindBrdfTable() const;

 private:
  SurfacePrograms(gl::Api api, gl::Texture brdf_table) : api_(api), brdf_table_(std::move(brdf_table)) {}
  void connect(Program& made, const SurfaceVariant& variant, ProxyUniforms& proxy);
  Result<void> addClothToBrdfTable();

  gl::Api api_;
  gl::Texture brdf_table_;
  bool brdf_table_has_cloth_ = false;
  Programs programs_;
  std::array<std::shared_ptr<const gl::BlockLayout>, block_points> layouts_;
};

}  // namespace mirrorball
