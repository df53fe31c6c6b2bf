#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/gl/texture.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/environment_light.h"
#include "mirrorball/render/render_options.h"
#include "mirrorball/render/scene_buffers.h"
#include "mirrorball/scene/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The texture units that the shaders read from.
struct TextureUnit {
  static constexpr int environment = 0;
  static constexpr int sphere_map = 1;
  static constexpr int picture = 2;
  static constexpr int brdf_table = 3;
  static constexpr int prefiltered = 4;
  static constexpr int irradiance = 5;
  static constexpr int first_of_material = 6;
};

/// A chain of prefiltered cubes, of which a texture holds the levels from `first_level` on.
struct PrefilteredChain {
  const gl::Texture* texture = nullptr;
  int first_level = 0;

  /// That of roughness 1.
  int lastLevel() const { return first_level + texture->levels() - 1; }
  /// The side of its level 0, in the texture or not.
  int size() const { return texture->width() << first_level; }
};

/// What all surfaces of a frame share.
struct FrameUniforms {
  PrefilteredChain prefiltered;
  Camera camera;
  glm::mat3 environment_from_world{1.0f};
  glm::mat4 texture_matrix{1.0f};  ///< of the sphere map
};

/// The BRDF table as shaders/surface.frag looks it up; needs no GL context.
///
/// cost     about 10 ms on 2 cores
Result<Image> surfaceBrdfTable();

/// The shader programs for surfaces, one for each set of features that some material needs, made when first needed.
class SurfacePrograms {
 public:
  /// brdf_table   surfaceBrdfTable()
  /// errors       too_large (for this driver)
  static Result<SurfacePrograms> make(gl::Api api, const Image& brdf_table);

  /// The program for a material with everything set that does not depend on the instance.
  ///
  /// errors   unsupported (the driver does not compile it)
  Result<gl::Program*> prepare(const Material& material, const SceneBuffers& buffers, const EnvironmentLight& light,
                               const FrameUniforms& frame, const FrameSettings& settings);

 private:
  SurfacePrograms(gl::Api api, gl::Texture brdf_table) : api_(api), brdf_table_(std::move(brdf_table)) {}

  Result<gl::Program*> programFor(const std::vector<std::string>& defines);

  gl::Api api_;
  gl::Texture brdf_table_;
  std::map<std::vector<std::string>, gl::Program> programs_;
};

}  // namespace mirrorball
