#include "mirrorball/base/json_memory.h"

#include <algorithm>
#include <cstddef>

namespace mirrorball {
namespace {

// Bytes of nlohmann::json 3.11 with the 64-bit allocator of glibc, which adds 8 bytes and rounds up to 16.
constexpr std::uint64_t kValue = 48;     // 16 in a vector that may be half empty, and in the list that destroys it
constexpr std::uint64_t kMember = 96;    // a tree's node: its header, a key of 32 and a value of 16
constexpr std::uint64_t kObject = 64;    // a map
constexpr std::uint64_t kArray = 64;     // a vector and its first elements
constexpr std::uint64_t kString = 48;    // of a value
constexpr std::uint64_t kInString = 15;  // letters of a std::string that take no memory of their own
constexpr std::uint64_t kOutside = 32;   // of longer ones in addition to the letters
// What the parser has beside the tree. Of a string that it refuses, six copies at a time: the token's letters, the
// decoded ones, the token once more for the handler and once for the message, that message, and the exception's text;
// and up to two in the gaps that shorter copies have left in the heap as these grew. Of an object or array that is
// open, a pointer in a vector that grows.
constexpr std::uint64_t kParserCopies = 8;
constexpr std::uint64_t kParent = 24;

/// Where a string ends that begins at `begin`, behind its quotation mark: the place of the other one.
std::size_t endOfString(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while ((end = text.find_first_of("\"\\", end)) < text.size() && text[end] == '\\') end += 2;
  return std::min(end, text.size());
}

}  // namespace

JsonMemory jsonMemory(std::string_view text) {
  JsonMemory memory{.tree = kValue, .parsing = 0};
  std::uint64_t longest = 0;  // of the strings
  std::uint64_t depth = 0, deepest = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    if (letter == '"') {
      const std::size_t end = endOfString(text, at + 1);
      const std::uint64_t length = end - at - 1;
      memory.tree += kString + (length > kInString ? length + kOutside : 0);
      longest = std::max(longest, length);
      at = end;
    } else if (letter == ',') {
      memory.tree += kValue;
    } else if (letter == ':') {
      memory.tree += kMember - kString;  // its key was counted as a value
    } else if (letter == '{' || letter == '[') {
      memory.tree += letter == '{' ? kObject : kArray;
      deepest = std::max(deepest, ++depth);
    } else if ((letter == '}' || letter == ']') && depth > 0) {
      --depth;
    }
  }
  memory.parsing = kParserCopies * longest + kParent * deepest;
  return memory;
}

}  // namespace mirrorball
