#include "mirrorball/scene/relief/relief.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "mirrorball/scene/relief/displaced_mesh.h"

namespace mirrorball {
namespace {

constexpr int kBuiltinSide = 512;

/// Whether a kind looks heights up in a texture: bumps of the orange are a function of the place.
bool readsTexture(const Material& material, ReliefKind kind) {
  if (material.height == HeightKind::none || kind == ReliefKind::none) return false;
  if (material.height == HeightKind::map) return material.height_texture >= 0;
  return material.height != HeightKind::orange || kind != ReliefKind::bump;
}

/// The textures that materials share.
class SharedHeights {
 public:
  explicit SharedHeights(std::vector<HeightTexture>& textures) : textures_(textures) {}

  /// The texture of a material, an index.
  ///
  /// errors   too_large
  Result<int> of(const Material& material) {
    const bool is_inverted = material.height_scale < 0.0f;
    if (material.height_texture >= 0 && !is_inverted) return material.height_texture;
    const auto key = std::tuple(material.height, material.height_texture, is_inverted);
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    const bool is_builtin = material.height_texture < 0;
    const MapEdges edges = is_builtin ? MapEdges::tiled : textures_[std::size_t(material.height_texture)].edges;
    Image heights = is_builtin ? builtinHeights(material.height, kBuiltinSide)
                               : textures_[std::size_t(material.height_texture)].heights;
    MIRRORBALL_TRY(texture, heightTexture(is_inverted ? turnedOver(std::move(heights)) : std::move(heights), edges));
    textures_.push_back(std::move(texture));
    return made_[key] = static_cast<int>(textures_.size()) - 1;
  }

 private:
  std::vector<HeightTexture>& textures_;
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

}  // namespace

Result<void> prepareRelief(Scene& scene, ReliefKind kind) {
  warnOfMeshesWithoutCoordinates(scene, kind);
  SharedHeights textures(scene.height_textures);
  for (Material& material : scene.materials) {
    if (!readsTexture(material, kind)) continue;
    MIRRORBALL_TRY(texture, textures.of(material));
    material.height_texture = texture;
    material.height_scale = std::abs(material.height_scale);
  }
  if (kind == ReliefKind::cone)
    for (HeightTexture& texture : scene.height_textures) MIRRORBALL_TRY_VOID(makeCones(texture));
  if (movesSurface(kind))
    for (HeightTexture& texture : scene.height_textures) MIRRORBALL_TRY_VOID(makeHorizons(texture));
  return kind == ReliefKind::geometry ? displaceMeshes(scene) : Result<void>();
}

}  // namespace mirrorball
