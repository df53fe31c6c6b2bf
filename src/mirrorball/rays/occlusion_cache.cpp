#include "mirrorball/rays/occlusion_cache.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <type_traits>
#include <vector>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/rays/occlusion_refinement.h"
#include "mirrorball/rays/triangle_holes.h"

namespace mirrorball {
namespace {

/// The maps of a material that findOcclusion reads, which normals and layers of other light do not change.
std::vector<const TextureSlot*> slotsOf(const Material& m, const SceneOcclusionSettings& settings) {
  std::vector<const TextureSlot*> slots{&m.base_color_map,     &m.metallic_map,     &m.specular_map,
                                        &m.specular_color_map, &m.transmission_map, &m.emission_map};
  if (m.iridescence > 0.0f) slots.insert(slots.end(), {&m.iridescence_map, &m.iridescence_thickness_map});
  if (settings.finds_materials) slots.push_back(&m.roughness_map);
  return slots;
}

void addMaterial(const Material& material, const SceneOcclusionSettings& settings, ContentHash& hash) {
  static_assert(alignof(formula::Material) == sizeof(float), "nothing lies between the numbers");
  hash.add(static_cast<const formula::Material&>(material));
  hash.add(material.alpha_mode);
  hash.add(material.unlit);
  hash.add(material.double_sided);
  hash.add(material.thin_walled);  // with the transmission it says whether a back is culled
  for (const TextureSlot* slot : slotsOf(material, settings)) {
    hash.add(slot->texture);
    if (slot->texture < 0) continue;  // what such a slot holds besides is not read
    hash.add(slot->uv_set);
    hash.add(slot->offset);
    hash.add(slot->scale);
    hash.add(slot->rotation_rad);
  }
}

std::string contentOf(const Texture& texture) {
  ContentHash hash;
  hash.add(texture.image.width());
  if (texture.image.hasNumbers())
    hash.addAll(texture.image.numbers().samples());
  else
    hash.addAll(texture.image.samples());
  hash.add(texture.srgb);
  hash.add(texture.wrap_s);
  hash.add(texture.wrap_t);
  hash.add(texture.nearest);
  return hash.digits();
}

template <typename Value>
void addCounted(const std::vector<Value>& values, ContentHash& hash) {
  hash.add(values.size());
  hash.addAll(std::span(values));
}

std::size_t verticesOf(const Scene& scene, const Instance& instance) {
  return scene.meshes[std::size_t(instance.mesh)]->vertices.size();
}

std::size_t verticesOf(const Scene& scene) {
  std::size_t vertices = 0;
  for (const Instance& instance : scene.instances) vertices += verticesOf(scene, instance);
  return vertices;
}

static_assert(sizeof(VertexOcclusion) == 13 * sizeof(float) && sizeof(VertexMaterial) == 8 * sizeof(float));

/// What a file holds.
struct Known {
  struct OfMesh {
    std::array<std::uint64_t, 2> counts{};  ///< of new vertices, and of indices
    MeshRefinement refinement;
  };
  struct OfInstance {
    std::array<std::uint64_t, 1> sides{};
    std::vector<VertexOcclusion> occlusion;
    std::vector<VertexMaterial> vertex_materials;
  };
  std::vector<OfMesh> meshes;
  std::vector<OfInstance> instances;
};

/// Reads values one after the other.
class KnownReader {
 public:
  explicit KnownReader(const CachedContent& content) : content_(content) {}

  template <typename Value>
  bool read(std::span<Value> values) {
    const std::span<std::uint8_t> bytes{reinterpret_cast<std::uint8_t*>(values.data()), values.size_bytes()};
    if (bytes.size() > left()) return false;
    const auto count = content_.file.readAt(offset_, bytes);
    offset_ += bytes.size();
    return count && *count == bytes.size();
  }
  /// As many values more as there are to be; no memory is taken for what the content is too short for.
  template <typename Value>
  bool read(std::vector<Value>& values, std::uint64_t count) {
    if (count > left() / sizeof(Value)) return false;
    values.resize(count);
    return read(std::span(values));
  }

  std::uint64_t left() const { return content_.size - offset_; }

