#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball {

struct Scene;

/// One of a model's animations, and a moment of it.
struct AnimationChoice {
  std::string name = {};              ///< or its number, from 1; empty: none, and the model is at rest
  std::optional<float> seconds = {};  ///< at least 0; none: its start, or all of it where there are several pictures

  bool operator==(const AnimationChoice&) const = default;
};

/// The place in the scene's rig of the animation that is chosen.
///
/// errors   usage: there is none of that name or number; lists those there are
Result<std::size_t> chosenAnimation(const Scene& scene, const AnimationChoice& choice);

}  // namespace mirrorball
