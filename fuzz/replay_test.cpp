// Feeds every file of a decoder's corpus to the fuzzer's entry point, without libFuzzer. A finding ends the program by
// itself; the last name printed is that of the file.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "fuzz.h"
#include "mirrorball/base/file.h"
#include "model_mutation.h"

namespace mirrorball::fuzz {
namespace {

namespace fs = std::filesystem;
using Harness = int (*)(const std::uint8_t* data, std::size_t size);

std::map<std::string, Harness>& harnesses() {
  static std::map<std::string, Harness> all;
  return all;
}

std::vector<std::string> decoders() {
  std::vector<std::string> names;
  for (const auto& [decoder, harness] : harnesses()) names.push_back(decoder);
  return names;
}

/// The harnesses that show models, which other harnesses decode.
std::vector<std::string> harnessesOfPictures() { return {"reference", "render"}; }

/// The corpora that a harness reads, which has its own unless it is for what others decode.
std::vector<std::string> corporaOf(const std::string& harness) {
  if (std::ranges::count(harnessesOfPictures(), harness) > 0) return {"gltf", "obj", "ply", "stl"};
  return {harness};
}

fs::path corpora() { return fs::path(MIRRORBALL_SOURCE_DIR) / "fuzz/corpus"; }

class Corpus : public ::testing::TestWithParam<std::string> {
 protected:
  // A model may name files beside it: there are none.
  Corpus() {
    fs::create_directories(empty_);
    fs::current_path(empty_);
  }
  ~Corpus() override {
    fs::current_path(before_);
    fs::remove_all(empty_);
  }

 private:
  fs::path before_ = fs::current_path();
  fs::path empty_ = fs::path(::testing::TempDir()) / ("mirrorball_corpus_" + std::to_string(::getpid()));
};

TEST_P(Corpus, EveryInputIsSurvived) {
  std::vector<fs::path> files;
  for (const std::string& corpus : corporaOf(GetParam()))
    for (const fs::directory_entry& entry : fs::directory_iterator(corpora() / corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    const auto bytes = readFile(file);
    ASSERT_TRUE(bytes) << bytes.error().message;
    std::printf("%s\n", file.filename().c_str());
    std::fflush(stdout);
    harnesses().at(GetParam())(bytes->data(), bytes->size());
  }
}

INSTANTIATE_TEST_SUITE_P(OfADecoder, Corpus, ::testing::ValuesIn(decoders()),
                         [](const auto& instance) { return instance.param; });

class MutatedModels : public ::testing::TestWithParam<std::string> {};

TEST_P(MutatedModels, AreShown) {
  // A driver compiles shaders of a model for seconds.
  const std::uint32_t models = GetParam() == "render" ? 3 : 20;
  constexpr std::uint32_t kChanges = 40;
  for (std::uint32_t model = 0; model < models; ++model) {
    for (std::uint32_t change = 0; change < kChanges; ++change) {
      const Bytes bytes = mutatedModel(model, change);
      std::printf("model %u, change %u\n", model, change);
      std::fflush(stdout);
      harnesses().at(GetParam())(bytes.data(), bytes.size());
    }
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(MutatedModels);
INSTANTIATE_TEST_SUITE_P(Of, MutatedModels, ::testing::ValuesIn(harnessesOfPictures()),
                         [](const auto& instance) { return instance.param; });

TEST(Corpora, AllHaveAHarness) {
  for (const fs::directory_entry& folder : fs::directory_iterator(corpora()))
    EXPECT_THAT(decoders(), ::testing::Contains(folder.path().filename().string()));
}

// As fuzz/README.md says: they travel with every clone.
TEST(Corpora, StaySmall) {
  constexpr std::uintmax_t kMostBytes = 256'000, kMostBytesOfFile = 4096;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(corpora())) {
    if (!entry.is_regular_file()) continue;
    EXPECT_LE(entry.file_size(), kMostBytesOfFile) << entry.path();
    bytes += entry.file_size();
  }
  EXPECT_GT(bytes, 0u);
  EXPECT_LE(bytes, kMostBytes);
}

}  // namespace

bool addHarness(const char* decoder, Harness harness) { return harnesses().emplace(decoder, harness).second; }

}  // namespace mirrorball::fuzz
