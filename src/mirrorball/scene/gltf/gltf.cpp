#include "mirrorball/scene/gltf/gltf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_camera.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_material.h"
#include "mirrorball/scene/gltf/gltf_mesh.h"

namespace mirrorball {
namespace gltf {
namespace {

// 2²⁶ vertices of 72 bytes each: a small file that names the same accessor again and again must not fill the memory.
constexpr std::size_t kMaxVertices = std::size_t{1} << 26;

// Likewise: each primitive has a material in each of a file's variants.
constexpr std::size_t kMaxVariantMaterials = std::size_t{1} << 24;

// More than anybody chooses from.
constexpr std::size_t kMaxCameras = 1000;

bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      // Within the range of float, with which the renderer goes on.
      if (!(std::abs(matrix[column][row]) < 1e30)) return false;
  return true;
}

/// A mesh seen in a mirror: triangles turned round so that their outside is outside,
/// and the sense of the bitangent too.
Mesh mirrored(Mesh mesh) {
  for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
    std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
  for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
  return mesh;
}

/// How much memory a primitive asks for, by what its accessors say: vertices, or corners where it has more of them.
std::size_t declaredSize(const Document& document, const Primitive& primitive) {
  const auto count_of = [&](int accessor) {
    const bool exists = accessor >= 0 && std::size_t(accessor) < document.accessors.size();
    return exists ? document.accessors[std::size_t(accessor)].count : 0;
  };
  const auto position = primitive.attributes.find("POSITION");
  const std::size_t vertices = position == primitive.attributes.end() ? 0 : count_of(position->second);
  return std::max(vertices, count_of(primitive.indices));
}

/// The texture coordinates that tangents follow: of the first map that is read in their frame.
int tangentUvSet(const Material& material) {
  for (const TextureSlot* slot : {&material.normal_map, &material.anisotropy_map, &material.clearcoat_normal_map})
    if (slot->texture >= 0) return slot->uv_set;
  return 0;
}

/// Names of which each is another one.
class Names {
 public:
  /// The name, or if it is taken "name 2", "name 3" and so on.
  std::string unlike(const std::string& wanted) {
    std::string name = wanted;
    // What was tried before stays taken.
    for (int& number = last_number_.try_emplace(wanted, 1).first->second; !taken_.insert(name).second;)
      name = wanted + " " + std::to_string(++number);
    return name;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_number_;  // that was behind a name
};

class SceneBuilder {
 public:
  explicit SceneBuilder(const File& file) : file_(file), document_(file.document), materials_(file, scene_) {}

  Result<Scene> build() {
    for (const std::string& what : document_.left_out)
      scene_.warnings.push_back(file_.name + ": its " + what + " are left out");
    if (const std::vector<std::string>& unread = document_.unread_extensions; !unread.empty())
      scene_.warnings.push_back(file_.name + ": what it says by " + join(unread, ", ", " and ") + " is left out");
    MIRRORBALL_TRY(roots, rootNodes());
    MIRRORBALL_TRY(placements, walk(roots));
    if (has_more_lights_) leaveOut("all of its light but " + std::to_string(Scene::kMaxLights) + " lamps");
    MIRRORBALL_TRY(jobs, planPrimitives(placements));
    scene_.variants = document_.variants;
    MIRRORBALL_TRY_VOID(readPrimitives(jobs));
    addInstances(placements);
    if (scene_.instances.empty()) return fail(ErrorCode::bad_file, "its scene shows no triangles");
    MIRRORBALL_TRY_VOID(materials_.decodeTextures());
    return std::move(scene_);
  }

 private:
  struct Visit {
    int node;
    glm::dmat4 world_from_parent;
    std::string key;  // what refers to the node
  };
  struct Placement {
    int mesh;  // of the file
    glm::dmat4 world_from_node;
  };
  struct Job {
    int mesh;  // of the file
    const Primitive* primitive;
    int material;  // of the scene
    std::vector<int> material_of_variant;
    int tangent_uv_set;
    std::string key;
  };

  /// The nodes of the default scene; of a file that names none, all that are nobody's child.
  Result<std::vector<Visit>> rootNodes() const {
    std::vector<Visit> roots;
    if (const int scene = document_.scene; scene != -1) {
      MIRRORBALL_TRY_VOID(checkIndex(scene, document_.scenes.size(), "scene", "scene"));
      for (const int node : document_.scenes[std::size_t(scene)])
        roots.push_back({node, glm::dmat4(1.0), quoted("scenes", std::size_t(scene)) + ".nodes"});
      return roots;
    }
    std::vector<bool> is_child(document_.nodes.size(), false);
    for (const Node& node : document_.nodes)
      for (const int child : node.children)
        if (child >= 0 && std::size_t(child) < is_child.size()) is_child[std::size_t(child)] = true;
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) roots.push_back({static_cast<int>(i), glm::dmat4(1.0), "nodes"});
    return roots;
  }

