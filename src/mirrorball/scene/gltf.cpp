#include "mirrorball/scene/gltf.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/scene/gltf_file.h"
#include "mirrorball/scene/gltf_material.h"
#include "mirrorball/scene/gltf_mesh.h"

namespace mirrorball {
namespace {

// 2²⁶ vertices of 72 bytes each: a small file that names the same accessor again and again must not fill the memory.
constexpr std::size_t kMostVertices = std::size_t{1} << 26;

std::string quoted(const char* array, int index) { return std::string(array) + "[" + std::to_string(index) + "]"; }

bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      // Within the range of float, with which the renderer goes on.
      if (!(std::abs(matrix[column][row]) < 1e30)) return false;
  return true;
}

/// A mesh seen in a mirror: triangles turned round so that their outside is outside, and the sense of the bitangent too.
Mesh mirrored(Mesh mesh) {
  for (std::size_t first = 0; first < mesh.indices.size(); first += 3)
    std::swap(mesh.indices[first + 1], mesh.indices[first + 2]);
  for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
  return mesh;
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const GltfFile& file) : file_(file), materials_(file, scene_) {}

  Result<Scene> build() {
    warnOfOmissions();
    MIRRORBALL_TRY(roots, rootNodes());
    MIRRORBALL_TRY_VOID(addNodes(roots));
    if (scene_.instances.empty())
      return fail(ErrorCode::bad_file, file_.name + ": its scene shows no triangles");
    MIRRORBALL_TRY_VOID(materials_.decodeTextures());
    return std::move(scene_);
  }

 private:
  struct Visit {
    int node;
    glm::dmat4 world_from_parent;
    std::string key;  // what refers to the node
  };

  void warnOfOmissions() {
    const auto warn = [&](bool has, const std::string& what) {
      if (has) scene_.warnings.push_back(file_.name + ": " + what + " left out");
    };
    warn(!file_.model.animations.empty(), "its animations are");
    warn(!file_.model.skins.empty(), "its skins are");
    warn(!file_.model.lights.empty(), "its lights are");
  }

  /// The nodes of the default scene; of a file that names none, all that are nobody's child.
  Result<std::vector<Visit>> rootNodes() const {
    std::vector<Visit> roots;
    if (file_.model.defaultScene != -1) {
      const int scene = file_.model.defaultScene;
      MIRRORBALL_TRY_VOID(checkIndex(file_, scene, file_.model.scenes.size(), "scene", "scenes"));
      for (const int node : file_.model.scenes[std::size_t(scene)].nodes)
        roots.push_back({node, glm::dmat4(1.0), quoted("scenes", scene) + ".nodes"});
      return roots;
    }
    const auto count = file_.model.nodes.size();
    std::vector<bool> is_child(count, false);
    for (const tinygltf::Node& node : file_.model.nodes)
      for (const int child : node.children)
        if (child >= 0 && std::size_t(child) < count) is_child[std::size_t(child)] = true;
    for (std::size_t i = 0; i < count; ++i)
      if (!is_child[i]) roots.push_back({static_cast<int>(i), glm::dmat4(1.0), "nodes"});
    return roots;
  }

  /// Walks the tree with a stack of its own, so that a deep one cannot overflow the program's.
  Result<void> addNodes(std::vector<Visit> pending) {
    std::vector<bool> visited(file_.model.nodes.size(), false);
    while (!pending.empty()) {
      const Visit visit = std::move(pending.back());
      pending.pop_back();
      MIRRORBALL_TRY_VOID(checkIndex(file_, visit.node, file_.model.nodes.size(), visit.key, "nodes"));
      const std::string key = quoted("nodes", visit.node);
      if (visited[std::size_t(visit.node)])
        return fail(ErrorCode::bad_file, file_.name + ": " + key +
                                             " is reached twice; nodes must form a tree without cycles");
      visited[std::size_t(visit.node)] = true;

      const tinygltf::Node& node = file_.model.nodes[std::size_t(visit.node)];
      MIRRORBALL_TRY(parent_from_node, transformOf(node, key));
      const glm::dmat4 world_from_node = visit.world_from_parent * parent_from_node;
      if (!isFinite(world_from_node))
        return fail(ErrorCode::bad_file, file_.name + ": " + key + " has a transform that is not finite");
      if (node.mesh != -1) MIRRORBALL_TRY_VOID(addInstances(node.mesh, world_from_node, key));
      for (const int child : node.children) pending.push_back({child, world_from_node, key + ".children"});
    }
    return {};
  }

