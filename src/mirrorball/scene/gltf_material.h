#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf_file.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Turns the materials of a glTF file into those of a scene, each when it is first asked for, so that pictures which
/// nothing uses are never decoded.
class GltfMaterials {
 public:
  GltfMaterials(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  /// The index in the scene of the glTF material; −1 means glTF's default material.
  ///
  /// key      what refers to it, for messages
  /// errors   bad_file (an index or a transform is wrong)
  Result<int> sceneMaterial(int material, const std::string& key);

  /// Decodes the pictures of all materials asked for, and gives them to the scene's textures.
  ///
  /// errors   bad_file (missing or damaged); too_large
  Result<void> decodeTextures();

 private:
  Result<Material> convert(int index);
  template <typename TextureInfo>
  Result<TextureSlot> slot(const TextureInfo& info, bool srgb, const std::string& key);
  Result<void> applyTransform(const tinygltf::Value& transform, TextureSlot& slot, const std::string& key);
  Result<int> sceneTexture(int texture, bool srgb, const std::string& key);
  Result<std::span<const std::uint8_t>> encoded(int image) const;

  const GltfFile& file_;
  Scene& scene_;
  std::map<int, int> materials_;                      // glTF index → scene index
  std::map<std::pair<int, bool>, int> textures_;      // glTF index, sRGB → scene index
  std::vector<int> images_;                           // scene texture → glTF image
};

/// The extensions that GltfMaterials reads.
inline constexpr std::string_view kMaterialExtensions[] = {
    "KHR_texture_transform",    "KHR_materials_ior",        "KHR_materials_specular",
    "KHR_materials_transmission", "KHR_materials_dispersion", "KHR_materials_emissive_strength",
};

}  // namespace mirrorball
