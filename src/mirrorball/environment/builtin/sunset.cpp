#include "mirrorball/environment/builtin/sunset.h"

#include <utility>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/builtin/sunset_file.h"

namespace mirrorball {

bool hasSunset() { return true; }

Result<Environment> sunsetEnvironment() {
  MIRRORBALL_TRY(decoded, decodeImage(sunsetFile()));
  EnvironmentMap map(Projection::equirect, ImageSet(std::move(decoded.image)));
  raiseNegativeLight(map);  // of its compression
  return Environment(std::move(map));
}

}  // namespace mirrorball
