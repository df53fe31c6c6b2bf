// Feeds every file of a decoder's corpus to the fuzzer's entry point, without libFuzzer. A finding ends the program by
// itself; the last name printed is that of the file.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fuzz.h"
#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {
namespace {

namespace fs = std::filesystem;
using Harness = int (*)(const std::uint8_t* data, std::size_t size);

std::map<std::string, Harness>& harnesses() {
  static std::map<std::string, Harness> all;
  return all;
}

class Corpus : public ::testing::Test {
 protected:
  // A model may name files beside it: there are none.
  void SetUp() override {
    const fs::path empty = fs::path(::testing::TempDir()) / "mirrorball_empty";
    fs::create_directories(empty);
    fs::current_path(empty);
  }
};

TEST_F(Corpus, EveryInputIsSurvived) {
  const fs::path corpora = fs::path(MIRRORBALL_SOURCE_DIR) / "fuzz/corpus";
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(corpora))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::map<std::string, int> tried;
  for (const fs::path& file : files) {
    const std::string decoder = file.parent_path().filename().string();
    ASSERT_TRUE(harnesses().contains(decoder)) << file << " has no harness";
    const auto bytes = readFile(file);
    ASSERT_TRUE(bytes) << bytes.error().message;
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);
    harnesses().at(decoder)(bytes->data(), bytes->size());
    ++tried[decoder];
  }
  for (const auto& [decoder, harness] : harnesses()) EXPECT_GT(tried[decoder], 0) << decoder << " has no corpus";
}

}  // namespace

bool addHarness(const char* decoder, Harness harness) { return harnesses().emplace(decoder, harness).second; }

}  // namespace mirrorball::fuzz
