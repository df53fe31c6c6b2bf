#include "mirrorball/scene/gltf/gltf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/gltf/gltf_animation.h"
#include "mirrorball/scene/gltf/gltf_deformation.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_material.h"
#include "mirrorball/scene/gltf/gltf_mesh.h"
#include "mirrorball/scene/gltf/gltf_nodes.h"
#include "mirrorball/scene/gltf/gltf_parts.h"
#include "mirrorball/scene/gltf/gltf_pointer.h"
#include "mirrorball/scene/gltf/gltf_remarks.h"
#include "mirrorball/scene/gltf/gltf_skin.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/mesh_repair.h"

namespace mirrorball {
namespace gltf {
namespace {

// Each primitive has a material in each of a file's variants.
constexpr std::size_t kMaxVariantMaterials = std::size_t{1} << 24;

// More than anybody chooses from.
constexpr std::size_t kMaxCameras = 1000;

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

/// Whether morph targets change what is not read of them.
bool hasOtherTargets(const Primitive& primitive) {
  return std::any_of(primitive.targets.begin(), primitive.targets.end(), [](const auto& target) {
    return std::any_of(target.begin(), target.end(), [](const auto& each) {
      return each.first.starts_with("TEXCOORD_") || each.first.starts_with("COLOR_");
    });
  });
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const File& file)
      : file_(file), document_(file.document), materials_(file, scene_), places_(document_.nodes.size(), -1) {}

  Result<Scene> build() {
    if (const std::vector<std::string>& unread = document_.unread_extensions; !unread.empty())
      leaveOut("what it says by " + join(unread, ", ", " and "));
    MIRRORBALL_TRY(placements, addNodes());
    if (has_more_lights_) leaveOut("all of its light but " + std::to_string(Scene::kMaxLights) + " lamps");
    MIRRORBALL_TRY(jobs, planPrimitives(placements));
    scene_.variants = document_.variants;
    MIRRORBALL_TRY_VOID(readPrimitives(jobs));
    MIRRORBALL_TRY_VOID(addParts(scene_, placements, meshes_, vertices_, file_.remarks));
    MIRRORBALL_TRY_VOID(readAnimations(file_, ofFile()));
    MIRRORBALL_TRY_VOID(poseAtRest(scene_));
    if (scene_.instances.empty()) return nothingToShow();
    MIRRORBALL_TRY_VOID(materials_.decodeTextures());
    for (const std::string& spelling : file_.named.remarks()) file_.remarks.tell(spelling);
    for (const std::string& line : file_.remarks.lines()) scene_.warnings.push_back(file_.name + ": " + line);
    return std::move(scene_);
  }

 private:
  struct Job {
    int mesh;  // of the file
    const Primitive* primitive;
    int material;  // of the scene
    std::vector<int> material_of_variant;
    int tangent_uv_set;
    WantedDeformation wanted;
    std::string key;
  };
  /// Why nothing of the file is shown: what is damaged, or what was left out.
  tl::unexpected<Error> nothingToShow() const {
    if (const std::optional<Error>& damage = file_.remarks.firstDamage()) return tl::unexpected<Error>(*damage);
    const std::vector<std::string> left_out = file_.remarks.lines();
    return fail(ErrorCode::bad_file,
                "its scene shows no triangles" + (left_out.empty() ? "" : ": " + left_out.front()));
  }

  /// A node of the rig, and the file's that it was.
  struct RigPlace {
    int node;  // of the file
    glm::dmat4 world;
  };

  /// Gives the rig its nodes, and the scene what they have beside meshes; lists the meshes that they show.
  Result<std::vector<Placement>> addNodes() {
    const std::vector<ListedNode> listed = nodesOfScene(document_, file_.remarks);
    MIRRORBALL_TRY_VOID(takeNodes(listed));
    const std::vector<RigPlace> places = placeNodes(listed);
    const std::vector<bool> morphing = nodesWithAnimatedWeights(document_);
    std::vector<Placement> placements;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t index = std::size_t(places[i].node);
      const Node& node = document_.nodes[index];
      const std::string key = quoted("nodes", index);
      if (isThere(node.mesh, document_.meshes.size(), key + ".mesh", "mesh")) {
        MIRRORBALL_TRY(placement, placementOf(node, static_cast<int>(i), morphing[index], key));
        // What is scaled to nothing is a file's way to hide it, at least until something moves.
        const bool is_seen = glm::determinant(glm::dmat3(places[i].world)) != 0.0 || placement.skin >= 0;
        if (is_seen || !document_.animations.empty())
          placements.push_back(placement);
        else
          file_.remarks.leaveOut(key + " has no volume by its scale", "mesh of such a node");
      }
      addCamera(node, static_cast<int>(i), places[i].world, key);
      addLight(node, static_cast<int>(i), places[i].world, key);
    }
    return placements;
  }

