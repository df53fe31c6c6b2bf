#include "mirrorball/rays/occlusion_cache.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <set>
#include <span>
#include <vector>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// The maps of a material that findOcclusion reads, which normals and layers of other light do not change.
std::vector<const TextureSlot*> slotsOf(const Material& m, const SceneOcclusionSettings& settings) {
  std::vector<const TextureSlot*> slots{&m.base_color_map, &m.metallic_map, &m.specular_map, &m.specular_color_map,
                                        &m.transmission_map};
  if (m.iridescence > 0.0f) slots.insert(slots.end(), {&m.iridescence_map, &m.iridescence_thickness_map});
  if (settings.finds_looks) slots.insert(slots.end(), {&m.roughness_map, &m.emission_map});
  return slots;
}

void addMaterial(const Material& material, const SceneOcclusionSettings& settings, ContentHash& hash) {
  static_assert(alignof(formula::Material) == sizeof(float), "nothing lies between the numbers");
  hash.add(static_cast<const formula::Material&>(material));
  hash.add(material.alpha_mode);
  hash.add(material.unlit);
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

/// What a file begins with. Its numbers are as this machine has them: on another one they are not those that are
/// expected, and the file is made again.
struct Header {
  std::array<char, 8> magic{'M', 'B', 'o', 'c', 'c', 'l', '\r', '\n'};
  std::uint32_t version = OcclusionCache::kVersion;
  std::uint32_t has_looks = 0;
  std::uint64_t vertices = 0;  ///< of all instances
  std::array<char, ContentHash::kDigits> key{};
  std::array<char, ContentHash::kDigits> checksum{};  ///< of all that follows

  bool operator==(const Header&) const = default;
};
static_assert(sizeof(Header) == 24 + 2 * ContentHash::kDigits, "nothing lies between its members");
static_assert(sizeof(VertexOcclusion) == 8 * sizeof(float) && sizeof(VertexLook) == 8 * sizeof(float));

std::array<char, ContentHash::kDigits> digitsOf(const std::string& written) {
  std::array<char, ContentHash::kDigits> digits{};
  std::copy_n(written.begin(), std::min(written.size(), digits.size()), digits.begin());
  return digits;
}

std::size_t verticesOf(const Scene& scene, const Instance& instance) {
  return scene.meshes[std::size_t(instance.mesh)].vertices.size();
}

std::size_t verticesOf(const Scene& scene) {
  std::size_t vertices = 0;
  for (const Instance& instance : scene.instances) vertices += verticesOf(scene, instance);
  return vertices;
}

Header headerOf(const std::string& key, bool has_looks, const Scene& scene) {
  return {.has_looks = has_looks, .vertices = verticesOf(scene), .key = digitsOf(key)};
}

/// Of one instance.
struct Known {
  std::vector<VertexOcclusion> occlusion;
  std::vector<VertexLook> looks;
};

/// Visits what is kept of instances, or of Known, in the order of the file.
template <typename Each, typename Visit>
void forEachArray(std::span<Each> all, bool has_looks, Visit&& visit) {
  for (Each& each : all) {
    visit(each.occlusion);
    if (has_looks) visit(each.looks);
  }
}

template <typename Value>
std::span<const std::uint8_t> bytesOf(std::span<const Value> values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

template <typename Value>
bool readAll(const FileReader& file, std::uint64_t offset, std::span<Value> values) {
  const std::span<std::uint8_t> bytes{reinterpret_cast<std::uint8_t*>(values.data()), values.size_bytes()};
  const auto count = file.readAt(offset, bytes);
  return count && *count == bytes.size();
}

/// What a file holds; nothing: it is not the one that is expected, or damaged.
std::optional<std::vector<Known>> readKnown(const fs::path& path, const Header& expected, const Scene& scene) {
  const auto file = FileReader::open(path);
  const bool has_looks = expected.has_looks != 0;
  const std::uint64_t of_vertex = sizeof(VertexOcclusion) + (has_looks ? sizeof(VertexLook) : 0);
  const std::uint64_t bytes = expected.vertices * of_vertex;
  if (!file || file->size() != sizeof(Header) + bytes || !checkMemory(bytes)) return {};
  Header header;
  if (!readAll(*file, 0, std::span(&header, 1))) return {};
  std::vector<Known> all(scene.instances.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].occlusion.resize(verticesOf(scene, scene.instances[i]));
    if (has_looks) all[i].looks.resize(all[i].occlusion.size());
  }
  ContentHash content;
  std::uint64_t offset = sizeof(Header);
  bool is_whole = true;
  forEachArray(std::span(all), has_looks, [&](auto& values) {
    is_whole = is_whole && readAll(*file, offset, std::span(values));
    content.addAll(std::span(std::as_const(values)));
    offset += std::span(values).size_bytes();
  });
  Header as_read = expected;
  as_read.checksum = digitsOf(content.digits());
  if (!is_whole || header != as_read) return {};
  return all;
}

Result<void> write(const fs::path& path, Header header, const Scene& scene) {
  MIRRORBALL_TRY(writer, FileWriter::create(path));
  ContentHash content;
  std::uint64_t offset = sizeof(Header);
  Result<void> written;
  forEachArray(std::span(scene.instances), header.has_looks != 0, [&](const auto& values) {
    const std::span array(values);
    if (written) written = writer.writeAt(offset, bytesOf(array));
    content.addAll(array);
    offset += array.size_bytes();
  });
  MIRRORBALL_TRY_VOID(written);
  header.checksum = digitsOf(content.digits());
  MIRRORBALL_TRY_VOID(writer.writeAt(0, bytesOf(std::span<const Header>(&header, 1))));
  return writer.commit();
}

}  // namespace

