#include "mirrorball/render/surface/map_levels.h"

#include <cstddef>
#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/normal_levels.h"
#include "mirrorball/image/halve.h"
#include "mirrorball/render/surface/map_sources.h"

namespace mirrorball {
namespace {

/// Of each texture: whether nothing but normals is read of it.
std::vector<bool> holdNormals(const Scene& scene) {
  std::vector<bool> normals(scene.textures.size(), false);
  for (const bool is_of_normals : {true, false})
    for (const Material& material : scene.materials)
      for (const MaterialMap& map : materialMaps())
        if (const int texture = (material.*map.slot).texture; texture >= 0 && isNormalMap(map) == is_of_normals)
          normals[static_cast<std::size_t>(texture)] = is_of_normals;
  return normals;
}

/// The mip levels of colours and numbers after the first.
std::vector<Image8> halvedLevels(const Texture& texture) {
  std::vector<Image8> levels;
  const Image8& first = texture.image;
  const Image8* last = &first;
  while (last->width() > 1 || last->height() > 1) {
    Image8 next = halved(*last, texture.srgb);
    last = &levels.emplace_back(std::move(next));
  }
  return levels;
}

}  // namespace

std::vector<MapContent> contentsOfMaps(const Scene& scene) {
  const std::vector<bool> normals = holdNormals(scene);
  std::vector<MapContent> contents;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Image8& picture = scene.textures[i].image;
    contents.push_back({&picture, scene.textures[i].srgb, normals[i]});
  }
  return contents;
}

Result<LevelsOfMaps> makeMapLevels(const Scene& scene, const std::vector<MapContent>& contents,
                                   const std::vector<bool>& needed, const LevelsOfMaps& known,
                                   const ProgressFunction& progress) {
  LevelsOfMaps levels;
  std::map<MapContent, std::size_t> missing;  // of which texture
  for (std::size_t i = 0; i < contents.size(); ++i) {
    if (!needed[i]) continue;
    if (const auto found = known.find(contents[i]); found != known.end())
      levels.insert(*found);
    else
      missing.emplace(contents[i], i);
  }
  const std::vector<std::pair<MapContent, std::size_t>> work(missing.begin(), missing.end());
  std::vector<std::shared_ptr<const MapLevels>> made(work.size());
  ProgressCounter counter(progress, work.size());
  parallelFor(work.size(), 1, [&](std::size_t index, std::size_t) {
    if (counter.stopped()) return;
    const Texture& texture = scene.textures[work[index].second];
    const bool holds_normals = work[index].first.holds_normals;
    made[index] = std::make_shared<const MapLevels>(
        MapLevels{texture.image, holds_normals ? normalLevels(texture.image) : halvedLevels(texture), holds_normals});
    counter.advance();
  });
  MIRRORBALL_TRY_VOID(counter.result());
  for (std::size_t i = 0; i < work.size(); ++i) levels.emplace(work[i].first, std::move(made[i]));
  return levels;
}

Result<LevelsOfMaps> makeMapLevels(const Scene& scene, const ProgressFunction& progress) {
  std::vector<bool> needed(scene.textures.size(), false);
  for (const Material& material : scene.materials)
    for (const MaterialMap& map : materialMaps())
      if (const int texture = (material.*map.slot).texture; texture >= 0) needed[std::size_t(texture)] = true;
  return makeMapLevels(scene, contentsOfMaps(scene), needed, {}, progress);
}

}  // namespace mirrorball
