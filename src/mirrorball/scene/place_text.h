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

/// "1,2.5,4000000.3": the shortest numbers that read back as the same place.
std::string writtenPlace(glm::dvec3 place);

/// A place in a scene in the coordinates of its file, as options name it. Near their origin it is by its shortest text:
/// 0.1 rather than 0.10000000149.
///
/// origin   Scene::origin
glm::dvec3 placeInFile(glm::vec3 place, glm::dvec3 origin);

}  // namespace mirrorball
