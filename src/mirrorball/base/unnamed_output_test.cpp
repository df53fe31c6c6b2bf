#include "mirrorball/base/unnamed_output.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// The temporary folder of these tests.
class UnnamedOutputTest : public ::testing::Test {
 protected:
  UnnamedOutputTest() {
    fs::create_directories(folder_);
    ::setenv("TMPDIR", folder_.c_str(), 1);
  }
  ~UnnamedOutputTest() override {
    if (usual_.empty())
      ::unsetenv("TMPDIR");
    else
      ::setenv("TMPDIR", usual_.c_str(), 1);
    fs::remove_all(folder_);
  }

  static std::string contentOf(const UnnamedOutput& output) {
    std::string content(100, '\0');
    const ssize_t size = ::pread(output.file().number(), content.data(), content.size(), 0);
    content.resize(size > 0 ? std::size_t(size) : 0);
    return content;
  }

  const std::string usual_ = std::getenv("TMPDIR") == nullptr ? "" : std::getenv("TMPDIR");
  const fs::path folder_ = fs::path(::testing::TempDir()) / ("unnamed_output_" + std::to_string(::getpid()));
};

const std::vector<std::uint8_t> kAbc = {'a', 'b', 'c'};

TEST_F(UnnamedOutputTest, HasNoNameWhileItIsWrittenNorAfterwards) {
  const UnnamedOutput output("/dev/fd/1.exr");
  auto writer = FileWriter::create("/dev/fd/1.exr");
  ASSERT_TRUE(writer) << writer.error().message;
  ASSERT_TRUE(writer->writeAt(0, kAbc));
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_FALSE(output.file().isOpen());
  ASSERT_TRUE(writer->commit());
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_EQ(contentOf(output), "abc");
}

TEST_F(UnnamedOutputTest, KeepsWhatWasCommittedLast) {
  const UnnamedOutput output("output.png");
  ASSERT_TRUE(writeFile("output.png", kAbc));
  ASSERT_TRUE(writeFile("output.png", std::vector<std::uint8_t>{'d'}));
  {
    const auto abandoned = FileWriter::create("output.png");
    ASSERT_TRUE(abandoned->writeAt(0, kAbc));
  }
  EXPECT_EQ(contentOf(output), "d");
  EXPECT_FALSE(fs::exists("output.png"));
}

TEST_F(UnnamedOutputTest, OtherNamesAreFilesAndSoIsItsOwnAfterwards) {
  const std::string name = folder_ / "a.png";
  {
    const UnnamedOutput output(name);
    ASSERT_TRUE(writeFile(folder_ / "b.png", kAbc));
    EXPECT_TRUE(fs::exists(folder_ / "b.png"));
    EXPECT_FALSE(output.file().isOpen());
  }
  EXPECT_EQ(UnnamedOutput::find(name), nullptr);
  ASSERT_TRUE(writeFile(name, kAbc));
  EXPECT_TRUE(fs::exists(name));
}

TEST_F(UnnamedOutputTest, WithoutATemporaryFolderTheErrorNamesTMPDIR) {
  ::setenv("TMPDIR", (folder_ / "missing").c_str(), 1);
  const UnnamedOutput output("output.png");
  const auto refused = writeFile("output.png", kAbc);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("TMPDIR"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace mirrorball
