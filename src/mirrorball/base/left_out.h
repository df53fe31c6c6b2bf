#pragma once

#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The failure of what a build was made without: "this build reads no TIFF; one with MIRRORBALL_TIFF=ON does".
///
/// lacks    "reads no TIFF"
/// option   of CMake, which brings it (cmake/MirrorballParts.cmake)
inline tl::unexpected<Error> leftOut(std::string_view lacks, std::string_view option) {
  return fail(ErrorCode::unsupported,
              "this build " + std::string(lacks) + "; one with " + std::string(option) + "=ON does");
}

}  // namespace mirrorball
