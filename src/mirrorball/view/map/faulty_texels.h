#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// Why the value of a texel is no light.
enum class TexelFault {
  none,
  not_finite,  ///< NaN or infinite
  negative,
  too_bright,  ///< above 1e36: sums over the whole sphere would not be finite
};

/// "no", "NaN or infinite", "negative", "too bright"
std::string_view nameOf(TexelFault fault);

/// The first of these that a channel has.
TexelFault faultOf(glm::vec3 radiance);

/// The texels of a map that are no light.
struct FaultyTexels {
  std::size_t not_finite = 0;
  std::size_t negative = 0;
  std::size_t too_bright = 0;
  /// Where some of them are: the first of each part of the sphere in the order of the map, at most 64² in all, so that
  /// no place with such texels is missing however many they are.
  std::vector<glm::vec3> directions = {};

  std::size_t count() const { return not_finite + negative + too_bright; }
};

/// Finds them; what lies beside a disc is none.
///
/// cost     a pass over the texels; bit-identical for any number of threads
FaultyTexels faultyTexels(const EnvironmentMap& map);

/// Makes light of them: what is not finite becomes the mean of its neighbours, and 0 in an image without any that is;
/// what is negative 0, and what is too bright as bright as can be summed.
void mendFaults(EnvironmentMap& map);

}  // namespace mirrorball
