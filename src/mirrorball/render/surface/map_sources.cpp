#include "mirrorball/render/surface/map_sources.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

/// In the order of the rows.
std::vector<int> differentTextures(const Material& material) {
  std::vector<int> different;
  for (const MaterialMap& map : materialMaps())
    if (const int texture = (material.*map.slot).texture; texture >= 0 && !contains(different, texture))
      different.push_back(texture);
  return different;
}

}  // namespace

std::vector<MapSource> mapSources(const Material& material, std::span<const Texture> textures, int units) {
  assert(units >= 1);
  std::vector<int> different = differentTextures(material);
  std::size_t alone = different.size();
  if (const auto has = static_cast<std::size_t>(units); different.size() > has) {
    // All layers of an array are as large as its largest.
    const auto texels = [&](int texture) { return textures[std::size_t(texture)].image.texelCount(); };
    sortDownBy(different, texels);
    alone = has - 1;
  }
  std::vector<MapSource> sources;
  for (const MaterialMap& map : materialMaps()) {
    MapSource& source = sources.emplace_back();
    const auto found = std::find(different.begin(), different.end(), (material.*map.slot).texture);
    if (found == different.end()) continue;
    const auto place = static_cast<std::size_t>(found - different.begin());
    source.unit = static_cast<int>(std::min(place, alone));
    if (place < alone) continue;
    source.layer = static_cast<int>(place - alone);
    const Texture& texture = textures[std::size_t(*found)];
    source.srgb = texture.srgb;
    source.nearest = texture.nearest;
    source.wrap_s = texture.wrap_s;
    source.wrap_t = texture.wrap_t;
  }
  return sources;
}

std::string_view samplerName(std::span<const MapSource> sources, std::size_t row) {
  assert(sources[row].unit >= 0);
  if (sources[row].layer >= 0) return "map_layers";
  const auto first = findBy(sources, sources[row].unit, &MapSource::unit);
  return materialMaps()[static_cast<std::size_t>(first - sources.begin())].name;
}

}  // namespace mirrorball
