#include "mirrorball/base/file.h"

#include <array>
#include <thread>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mirrorball/base/memory.h"

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
  fs::create_symlink("/dev/full", folder_ / "a");
  const auto result = writeFile(folder_ / "a", Bytes(10));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::io);
  EXPECT_THAT(result.error().message, HasSubstr("No space"));
  EXPECT_EQ(fileCount(), 1u) << "the temporary file stayed";
}

TEST_F(FileTest, ALinkIsWrittenThrough) {
  fs::create_directories(folder_ / "far");
  ASSERT_TRUE(writeFile(folder_ / "far" / "a", Bytes{1}));
  fs::create_symlink("far/a", folder_ / "near");
  fs::create_symlink(folder_ / "near", folder_ / "farther");
  fs::create_symlink("far/new", folder_ / "dangling");
  for (const char* name : {"near", "farther", "dangling"}) {
    ASSERT_TRUE(writeFile(folder_ / name, Bytes{2, 3})) << name;
    EXPECT_TRUE(fs::is_symlink(folder_ / name)) << name;
    EXPECT_EQ(*readFile(folder_ / name), (Bytes{2, 3})) << name;
  }
  EXPECT_FALSE(fs::is_symlink(folder_ / "far" / "a"));
  EXPECT_TRUE(fs::exists(folder_ / "far" / "new"));
  EXPECT_EQ(fileCount(), 4u);
  fs::create_symlink("round", folder_ / "round");
  EXPECT_THAT(writeFile(folder_ / "round", Bytes{1}).error().message, HasSubstr("ymbolic link"));
}

// File systems allow 255 bytes.
TEST_F(FileTest, ALongNameIsWritten) {
  for (const std::size_t length : {250u, 254u, 255u}) {
    const auto written = writeFile(folder_ / std::string(length, 'n'), Bytes{1});
    EXPECT_TRUE(written) << length << ": " << written.error().message;
  }
  EXPECT_EQ(fileCount(), 3u);
}

#if GTEST_IS_THREADSAFE  // a browser has neither threads nor pipes nor other users
// Nobody else decides where our bytes go.
TEST_F(FileTest, ALinkOfAnotherUserInAWorldWritableFolderIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make links of others";
  const fs::path folder = folder_ / "world_writable", victim = folder_ / "victim", link = folder / "out.txt";
  fs::create_directories(folder);
  ASSERT_EQ(::chown(folder.c_str(), 12346, 12346), 0);
  fs::permissions(folder, fs::perms::all | fs::perms::sticky_bit);
  ASSERT_TRUE(writeFile(victim, Bytes(8)));
  fs::create_symlink(victim, link);
  ASSERT_EQ(::lchown(link.c_str(), 12345, 12345), 0);
  const auto refused = writeFile(link, Bytes(1));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("another user"), std::string::npos) << refused.error().message;
  EXPECT_EQ(fs::file_size(victim), 8u);
  ASSERT_EQ(::lchown(link.c_str(), 0, 0), 0);
  EXPECT_TRUE(writeFile(link, Bytes(1))) << "a link of our own";
  EXPECT_EQ(fs::file_size(victim), 1u);
  ASSERT_TRUE(FileWriter::create(link, Links::refuse)->commit());
  EXPECT_FALSE(fs::is_symlink(link)) << "replaced";
}

TEST_F(FileTest, APipeIsWrittenInto) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Bytes bytes(300'000);  // more than a pipe holds
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 / 5);
  const Descriptor reading(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK));
  Bytes got;
  std::thread reader([&] {
    std::array<std::uint8_t, 4096> piece;
    pollfd begun{.fd = reading.number(), .events = POLLIN, .revents = 0};
    while (::poll(&begun, 1, 60'000) > 0) {
      const ssize_t count = ::read(reading.number(), piece.data(), piece.size());
      if (count <= 0) break;
      got.insert(got.end(), piece.begin(), piece.begin() + count);
    }
  });
  EXPECT_TRUE(writeFile(pipe, bytes));
  reader.join();
  EXPECT_TRUE(got == bytes);
  EXPECT_TRUE(fs::is_fifo(pipe)) << "it was replaced";
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(FileTest, WhatMayNeverEndIsNotRead) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const fs::path& path : {folder_ / "pipe", fs::path("/dev/zero")}) {
    const auto read = readFile(path);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message, HasSubstr("a pipe or a device"));
  }
}

// Of a file with a hole that is larger than all memory nothing is read.
TEST_F(FileTest, WhatDoesNotFitIntoMemoryIsNotRead) {
  ASSERT_TRUE(writeFile(folder_ / "a", {}));
  fs::resize_file(folder_ / "a", 3u << 30u);
  const std::uint64_t limit = memoryLimit();
  setMemoryLimit(1u << 30u);
  const auto read = readFile(folder_ / "a");
  setMemoryLimit(limit);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::too_large);
  EXPECT_THAT(read.error().message, HasSubstr("a: "));
}

TEST_F(FileTest, AFileThatIsReplacedKeepsItsPermissions) {
  for (const mode_t mode : {0600u, 0644u, 0664u, 0755u}) {
    ASSERT_TRUE(writeFile(folder_ / "a", Bytes{1}));
    ASSERT_EQ(::chmod((folder_ / "a").c_str(), mode), 0);
    ASSERT_TRUE(writeFile(folder_ / "a", Bytes{2}));
    struct stat status {};
    ASSERT_EQ(::stat((folder_ / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, mode);
  }
}
#endif

TEST(ExtensionOf, IsLowerCaseWithoutDot) {
  EXPECT_EQ(extensionOf("a/Photo.HDR"), "hdr");
  EXPECT_EQ(extensionOf("a.b/photo"), "");
}

}  // namespace
}  // namespace mirrorball
