#include "mirrorball/output/baked/light_hash.h"

#include <cstdint>
#include <utility>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

/// Another one when other things are hashed.
constexpr std::uint64_t kLightHashVersion = 1;

void addTexels(const EnvironmentMap& map, ContentHash& hash) {
  hash.add(map.projection());
  for (int face = 0; face < map.faces(); ++face) {
    const Image& image = map.face(face);
    hash.add(image.width());
    hash.add(image.height());
    hash.add(image.channels());
    hash.addAll(image.samples());
  }
}

}  // namespace

Result<std::string> lightHash(const Environment& environment, const BakedSetSettings& settings) {
  ContentHash hash(kLightHashVersion);
  if (const EnvironmentMap* const map = environment.map()) {
    addTexels(*map, hash);
  } else {
    MIRRORBALL_TRY(values, convert(environment, Projection::equirect, environment.naturalSize(Projection::equirect)));
    addTexels(values, hash);
  }
  hash.add(sourceFromRotated(settings.rotate_deg));
  hash.add(settings.split);
  if (settings.split) {
    hash.add(settings.lamps.min_share);
    hash.add(settings.lamps.max_size_deg);
  }
  return hash.digits();
}

}  // namespace mirrorball
