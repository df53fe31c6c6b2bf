#include "mirrorball/render/surface/map_levels.h"

#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/normal_levels.h"
#include "mirrorball/image/halve.h"
#include "mirrorball/render/surface/map_sources.h"

namespace mirrorball {
namespace {

/// Of each texture: what stands for 0 in it, if nothing but normals is read of it.
std::vector<std::optional<float>> zerosOfNormals(const Scene& scene) {
  std::vector<std::optional<float>> zeros(scene.textures.size());
  for (const bool is_of_normals : {true, false})
    for (const Material& material : scene.materials)
      for (const MaterialMap& map : materialMaps()) {
        const int texture = (material.*map.slot).texture;
        if (texture < 0 || map.holdsNormals() != is_of_normals) continue;
        std::optional<float>& zero = zeros[static_cast<std::size_t>(texture)];
        if (!is_of_normals)
          zero.reset();
        else if (!zero)
          zero = material.*map.zero;
      }
  return zeros;
}

/// The mip levels after the first.
///
/// halve   (level) → the next one
template <typename Picture, typename Halve>
std::vector<Texels> levelsBelow(const Picture& first, const Halve& halve) {
  std::vector<Texels> levels;
  const Picture* last = &first;
  while (last->width() > 1 || last->height() > 1) {
    levels.emplace_back(halve(*last));
    last = &std::get<Picture>(levels.back());
  }
  return levels;
}

/// The mip levels of colours and numbers after the first.
std::vector<Texels> halvedLevels(const Texture& texture) {
  if (texture.image.hasNumbers())
    return levelsBelow(texture.image.numbers(), [](const Image& level) { return halved(level); });
  return levelsBelow(texture.image.codes(), [&texture](const Image8& level) { return halved(level, texture.srgb); });
}

std::vector<Texels> levelsOfNormals(const SharedPicture& picture, float zero) {
  const auto asTexels = [](auto levels) {
    return std::vector<Texels>(std::move_iterator(levels.begin()), std::move_iterator(levels.end()));
  };
  if (picture.hasNumbers()) return asTexels(decodedNormalLevels(picture.numbers(), zero));
  return asTexels(normalLevels(picture.codes(), zero));
}

}  // namespace

std::vector<MapContent> contentsOfMaps(const Scene& scene) {
  const std::vector<std::optional<float>> zeros = zerosOfNormals(scene);
  std::vector<MapContent> contents;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const Texture& texture = scene.textures[i];
    contents.push_back({texture.image.identity(), texture.srgb, zeros[i].has_value(), zeros[i].value_or(0.0f)});
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
    const MapContent& content = work[index].first;
    made[index] = std::make_shared<const MapLevels>(MapLevels{
        texture.image, content.holds_normals ? levelsOfNormals(texture.image, content.zero) : halvedLevels(texture),
        content.holds_normals});
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
