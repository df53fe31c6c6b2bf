#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/image/image.h"
#include "mirrorball/render/light/ground_light.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/coarse_mesh.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {

/// The shapes of a scene's meshes, each by few triangles: enough for their shadows.
///
/// cost     as coarseMesh's
std::vector<CoarseMesh> shadowCasters(const Scene& scene);

/// The shadow of a scene on a level ground: for each place the share of its irradiance that the scene keeps from it.
/// The model is drawn once a light, pressed flat along its direction (Blinn 1988, "Me and my (fake) shadow"), and the
/// shadows are added up (Heckbert & Herf 1997, "Simulating soft shadows with graphics hardware").
class GroundShadow {
 public:
  static constexpr int kSize = 512;                   ///< texels
  static constexpr float kModelRadii = kShadowReach;  ///< from the middle to each side

  /// casters  of a scene
  /// errors   unsupported, no_gl
  static Result<GroundShadow> make(gl::Api api, const std::vector<CoarseMesh>& casters);

  /// Thin glass lets through what it lets through straight on, bodies of it nothing (groundCaustics); what is cut away
  /// or blended is taken as solid. Of surfaces that have a front alone, that is what throws it.
  ///
  /// scene    of the same meshes
  /// bounds   of it
  /// cost     one pass over the few triangles for each light
  void draw(const Scene& scene, const BoundingSphere& bounds, const Proxy& ground, const GroundLights& lights);

  /// Adds light that comes by other ways.
  ///
  /// caustics  kSize texels to each side, of areaAround
  /// errors    too_large
  Result<void> addLight(const Image& caustics);

  /// The middle of the picture of a scene, x and z in the world, and half of its side.
  static glm::vec3 areaAround(const BoundingSphere& bounds);

  /// Red, green, blue: the share that is missing, less than 0 where there is more light than without the scene; beyond
  /// it none is.
  const gl::Texture& picture() const { return framebuffer_.color(); }
  /// The middle of the picture, x and z in the world, and half of its side.
  glm::vec3 area() const { return area_; }

 private:
  GroundShadow(gl::Program program, gl::Program add, gl::Framebuffer framebuffer)
      : program_(std::move(program)), add_(std::move(add)), framebuffer_(std::move(framebuffer)) {}

  struct Caster {
    gl::VertexArray vertices;
    std::size_t index_count;
  };

  gl::Program program_;
  gl::Program add_;
  gl::VertexArray screen_;
  gl::Framebuffer framebuffer_;
  std::vector<Caster> casters_;  // of Scene::meshes
  glm::vec3 area_{0.0f, 0.0f, 1.0f};
};

}  // namespace mirrorball