 private:
  const CachedContent& content_;
  std::uint64_t offset_ = 0;
};

/// Whether its numbers are those of vertices of a mesh that has so many.
bool isOfMesh(const MeshRefinement& refinement, std::size_t vertices) {
  for (std::size_t i = 0; i < refinement.parents.size(); ++i)
    if (std::max(refinement.parents[i].x, refinement.parents[i].y) >= vertices + i) return false;
  return refinement.indices.size() % 3 == 0 && (refinement.parents.empty() || !refinement.empty()) &&
         std::all_of(refinement.indices.begin(), refinement.indices.end(),
                     [&](std::uint32_t index) { return index < vertices + refinement.parents.size(); });
}

/// What a file holds; nothing: it is none of such a scene.
std::optional<Known> readKnown(const CachedContent& content, bool has_materials, const Scene& scene) {
  if (!checkMemory(content.size)) return {};
  KnownReader reader(content);
  Known known{.meshes = std::vector<Known::OfMesh>(scene.meshes.size()),
              .instances = std::vector<Known::OfInstance>(scene.instances.size())};
  for (std::size_t i = 0; i < known.meshes.size(); ++i) {
    Known::OfMesh& mesh = known.meshes[i];
    if (!reader.read(std::span<std::uint64_t>(mesh.counts)) || !reader.read(mesh.refinement.parents, mesh.counts[0]) ||
        !reader.read(mesh.refinement.indices, mesh.counts[1]) ||
        !isOfMesh(mesh.refinement, scene.meshes[i]->vertices.size()))
      return {};
  }
  for (std::size_t i = 0; i < known.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const std::uint64_t vertices = verticesOf(scene, instance) + known.meshes[std::size_t(instance.mesh)].counts[0];
    Known::OfInstance& of_instance = known.instances[i];
    if (!reader.read(std::span<std::uint64_t>(of_instance.sides)) || of_instance.sides[0] > 2 ||
        (of_instance.sides[0] == 0 && vertices > 0) ||
        !reader.read(of_instance.occlusion, of_instance.sides[0] * vertices) ||
        !reader.read(of_instance.vertex_materials, has_materials ? vertices : 0))
      return {};
  }
  if (reader.left() != 0) return {};
  return known;
}

Result<void> write(const FileWriter& file, bool has_materials, const Scene& scene,
                   std::span<const MeshRefinement> refinements) {
  std::uint64_t offset = 0;
  Result<void> written;
  const auto add = [&](const auto& values) {
    const std::span<const typename std::remove_cvref_t<decltype(values)>::value_type> all(values);
    if (written) written = file.writeAt(offset, bytesOf(all));
    offset += all.size_bytes();
  };
  for (const MeshRefinement& refinement : refinements) {
    add(std::array<std::uint64_t, 2>{refinement.parents.size(), refinement.indices.size()});
    add(refinement.parents);
    add(refinement.indices);
  }
  for (const Instance& instance : scene.instances) {
    add(std::array<std::uint64_t, 1>{instance.occlusion.size() /
                                     std::max<std::size_t>(verticesOf(scene, instance), 1)});
    add(instance.occlusion);
    if (has_materials) add(instance.vertex_materials);
  }
  return written;
}

}  // namespace

bool OcclusionCache::isWorthAFile(const Scene& scene, const SceneOcclusionSettings& settings) {
  return occlusionRays(verticesOf(scene), settings) >= kFewestRays;
}

std::string OcclusionCache::keyOf(const Scene& scene, const SceneOcclusionSettings& settings) {
  ContentHash hash(kVersion);
  hash.add(settings.rays);
  hash.add(settings.finds_materials);
  hash.add(settings.refines);
  hash.add(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    hash.add(instance.mesh);
    hash.add(instance.world_from_object);
  }
  std::set<int> used;
  for (const Mesh& mesh : scene.meshes) {
    addCounted(mesh.vertices, hash);
    addCounted(mesh.indices, hash);
    const Material& material = scene.materials[std::size_t(mesh.material)];
    addMaterial(material, settings, hash);
    if (settings.refines) {  // which leaves reliefs as they are
      hash.add(material.height);
      hash.add(mesh.first_of_relief);
    }
    for (const TextureSlot* slot : slotsOf(material, settings))
      if (slot->texture >= 0) used.insert(slot->texture);
  }
  const std::vector<int> textures(used.begin(), used.end());
  std::vector<std::string> contents(textures.size());
  parallelFor(textures.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) contents[i] = contentOf(scene.textures[std::size_t(textures[i])]);
  });
  for (const std::string& content : contents) hash.addAll(std::span(content));
  return hash.digits();
}

