#pragma once

#include <vector>

namespace mirrorball {

/// Solves a linear system by the elimination of Gauss and Jordan, with pivots by size.
///
/// rows     of n + 1 numbers, the last of which is the right side; not singular
/// returns  n numbers
/// cost     n³
std::vector<double> solved(std::vector<std::vector<double>> rows);

}  // namespace mirrorball
