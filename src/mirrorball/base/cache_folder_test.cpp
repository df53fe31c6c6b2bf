#include "mirrorball/base/cache_folder.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

constexpr std::array<CachedKind, 3> kKinds{CachedKind::prefiltered_chain, CachedKind::irradiance,
                                           CachedKind::occlusion};

/// The bytes that a file has beside its content.
constexpr std::size_t kSeal = 80;

class CacheFolderTest : public ::testing::Test {
 protected:
  CacheFolderTest() { fs::remove_all(folder_); }
  ~CacheFolderTest() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return fs::exists(folder_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {})) : 0;
  }

  static std::string keyOf(int content) {
    ContentHash hash;
    hash.add(content);
    return hash.digits();
  }

  static void keep(const CacheFolder& cache, const std::string& key, CachedKind kind, std::size_t size) {
    cache.keep(key, kind, [size](const FileWriter& file) { return file.writeAt(0, Bytes(size, 'x')); });
  }

  /// The size of what is found; nothing: it is not.
  static std::optional<std::uintmax_t> find(const CacheFolder& cache, const std::string& key, CachedKind kind) {
    return cache.find(key, kind, [](const CachedContent& content) { return std::optional(content.size); });
  }

  /// All that is there was last used so long ago.
  void age(std::chrono::hours time) const {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      fs::last_write_time(entry.path(), entry.last_write_time() - time);
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("cache_folder_" + std::to_string(::getpid()));
};

TEST_F(CacheFolderTest, FindsEachKindOfAKeyByItself) {
  const CacheFolder cache(folder_);
  keep(cache, keyOf(1), CachedKind::irradiance, 10);
  keep(cache, keyOf(1), CachedKind::occlusion, 20);
  EXPECT_EQ(find(cache, keyOf(1), CachedKind::irradiance), 10u);
  EXPECT_EQ(find(cache, keyOf(1), CachedKind::occlusion), 20u);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::prefiltered_chain));
  EXPECT_FALSE(find(cache, keyOf(2), CachedKind::irradiance));
}

TEST_F(CacheFolderTest, AFolderThatCannotBeMadeDoesNoHarm) {
  std::ofstream(folder_) << "a file";
  const CacheFolder cache(folder_ / "below");
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::occlusion));
  EXPECT_EQ(cache.contents().files, 0u);
}

#if GTEST_IS_THREADSAFE  // a browser has neither pipes nor other users
TEST_F(CacheFolderTest, TheFolderIsTheUsersAlone) {
  const CacheFolder cache(folder_ / "below");
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  const auto permissions = [&] { return fs::status(cache.folder()).permissions(); };
  EXPECT_EQ(permissions(), fs::perms::owner_all);
  EXPECT_TRUE(cache.check());
  fs::permissions(cache.folder(), fs::perms::group_write, fs::perm_options::add);
  ASSERT_FALSE(cache.check());
  EXPECT_NE(cache.check().error().message.find("chmod 700"), std::string::npos);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::occlusion)) << "whoever may write there may have put it there";
  keep(cache, keyOf(2), CachedKind::occlusion, 10);
  fs::permissions(cache.folder(), fs::perms::owner_all);
  EXPECT_FALSE(find(cache, keyOf(2), CachedKind::occlusion));
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion));
}

TEST_F(CacheFolderTest, AnotherUsersFolderIsNotUsed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  fs::create_directories(folder_);
  ASSERT_EQ(::chown(folder_.c_str(), 12345, 12345), 0);
  const CacheFolder cache(folder_);
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  EXPECT_EQ(files(), 0u);
  ASSERT_FALSE(cache.check());
  EXPECT_NE(cache.check().error().message.find("another user's"), std::string::npos);
}

// The names are predictable.
TEST_F(CacheFolderTest, LinksAndPipesOfANameAreReplaced) {
  const CacheFolder cache(folder_);
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  const fs::path path = fs::directory_iterator(folder_)->path();
  const fs::path victim = folder_ / "victim.txt";
  std::ofstream(victim) << "precious";
  fs::rename(path, folder_ / "moved");
  fs::create_symlink("moved", path);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::occlusion)) << "a link is not read";
  fs::remove(path);
  fs::create_symlink("victim.txt", path);
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  EXPECT_EQ(fs::file_size(victim), 8u);
  EXPECT_FALSE(fs::is_symlink(path));
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion));
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::occlusion));
  keep(cache, keyOf(1), CachedKind::occlusion, 10);
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion));
}
#endif

