#include "mirrorball/gl/context.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/sharing_contexts.h"
#include "mirrorball/gl/texture.h"
#include "test_data.h"

namespace mirrorball::gl {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ContextTest : public ::testing::TestWithParam<Api> {};

TEST_P(ContextTest, GivesTheVersionAskedFor) {
  MIRRORBALL_NEEDS_GL(context, GetParam());
  EXPECT_EQ(context.api(), GetParam());
  EXPECT_FALSE(context.renderer().empty());
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, GetParam() == Api::desktop43 ? 43 : 30);
  EXPECT_EQ(context.version().starts_with("OpenGL ES"), GetParam() == Api::es30);
  EXPECT_GE(context.largestTexture(), 2048);
}

MIRRORBALL_WITH_BOTH_APIS(ContextTest);

TEST(Context, TwoLiveSideBySide) {
  MIRRORBALL_NEEDS_GL(desktop, Api::desktop43);
  {
    MIRRORBALL_NEEDS_GL(embedded, Api::es30);
    EXPECT_THAT(embedded.version(), StartsWith("OpenGL ES"));
    ASSERT_TRUE(desktop.makeCurrent());
    EXPECT_THAT(desktop.version(), Not(StartsWith("OpenGL ES")));
    ASSERT_TRUE(embedded.makeCurrent());
    EXPECT_THAT(embedded.version(), StartsWith("OpenGL ES"));
  }
  // The second one's end leaves the display that they share.
  ASSERT_TRUE(desktop.makeCurrent());
  EXPECT_FALSE(desktop.version().empty());
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_P(ContextTest, TheCurrentOneCanBeAdoptedAndStaysItsOwners) {
  MIRRORBALL_NEEDS_GL(owner, GetParam());
  GLuint owned = 0;
  glGenTextures(1, &owned);
  glBindTexture(GL_TEXTURE_2D, owned);
  {
    const Result<Context> adopted = Context::adoptCurrent();
    ASSERT_TRUE(adopted) << adopted.error().message;
    EXPECT_EQ(adopted->api(), GetParam());
    EXPECT_EQ(adopted->largestTexture(), owner.largestTexture());
  }
  EXPECT_TRUE(glIsTexture(owned)) << "the same context is still there and current";
}

TEST_P(ContextTest, OthersShareItsTexturesInThreadsOfTheirOwn) {
  MIRRORBALL_NEEDS_GL(context, GetParam());
  const Result<Texture> made = Texture::make2d(Format::rgba8, 1, 1);
  ASSERT_TRUE(made);
  std::atomic<int> sharing = 0;
  const auto work = [&]() -> Result<void> {
    sharing += glIsTexture(made->name()) == GL_TRUE ? 1 : 0;
    return {};
  };
  ASSERT_TRUE(inSharingContexts(context, 3, work));
  EXPECT_EQ(sharing, 3);
  EXPECT_TRUE(glIsTexture(made->name())) << "the calling thread still has its own";
}

TEST(Context, WhatFailsInAThreadThatSharesIsTold) {
  MIRRORBALL_NEEDS_GL(context, Api::desktop43);
  std::atomic<int> calls = 0;
  const auto failing = [&]() -> Result<void> {
    if (++calls == 2) return fail(ErrorCode::unsupported, "the second");
    return {};
  };
  const Result<void> result = inSharingContexts(context, 2, failing);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "the second");
}

TEST(Context, OneThatIsTakenOverIsNotShared) {
  MIRRORBALL_NEEDS_GL(owner, Api::desktop43);
  const Result<Context> adopted = Context::adoptCurrent();
  ASSERT_TRUE(adopted);
  EXPECT_FALSE(adopted->share());
  std::atomic<int> calls = 0;
  EXPECT_TRUE(inSharingContexts(*adopted, 3, [&]() -> Result<void> {
    ++calls;
    return {};
  }));
  EXPECT_EQ(calls, 1) << "the calling thread does all of it";
}

TEST(Context, WithoutACurrentOneThereIsNothingToAdopt) {
  { MIRRORBALL_NEEDS_GL(gone, Api::desktop43); }
  const Result<Context> adopted = Context::adoptCurrent();
  ASSERT_FALSE(adopted);
  EXPECT_THAT(adopted.error().message, HasSubstr("no OpenGL context is current"));
}

/// Sets an environment variable and reports what createHeadless says, in a process of its own: a
/// driver reads its variables once.
[[noreturn]] void reportWith(const char* variable, const char* value) {
  setenv(variable, value, 1);
  const Result<Context> context = Context::createHeadless();
  std::fputs(context ? context->version().c_str() : context.error().message.c_str(), stderr);
  std::_Exit(context ? 1 : 0);
}

TEST(ContextDeathTest, MissingDriversAreAnErrorThatSaysWhatToInstall) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(reportWith("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"), ::testing::ExitedWithCode(0),
              AllOf(HasSubstr("no driver for OpenGL 4.3 found"), HasSubstr("install libegl1")));
}

TEST(ContextDeathTest, AnOldDriverIsNamedWithItsVersion) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto any_status = [](int) { return true; };
  EXPECT_EXIT(
      reportWith("MESA_GL_VERSION_OVERRIDE", "3.1"), any_status,
      AnyOf(Not(HasSubstr("Mesa")), AllOf(HasSubstr("offers only version 3.1"), HasSubstr("OpenGL 4.3 is needed"))));
  MIRRORBALL_NEEDS_GL(context, Api::desktop43);
  if (context.version().find("Mesa") == std::string::npos) {
    GTEST_SKIP() << "only Mesa can pretend to be an older version";
  }
}

// Mesa's compilers would end the process.
TEST(ContextInLittleSpace, IsRefused) {
  if (mirrorball::testing::isSanitized())
    GTEST_SKIP() << "the address sanitizer has taken more addresses than the bound";
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &usual), 0);
  if (usual.rlim_cur != RLIM_INFINITY) GTEST_SKIP() << "the tests themselves are bounded";
  // The address sanitizer takes more than any bound; what is left of one that is smaller is nothing.
  const rlimit bounded{rlim_t{1} << 30, usual.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &bounded), 0);
  const auto refused = Context::createHeadless(Api::desktop43);
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &usual), 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_NE(refused.error().message.find("ulimit -v"), std::string::npos);
}

}  // namespace
}  // namespace mirrorball::gl
