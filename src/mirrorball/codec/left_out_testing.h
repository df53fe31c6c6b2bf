#pragma once

#include <string>

#include <gtest/gtest.h>

#include "mirrorball/base/left_out.h"
#include "mirrorball/codec/image_format.h"

namespace mirrorball::testing {

/// errors   unsupported: the build lacks the format
inline Result<void> checkFormat(ImageFormatId id) {
  const ImageFormat& format = formatOf(id);
  if (isInThisBuild(format)) return {};
  return leftOut("reads no " + std::string(format.name), format.build_option);
}

}  // namespace mirrorball::testing

/// Skips a test that needs what this build has left out, and says what that is: `MIRRORBALL_NEEDS(checkZstandard());`
#define MIRRORBALL_NEEDS(check)                                                                          \
  do {                                                                                                   \
    if (const ::mirrorball::Result<void> there = (check); !there) GTEST_SKIP() << there.error().message; \
  } while (false)
