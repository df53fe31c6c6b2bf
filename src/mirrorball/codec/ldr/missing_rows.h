#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "mirrorball/image/image.h"

namespace mirrorball {

/// Rows of a picture that its file does not hold, because it ends early or is damaged.

/// "the 12 rows that are missing are black": the end of a remark.
inline std::string missingRowsText(std::size_t count) {
  return count == 1 ? "the row that is missing is black"
                    : "the " + std::to_string(count) + " rows that are missing are black";
}

/// Makes a row of codes black, and opaque.
template <typename Sample>
void blackenRow(ImageOf<Sample>& picture, int y) {
  const auto row = picture.row(y);
  std::fill(row.begin(), row.end(), Sample{0});
  if (picture.channels() == 4)
    for (std::size_t i = 3; i < row.size(); i += 4) row[i] = std::numeric_limits<Sample>::max();
}

}  // namespace mirrorball
