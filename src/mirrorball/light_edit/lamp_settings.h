#pragma once

#include <span>

#include "mirrorball/base/option.h"

namespace mirrorball {

/// Which lamps of a map are wanted, and which of them are taken out of it.
struct LampSettings {
  int max = 8;                ///< how many, at least 1: the strongest
  float min_share = 0.01f;    ///< of all light, 0 … 1; less is no lamp
  float max_size_deg = 2.0f;  ///< angular size of those that are taken out or scaled; wider ones stay
};

/// The table of these settings: max, min-share, max-size.
std::span<const Option<LampSettings>> lampOptions();

}  // namespace mirrorball
