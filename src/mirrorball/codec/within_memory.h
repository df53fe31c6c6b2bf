#pragma once

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

}  // namespace mirrorball
