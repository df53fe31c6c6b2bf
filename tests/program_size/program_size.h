#pragma once

#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball::testing {

/// How large a fragment shader is as compilers see it.
struct ProgramSize {
  int instructions = 0;  ///< inlined, and without what constants exclude
  int inlined = 0;       ///< once all calls are replaced by bodies, before anything is left out
  int samplings = 0;     ///< of `instructions`
  // Copies of the functions that add most: countCopies, of the calls that constants do not exclude.
  int arriving_light = 0;  ///< arrivingLight: a look-up of the environment
  int sight_from = 0;      ///< sightFrom: what a direction sees through the proxy
  int ray_walks = 0;       ///< nearestTriangleBeside

  bool operator==(const ProgramSize&) const = default;
};

/// The versions of the tools that count: "glslang 11:12.0.0, SPIRV-Tools v2023.1". Others count otherwise.
///
/// errors   not_found: one of them is not installed
Result<std::string> findSizeTools();

/// fragment   GLSL for desktop OpenGL
/// errors     unsupported: a tool does not take it; io
/// cost       up to a second
Result<ProgramSize> measureSize(const std::string& fragment);

}  // namespace mirrorball::testing