  Result<glm::dmat4> transformOf(const tinygltf::Node& node, const std::string& key) const {
    const auto has = [](const std::vector<double>& numbers, std::size_t size) {
      return numbers.empty() || numbers.size() == size;
    };
    if (!has(node.matrix, 16) || !has(node.translation, 3) || !has(node.rotation, 4) || !has(node.scale, 3))
      return fail(ErrorCode::bad_file, file_.name + ": " + key + " has a transform with a wrong count of numbers");
    glm::dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
      for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[std::size_t(i)];  // column by column
      return matrix;
    }
    if (!node.translation.empty())
      matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    if (!node.rotation.empty()) {
      const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
      if (!(glm::length(rotation) > 0.0))
        return fail(ErrorCode::bad_file, file_.name + ": " + key + ".rotation has no length");
      matrix *= glm::mat4_cast(glm::normalize(rotation));
    }
    if (!node.scale.empty())
      for (int axis = 0; axis < 3; ++axis) matrix[axis] *= node.scale[std::size_t(axis)];
    return matrix;
  }

  Result<void> addInstances(int mesh, const glm::dmat4& world_from_node, const std::string& key) {
    MIRRORBALL_TRY_VOID(checkIndex(file_, mesh, file_.model.meshes.size(), key + ".mesh", "meshes"));
    const double determinant = glm::determinant(glm::dmat3(world_from_node));
    if (determinant == 0.0) return {};  // scaled to nothing: a file's way to hide it
    if (!scene_meshes_.contains(mesh)) MIRRORBALL_TRY_VOID(readMesh(mesh));
    for (const int scene_mesh : scene_meshes_[mesh]) {
      const int turned = determinant < 0.0 ? mirroredMesh(scene_mesh) : scene_mesh;
      scene_.instances.push_back({turned, glm::mat4(world_from_node)});
    }
    return {};
  }

  /// Reads a glTF mesh's primitives when its first instance asks for them.
  Result<void> readMesh(int mesh_index) {
    std::vector<int>& scene_meshes = scene_meshes_[mesh_index];
    const tinygltf::Mesh& source = file_.model.meshes[std::size_t(mesh_index)];
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = source.primitives[i];
      const std::string key = quoted("meshes", mesh_index) + "." + quoted("primitives", static_cast<int>(i));
      if (!hasTriangles(primitive)) {
        scene_.warnings.push_back(file_.name + ": " + key + " is made of points or lines; it is left out");
        continue;
      }
      if (!primitive.targets.empty())
        scene_.warnings.push_back(file_.name + ": " + key + ".targets are left out; it keeps its basic shape");
      MIRRORBALL_TRY(material, materials_.sceneMaterial(primitive.material, key + ".material"));
      const TextureSlot& normal = scene_.materials[std::size_t(material)].normal_texture;
      MIRRORBALL_TRY(mesh, readPrimitive(file_, primitive, normal.uv_set, verticesLeft(), key));
      if (mesh.indices.empty()) continue;
      mesh.material = material;
      scene_meshes.push_back(addMesh(std::move(mesh)));
    }
    return {};
  }

  std::size_t verticesLeft() const { return vertex_count_ < kMostVertices ? kMostVertices - vertex_count_ : 0; }

  int mirroredMesh(int mesh) {
    const auto found = mirrored_.find(mesh);
    if (found != mirrored_.end()) return found->second;
    return mirrored_[mesh] = addMesh(mirrored(scene_.meshes[std::size_t(mesh)]));
  }

  int addMesh(Mesh mesh) {
    vertex_count_ += std::max(mesh.vertices.size(), mesh.indices.size());
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
  }

  const GltfFile& file_;
  Scene scene_;
  GltfMaterials materials_;
  std::map<int, std::vector<int>> scene_meshes_;  // glTF mesh → its primitives in the scene
  std::map<int, int> mirrored_;                   // scene mesh → its mirrored copy
  std::size_t vertex_count_ = 0;
};

}  // namespace

Result<Scene> decodeGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
  std::vector<std::string_view> known(std::begin(kMaterialExtensions), std::end(kMaterialExtensions));
  known.emplace_back("KHR_mesh_quantization");  // any component type is read everywhere
  MIRRORBALL_TRY(file, readGltfFile(bytes, path, known));
  return SceneBuilder(file).build();
}

Result<Scene> loadGltf(const std::filesystem::path& path) {
  MIRRORBALL_TRY(bytes, readFile(path));
  return decodeGltf(bytes, path);
}

}  // namespace mirrorball