  /// Walks the tree with a stack of its own, so that a deep one cannot overflow the program's.
  Result<std::vector<Placement>> walk(std::vector<Visit> pending) {
    std::vector<Placement> placements;
    std::vector<bool> visited(document_.nodes.size(), false);
    std::reverse(pending.begin(), pending.end());  // the last is the next
    while (!pending.empty()) {
      const Visit visit = std::move(pending.back());
      pending.pop_back();
      MIRRORBALL_TRY_VOID(checkIndex(visit.node, document_.nodes.size(), visit.key, "node"));
      const auto index = std::size_t(visit.node);
      const std::string key = quoted("nodes", index);
      if (visited[index])
        return fail(ErrorCode::bad_file, key + " is reached twice; nodes must form a tree without cycles");
      visited[index] = true;

      const Node& node = document_.nodes[index];
      const glm::dmat4 world_from_node = visit.world_from_parent * node.parent_from_node;
      if (!isFinite(world_from_node)) return fail(ErrorCode::bad_file, key + " has a transform that is too large");
      if (node.mesh != -1) {
        MIRRORBALL_TRY_VOID(checkIndex(node.mesh, document_.meshes.size(), key + ".mesh", "mesh"));
        // What is scaled to nothing is a file's way to hide it.
        if (determinantOf(world_from_node) != 0.0) placements.push_back({node.mesh, world_from_node});
      }
      MIRRORBALL_TRY_VOID(addCamera(node, world_from_node, key));
      MIRRORBALL_TRY_VOID(addLight(node, world_from_node, key));
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        pending.push_back({*child, world_from_node, key + ".children"});
    }
    return placements;
  }

  /// Puts a node's camera into the scene, under the node's name, else its own.
  Result<void> addCamera(const Node& node, const glm::dmat4& world_from_node, const std::string& key) {
    if (node.camera == -1) return {};
    MIRRORBALL_TRY_VOID(checkIndex(node.camera, document_.cameras.size(), key + ".camera", "camera"));
    const std::optional<ModelCamera>& camera = document_.cameras[std::size_t(node.camera)];
    const std::optional<glm::mat4> place = rigidPart(world_from_node);
    if (!camera || !place) {
      leaveOut("the camera of " + key + ", which shows nothing,");
      return {};
    }
    if (scene_.cameras.size() == kMaxCameras) return {};
    ModelCamera& added = scene_.cameras.emplace_back(*camera);
    added.world_from_view = *place;
    if (!node.name.empty()) added.name = node.name;
    added.name = camera_names_.unlike(added.name.empty() ? "camera" : added.name);
    return {};
  }

  Result<void> addLight(const Node& node, const glm::dmat4& world_from_node, const std::string& key) {
    if (node.light == -1) return {};
    const std::string light_key = key + ".extensions.KHR_lights_punctual.light";
    MIRRORBALL_TRY_VOID(checkIndex(node.light, document_.lights.size(), light_key, "light"));
    const std::optional<ModelLight>& light = document_.lights[std::size_t(node.light)];
    const std::optional<glm::mat4> place = rigidPart(world_from_node);
    if (!light || !place) {
      leaveOut("the light of " + key + ", which has no kind or no direction,");
    } else if (scene_.lights.size() == Scene::kMaxLights) {
      has_more_lights_ = true;
    } else {
      ModelLight& added = scene_.lights.emplace_back(*light);
      added.position = glm::vec3((*place)[3]);
      added.direction = -glm::vec3((*place)[2]);
      if (added.name.empty()) added.name = node.name;
    }
    return {};
  }

  void leaveOut(const std::string& what) { scene_.warnings.push_back(file_.name + ": " + what + " is left out"); }

  static double determinantOf(const glm::dmat4& matrix) { return glm::determinant(glm::dmat3(matrix)); }

