#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Runs one of the codecs, the only places that take memory for as many texels as a file says.
///
/// errors   too_large where the memory is not there; else what `work` returns
template <typename Value, typename Work>
Result<Value> withinMemory(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "not enough memory for so many texels");
  }
}

/// Memory that holds nothing at first, so that a size that lies costs none: only what is written is touched. libc++ 14,
/// which compilers for browsers have, lacks std::make_unique_for_overwrite.
inline std::unique_ptr<std::uint8_t[]> bytesWithoutValues(std::size_t size) {
  return std::unique_ptr<std::uint8_t[]>(new std::uint8_t[size]);
}

}  // namespace mirrorball
