#include "mirrorball/environment/builtin/sunset.h"

#include <utility>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/builtin/sunset_file.h"

namespace mirrorball {

Result<Environment> sunsetEnvironment() {
  MIRRORBALL_TRY(decoded, decodeImage(sunsetFile()));
  return Environment(EnvironmentMap(Projection::equirect, ImageSet(std::move(decoded.image))));
}

}  // namespace mirrorball
