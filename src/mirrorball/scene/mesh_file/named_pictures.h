#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "mirrorball/scene/material/texture_numbers.h"
#include "mirrorball/scene/mesh_file/mtl.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// The pictures that the materials of a .mtl name, as textures of a scene. Pictures that materials use alike are one
/// texture. What cannot be read becomes a warning, and the material goes without it.
class NamedPictures {
 public:
  /// named, scene   must outlive this
  NamedPictures(NamedFiles& named, Scene& scene) : named_(named), scene_(scene) {}

  /// A picture of base colours or of light.
  TextureSlot colors(const MtlMap& map, TextureUse use);

  /// Base colours with a picture of opacities in their alpha, in the larger of their sizes; either may be absent, not
  /// both. The colours say where both are.
  TextureSlot colorsWithOpacity(const MtlMap& colors, const MtlMap& opacity);

  /// Numbers from 0 to 1, one a texel.
  TextureSlot factors(const MtlMap& map);

  TextureSlot normals(const MtlMap& map);

  /// Heights, shown by the normals that they have where 1 is 0.01 texture widths above 0, times MtlMap::strength: the
  /// format names no length. A picture that looks like normals is read as such, whatever its statement says; of another
  /// one with colours the luma counts.
  TextureSlot heights(const MtlMap& map);

  /// Reads them all into Scene::textures, and takes those out that cannot be read (material/lost_textures.h). To be
  /// called once, when the scene has all materials that use them.
  void decode();

 private:
  enum class Reading { colors, light, factors, normals, heights };
  struct Pending {
    Reading reading;
    const MtlMap* map;
    const MtlMap* opacity;                        ///< nullptr: none
    std::span<const std::uint8_t> bytes;          ///< empty: only its opacities are a picture
    std::span<const std::uint8_t> opacity_bytes;  ///< empty: none
  };

  TextureSlot add(const MtlMap& map, Reading reading, const MtlMap* opacity = nullptr);
  std::span<const std::uint8_t> read(const MtlMap& map);
  void warn(const MtlMap& map, const std::string& what);
  Result<void> fill(Pending pending, Result<Texels> texels, Result<Texels>* opacity, Texture& texture);
  Result<void> fillFromHeights(const MtlMap& map, Texture& texture);
  Result<void> addOpacity(const Pending& pending, Texels texels, Texture& texture);

  NamedFiles& named_;
  Scene& scene_;
  std::set<std::string> told_;                                              // each remark once, however many use it
  std::map<std::vector<std::string>, std::span<const std::uint8_t>> read_;  // by what names them
  using Key = std::tuple<const std::uint8_t*, const std::uint8_t*, Reading, bool, float, char>;
  std::map<Key, int> textures_;
  std::vector<Pending> pending_;
};

/// How a picture's alpha is shown: masked where nearly all of it is 0 or 1, as of leaves; else blended.
AlphaMode chooseAlphaMode(const SharedPicture& picture);

}  // namespace mirrorball
