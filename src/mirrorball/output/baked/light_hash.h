#pragma once

#include <string>

#include "mirrorball/environment/environment.h"
#include "mirrorball/output/baked/baked_set.h"

namespace mirrorball {

/// What the light of a set is known by, whatever its input is called: a hash of all texels as they were loaded, scaled
/// and limited, of how they are turned, and of which lamps are taken out of them.
///
/// environment   a function is hashed by its values in the texels of a panorama that shows all its detail
/// returns       ContentHash's digits; the same light in another projection or resolution has others
/// errors        as convert's
/// cost          one pass over the texels, little beside reading them from a file; of a function as convert's
Result<std::string> lightHash(const Environment& environment, const BakedSetSettings& settings);

}  // namespace mirrorball
