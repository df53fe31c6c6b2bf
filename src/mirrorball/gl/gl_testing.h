#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "gl_driver.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/gl/gl_api.h"

/// Declares a current context of an Api, or skips the test with the reason where there is no GL.
#define MIRRORBALL_NEEDS_GL(name, api)                                          \
  auto name##_result = ::mirrorball::gl::Context::createHeadless(api);          \
  if (!name##_result) MIRRORBALL_END_WITHOUT_GL(name##_result.error().message); \
  [[maybe_unused]] ::mirrorball::gl::Context& name = *name##_result

namespace mirrorball::gl {

/// For the names of tests.
inline std::string shortNameOf(Api api) { return api == Api::desktop43 ? "desktop43" : "es30"; }

/// How GoogleTest shows it.
inline void PrintTo(Api api, std::ostream* out) { *out << nameOf(api); }

/// Names the instances of a test that runs with both APIs.
inline std::string apiName(const ::testing::TestParamInfo<Api>& info) { return shortNameOf(info.param); }

/// A test that runs once with each Api, or skips itself with the reason where there is no GL, and
/// fails when it leaves an OpenGL error.
class GlTest : public ::testing::TestWithParam<Api> {
 protected:
  void SetUp() override {
    auto made = Context::createHeadless(GetParam());
    if (!made) MIRRORBALL_END_WITHOUT_GL(made.error().message);
    context_.emplace(std::move(*made));
  }
  void TearDown() override {
    if (context_) {
      EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
  }
  const Context& context() const { return *context_; }

 private:
  std::optional<Context> context_;
};

/// Runs a GlTest with both APIs: two suites, since each API compiles all programs of its own.
#define MIRRORBALL_WITH_BOTH_APIS(suite)                                                        \
  INSTANTIATE_TEST_SUITE_P(Desktop, suite, ::testing::Values(::mirrorball::gl::Api::desktop43), \
                           ::mirrorball::gl::apiName);                                          \
  INSTANTIATE_TEST_SUITE_P(Es, suite, ::testing::Values(::mirrorball::gl::Api::es30), ::mirrorball::gl::apiName)

}  // namespace mirrorball::gl
