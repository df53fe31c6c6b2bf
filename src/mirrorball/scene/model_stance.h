#pragma once

#include <span>

#include "mirrorball/base/option.h"
#include "mirrorball/scene/animation/animation_choice.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How a model stands.
struct ModelStance {
  UpAxis up = UpAxis::y;           ///< its axis that points up
  AnimationChoice animation = {};  ///< the moment of its own animation

  bool operator==(const ModelStance&) const = default;
};

/// The table of its options; an animation is written as "NAME|N[@SECONDS]".
std::span<const Option<ModelStance>> stanceOptions();

}  // namespace mirrorball
