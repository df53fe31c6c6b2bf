#pragma once

#include <compare>
#include <map>
#include <memory>
#include <vector>

#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// What tells the content of one texture of a scene from that of another: how it wraps is its sampler's.
struct MapContent {
  const void* picture = nullptr;  ///< SharedPicture::identity()
  bool srgb = false;
  bool holds_normals = false;  ///< and nothing else
  float zero = 0.0f;           ///< of normals: MaterialMap::zero of the first material that has them

  auto operator<=>(const MapContent&) const = default;
};

/// The mip levels of a texture.
struct MapLevels {
  SharedPicture picture;     ///< that they are made from, which stays as long as they do
  std::vector<Texels> made;  ///< the last of them: all but the texture's own image, or with spreads all
  bool has_spread = false;   ///< normalLevels(), or of numbers decodedNormalLevels()

  /// upload(level, image) for each of them, each an Image8 or an Image.
  template <typename Upload>
  void forEach(const Upload& upload) const {
    int level = 0;
    if (!has_spread && picture.hasNumbers()) upload(level++, picture.numbers());
    if (!has_spread && !picture.hasNumbers()) upload(level++, picture.codes());
    for (const Texels& texels : made) std::visit([&](const auto& image) { upload(level++, image); }, texels);
  }
};

using LevelsOfMaps = std::map<MapContent, std::shared_ptr<const MapLevels>>;

/// Of each of a scene's textures.
std::vector<MapContent> contentsOfMaps(const Scene& scene);

/// The mip levels of textures, made on all cores: a software driver would take a multiple of the time.
///
/// contents   contentsOfMaps() of the scene
/// needed     of each texture: whether its levels are to be among the result
/// known      levels that are there already; they are not made again
/// errors     interrupted
Result<LevelsOfMaps> makeMapLevels(const Scene& scene, const std::vector<MapContent>& contents,
                                   const std::vector<bool>& needed, const LevelsOfMaps& known,
                                   const ProgressFunction& progress = {});

/// The same of all textures that some material has: in any thread, before the scene is set (Stage::setScene).
///
/// progress   is called from several threads, but not at once
/// errors     interrupted
Result<LevelsOfMaps> makeMapLevels(const Scene& scene, const ProgressFunction& progress = {});

}  // namespace mirrorball
