#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mirrorball::gltf {

/// A text of JSON with null in place of the words NaN, Infinity and -Infinity outside of its strings: Python's json
/// module writes these (its documentation, "Standard Compliance and Interoperability"), and JSON has none of them.
///
/// returns  nothing: there is no such word
std::optional<std::string> withoutNan(std::string_view json);

}  // namespace mirrorball::gltf