bool OcclusionCache::find(const std::string& key, bool has_materials, Scene& scene) const {
  auto known = folder_.find(key, CachedKind::occlusion,
                            [&](const CachedContent& content) { return readKnown(content, has_materials, scene); });
  if (!known) return false;
  for (std::size_t i = 0; i < known->meshes.size(); ++i)
    if (!known->meshes[i].refinement.empty()) refine(scene.meshes[i].edit(), known->meshes[i].refinement);
  for (std::size_t i = 0; i < known->instances.size(); ++i) {
    scene.instances[i].occlusion = std::move(known->instances[i].occlusion);
    scene.instances[i].vertex_materials = std::move(known->instances[i].vertex_materials);
  }
  return true;
}

void OcclusionCache::keep(const std::string& key, bool has_materials, const Scene& scene,
                          std::span<const MeshRefinement> refinements) const {
  folder_.keep(key, CachedKind::occlusion,
               [&](const FileWriter& file) { return write(file, has_materials, scene, refinements); });
}

namespace {

/// Cuts a scene's meshes where that is needed; the geometry is then that of the scene as it is.
///
/// returns   how, one for each mesh
Result<std::vector<MeshRefinement>> refined(Scene& scene, Geometry& geometry, const ProgressFunction& progress) {
  MIRRORBALL_TRY(refinements, occlusionRefinements(scene, geometry, progress));
  if (std::all_of(refinements.begin(), refinements.end(), [](const auto& each) { return each.empty(); }))
    return refinements;
  for (std::size_t i = 0; i < refinements.size(); ++i)
    if (!refinements[i].empty()) refine(scene.meshes[i].edit(), refinements[i]);
  MIRRORBALL_TRY(of_cut, Geometry::make(scene));
  geometry = std::move(of_cut);
  return refinements;
}

/// Unless the cache has it.
Result<void> findOrRead(Scene& scene, const SceneOcclusionSettings& settings, const std::optional<CacheFolder>& cache,
                        const ProgressFunction& progress) {
  // A few large triangles may become many.
  bool is_kept = cache && cache->maxBytes() > 0 && (settings.refines || OcclusionCache::isWorthAFile(scene, settings));
  const std::string key = is_kept ? OcclusionCache::keyOf(scene, settings) : std::string();
  if (is_kept && OcclusionCache(*cache).find(key, settings.finds_materials, scene)) return {};
  MIRRORBALL_TRY(geometry, Geometry::make(scene));
  // Looking for where meshes are cut takes a quarter to a third of FlightHelmet's time.
  constexpr std::size_t kAll = 1000, kOfCuts = 250;
  std::vector<MeshRefinement> refinements(scene.meshes.size());
  if (settings.refines) {
    MIRRORBALL_TRY(found, refined(scene, geometry, partOf(progress, 0, kOfCuts, kAll)));
    refinements = std::move(found);
  }
  const std::size_t first = settings.refines ? kOfCuts : 0;
  MIRRORBALL_TRY_VOID(findOcclusion(scene, geometry, settings, partOf(progress, first, kAll - first, kAll)));
  is_kept = is_kept && OcclusionCache::isWorthAFile(scene, settings);
  if (is_kept) OcclusionCache(*cache).keep(key, settings.finds_materials, scene, refinements);
  return {};
}

}  // namespace

Result<void> findOcclusionOnce(Scene& scene, const SceneOcclusionSettings& settings,
                               const std::optional<CacheFolder>& cache, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(findOrRead(scene, settings, cache, progress));
  if (settings.finds_materials) findHoles(scene);
  return {};
}

}  // namespace mirrorball
