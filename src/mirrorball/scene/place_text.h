#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "mirrorball/base/option.h"

namespace mirrorball {

/// The same as parseNumbers(), in double precision: floats do not hold a place far from the origin.
///
/// errors   usage
Result<std::vector<double>> parseExactNumbers(const OptionText& text, std::string_view written);

/// "1,2.5,4000000.3": the shortest numbers that read back as the same place; of one that was a float, as that float.
std::string writtenPlace(glm::dvec3 place);

}  // namespace mirrorball
