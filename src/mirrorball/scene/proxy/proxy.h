#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "formula/proxy.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/bodies/body_tree.h"
#include "mirrorball/scene/model_files.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The shape of the surface that an environment's light comes from (formula/proxy/proxy.glsl).
enum class ProxyKind {
  none,  ///< it is infinitely far away
  box,
  sphere,
  ground,  ///< a level ground below a dome
  mesh,
};

/// That surface as a user asks for it, in the coordinates of the scene's file.
struct ProxyOptions {
  ProxyKind kind = ProxyKind::none;
  glm::dvec3 low{0.0}, high{0.0};              ///< of a box
  glm::dvec3 center{0.0};                      ///< of a sphere
  float radius = 0.0f;                         ///< of a sphere or a dome; 0: ten times the height
  float height = 0.0f;                         ///< of the panorama's camera above the ground; 0: two model radii
  float ground_roughness = 1.0f;               ///< perceptual: of a ground; below 1 it mirrors the scene
  std::string file = {};                       ///< of a mesh, or the name of a built-in model
  ModelLoadOptions load = {};                  ///< of that file
  std::optional<glm::dvec3> captured_at = {};  ///< where the map was; without it the middle, or above the model

  bool operator==(const ProxyOptions&) const = default;
  /// Whether its ground is polished, so that it shows the scene (formula/proxy/glossy_ground.glsl).
  bool mirrorsScene() const { return kind == ProxyKind::ground && ground_roughness < 1.0f; }
};

/// "box:-2,0,-2,2,3,2", "sphere:0,0,0,5", "ground", "ground:1.6", "ground:1.6,20", "room.glb", "none".
///
/// option   its name, for messages
/// errors   usage
Result<ProxyOptions> parseProxy(std::string_view option, std::string_view written);

/// As parseProxy reads it; without where the map was captured and how rough its ground is.
std::string writtenProxy(const ProxyOptions& proxy);

/// The surface where it is in a scene.
struct Proxy {
  ProxyKind kind = ProxyKind::none;
  glm::vec3 low{0.0f}, high{0.0f};
  glm::vec3 center{0.0f};
  float radius = 0.0f;
  float ground = 0.0f;            ///< its height in the world
  float ground_roughness = 1.0f;  ///< perceptual; 1: it is matt
  glm::vec3 captured_at{0.0f};
  std::shared_ptr<const BodyTree> mesh = {};

  /// The nearest place within, which what is seen from there is right for; of a mesh the place itself.
  glm::vec3 within(glm::vec3 place) const;
  bool holds(glm::vec3 place) const { return within(place) == place; }
};

/// The ground lies below the scene's lowest point, and its panorama's camera stands above the middle of the scene.
///
/// errors   usage: the map's place is not within, or the ground's height is of no use; of a mesh: as loadModel's
/// cost     that of a tree for a mesh (bodyTree)
Result<Proxy> placedProxy(const ProxyOptions& options, const Scene& scene);

/// Where a ray meets the proxy.
formula::ProxyHit hitOf(const Proxy& proxy, glm::vec3 origin, glm::vec3 direction);

/// What it sees, from where the map was captured.
formula::ProxySight sightFrom(const Proxy& proxy, glm::vec3 origin, glm::vec3 direction);

}  // namespace mirrorball
