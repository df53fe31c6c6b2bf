#include "mirrorball/rays/occlusion_cache.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/file.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

class OcclusionCacheTest : public ::testing::Test {
 protected:
  OcclusionCacheTest() { fs::remove_all(folder_); }
  ~OcclusionCacheTest() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const {
    if (!fs::exists(folder_)) return {};
    return {fs::directory_iterator(folder_), fs::directory_iterator()};
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("occlusion_cache_" + std::to_string(::getpid()));
  const std::optional<CacheFolder> cache_ = CacheFolder(folder_);
};

/// A texture of noise, which differs from place to place.
Texture noise() {
  Texture texture{.image = Image8(8, 8, 4)};
  std::uint32_t state = 1;
  for (std::uint8_t& sample : texture.image.edit().samples()) {
    state = state * 1664525u + 1013904223u;
    sample = static_cast<std::uint8_t>(state >> 24u);
  }
  return texture;
}

/// Two balls beside each other, of a material that has something of all that counts.
Scene twoBalls() {
  Material material;
  material.base_color = glm::vec3(0.7f, 0.5f, 0.3f);
  material.metallic = 0.5f;
  material.transmission = 0.3f;
  material.alpha_mode = AlphaMode::blend;
  material.opacity = 0.8f;
  material.iridescence = 0.5f;
  material.emission = glm::vec3(1.0f);
  material.clearcoat = 0.5f;
  Scene scene = meshScene(sphereMesh(12, 24), material);
  scene.instances.push_back(scene.instances.front());
  scene.instances[1].world_from_object[3] = glm::vec4(1.2f, 0.0f, 0.0f, 1.0f);
  scene.textures.push_back(noise());
  return scene;
}

constexpr SceneOcclusionSettings kSettings{.rays = 80, .finds_materials = true};

Scene found(Scene scene, const SceneOcclusionSettings& settings, const std::optional<CacheFolder>& cache = {}) {
  EXPECT_TRUE(findOcclusionOnce(scene, settings, cache));
  return scene;
}

/// What was found, bit for bit.
std::string bitsOf(const Scene& scene) {
  std::string bits;
  for (const Instance& instance : scene.instances) {
    bits.append(reinterpret_cast<const char*>(instance.occlusion.data()),
                instance.occlusion.size() * sizeof(VertexOcclusion));
    bits.append(reinterpret_cast<const char*>(instance.vertex_materials.data()),
                instance.vertex_materials.size() * sizeof(VertexMaterial));
  }
  return bits;
}

TEST_F(OcclusionCacheTest, IsFoundAgainBitForBit) {
  for (const bool finds_materials : {true, false}) {
    const SceneOcclusionSettings settings{.rays = 80, .finds_materials = finds_materials};
    const std::string made = bitsOf(found(twoBalls(), settings));
    EXPECT_TRUE(bitsOf(found(twoBalls(), settings, cache_)) == made);
    Scene again = twoBalls();
    EXPECT_TRUE(OcclusionCache(*cache_).find(OcclusionCache::keyOf(again, settings), finds_materials, again));
    EXPECT_TRUE(bitsOf(again) == made);
    EXPECT_EQ(again.instances[1].vertex_materials.empty(), !finds_materials);
  }
  EXPECT_EQ(files().size(), 2u);
}

// What is in the file is what is taken: no ray is traced.
TEST_F(OcclusionCacheTest, IsTakenInPlaceOfRays) {
  Scene scene = twoBalls();
  for (Instance& instance : scene.instances)
    instance.occlusion.assign(scene.meshes[0]->vertices.size(), {.open = 0.25f});
  const SceneOcclusionSettings settings{.rays = 80};
  const std::string key = OcclusionCache::keyOf(scene, settings);
  OcclusionCache(*cache_).keep(key, false, scene, std::vector<MeshRefinement>(scene.meshes.size()));
  for (const Instance& instance : found(twoBalls(), settings, cache_).instances)
    for (const VertexOcclusion& occlusion : instance.occlusion) ASSERT_EQ(occlusion.open, 0.25f);
}

// Where triangles are too large to tell, the cuts are kept too.
TEST_F(OcclusionCacheTest, HowMeshesAreCutIsKept) {
  const auto make = [] {
    Scene scene = twoBalls();
    scene.materials.push_back({});
    scene.meshes.push_back(planeMesh());
    scene.meshes[1].edit().material = 1;
    scene.instances.push_back({.mesh = 1, .world_from_object = glm::mat4(4.0f)});
    scene.instances[2].world_from_object[3] = glm::vec4(0.0f, -1.0f, 0.0f, 1.0f);
    return scene;
  };
  constexpr SceneOcclusionSettings kRefined{.rays = 80, .refines = true};
  const Scene made = found(make(), kRefined);
  EXPECT_GT(made.meshes[1]->vertices.size(), planeMesh().vertices.size());
  EXPECT_TRUE(bitsOf(found(make(), kRefined, cache_)) == bitsOf(made));
  Scene again = make();
  EXPECT_TRUE(OcclusionCache(*cache_).find(OcclusionCache::keyOf(again, kRefined), false, again));
  EXPECT_TRUE(bitsOf(again) == bitsOf(made));
  EXPECT_EQ(again.meshes[1]->indices, made.meshes[1]->indices);
  EXPECT_NE(OcclusionCache::keyOf(make(), kRefined), OcclusionCache::keyOf(make(), {.rays = 80}));
  // What has heights is not cut.
  Scene with_heights = make();
  with_heights.materials[1].height = HeightKind::waves;
  EXPECT_NE(OcclusionCache::keyOf(with_heights, kRefined), OcclusionCache::keyOf(make(), kRefined));
}

TEST_F(OcclusionCacheTest, LittleWorkIsNotKept) {
  found(twoBalls(), {.rays = 1}, cache_);
  EXPECT_TRUE(files().empty());
  found(twoBalls(), {.rays = 80}, CacheFolder(folder_, 0));
  EXPECT_TRUE(files().empty()) << "and nothing in a cache of size 0";
  EXPECT_FALSE(OcclusionCache::isWorthAFile(Scene(), {}));
}

using Change = std::function<void(Scene&, SceneOcclusionSettings&)>;

// Whatever changes what is found must change the key; these all do change it.
TEST_F(OcclusionCacheTest, AnotherKeyForAllThatItReads) {
  const std::pair<const char*, Change> changes[] = {
      {"rays", [](Scene&, auto& settings) { settings.rays = 81; }},
      {"materials", [](Scene&, auto& settings) { settings.finds_materials = false; }},
      {"position", [](Scene& scene, auto&) { scene.meshes[0].edit().vertices[40].position.x += 0.01f; }},
      {"normal",
       [](Scene& scene, auto&) {
         scene.meshes[0].edit().vertices[40].normal = {1, 0, 0};
       }},
      {"colour", [](Scene& scene, auto&) { scene.meshes[0].edit().vertices[40].color = glm::vec4(0.5f); }},
      {"index", [](Scene& scene, auto&) { scene.meshes[0].edit().indices[600] = scene.meshes[0]->indices[601]; }},
      {"place", [](Scene& scene, auto&) { scene.instances[1].world_from_object[3].x = 1.3f; }},
      {"instances", [](Scene& scene, auto&) { scene.instances.pop_back(); }},
      {"material", [](Scene& scene, auto&) { scene.materials[0].base_color.y = 0.9f; }},
      {"another material",
       [](Scene& scene, auto&) {
         scene.materials.push_back({});
         scene.meshes[0].edit().material = 1;
       }},
      {"alpha", [](Scene& scene, auto&) { scene.materials[0].alpha_mode = AlphaMode::opaque; }},
      {"unlit", [](Scene& scene, auto&) { scene.materials[0].unlit = true; }},
  };
  std::set<std::string> keys{OcclusionCache::keyOf(twoBalls(), kSettings)};
  const std::string bits = bitsOf(found(twoBalls(), kSettings));
  for (const auto& [name, change] : changes) {
    Scene scene = twoBalls();
    SceneOcclusionSettings settings = kSettings;
    change(scene, settings);
    EXPECT_TRUE(keys.insert(OcclusionCache::keyOf(scene, settings)).second) << name;
    EXPECT_TRUE(bitsOf(found(std::move(scene), settings)) != bits) << name << " is not read";
  }
}

// Also of textures that are added to what is read later on.
TEST_F(OcclusionCacheTest, AnotherKeyForEachMapThatItReads) {
  std::size_t that_count = 0;
  for (const bool finds_materials : {true, false}) {
    const SceneOcclusionSettings settings{.rays = 80, .finds_materials = finds_materials};
    const std::string key = OcclusionCache::keyOf(twoBalls(), settings);
    const std::string bits = bitsOf(found(twoBalls(), settings));
    std::set<std::string> keys{key};
    for (const MaterialMap& map : materialMaps()) {
      Scene scene = twoBalls();
      (scene.materials[0].*map.slot).texture = 0;
      const std::string key_with = OcclusionCache::keyOf(scene, settings);
      const bool counts = bitsOf(found(scene, settings)) != bits;
      that_count += counts ? 1u : 0u;
      EXPECT_EQ(key_with != key, counts) << map.name << (finds_materials ? " with materials" : "");
      if (!counts) continue;
      EXPECT_TRUE(keys.insert(key_with).second) << map.name << ": the key of the same texture as another map";
      const std::pair<const char*, std::function<void(Scene&)>> changes[] = {
          {"texel", [](Scene& s) { ++s.textures[0].image.edit().samples()[21]; }},
          {"offset", [&](Scene& s) { (s.materials[0].*map.slot).offset.x = 0.5f; }},
          {"scale", [&](Scene& s) { (s.materials[0].*map.slot).scale.y = 2.0f; }},
          {"rotation", [&](Scene& s) { (s.materials[0].*map.slot).rotation_rad = 1.0f; }},
          {"uv set", [&](Scene& s) { (s.materials[0].*map.slot).uv_set = 1; }},
          {"srgb", [](Scene& s) { s.textures[0].srgb = true; }},
          {"wrap s", [](Scene& s) { s.textures[0].wrap_s = Wrap::clamp_to_edge; }},
          {"wrap t", [](Scene& s) { s.textures[0].wrap_t = Wrap::clamp_to_edge; }},
          {"nearest", [](Scene& s) { s.textures[0].nearest = true; }}};
      for (const auto& [name, change] : changes) {
        Scene changed = scene;
        change(changed);
        EXPECT_NE(OcclusionCache::keyOf(changed, settings), key_with) << map.name << ": " << name;
      }
    }
  }
  EXPECT_EQ(that_count, 9u + 8u) << "with materials, and without";
}

// Also of numbers that are added.
TEST_F(OcclusionCacheTest, AnotherKeyForEachNumberOfTheMaterial) {
  const std::string key = OcclusionCache::keyOf(twoBalls(), kSettings);
  for (std::size_t i = 0; i < sizeof(formula::Material) / sizeof(float); ++i) {
    Scene scene = twoBalls();
    auto* bytes = reinterpret_cast<unsigned char*>(static_cast<formula::Material*>(scene.materials.data()));
    bytes[i * sizeof(float)] ^= 1u;
    EXPECT_NE(OcclusionCache::keyOf(scene, kSettings), key) << i;
  }
}

// Each single byte of the file counts, and each length.
TEST_F(OcclusionCacheTest, ADamagedFileIsMadeAgain) {
  const std::string bits = bitsOf(found(twoBalls(), kSettings, cache_));
  ASSERT_EQ(files().size(), 1u);
  const fs::path path = files().front();
  const auto whole = readFile(path);
  ASSERT_TRUE(whole);
  const std::string key = OcclusionCache::keyOf(twoBalls(), kSettings);
  const auto isFound = [&](const Bytes& bytes) {
    EXPECT_TRUE(writeFile(path, bytes));
    Scene scene = twoBalls();
    const bool is_found = OcclusionCache(*cache_).find(key, true, scene);
    EXPECT_EQ(bitsOf(scene).empty(), !is_found) << "else the scene is as before";
    return is_found;
  };
  EXPECT_TRUE(isFound(*whole));
  constexpr std::size_t kHeader = 80;
  for (std::size_t i = 0; i < whole->size(); i += i < kHeader ? 1 : 997) {
    Bytes damaged = *whole;
    damaged[i] ^= 4u;
    EXPECT_FALSE(isFound(damaged)) << "byte " << i;
  }
  for (const std::size_t size : {std::size_t{0}, kHeader - 1, kHeader, whole->size() - 1, whole->size() + 1}) {
    Bytes other = *whole;
    other.resize(size);
    EXPECT_FALSE(isFound(other)) << size << " bytes";
  }
  EXPECT_TRUE(bitsOf(found(twoBalls(), kSettings, cache_)) == bits);
  EXPECT_TRUE(readFile(path).value() == *whole) << "kept again";
}

TEST_F(OcclusionCacheTest, AFileOfAnotherSceneIsMadeAgain) {
  const auto fileOf = [&](Scene scene) {
    for (const fs::path& path : files()) fs::remove(path);
    found(std::move(scene), kSettings, cache_);
    return files().front();
  };
  Scene moved = twoBalls();
  moved.instances[1].world_from_object[3].x = 1.3f;
  const auto of_other = readFile(fileOf(moved));
  ASSERT_TRUE(of_other);
  const fs::path path = fileOf(twoBalls());
  ASSERT_TRUE(writeFile(path, *of_other)) << "of the same counts, under the name of the other";
  Scene scene = twoBalls();
  EXPECT_FALSE(OcclusionCache(*cache_).find(OcclusionCache::keyOf(scene, kSettings), true, scene));
}

// Where these change, findOcclusion finds something else: raise OcclusionCache::kVersion, so that nobody is shown what
// was kept before, and write both down here.
TEST(OcclusionCacheVersion, GoesUpWithOtherValues) {
  const Scene scene = found(twoBalls(), kSettings);
  std::vector<float> values;
  for (const std::size_t vertex : {140u, 165u, 190u}) {
    const VertexOcclusion& occlusion = scene.instances[0].occlusion[vertex];
    values.insert(values.end(), {occlusion.occluded.x, occlusion.open, occlusion.interreflected.y, occlusion.lit_from.x,
                                 occlusion.emitted.z});
  }
  EXPECT_EQ(OcclusionCache::kVersion, 5u);
  EXPECT_THAT(values, ::testing::Pointwise(::testing::FloatNear(1e-3f),
                                           {0.1804f, 0.5752f, 0.1858f, -0.0233f, 0.4179f, 0.2485f, 0.4261f, 0.2513f,
                                            -0.0239f, 0.5960f, 0.2506f, 0.3627f, 0.2763f, -0.0650f, 0.6600f}));
}

}  // namespace
}  // namespace mirrorball
