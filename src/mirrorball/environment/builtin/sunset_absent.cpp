// A build without OpenEXR, as which the photograph is stored.
#include "mirrorball/base/left_out.h"
#include "mirrorball/environment/builtin/sunset.h"

namespace mirrorball {

bool hasSunset() { return false; }

Result<Environment> sunsetEnvironment() { return leftOut("has no sunset, which is an OpenEXR file", "MIRRORBALL_EXR"); }

}  // namespace mirrorball