  /// Gives the rig the nodes that are somewhere, and leaves out the others with all that hangs on them.
  std::vector<RigPlace> placeNodes(const std::vector<ListedNode>& listed) {
    constexpr int kNone = -2;
    std::vector<int> in_rig(listed.size(), kNone);
    std::vector<RigPlace> places;
    places.reserve(listed.size());
    for (std::size_t i = 0; i < listed.size(); ++i) {
      const int parent = listed[i].parent < 0 ? -1 : in_rig[std::size_t(listed[i].parent)];
      if (parent == kNone) continue;
      const Node& node = document_.nodes[std::size_t(listed[i].node)];
      const std::string key = quoted("nodes", std::size_t(listed[i].node));
      const glm::dmat4 world =
          (parent < 0 ? glm::dmat4(1.0) : places[std::size_t(parent)].world) * parentFromNode(node.place);
      if (!node.is_somewhere || !isWithinFloats(world)) {
        const char* why = node.is_somewhere ? " has a transform that is too large" : " has a transform that holds NaN";
        file_.remarks.leaveOut({ErrorCode::bad_file, key + why}, "node with all below it");
        continue;
      }
      if (!node.has_rotation)
        file_.remarks.leaveOut({ErrorCode::bad_file, key + ".rotation has no direction"}, "rotation");
      if (!node.is_affine)
        file_.remarks.leaveOut({ErrorCode::bad_file, key + ".matrix, which goes column by column, ends its columns "
                                                           "with other numbers than 0, 0, 0 and 1"},
                               "last row");
      in_rig[i] = static_cast<int>(places.size());
      places_[std::size_t(listed[i].node)] = in_rig[i];
      scene_.rig.nodes.push_back({.name = node.name, .parent = parent, .place = node.place});
      places.push_back({listed[i].node, world});
    }
    return places;
  }

  /// Whether an index is one of `count` things; −1 is none. Another that does not exist is reported.
  bool isThere(int index, std::size_t count, const std::string& key, const char* thing) {
    if (index == -1) return false;
    const Result<void> exists = checkIndex(index, count, key, thing);
    if (!exists) file_.remarks.leaveOut(exists.error(), "reference");
    return exists.has_value();
  }

  /// Asks for the memory of the rig's nodes, and of where each is in the world, before it is taken.
  ///
  /// errors   too_large
  Result<void> takeNodes(const std::vector<ListedNode>& listed) {
    constexpr std::size_t kInString = 15;  // letters that take no memory of their own
    std::uint64_t bytes = listed.size() * (sizeof(RigNode) + sizeof(RigPlace) + sizeof(Placement));
    for (const ListedNode& each : listed) {
      const std::string& name = document_.nodes[std::size_t(each.node)].name;
      if (name.size() > kInString) bytes += name.size() + 2 * sizeof(void*);
    }
    MIRRORBALL_TRY_VOID(withName(counted(listed.size(), "node"), file_.files.budget().take(bytes)));
    scene_.rig.nodes.reserve(listed.size());
    return {};
  }