TEST_F(CacheFolderTest, WhatCannotBeWrittenIsNotThere) {
  const CacheFolder cache(folder_);
  cache.keep(keyOf(1), CachedKind::occlusion, [](const FileWriter& file) -> Result<void> {
    MIRRORBALL_TRY_VOID(file.writeAt(0, Bytes(5)));
    return fail(ErrorCode::io, "the disk is full");
  });
  EXPECT_EQ(files(), 0u);
}

// Each byte counts, of the content and of the seal, and each length.
TEST_F(CacheFolderTest, WhatIsDamagedIsNotFound) {
  const CacheFolder cache(folder_);
  keep(cache, keyOf(1), CachedKind::occlusion, 1000);
  const fs::path path = fs::directory_iterator(folder_)->path();
  const Bytes whole = readFile(path).value();
  const auto isFound = [&](const Bytes& bytes) {
    EXPECT_TRUE(writeFile(path, bytes));
    return find(cache, keyOf(1), CachedKind::occlusion).has_value();
  };
  EXPECT_TRUE(isFound(whole));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes damaged = whole;
    damaged[i] ^= 4u;
    EXPECT_FALSE(isFound(damaged)) << "byte " << i;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{79}, whole.size() - 1, whole.size() + 1}) {
    Bytes other = whole;
    other.resize(size);
    EXPECT_FALSE(isFound(other)) << size << " bytes";
  }
  EXPECT_TRUE(isFound(whole));
}

TEST_F(CacheFolderTest, AFileUnderTheNameOfAnotherIsNotFound) {
  const CacheFolder cache(folder_);
  keep(cache, keyOf(1), CachedKind::occlusion, 1000);
  const fs::path path = fs::directory_iterator(folder_)->path();
  fs::copy_file(path, folder_ / (keyOf(2) + "-occlusion.bin"));
  fs::copy_file(path, folder_ / (keyOf(1) + "-irradiance.ktx2"));
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion));
  EXPECT_FALSE(find(cache, keyOf(2), CachedKind::occlusion));
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::irradiance));
}

TEST_F(CacheFolderTest, LargeContentIsFound) {
  const CacheFolder cache(folder_);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1} << 20u, (std::size_t{1} << 21u) + 1}) {
    keep(cache, keyOf(1), CachedKind::occlusion, size);
    EXPECT_EQ(find(cache, keyOf(1), CachedKind::occlusion), size);
  }
}

// One limit for all kinds together; and a file that was found counts as used.
TEST_F(CacheFolderTest, WhatWasNotUsedForLongestIsDroppedOfAllKindsAndNothingElse) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "mine.ktx2") << std::string(5000, 'x');
  std::ofstream(folder_ / (keyOf(1) + "-photo.jpg")) << "begins as a key does";
  const CacheFolder cache(folder_, 2500);
  keep(cache, keyOf(1), CachedKind::occlusion, 1000 - kSeal);
  age(std::chrono::hours(1));
  keep(cache, keyOf(2), CachedKind::prefiltered_chain, 1000 - kSeal);
  age(std::chrono::hours(1));
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion)) << "now the last that was used";
  keep(cache, keyOf(3), CachedKind::irradiance, 1000 - kSeal);
  EXPECT_TRUE(find(cache, keyOf(1), CachedKind::occlusion));
  EXPECT_FALSE(find(cache, keyOf(2), CachedKind::prefiltered_chain));
  EXPECT_TRUE(find(cache, keyOf(3), CachedKind::irradiance));
  EXPECT_EQ(cache.contents().bytes, 2000u);
  EXPECT_EQ(files(), 4u) << "with those that are not ours";
}