bool OcclusionCache::isWorthAFile(const Scene& scene, const SceneOcclusionSettings& settings) {
  const std::size_t vertices = verticesOf(scene);
  return vertices * occlusionRaysOfVertex(vertices, settings) >= kFewestRays;
}

std::string OcclusionCache::keyOf(const Scene& scene, const SceneOcclusionSettings& settings) {
  ContentHash hash(kVersion);
  hash.add(settings.rays);
  hash.add(settings.finds_looks);
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

bool OcclusionCache::find(const std::string& key, bool has_looks, Scene& scene) const {
  auto known = folder_.find(key, CachedKind::occlusion, [&](const fs::path& path) {
    return readKnown(path, headerOf(key, has_looks, scene), scene);
  });
  if (!known) return false;
  for (std::size_t i = 0; i < known->size(); ++i) {
    scene.instances[i].occlusion = std::move((*known)[i].occlusion);
    scene.instances[i].looks = std::move((*known)[i].looks);
  }
  return true;
}

void OcclusionCache::keep(const std::string& key, bool has_looks, const Scene& scene) const {
  folder_.keep(key, CachedKind::occlusion,
               [&](const fs::path& path) { return write(path, headerOf(key, has_looks, scene), scene); });
}

Result<void> findOcclusionOnce(Scene& scene, const SceneOcclusionSettings& settings,
                               const std::optional<CacheFolder>& cache, const ProgressFunction& progress) {
  const bool is_kept = cache && cache->maxBytes() > 0 && OcclusionCache::isWorthAFile(scene, settings);
  const std::string key = is_kept ? OcclusionCache::keyOf(scene, settings) : std::string();
  if (is_kept && OcclusionCache(*cache).find(key, settings.finds_looks, scene)) return {};
  MIRRORBALL_TRY(geometry, Geometry::make(scene));
  MIRRORBALL_TRY_VOID(findOcclusion(scene, geometry, settings, progress));
  if (is_kept) OcclusionCache(*cache).keep(key, settings.finds_looks, scene);
  return {};
}

}  // namespace mirrorball
