#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Parses a whole text as one number, independent of the locale. Infinity and NaN are refused.
std::optional<double> parseNumber(std::string_view text);

/// Splits at every `separator`; "a,,b" has three parts, "" has one.
std::vector<std::string> split(std::string_view text, char separator);

/// A text without white space at its ends.
std::string_view trimmed(std::string_view text);

/// Takes the first word off a text, with the white space around it; empty where there is none.
std::string_view takeWord(std::string_view& text);

/// Small letters, of ASCII.
std::string lowerCase(std::string_view text);

/// With which some programs begin UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// A text without the byte-order mark that it may begin with.
constexpr std::string_view withoutByteOrderMark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

/// "a, b, c"; with " or " before the last, "a, b or c".
std::string join(std::span<const std::string_view> words, std::string_view separator = ", ",
                 std::optional<std::string_view> before_last = {});
std::string join(std::span<const std::string> words, std::string_view separator = ", ",
                 std::optional<std::string_view> before_last = {});

/// How many columns UTF-8 text takes on a terminal: its code points, but for those that only mark the letter before
/// them.
std::size_t columnsOf(std::string_view text);

/// "1 texel", "3 texels", "2 meshes"
std::string counted(std::uint64_t count, std::string_view noun);
/// "1 texel is", "3 texels are"
std::string countedAre(std::uint64_t count, std::string_view noun);
/// "there is 1 texel", "there are 3 texels"
std::string thereAre(std::uint64_t count, std::string_view noun);

/// The shortest text that reads back as the same float: "0.3", "1000000", "1e-07".
std::string formatNumber(double number);

/// A foreign text as it may stand in a line on a terminal: with '?' for each character that does something there
/// instead of being shown (control characters, of C1 too, and those that turn the direction of writing), and for each
/// byte that is no UTF-8.
std::string printable(std::string_view text);

/// The same for messages, shortened: "aaa… (4920 bytes more)".
///
/// longest  how many code points remain
std::string excerpt(std::string_view text, std::size_t longest = 80);

/// Whether a file's name is an address of the network, such as https://…
bool isUrl(std::string_view name);

/// The error for one: whatever else it would be, it is not fetched.
Error downloadsNothing(std::string_view url);

/// Another way to write a name.
struct Alias {
  std::string_view written;
  std::string_view name;
};

/// The place of a name in a list: in small or capital letters, with '_' or '-', or as one of the aliases, which go to
/// names of the list.
std::optional<std::size_t> indexOfName(std::string_view written, std::span<const std::string_view> names,
                                       std::span<const Alias> aliases = {});

/// The word that `text` may be a slip of the finger for: about a third of its letters may be wrong, missing, too many
/// or swapped with their neighbours. Else the one of which it is a part, as "roughness" is of "perceptual_roughness",
/// or a fifth of its letters away from one.
std::optional<std::string_view> nearestWord(std::string_view text, std::span<const std::string_view> words);

/// The error for a name that is not in a list: names the thing, suggests the nearest of them and of their aliases, and
/// lists the right ones.
///
/// what     what the name should name, as in "material"
Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right,
                  std::span<const Alias> aliases = {});

/// The same where it is known otherwise which of them is meant, if any is.
Error unknownName(std::string_view what, std::string_view given, std::span<const std::string_view> right,
                  std::optional<std::string_view> meant);

}  // namespace mirrorball