// What `read` has no use for stays as old as it is.
TEST_F(CacheFolderTest, WhatIsOfNoUseIsNotUsed) {
  const CacheFolder cache(folder_, 2500);
  keep(cache, keyOf(1), CachedKind::occlusion, 1000);
  age(std::chrono::hours(2));
  keep(cache, keyOf(2), CachedKind::occlusion, 1000);
  age(std::chrono::hours(1));
  EXPECT_FALSE(cache.find(keyOf(1), CachedKind::occlusion, [](const CachedContent&) { return std::optional<int>(); }));
  keep(cache, keyOf(3), CachedKind::occlusion, 1000);
  EXPECT_FALSE(find(cache, keyOf(1), CachedKind::occlusion));
  EXPECT_TRUE(find(cache, keyOf(2), CachedKind::occlusion));
}

TEST_F(CacheFolderTest, ClearRemovesWhatItKeptAndNothingElse) {
  const CacheFolder cache(folder_);
  EXPECT_EQ(cache.contents().files, 0u) << "there is no folder yet";
  ASSERT_TRUE(cache.clear());
  for (const CachedKind kind : kKinds) keep(cache, keyOf(1), kind, 100);
  std::ofstream(folder_ / ".mirrorball-0123456789abcdef.part") << "half";
  std::ofstream(folder_ / ".mirrorball-0000000000000009.part") << "half";
  const std::string foreign[] = {"holiday.ktx2",
                                 "-occlusion.bin",
                                 keyOf(3),
                                 keyOf(3) + ".bin",
                                 "x" + keyOf(3) + "-occlusion.bin",
                                 keyOf(3) + "-occlusion.bin.old"};
  for (const std::string& name : foreign) std::ofstream(folder_ / name) << "mine";
  const auto contents = cache.contents();
  EXPECT_EQ(contents.files, 5u);
  EXPECT_EQ(contents.bytes, 308u + 3 * kSeal);
  const auto removed = cache.clear();
  ASSERT_TRUE(removed) << removed.error().message;
  EXPECT_EQ(removed->files, 5u);
  EXPECT_EQ(removed->bytes, contents.bytes);
  EXPECT_EQ(files(), std::size(foreign));
  for (const std::string& name : foreign) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
}

TEST_F(CacheFolderTest, TheUserSaysHowLargeItMayGrow) {
  ::setenv("MIRRORBALL_CACHE", folder_.c_str(), 1);
  const auto ofSize = [](const char* written) {
    ::setenv("MIRRORBALL_CACHE_SIZE", written, 1);
    return CacheFolder::ofUser();
  };
  for (const auto& [written, bytes] : {std::pair<const char*, std::uintmax_t>{"500M", std::uintmax_t{500} << 20},
                                       {"2G", std::uintmax_t{2} << 30},
                                       {"0", 0},
                                       {"", CacheFolder::kMaxBytes}}) {
    const auto cache = ofSize(written);
    ASSERT_TRUE(cache && *cache) << written;
    EXPECT_EQ((*cache)->maxBytes(), bytes) << written;
    EXPECT_EQ((*cache)->folder(), folder_);
  }
  const auto wrong = ofSize("much");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::usage);
  EXPECT_NE(wrong.error().message.find("MIRRORBALL_CACHE_SIZE"), std::string::npos);
  const auto none = ofSize("0");
  keep(**none, keyOf(1), CachedKind::occlusion, 10);
  EXPECT_EQ(files(), 0u) << "of size 0 nothing is kept";
  ::unsetenv("MIRRORBALL_CACHE_SIZE");
  ::unsetenv("MIRRORBALL_CACHE");
}

// Keys stay the same, so that what was kept is found by later versions of the program: XXH3's own test values (its
// XXH3_128bits of nothing).
TEST(ContentHash, IsXxh3) {
  EXPECT_EQ(ContentHash().digits(), "99aa06d3014798d86001c324468d497f");
  ContentHash parts, whole;
  parts.add('a');
  parts.addAll(std::span(std::string_view("bc")));
  whole.addAll(std::span(std::string_view("abc")));
  EXPECT_EQ(parts.digits(), whole.digits());
  EXPECT_NE(ContentHash(1).digits(), ContentHash().digits());
}

}  // namespace
}  // namespace mirrorball
