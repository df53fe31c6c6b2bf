#pragma once

#include <cstdint>
#include <string_view>

namespace mirrorball {

/// Memory that a JSON text takes when it is parsed as an nlohmann::json [bytes]: several times the text's own, since
/// each `{}` becomes an object with a map.
struct JsonMemory {
  std::uint64_t tree = 0;     ///< of the parsed values
  std::uint64_t parsing = 0;  ///< in addition while the parser runs, until it has refused a text: its copies of the
                              ///< longest string, and its stack of the objects and arrays that are open
};

/// The memory for a text, from above, by counting its brackets, commas, colons and the lengths of its strings. A text
/// that is not valid JSON takes no more than that either before the parser refuses it.
///
/// cost     one pass over the text
JsonMemory jsonMemory(std::string_view text);

}  // namespace mirrorball
