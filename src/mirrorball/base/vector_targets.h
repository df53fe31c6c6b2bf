#pragma once

// Which instructions Highway compiles for; included before it. ARM's vectors of unknown size can be no operands of +
// and no elements of arrays, so there NEON takes their place.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
