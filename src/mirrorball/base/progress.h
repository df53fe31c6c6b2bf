#pragma once

#include <cstddef>
#include <functional>

namespace mirrorball {

/// What long work calls as it goes on. Returns false when the work should stop (Ctrl-C).
///
/// done     how many steps are finished, from 0
/// total    how many there are
using ProgressFunction = std::function<bool(std::size_t done, std::size_t total)>;

}  // namespace mirrorball
