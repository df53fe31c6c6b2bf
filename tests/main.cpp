// The main program of every GoogleTest program. CTest runs a suite at a time: one in which every test skipped itself
// (no GL driver, no shared data) ends with the code that CTest counts as skipped,
// and one that has no test any more fails.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace {

/// A folder for temporary files that only this program has, so that others, of another build or another checkout, do
/// not write files of the same names at the same time.
class OwnTemporaryFolder {
 public:
  OwnTemporaryFolder() : folder_((std::filesystem::temp_directory_path() / "mirrorball_test_XXXXXX").string()) {
    if (::mkdtemp(folder_.data()) == nullptr) {
      std::fprintf(stderr, "cannot make the folder %s\n", folder_.c_str());
      std::exit(1);
    }
    ::setenv("TMPDIR", folder_.c_str(), 1);
  }
  ~OwnTemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  OwnTemporaryFolder(const OwnTemporaryFolder&) = delete;
  OwnTemporaryFolder& operator=(const OwnTemporaryFolder&) = delete;

 private:
  std::string folder_;
};

/// Makes the file by which tests/unchanged.sh learns that not every test was run.
void tellOfSkippedTests() {
  const char* const path = std::getenv("MIRRORBALL_SKIPPED_FILE");
  if (path == nullptr) return;
  if (std::FILE* const file = std::fopen(path, "w")) std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kSkipped = 77;
  ::testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const OwnTemporaryFolder folder;
  const int result = RUN_ALL_TESTS();
  const ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
  if (tests.test_to_run_count() == 0) {
    std::fprintf(stderr, "no test has such a name\n");
    return 1;
  }
  if (tests.skipped_test_count() > 0) tellOfSkippedTests();
  return result == 0 && tests.skipped_test_count() == tests.test_to_run_count() ? kSkipped : result;
}
