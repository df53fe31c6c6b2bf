#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/light_sampler.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/environment.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/scene/coarse_mesh.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {

/// A direction that light comes from, and what part of a level ground's irradiance it stands for.
struct GroundLight {
  glm::vec3 direction{0.0f};  ///< world, unit, upwards
  glm::vec3 share{0.0f};      ///< of all such lights it is 1
};

/// What lights a level ground: directions chosen by the environment's light, as many of them at a sun as it has of the
/// light.
struct GroundLights {
  std::vector<GroundLight> lights;
  glm::vec3 irradiance{0.0f};  ///< divided by π
};

/// Chooses them; the same for the same environment.
///
/// environment_from_world   turns it
GroundLights groundLights(const Environment& environment, const LightSampler& sampler,
                          const glm::mat3& environment_from_world, int count);

/// The shapes of a scene's meshes, each by few triangles: enough for their shadows.
///
/// cost     as coarseMesh's
std::vector<CoarseMesh> shadowCasters(const Scene& scene);

/// The shadow of a scene on a level ground: for each place the share of its irradiance that the scene keeps from it.
/// The model is drawn once a light, pressed flat along its direction (Blinn 1988, "Me and my (fake) shadow"), and the
/// shadows are added up (Heckbert & Herf 1997, "Simulating soft shadows with graphics hardware").
class GroundShadow {
 public:
  static constexpr int kSize = 512;        ///< texels
  static constexpr float kModelRadii = 4;  ///< from the middle to each side

  /// casters  of a scene
  /// errors   unsupported, no_gl
  static Result<GroundShadow> make(gl::Api api, const std::vector<CoarseMesh>& casters);

  /// Glass lets through what it lets through straight on; what is cut away or blended is taken as solid. Of
  /// surfaces that have a front alone, that is what throws it.
  ///
  /// scene    of the same meshes
  /// bounds   of it
  /// cost     one pass over the few triangles for each light
  void draw(const Scene& scene, const BoundingSphere& bounds, const Proxy& ground, const GroundLights& lights);

  /// Red, green, blue: the share that is missing; beyond it none is.
  const gl::Texture& picture() const { return framebuffer_.color(); }
  /// The middle of the picture, x and z in the world, and half of its side.
  glm::vec3 area() const { return area_; }

 private:
  GroundShadow(gl::Program program, gl::Framebuffer framebuffer)
      : program_(std::move(program)), framebuffer_(std::move(framebuffer)) {}

  struct Caster {
    gl::VertexArray vertices;
    std::size_t index_count;
  };

  gl::Program program_;
  gl::Framebuffer framebuffer_;
  std::vector<Caster> casters_;  // of Scene::meshes
  glm::vec3 area_{0.0f, 0.0f, 1.0f};
};

}  // namespace mirrorball
