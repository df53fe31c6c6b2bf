#include "mirrorball/gl/driver_cache.h"

#include <cstdlib>
#include <fstream>
#include <list>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

#include "environment_variable_testing.h"

namespace mirrorball::gl {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

const std::string kMesa = "4.5 (Core Profile) Mesa 22.3.6";
const std::string kNvidia = "4.6.0 NVIDIA 550.54.14";

/// A fresh folder, and environment variables that are as before after the test.
class DriverCacheTest : public ::testing::Test {
 protected:
  DriverCacheTest() {
    fs::remove_all(folder_);
    for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_SHADER_CACHE_DISABLE", "MESA_DISK_CACHE_DATABASE",
                             "MESA_DISK_CACHE_SINGLE_FILE", "XDG_CACHE_HOME", "HOME", "__GL_SHADER_DISK_CACHE",
                             "__GL_SHADER_DISK_CACHE_PATH"})
      without_.emplace_back(name, std::nullopt);
  }
  ~DriverCacheTest() override { fs::remove_all(folder_); }

  static void set(const std::string& name, const std::string& value) { ::setenv(name.c_str(), value.c_str(), 1); }

  static void write(const fs::path& path, std::size_t bytes) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << std::string(bytes, 'x');
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("driver_cache_" + std::to_string(::getpid()));

 private:
  std::list<testing::VariableForTest> without_;  // whose end restores what tests set
};

TEST_F(DriverCacheTest, MesasFolderIsWhereItsVariablesSay) {
  set("XDG_CACHE_HOME", folder_ / "xdg");
  EXPECT_THAT(findDriverCache(kMesa)->folders, ElementsAre(folder_ / "xdg" / "mesa_shader_cache"));
  set("MESA_SHADER_CACHE_DIR", folder_ / "own");
  EXPECT_THAT(findDriverCache(kMesa)->folders, ElementsAre(folder_ / "own" / "mesa_shader_cache"));
  set("MESA_DISK_CACHE_SINGLE_FILE", "1");
  EXPECT_THAT(findDriverCache(kMesa)->folders, ElementsAre(folder_ / "own" / "mesa_shader_cache_sf"));
  write(folder_ / "own" / "mesa_shader_cache_db" / "part0" / "mesa_cache.db", 7);
  EXPECT_THAT(findDriverCache(kMesa)->folders, ElementsAre(folder_ / "own" / "mesa_shader_cache_db"))
      << "what is there is shown";
}

TEST_F(DriverCacheTest, MesasFolderIsInTheHomeOfTheUserDatabase) {
  const passwd* user = ::getpwuid(::getuid());
  if (user == nullptr) GTEST_SKIP() << "which has no such user";
  set("HOME", folder_ / "other");
  EXPECT_EQ(findDriverCache(kMesa)->folders.front().parent_path(), fs::path(user->pw_dir) / ".cache");
}

TEST_F(DriverCacheTest, MesasIsOnUnlessItIsDisabled) {
  EXPECT_EQ(findDriverCache(kMesa)->is_on, true);
  for (const char* yes : {"true", "1", "YES"}) {
    set("MESA_SHADER_CACHE_DISABLE", yes);
    EXPECT_EQ(findDriverCache(kMesa)->is_on, false) << yes;
  }
  for (const char* no : {"false", "0"}) {
    set("MESA_SHADER_CACHE_DISABLE", no);
    EXPECT_EQ(findDriverCache(kMesa)->is_on, true) << no;
  }
}

TEST_F(DriverCacheTest, NvidiasFolderIsWhereItsVariablesSay) {
  set("HOME", folder_);
  EXPECT_THAT(findDriverCache(kNvidia)->folders, ElementsAre(folder_ / ".cache" / "nvidia" / "GLCache"));
  write(folder_ / ".nv" / "GLCache" / "a" / "b.bin", 5);
  EXPECT_THAT(findDriverCache(kNvidia)->folders, ElementsAre(folder_ / ".nv" / "GLCache")) << "an older driver's";
  set("__GL_SHADER_DISK_CACHE_PATH", folder_ / "own");
  EXPECT_THAT(findDriverCache(kNvidia)->folders, ElementsAre(folder_ / "own" / "GLCache"));
  set("__GL_SHADER_DISK_CACHE", "0");
  EXPECT_EQ(findDriverCache(kNvidia)->is_on, false);
  set("__GL_SHADER_DISK_CACHE", "1");
  EXPECT_EQ(findDriverCache(kNvidia)->is_on, true);
}

TEST_F(DriverCacheTest, OfAnotherDriverNothingIsKnown) {
  EXPECT_FALSE(findDriverCache("4.1 Metal - 88"));
  EXPECT_FALSE(findDriverCache(""));
}

TEST_F(DriverCacheTest, AllFilesBelowItsFoldersCount) {
  set("MESA_SHADER_CACHE_DIR", folder_);
  EXPECT_EQ(findDriverCache(kMesa)->contents().files, 0u) << "none has been made";
  write(folder_ / "mesa_shader_cache" / "00" / "first", 100);
  write(folder_ / "mesa_shader_cache_db" / "second", 20);
  write(folder_ / "other", 3);
  const CacheFolder::Contents contents = findDriverCache(kMesa)->contents();
  EXPECT_EQ(contents.files, 2u);
  EXPECT_EQ(contents.bytes, 120u);
}

}  // namespace
}  // namespace mirrorball::gl
