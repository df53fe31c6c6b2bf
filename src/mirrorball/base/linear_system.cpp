#include "mirrorball/base/linear_system.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mirrorball {

std::vector<double> solved(std::vector<std::vector<double>> rows) {
  const std::size_t count = rows.size();
  for (std::size_t column = 0; column < count; ++column) {
    const auto pivot =
        std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(column), rows.end(),
                         [&](const auto& a, const auto& b) { return std::abs(a[column]) < std::abs(b[column]); });
    std::swap(*pivot, rows[column]);
    for (std::size_t row = 0; row < count; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= count; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::vector<double> solution;
  for (std::size_t row = 0; row < count; ++row) solution.push_back(rows[row][count] / rows[row][row]);
  return solution;
}

}  // namespace mirrorball
