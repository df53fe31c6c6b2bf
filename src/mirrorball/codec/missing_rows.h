#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

// Rows of a picture that its file does not hold, because it ends early or is damaged. What is there is read, what is
// missing is black, and one remark says how much that is.

/// "the 12 rows that are missing are black": the end of a remark.
///
/// one   what the file stores one behind the other: "row", "column", "tile"
inline std::string missingRowsText(std::size_t count, const std::string& one = "row") {
  return count == 1 ? "the " + one + " that is missing is black"
                    : "the " + std::to_string(count) + " " + one + "s that are missing are black";
}

/// The remark on a file that ends before its last row.
inline std::string earlyEndText(std::size_t count, const std::string& one = "row") {
  return "ends before its last " + one + ": " + missingRowsText(count, one);
}

/// The remark on a file that lacks the rows for which a flag is not 0, in the order in which it stores them; nothing
/// where it has all.
inline std::string missingRowsRemark(std::span<const std::uint8_t> is_missing) {
  const auto isSet = [](std::uint8_t flag) { return flag != 0; };
  const auto first = std::find_if(is_missing.begin(), is_missing.end(), isSet);
  if (first == is_missing.end()) return {};
  const auto count = static_cast<std::size_t>(std::count_if(first, is_missing.end(), isSet));
  const bool are_last = std::all_of(first, is_missing.end(), isSet);
  return are_last ? earlyEndText(count) : "was not written to its end: " + missingRowsText(count);
}

/// The error for a file that ends before its first row does.
///
/// size   of the file, in bytes
inline tl::unexpected<Error> endsInFirstRow(std::uint64_t size) {
  return fail(ErrorCode::bad_file, "ends at byte " + std::to_string(size) +
                                       ", before the end of its first row; the file is truncated or damaged");
}

/// Whether that many bytes may be all that is left of a picture. With fewer than one of 1024 the size that the file
/// states is more likely a lie, which would only cost memory.
///
/// whole   how many bytes the picture has
constexpr bool mayBeLeftOf(std::uint64_t whole, std::uint64_t bytes) { return whole / 1024 <= bytes; }

/// Makes a row black, and opaque.
template <typename Sample>
void blackenRow(ImageOf<Sample>& picture, int y) {
  const auto row = picture.row(y);
  std::fill(row.begin(), row.end(), Sample{0});
  constexpr Sample kOpaque = std::is_floating_point_v<Sample> ? Sample{1} : std::numeric_limits<Sample>::max();
  if (picture.channels() == 4)
    for (std::size_t i = 3; i < row.size(); i += 4) row[i] = kOpaque;
}

/// Blackens the rows for which a flag is not 0.
///
/// is_missing   for each row, or empty: none is missing
template <typename Sample>
void blackenRows(ImageOf<Sample>& picture, std::span<const std::uint8_t> is_missing) {
  for (std::size_t y = 0; y < is_missing.size(); ++y)
    if (is_missing[y] != 0) blackenRow(picture, static_cast<int>(y));
}

/// Blackens the rows that a file ends before.
///
/// there      how many rows the file holds
/// from_top   whether these are the upper ones; else the lower ones
/// oddities   receives the remark on rows that are missing
template <typename Sample>
void blackenMissingRows(ImageOf<Sample>& picture, int there, bool from_top, std::vector<std::string>& oddities) {
  const int begin = from_top ? there : 0;
  const int end = from_top ? picture.height() : picture.height() - there;
  for (int y = begin; y < end; ++y) blackenRow(picture, y);
  if (begin < end) oddities.push_back(earlyEndText(static_cast<std::size_t>(end - begin)));
}

}  // namespace mirrorball
