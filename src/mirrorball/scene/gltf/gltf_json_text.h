#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mirrorball::gltf {

/// A text that is JSON now, and what was done to it.
struct MendedJson {
  std::string text;
  std::string how;  ///< a sentence: "comments are passed over"
};

/// Mends a text that would be JSON but for what programs write who make it without a library for it:
///
/// - NaN and Infinity of Python's json module (its documentation, "Standard Compliance and Interoperability"), `nan`
///   and `inf` of C's printf, `1.#INF` and `-nan(ind)` of Microsoft's, numbers beyond all doubles, and nothing at all
///   between two commas, as Maya2glTF writes, become null; a comma behind the last of a list goes;
/// - `+1`, `.5`, `5.` and `01` become 1, 0.5, 5 and 1;
/// - comments of C and C++ go, and so does what follows the outermost closing bracket;
/// - in strings a byte that is not of UTF-8 is the letter of Latin-1, control characters are escaped, and a '\' is one
///   where some '\' of that string begin no escape, as in a path of Windows.
///
/// returns  nothing: there is none of these
/// cost     one pass, and at most mostMended() bytes
std::optional<MendedJson> mendJson(std::string_view json);

/// The most bytes that a text of so many takes when it is mended.
constexpr std::uint64_t mostMended(std::size_t bytes) { return std::uint64_t{6} * bytes; }

}  // namespace mirrorball::gltf
