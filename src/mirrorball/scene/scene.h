#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/base/shared.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/animation/rig.h"
#include "mirrorball/scene/box.h"
#include "mirrorball/scene/camera/model_camera.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/model_light.h"
#include "mirrorball/scene/shared_picture.h"

namespace mirrorball {

/// How texture coordinates outside [0, 1] are wrapped.
enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

/// A picture on a surface.
struct Texture {
  SharedPicture image;  ///< 4 channels
  bool srgb = false;    ///< its colour channels are sRGB-encoded (base colour, emission)
  Wrap wrap_s = Wrap::repeat;
  Wrap wrap_t = Wrap::repeat;
  bool nearest = false;  ///< magnified without interpolation
};

/// What the scene hides of the environment from a vertex, and what it shows there instead: each weighted by the cosine
/// to the vertex's normal. The GPU reads it as it is.
struct VertexOcclusion {
  glm::vec3 occluded{0.0f};  ///< world: the mean of the occluded directions, those that are open counting as 0
  float open = 1.0f;         ///< the share of an even sky's irradiance that arrives
  glm::vec3 interreflected{
      0.0f};  ///< what the scene sends instead under that sky: red, green, blue; with `open` at most 1
  /// World: the mean direction in which the surfaces that send it are open, weighted by their part of its luminance; no
  /// longer than that.
  glm::vec3 lit_from{0.0f};
  glm::vec3 emitted{0.0f};  ///< what arrives of the scene's own emission, with its reflections: irradiance over π
};

/// The material at a vertex, for reflections of the scene in itself: its own, with what textures hold around it.
struct VertexMaterial {
  glm::vec3 base_color{0.8f};
  float metallic = 0.0f;
  glm::vec3 emission{0.0f};
  float perceptual_roughness = 0.5f;
};

/// Where a triangle is cut away by an alpha mask: in which of rows² cells (formula/bodies/scene_surface.glsl).
struct TriangleHoles {
  int rows = 0;                     ///< 0: nowhere
  std::vector<std::uint32_t> bits;  ///< of each cell, the lowest first
};

/// A mesh that is placed in the world, without mirroring: for a mirror image, mirror the mesh.
struct Instance {
  int mesh = 0;
  glm::mat4 world_from_object{1.0f};
  /// Of the mesh's vertices, as their triangles are seen counter-clockwise; then, if they show something, of their
  /// backs. Empty: not known (rays/scene_occlusion.h).
  std::vector<VertexOcclusion> occlusion = {};
  std::vector<VertexMaterial> vertex_materials = {};  ///< of the mesh's vertices; empty: not known
  std::vector<TriangleHoles> holes = {};              ///< of its triangles; empty: none, or not known (findHoles)
  int node = -1;                                      ///< that shows it, of Scene::rig; −1: none
};

/// A ball that encloses everything; what "model radii" on the command line means.
struct BoundingSphere {
  glm::vec3 center{0.0f};
  float radius = 1.0f;
  glm::dvec3 origin{0.0};  ///< Scene::origin: places that options name are in the file's coordinates

  glm::vec3 inScene(glm::dvec3 in_file) const { return glm::vec3(in_file - origin); }
  glm::dvec3 inFile(glm::vec3 in_scene) const { return origin + glm::dvec3(in_scene); }
};

/// The objects that are seen, with their materials and textures, and what else a model's file has.
struct Scene {
  static constexpr std::size_t kMaxLights = 32;

  // Copies of a scene share what is large.
  std::vector<Shared<Mesh>> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;  ///< at least one if there is a mesh
  std::vector<Texture> textures;
  std::vector<Shared<HeightTexture>> height_textures;
  std::vector<Shared<Image>>
      slope_textures;  ///< 3 channels (∂d/∂u, 0, ∂d/∂v), each in lengths of the surface; they tile
  std::vector<ModelCamera> cameras;
  std::vector<ModelLight> lights;     ///< at most kMaxLights
  std::vector<std::string> variants;  ///< names of other choices of materials: chooseVariant()
  std::vector<std::string> warnings;  ///< what was left out of a file, one line each
  std::vector<std::string> files;     ///< that were read beside the model's own
  /// The place in the file's coordinates that is (0, 0, 0) here, after its turn upright: 0, but for a model that lies
  /// far away from it (model_origin.h).
  glm::dvec3 origin{0.0};
  /// What the file's 32-bit vertices were rounded to, where they lie so far away that it may be seen [world units]; 0:
  /// less.
  double vertex_step = 0.0;
  Rig rig;  ///< its nodes, and what moves them; a scene made by code needs none: addNodes()

  bool empty() const { return instances.empty(); }
};

/// The material of an instance, an index into Scene::instances.
const Material& materialOf(const Scene& scene, std::size_t instance);

/// Whether Instance::occlusion has the backs of its vertices too.
bool knowsBacks(const Scene& scene, std::size_t instance);

/// A scene of one mesh where it is, with one material.
Scene meshScene(Mesh mesh, Material material = {});

/// Gives every mesh the material that it has in one of the scene's variants.
///
/// errors   usage: there is none of that name; lists those there are
Result<void> chooseVariant(Scene& scene, const std::string& name);

/// Which of a file's axes points upwards.
enum class UpAxis { y, z };

/// Turns a scene whose `up` axis points upwards so that +Y does: about +X, which stays on the right.
void standUpright(Scene& scene, UpAxis up);

/// The box around everything; empty for an empty scene.
Box boundingBox(const Scene& scene);
/// The box around what one instance places; relief is left out.
Box boundingBox(const Scene& scene, const Instance& instance);

/// The sphere about the middle of the bounding box through the farthest vertex; radius 1 about the origin for an empty
/// scene, and never 0. Exact for a sphere about its own centre.
BoundingSphere boundingSphere(const Scene& scene);

}  // namespace mirrorball
