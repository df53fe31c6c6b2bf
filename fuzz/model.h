#pragma once

#include "fuzz.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball::fuzz {

/// What every reader of models owes its caller: lines for what it refuses and for what it leaves out.
inline void checkModel(const Result<Scene>& scene) {
  checkError(scene);
  if (!scene) return;
  for (const std::string& warning : scene->warnings) checkLine(warning);
}

}  // namespace mirrorball::fuzz