  /// Lists the primitives of the meshes that are placed, with their materials, and refuses them if they take too much
  /// memory together.
  Result<std::vector<Job>> planPrimitives(const std::vector<Placement>& placements) {
    std::set<int> meshes;
    for (const Placement& placement : placements) meshes.insert(placement.mesh);
    std::vector<Job> jobs;
    std::size_t left = kMaxVertices;
    for (const int mesh : meshes) {
      const std::vector<Primitive>& primitives = document_.meshes[std::size_t(mesh)];
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Primitive& primitive = primitives[i];
        const std::string key = quoted("meshes", std::size_t(mesh)) + "." + quoted("primitives", i);
        if (!hasTriangles(primitive)) {
          scene_.warnings.push_back(file_.name + ": " + key + " is made of points or lines; it is left out");
          continue;
        }
        if (primitive.has_targets)
          scene_.warnings.push_back(file_.name + ": " + key + ".targets are left out; it keeps its basic shape");
        const std::size_t size = declaredSize(document_, primitive);
        if (size > left)
          return fail(ErrorCode::too_large,
                      key + " brings the model above " + std::to_string(kMaxVertices) + " vertices");
        left -= size;
        MIRRORBALL_TRY_VOID(withName(key, file_.named.budget().take(size * (sizeof(Vertex) + sizeof(std::uint32_t)))));
        MIRRORBALL_TRY(material, materials_.sceneMaterial(primitive.material, key + ".material"));
        MIRRORBALL_TRY(of_variants, materialsOfVariants(primitive, material, key));
        const int tangent_uv_set = tangentUvSet(scene_.materials[std::size_t(material)]);
        jobs.push_back({mesh, &primitive, material, std::move(of_variants), tangent_uv_set, key});
      }
    }
    return jobs;
  }

  /// Mesh::material_of_variant of a primitive with that material.
  Result<std::vector<int>> materialsOfVariants(const Primitive& primitive, int material, const std::string& key) {
    if (primitive.variant_mappings.empty()) return std::vector<int>();
    if (document_.variants.size() > left_of_variants_)
      return fail(ErrorCode::too_large, key + " brings the model above " + std::to_string(kMaxVariantMaterials) +
                                            " materials of primitives in variants");
    left_of_variants_ -= document_.variants.size();
    std::vector<int> materials(document_.variants.size(), material);
    const std::string extension = key + ".extensions.KHR_materials_variants.";
    for (std::size_t i = 0; i < primitive.variant_mappings.size(); ++i) {
      const VariantMapping& mapping = primitive.variant_mappings[i];
      const std::string mapping_key = extension + quoted("mappings", i);
      MIRRORBALL_TRY(mapped, materials_.sceneMaterial(mapping.material, mapping_key + ".material"));
      for (const int variant : mapping.variants) {
        MIRRORBALL_TRY_VOID(checkIndex(variant, materials.size(), mapping_key + ".variants", "variant"));
        materials[std::size_t(variant)] = mapped;
      }
    }
    return materials;
  }

  Result<void> readPrimitives(const std::vector<Job>& jobs) {
    std::vector<Result<Mesh>> meshes(jobs.size());
    parallelFor(jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        meshes[i] = readPrimitive(file_, *jobs[i].primitive, jobs[i].tangent_uv_set, jobs[i].key);
    });
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!meshes[i]) return fail(std::move(meshes[i]));
      if (meshes[i]->indices.empty()) continue;
      meshes[i]->material = jobs[i].material;
      meshes[i]->material_of_variant = jobs[i].material_of_variant;
      scene_meshes_[jobs[i].mesh].push_back(addMesh(std::move(*meshes[i])));
    }
    return {};
  }

  void addInstances(const std::vector<Placement>& placements) {
    for (const auto& [mesh, world_from_node] : placements) {
      for (const int scene_mesh : scene_meshes_[mesh]) {
        const int turned = determinantOf(world_from_node) < 0.0 ? mirroredMesh(scene_mesh) : scene_mesh;
        scene_.instances.push_back({turned, glm::mat4(world_from_node)});
      }
    }
  }

  int mirroredMesh(int mesh) {
    const auto found = mirrored_.find(mesh);
    if (found != mirrored_.end()) return found->second;
    return mirrored_[mesh] = addMesh(mirrored(scene_.meshes[std::size_t(mesh)]));
  }

  int addMesh(Mesh mesh) {
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }

  const File& file_;
  const Document& document_;
  Scene scene_;
  Materials materials_;
  Names camera_names_;
  bool has_more_lights_ = false;
  std::size_t left_of_variants_ = kMaxVariantMaterials;
  std::map<int, std::vector<int>> scene_meshes_;  // mesh of the file → its primitives in the scene
  std::map<int, int> mirrored_;                   // scene mesh → its mirrored copy
};

}  // namespace
}  // namespace gltf

Result<Scene> decodeGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                         const ModelLoadOptions& options) {
  ModelFiles named(path, options);
  MIRRORBALL_TRY(file, gltf::openFile(bytes, path, named));
  MIRRORBALL_TRY(scene, gltf::SceneBuilder(file).build());
  tellOfFiles(named, scene);
  return scene;
}

}  // namespace mirrorball
