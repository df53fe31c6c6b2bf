#include "mirrorball/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class FileTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::size_t fileCount() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  const fs::path folder_ = fs::path(::testing::TempDir()) / ("mirrorball_file_test_" + std::to_string(::getpid()));
};

TEST_F(FileTest, WhatIsWrittenIsRead) {
  const Bytes bytes{1, 2, 0, 255};
  ASSERT_TRUE(writeFile(folder_ / "a", bytes));
  EXPECT_EQ(*readFile(folder_ / "a"), bytes);
  EXPECT_EQ(fileCount(), 1u) << "the temporary file stayed";
}

TEST_F(FileTest, MissingFileAndFolderAreNamed) {
  const auto missing = readFile(folder_ / "b");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::not_found);
  EXPECT_THAT(missing.error().message, HasSubstr((folder_ / "b").string()));
  EXPECT_THAT(readFile(folder_).error().message, HasSubstr("is a folder"));
}

TEST_F(FileTest, TooLargeAFileIsRefused) {
  ASSERT_TRUE(writeFile(folder_ / "a", Bytes(10)));
  EXPECT_EQ(readFile(folder_ / "a", 9).error().code, ErrorCode::too_large);
}

TEST_F(FileTest, UnwritablePlaceLeavesNothing) {
  const auto result = writeFile(folder_ / "none" / "a", Bytes(10));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::io);
  fs::create_directory(folder_ / "target");
  EXPECT_FALSE(writeFile(folder_ / "target", Bytes(10)));
  EXPECT_EQ(fileCount(), 1u) << "the temporary file stayed";
}

TEST_F(FileTest, PiecesAreWrittenInAnyOrder) {
  auto writer = FileWriter::create(folder_ / "a");
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->writeAt(4, Bytes{5, 6}));
  ASSERT_TRUE(writer->writeAt(0, Bytes{1, 2}));
  EXPECT_FALSE(fs::exists(folder_ / "a")) << "the name is there before the file is whole";
  ASSERT_TRUE(writer->commit());
  EXPECT_EQ(*readFile(folder_ / "a"), (Bytes{1, 2, 0, 0, 5, 6}));
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileTest, WithoutCommitTheOldFileStays) {
  ASSERT_TRUE(writeFile(folder_ / "a", Bytes{1}));
  {
    auto writer = FileWriter::create(folder_ / "a");
    ASSERT_TRUE(writer);
    const FileWriter moved = std::move(*writer);
    ASSERT_TRUE(moved.writeAt(0, Bytes{2}));
  }
  EXPECT_EQ(*readFile(folder_ / "a"), Bytes{1});
  EXPECT_EQ(fileCount(), 1u) << "the temporary file stayed";
}

TEST_F(FileTest, AFullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The temporary name is a link to the device that is always full.
  fs::create_symlink("/dev/full", (folder_ / "a").string() + ".part" + std::to_string(::getpid()));
  const auto result = writeFile(folder_ / "a", Bytes(10));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::io);
  EXPECT_THAT(result.error().message, HasSubstr("No space"));
  EXPECT_EQ(fileCount(), 0u) << "the temporary file stayed";
}

TEST(ExtensionOf, IsLowerCaseWithoutDot) {
  EXPECT_EQ(extensionOf("a/Photo.HDR"), "hdr");
  EXPECT_EQ(extensionOf("a.b/photo"), "");
}

}  // namespace
}  // namespace mirrorball
