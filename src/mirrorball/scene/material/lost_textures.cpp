#include "mirrorball/scene/material/lost_textures.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace mirrorball {

void leaveOutTextures(Scene& scene, const std::vector<bool>& is_lost) {
  if (std::find(is_lost.begin(), is_lost.end(), true) == is_lost.end()) return;
  std::vector<int> places;  // of each texture, among those that stay
  std::vector<Texture> kept;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    places.push_back(is_lost[i] ? -1 : static_cast<int>(kept.size()));
    if (!is_lost[i]) kept.push_back(std::move(scene.textures[i]));
  }
  scene.textures = std::move(kept);
  for (Material& material : scene.materials)
    for (const MaterialMap& map : materialMaps()) {
      TextureSlot& slot = material.*map.slot;
      if (slot.texture < 0) continue;
      slot.texture = places[std::size_t(slot.texture)];
      if (slot.texture < 0 && map.slot == &Material::emission_map) material.emission = glm::vec3(0.0f);
    }
}

}  // namespace mirrorball
