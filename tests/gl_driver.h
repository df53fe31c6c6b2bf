#pragma once

#include <cstdlib>

#include <gtest/gtest.h>

/// Ends a test that finds no OpenGL driver, with the reason: it has failed, unless MIRRORBALL_WITHOUT_GL says that
/// there need be none, as `./test --without-gl` does. A machine that has lost its driver must not look like one whose
/// tests pass.
#define MIRRORBALL_END_WITHOUT_GL(reason)                                             \
  do {                                                                                \
    if (std::getenv("MIRRORBALL_WITHOUT_GL") != nullptr) GTEST_SKIP() << (reason);    \
    GTEST_FAIL() << (reason) << "; ./test --without-gl leaves out what needs OpenGL"; \
  } while (false)
