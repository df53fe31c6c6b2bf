#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mirrorball::gltf {

/// A text that would be JSON but for numbers as programs write them who have none: NaN and Infinity of Python's json
/// module (its documentation, "Standard Compliance and Interoperability"), nan and inf of C's printf, and nothing at
/// all between two commas, as Maya2glTF's. Each becomes null; a comma behind the last of a list goes.
///
/// returns  nothing: there is none of these
std::optional<std::string> mendedJson(std::string_view json);

}  // namespace mirrorball::gltf
