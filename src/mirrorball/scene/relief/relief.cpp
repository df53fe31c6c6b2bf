#include "mirrorball/scene/relief/relief.h"

#include <map>
#include <utility>

namespace mirrorball {
namespace {

constexpr int kBuiltinSide = 512;

/// Whether a kind looks heights up in a texture: bumps of the orange are a function of the place.
bool readsTexture(const Material& material, ReliefKind kind) {
  if (material.height == HeightKind::none || kind == ReliefKind::none) return false;
  return material.height != HeightKind::orange || kind != ReliefKind::bump;
}

}  // namespace

Result<void> prepareRelief(Scene& scene, ReliefKind kind) {
  std::map<HeightKind, int> made;
  for (Material& material : scene.materials) {
    if (!readsTexture(material, kind) || material.height_texture >= 0) continue;
    auto found = made.find(material.height);
    if (found == made.end()) {
      MIRRORBALL_TRY(texture, heightTexture(builtinHeights(material.height, kBuiltinSide), MapEdges::tiled));
      scene.height_textures.push_back(std::move(texture));
      found = made.emplace(material.height, static_cast<int>(scene.height_textures.size()) - 1).first;
    }
    material.height_texture = found->second;
  }
  if (kind == ReliefKind::cone)
    for (HeightTexture& texture : scene.height_textures) MIRRORBALL_TRY_VOID(makeCones(texture));
  return {};
}

}  // namespace mirrorball
