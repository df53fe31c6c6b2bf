#pragma once

#include <string>

#include "formula/lamp.h"

namespace mirrorball {

/// A light that a model's file has: a point, a spot or a direction, in photometric units. Radiance 1 is 1 cd/m², as in
/// what glTF's materials emit, so that 1 lx makes a white diffuse surface 1/π bright.
struct ModelLight : formula::Lamp {
  /// Of a channel of `color`: beyond it the light on a surface close by is more than floats can add up.
  static constexpr float kBrightest = 1e12f;

  std::string name;
};

}  // namespace mirrorball
