#include "mirrorball/scene/relief/relief.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mirrorball/scene/relief/displaced_mesh.h"

namespace mirrorball {
namespace {

constexpr int kBuiltinSide = 512;

std::string textOf(const Image& heights) {
  return std::to_string(heights.width()) + " × " + std::to_string(heights.height());
}

/// Whether a kind looks heights up in a texture: bumps of the orange are a function of the place.
bool readsTexture(const Material& material, ReliefKind kind) {
  if (material.height == HeightKind::none || kind == ReliefKind::none) return false;
  if (material.height == HeightKind::map) return material.height_texture >= 0;
  return material.height != HeightKind::orange || kind != ReliefKind::bump;
}

/// The textures that materials share.
class SharedHeights {
 public:
  explicit SharedHeights(std::vector<Shared<HeightTexture>>& textures) : textures_(textures) {}

  /// The texture of a material, an index.
  int of(const Material& material) {
    const bool is_inverted = material.height_scale < 0.0f;
    if (material.height_texture >= 0 && !is_inverted) return material.height_texture;
    const auto key = std::tuple(material.height, material.height_texture, is_inverted);
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    const bool is_builtin = material.height_texture < 0;
    const MapEdges edges = is_builtin ? MapEdges::tiled : textures_[std::size_t(material.height_texture)]->edges;
    Image heights = is_builtin ? builtinHeights(material.height, kBuiltinSide)
                               : textures_[std::size_t(material.height_texture)]->heights;
    textures_.push_back(
        HeightTexture{.heights = is_inverted ? turnedOver(std::move(heights)) : std::move(heights), .edges = edges});
    return made_[key] = static_cast<int>(textures_.size()) - 1;
  }

 private:
  std::vector<Shared<HeightTexture>>& textures_;
  std::map<std::tuple<HeightKind, int, bool>, int> made_;
};

/// Built-in heights lie over texture coordinates, but for the orange's bumps.
void warnOfMeshesWithoutCoordinates(Scene& scene, ReliefKind kind) {
  for (const Mesh& mesh : scene.meshes) {
    const Material& material = scene.materials[std::size_t(mesh.material)];
    const bool is_builtin = material.height != HeightKind::map && readsTexture(material, kind);
    if (!is_builtin || hasTextureCoordinates(mesh)) continue;
    scene.warnings.push_back("height: a mesh has no texture coordinates; all of it has one height");
    return;
  }
}

/// Leaves out textures that no material has: heights that were turned over, as they were before.
void keepUsedTextures(Scene& scene) {
  std::vector<Shared<HeightTexture>> used;
  std::map<int, int> places;  // before → now
  for (Material& material : scene.materials) {
    if (material.height_texture < 0) continue;
    const auto [found, is_new] = places.try_emplace(material.height_texture, static_cast<int>(used.size()));
    if (is_new) used.push_back(scene.height_textures[std::size_t(material.height_texture)]);
    material.height_texture = found->second;
  }
  scene.height_textures = std::move(used);
}

/// errors   too_large: the driver does not take the picture that searches read
Result<void> checkPicture(const HeightTexture& texture, const std::function<int()>& largest_texture) {
  constexpr int kTakenByAll = 2048;  // OpenGL ES 3.0's least GL_MAX_TEXTURE_SIZE; OpenGL 4.3's is 16384
  const glm::ivec2 size = sizeOfPicture(texture);
  const int longer = std::max(size.x, size.y);
  if (longer <= kTakenByAll || !largest_texture) return {};
  const int largest = largest_texture();
  if (longer <= largest) return {};
  return fail(ErrorCode::too_large, "heights of " + textOf(texture.heights) +
                                        " texels are too many for rays to be searched for in them: " +
                                        "with their maxima they need a texture of " + std::to_string(longer) +
                                        " texels a side, and the graphics driver takes " + std::to_string(largest) +
                                        "; show them as bumps or as geometry, trace them, or use a map of at most " +
                                        std::to_string(largest / 3 * 2) + " texels a side");
}

/// What searches of that kind read.
Result<void> prepareSearches(HeightTexture& texture, ReliefKind kind) {
  MIRRORBALL_TRY_VOID(withName("heights", makeSearchable(texture)));
  if (kind == ReliefKind::cone) MIRRORBALL_TRY_VOID(withName("heights", makeCones(texture)));
  return withName("heights", makeHorizons(texture));
}

}  // namespace

Result<void> prepareRelief(Scene& scene, ReliefKind kind, const std::function<int()>& largest_texture) {
  warnOfMeshesWithoutCoordinates(scene, kind);
  SharedHeights textures(scene.height_textures);
  for (Material& material : scene.materials) {
    if (!readsTexture(material, kind)) continue;
    material.height_texture = textures.of(material);
    material.height_scale = std::abs(material.height_scale);
  }
  keepUsedTextures(scene);
  if (kind == ReliefKind::geometry) return displaceMeshes(scene);
  if (!movesSurface(kind)) return {};
  for (const HeightTexture& texture : scene.height_textures)
    MIRRORBALL_TRY_VOID(checkPicture(texture, largest_texture));
  for (Shared<HeightTexture>& texture : scene.height_textures)
    MIRRORBALL_TRY_VOID(prepareSearches(texture.edit(), kind));
  return {};
}

}  // namespace mirrorball
