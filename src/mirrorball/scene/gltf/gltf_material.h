#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/material/texture_numbers.h"
#include "mirrorball/scene/picture_decoding.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::gltf {

/// Gives a scene the materials of a glTF file, each when it is first asked for, so that pictures which nothing uses are
/// neither read nor decoded.
class Materials {
 public:
  Materials(const File& file, Scene& scene) : file_(file), scene_(scene) {}

  /// The index in the scene of the glTF material; −1 means glTF's default material, which stands for one that is not
  /// there too.
  ///
  /// key      what refers to it, for messages
  /// errors   too_large
  Result<int> sceneMaterial(int material, const std::string& key);

  /// The index in the scene of a glTF material that was asked for; −1: it was not.
  int placeInScene(int material) const {
    const auto found = materials_.find(material);
    return found == materials_.end() ? -1 : found->second;
  }

  /// Reads and decodes the pictures of all materials asked for, and gives them to the scene's textures. Materials go
  /// without those that are missing or cannot be read, of which the file's remarks tell.
  ///
  /// errors   too_large; interrupted
  Result<void> decodeTextures();

 private:
  /// A scene's texture that is still to be decoded.
  struct Planned {
    int image;  // of the file
    bool srgb;
    TextureUse use;  // the first one
    /// FileMaterial::glossiness, for a texture that is to hold roughness instead.
    std::optional<float> glossiness;

    ReadAs as() const { return srgb ? ReadAs::light : ReadAs::numbers; }
  };

  void bindTexture(TextureSlot& slot, const MaterialMap& map, std::optional<float> glossiness, const std::string& key);
  int sceneTexture(int texture, const MaterialMap& map, std::optional<float> glossiness, const std::string& key);
  /// The first image that shows the same picture, as far as that is asked for.
  int sameImage(int image);
  int firstOfSameSource(int image);
  Result<std::span<const std::uint8_t>> encoded(int image);
  /// An image of the file, and what its samples are read as.
  struct PictureKey {
    int image;
    ReadAs as;

    bool operator<(const PictureKey& other) const { return std::tie(image, as) < std::tie(other.image, other.as); }
  };
  using Pictures = std::map<PictureKey, Result<SharedPicture>>;
  Result<Pictures> decodedImages();
  std::set<int> decodeInto(Pictures& pictures, std::span<const PictureKey> wanted, const ProgressFunction& progress);
  Result<void> setPicture(std::size_t index, const SharedPicture& picture);

  const File& file_;
  Scene& scene_;
  /// What a texture of the scene is made from: image, sRGB, whether it holds normals, glossiness, how it goes on beyond
  /// its edges, nearest.
  using TextureSource = std::tuple<int, bool, bool, std::optional<float>, Wrap, Wrap, bool>;
  std::map<int, int> materials_;           // glTF index → scene index
  std::map<TextureSource, int> textures_;  // → scene index
  std::set<int> without_picture_;          // glTF textures that are left out
  std::vector<Planned> planned_;           // by scene index
  std::map<std::string, int> images_;      // file, data or view → the first image of it
  std::map<int, int> same_image_;          // of each image that was asked for, sameImage
  std::map<int, Bytes> storage_;           // of the images that lie in the JSON
};

}  // namespace mirrorball::gltf
