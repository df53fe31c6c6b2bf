#include "mirrorball/base/result.h"

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

TEST(Result, ANameStandsInFrontOfAFailure) {
  const Result<int> failed = fail(ErrorCode::bad_file, "is truncated at byte 9");
  const Result<int> of_part = withName("images[3]", failed);
  const Result<int> of_file = withName("room.glb", of_part);
  EXPECT_EQ(of_file.error().message, "room.glb: images[3]: is truncated at byte 9");
  EXPECT_EQ(of_file.error().code, ErrorCode::bad_file);
}

TEST(Result, AValueHasNoName) {
  EXPECT_EQ(withName("room.exr", Result<int>(7)), 7);
  EXPECT_TRUE(withName("room.exr", Result<void>()));
}

TEST(Result, AnInterruptionIsAboutNoFile) {
  const Error stopped{ErrorCode::interrupted, "interrupted; nothing was written"};
  EXPECT_EQ(withName("room.exr", stopped).message, stopped.message);
}

}  // namespace
}  // namespace mirrorball