  /// What a node of the rig shows, which gets its weights.
  Result<Placement> placementOf(const Node& node, int place, bool weights_move, const std::string& key) {
    Placement placement{node.mesh, place, -1, false};
    MIRRORBALL_TRY(skin, rigSkin(node.skin, key + ".skin"));
    placement.skin = skin;
    const Morphing& mesh = morphingOf(node.mesh);
    const bool are_set = node.weights.empty() ? mesh.has_weights : isAnySet(node.weights);
    placement.morphs = mesh.targets > 0 && (weights_move || are_set);
    if (!placement.morphs) return placement;
    MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(mesh.targets * sizeof(float))));
    std::vector<float>& weights = scene_.rig.nodes[std::size_t(place)].weights;
    weights = node.weights.empty() ? document_.meshes[std::size_t(node.mesh)].weights : node.weights;
    weights.resize(mesh.targets, 0.0f);
    return placement;
  }

  /// What many nodes may ask of a mesh of the file.
  struct Morphing {
    std::size_t targets = 0;
    bool has_weights = false;
  };
  const Morphing& morphingOf(int mesh) {
    const auto [known, is_new] = morphing_.try_emplace(mesh);
    if (!is_new) return known->second;
    const FileMesh& source = document_.meshes[std::size_t(mesh)];
    known->second.has_weights = isAnySet(source.weights);
    for (const Primitive& primitive : source.primitives)
      known->second.targets = std::max(known->second.targets, primitive.targets.size());
    return known->second;
  }

  static bool isAnySet(const std::vector<float>& weights) {
    return std::any_of(weights.begin(), weights.end(), [](float weight) { return weight != 0.0f; });
  }

  /// The place in the rig of a skin of the file; −1: none, or none that can be read.
  ///
  /// errors   too_large
  Result<int> rigSkin(int skin, const std::string& key) {
    if (!isThere(skin, document_.skins.size(), key, "skin")) return -1;
    const auto [known, is_new] = skins_.try_emplace(skin, -1);
    if (!is_new) return known->second;
    Result<Skin> read = readSkin(file_, skin, places_);
    if (!read && !isDamage(read.error())) return fail(std::move(read));
    if (!read) {
      file_.remarks.leaveOut(read.error(), "skin");
      return -1;
    }
    if (read->joints.empty()) {
      leaveOut(quoted("skins", std::size_t(skin)) + ", of whose joints the scene has not all,");
      return -1;
    }
    scene_.rig.skins.push_back(std::move(*read));
    return known->second = static_cast<int>(scene_.rig.skins.size()) - 1;
  }

  /// Puts a node's camera into the scene, under the node's name, else its own.
  void addCamera(const Node& node, int place, const glm::dmat4& world_from_node, const std::string& key) {
    if (!isThere(node.camera, document_.cameras.size(), key + ".camera", "camera")) return;
    const std::optional<ModelCamera>& camera = document_.cameras[std::size_t(node.camera)];
    const std::optional<glm::mat4> rigid = rigidPart(world_from_node);
    if (!camera || !rigid) return leaveOut("the camera of " + key + ", which shows nothing,");
    if (scene_.cameras.size() == kMaxCameras) return;
    camera_sources_.push_back(node.camera);
    scene_.rig.camera_nodes.push_back(place);
    ModelCamera& added = scene_.cameras.emplace_back(*camera);
    added.world_from_view = *rigid;
    if (!node.name.empty()) added.name = node.name;
    added.name = camera_names_.unlike(added.name.empty() ? "camera" : added.name);
  }

  void addLight(const Node& node, int place, const glm::dmat4& world_from_node, const std::string& key) {
    const std::string light_key = key + ".extensions.KHR_lights_punctual.light";
    if (!isThere(node.light, document_.lights.size(), light_key, "light")) return;
    const std::optional<FileLight>& light = document_.lights[std::size_t(node.light)];
    const std::optional<glm::mat4> rigid = rigidPart(world_from_node);
    if (!light || !rigid) return leaveOut("the light of " + key + ", which has no kind or no direction,");
    if (scene_.lights.size() == Scene::kMaxLights) {
      has_more_lights_ = true;
      return;
    }
    light_sources_.push_back(node.light);
    scene_.rig.light_nodes.push_back(place);
    ModelLight& added = scene_.lights.emplace_back(*light);
    added.position = glm::vec3((*rigid)[3]);
    added.direction = -glm::vec3((*rigid)[2]);
    if (added.name.empty()) added.name = node.name;
  }

  void leaveOut(const std::string& what) { file_.remarks.tell(what + " is left out"); }

  /// Lists the primitives of the meshes that are placed, with their materials, and refuses them if they take too much
  /// memory together.
  Result<std::vector<Job>> planPrimitives(const std::vector<Placement>& placements) {
    std::map<int, WantedDeformation> meshes;
    for (const Placement& placement : placements) {
      WantedDeformation& wanted = meshes[placement.mesh];
      wanted.skin = wanted.skin || placement.skin >= 0;
      wanted.targets = wanted.targets || placement.morphs;
    }
    std::vector<Job> jobs;
    bool has_other_targets = false;
    for (const auto& [mesh, wanted] : meshes) {
      const std::vector<Primitive>& primitives = document_.meshes[std::size_t(mesh)].primitives;
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Primitive& primitive = primitives[i];
        const std::string key = quoted("meshes", std::size_t(mesh)) + "." + quoted("primitives", i);
        if (!hasTriangles(primitive)) {
          file_.remarks.leaveOut(key + " is made of points or lines", "primitive");
          continue;
        }
        has_other_targets = has_other_targets || (wanted.targets && hasOtherTargets(primitive));
        const std::size_t size = declaredSize(document_, primitive);
        constexpr std::size_t kOfEach = sizeof(Job) + sizeof(Result<PrimitiveMesh>) + sizeof(Mesh) + sizeof(SceneMesh);
        MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(kOfEach + 2 * key.size())));
        MIRRORBALL_TRY_VOID(vertices_.take(size, key));
        MIRRORBALL_TRY_VOID(withName(key, file_.files.budget().take(deformationSize(primitive, wanted, size))));
        MIRRORBALL_TRY(material, materials_.sceneMaterial(primitive.material, key + ".material"));
        MIRRORBALL_TRY(of_variants, materialsOfVariants(primitive, material, key));
        const int tangent_uv_set = tangentUvSet(scene_.materials[std::size_t(material)]);
        jobs.push_back({mesh, &primitive, material, std::move(of_variants), tangent_uv_set, wanted, key});
      }
    }
    if (has_other_targets) leaveOut("what its morph targets change of texture coordinates and colours");
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
      for (const int variant : mapping.variants)
        if (isThere(variant, materials.size(), mapping_key + ".variants", "variant"))
          materials[std::size_t(variant)] = mapped;
    }
    return materials;
  }

  Result<void> readPrimitives(const std::vector<Job>& jobs) {
    std::vector<Result<PrimitiveMesh>> read(jobs.size());
    const ProgressFunction progress = file_.files.progressOfHalf(0);
    ProgressCounter counter(progress, jobs.size());
    parallelFor(jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !counter.stopped(); ++i) {
        read[i] = readPrimitive(file_, *jobs[i].primitive, jobs[i].tangent_uv_set, jobs[i].wanted, jobs[i].key);
        counter.advance();
      }
    });
    MIRRORBALL_TRY_VOID(counter.result());
    MeshRepair repair;
    std::size_t tangents_made = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      if (!read[i]) {
        if (!isDamage(read[i].error())) return fail(std::move(read[i]));
        file_.remarks.leaveOut(read[i].error(), "damaged primitive");
        continue;
      }
      for (const Damage& damage : read[i]->damage) file_.remarks.leaveOut(damage.error, damage.what);
      repair += read[i]->repair;
      tangents_made += read[i]->tangents_made;
      if (read[i]->colors != ColorOddity::none)
        file_.remarks.tellOnce(jobs[i].key + ".attributes.COLOR_0", remarkOn(read[i]->colors));
      Mesh& mesh = read[i]->mesh;
      if (mesh.indices.empty()) continue;
      mesh.material = jobs[i].material;
      mesh.material_of_variant = jobs[i].material_of_variant;
      meshes_[jobs[i].mesh].push_back(
          {static_cast<int>(scene_.meshes.size()), std::move(read[i]->deformation), jobs[i].key});
      scene_.meshes.push_back(std::move(mesh));
    }
    if (tangents_made > 0)
      file_.remarks.tell(counted(tangents_made, "tangent") + (tangents_made == 1 ? " has" : " have") +
                         " no direction and " + (tangents_made == 1 ? "is" : "are") +
                         " made from the triangles around");
    if (const std::string repaired = remarkOn(repair); !repaired.empty()) {
      if (repair.trianglesLeftOut() > 0) file_.remarks.suspect({ErrorCode::bad_file, repaired});
      file_.remarks.tell(repaired);
    }
    return {};
  }

  /// What became of the file's parts, which its animations move.
  SceneOfFile ofFile() {
    SceneOfFile all{.document = document_, .scene = scene_, .place_of_node = places_, .materials = {}};
    for (std::size_t i = 0; i < document_.materials.size(); ++i)
      all.materials.push_back(materials_.placeInScene(static_cast<int>(i)));
    all.cameras.resize(document_.cameras.size());
    for (std::size_t i = 0; i < camera_sources_.size(); ++i)
      all.cameras[std::size_t(camera_sources_[i])].push_back(static_cast<int>(i));
    all.lights.resize(document_.lights.size());
    for (std::size_t i = 0; i < light_sources_.size(); ++i)
      all.lights[std::size_t(light_sources_[i])].push_back(static_cast<int>(i));
    return all;
  }

  const File& file_;
  const Document& document_;
  Scene scene_;
  Materials materials_;
  Names camera_names_;
  bool has_more_lights_ = false;
  std::size_t left_of_variants_ = kMaxVariantMaterials;
  VertexBudget vertices_{file_.files.budget()};
  std::vector<int> places_;                       // of each node of the file, in the rig; −1: it is not shown
  std::map<int, Morphing> morphing_;              // of meshes of the file
  std::map<int, int> skins_;                      // skin of the file → of the rig
  std::vector<int> camera_sources_;               // of each camera of the scene, the file's
  std::vector<int> light_sources_;                // likewise
  std::map<int, std::vector<SceneMesh>> meshes_;  // mesh of the file → its primitives in the scene
};

}  // namespace
}  // namespace gltf

Result<Scene> decodeGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                         const ModelLoadOptions& options) {
  ModelFiles files(path, options);
  MIRRORBALL_TRY_VOID(files.budget().take(bytes.size()));
  NamedFiles named(path, files);
  gltf::Remarks remarks;
  MIRRORBALL_TRY(file, gltf::openFile(bytes, path, named, remarks));
  MIRRORBALL_TRY(scene, gltf::SceneBuilder(file).build());
  tellOfFiles(files, scene);
  return scene;
}

}  // namespace mirrorball
