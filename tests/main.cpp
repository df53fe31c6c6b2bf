// The main program of every GoogleTest program. CTest runs a suite at a time: one in which every test skipped itself
// (no GL driver, no shared data) ends with the code that CTest counts as skipped,
// and one that has no test any more fails.

#include <cstdio>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  constexpr int kSkipped = 77;
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  if (GTEST_FLAG_GET(list_tests)) return result;
  const ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
  if (tests.test_to_run_count() == 0) {
    std::fprintf(stderr, "no test has such a name\n");
    return 1;
  }
  return result == 0 && tests.skipped_test_count() == tests.test_to_run_count() ? kSkipped : result;
}
