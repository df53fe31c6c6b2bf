#pragma once

#include <string>
#include <utility>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// Tells what failed in a line, which becomes empty where nothing has; but a driver that is gone ends all.
///
/// errors   no_gl
inline Result<void> tell(Result<void> result, std::string& line) {
  if (!result && result.error().code == ErrorCode::no_gl) return result;
  line = result ? std::string() : std::move(result).error().message;
  return {};
}

}  // namespace mirrorball
