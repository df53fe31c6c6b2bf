// What `render` keeps in the user's cache folder and takes from there: prefiltered environments, which `bake` never
// does, and the occlusion of models; and what the driver keeps of its programs.

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/base/cache_folder.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;

class CacheCliTest : public RenderCliTest {
 protected:
  /// Gives the program a cache folder of that name.
  Start withCache(const std::string& name) const {
    return {.environment = {{"MIRRORBALL_CACHE", path(name).string()}}};
  }

  /// The middle of a ball of rough metal, which shows the prefiltered environment.
  glm::vec3 drawMetal(const std::string& options = {}) const {
    succeed("render sphere -e map.exr --material rough-metal --size 33x33 --samples 1 -o metal.exr " + options,
            withCache("cache"));
    return rgbAt(image("metal.exr"), 16, 16);
  }

  /// Each file's name and bytes.
  std::map<std::string, Bytes> filesOf(const std::string& folder) const {
    std::map<std::string, Bytes> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(path(folder))) {
      const std::string name = entry.path().filename().string();
      all[name] = bytes(folder + "/" + name);
    }
    return all;
  }

  /// Makes all light of a cache red, of a radiance that is nowhere in the map, as if that had been kept.
  void makeRed(const std::string& folder) const {
    for (const auto& [name, unused] : filesOf(folder)) {
      ImageSet images = texture(folder + "/" + name);
      forEachImage(images, [](Image& image) {
        for (int y = 0; y < image.height(); ++y)
          for (int x = 0; x < image.width(); ++x)
            for (int c = 0; c < 3; ++c) image.texel(x, y)[c] = c == 0 ? 50.0f : 0.0f;
      });
      const CachedKind kind = name.ends_with("-chain.ktx2") ? CachedKind::prefiltered_chain : CachedKind::irradiance;
      CacheFolder(path(folder)).keep(name.substr(0, name.find('-')), kind, [&](const FileWriter& file) {
        return writeImageSet(file, images);
      });
    }
  }
};

TEST_F(CacheCliTest, RenderReadsItUnlessToldNotTo) {
  write("map.exr", smoothPanorama());
  const glm::vec3 fresh = drawMetal();
  EXPECT_EQ(filesOf("cache").size(), 2u);
  EXPECT_LT(glm::distance(drawMetal(), fresh), 1e-3f) << "from the cache";
  makeRed("cache");
  const glm::vec3 wrong = drawMetal();
  EXPECT_GT(wrong.x, 10.0f);
  EXPECT_LT(wrong.y, 0.01f);
  EXPECT_EQ(drawMetal("--no-cache"), fresh);
}

TEST_F(CacheCliTest, DamagedLightIsMadeAgain) {
  write("map.exr", smoothPanorama());
  const glm::vec3 fresh = drawMetal();
  const std::map<std::string, Bytes> kept = filesOf("cache");
  ASSERT_EQ(kept.size(), 2u);
  for (const auto& [name, whole] : kept) {
    Bytes damaged = whole;  // a disk's sectors, with other light in them
    for (std::size_t i = damaged.size() / 4; i < damaged.size() / 4 * 3; ++i) damaged[i] ^= 0x10u;
    write("cache/" + name, damaged);
  }
  EXPECT_EQ(drawMetal(), fresh);
  EXPECT_EQ(filesOf("cache"), kept) << "and kept";
}

TEST_F(CacheCliTest, CacheShowsAndClearsIt) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  write("map.exr", smoothPanorama());
  Start how = withCache("cache");
  EXPECT_THAT(succeed("cache", how),
              AllOf(HasSubstr("folder       " + path("cache").string()), HasSubstr("holds        nothing\n"),
                    HasSubstr("at most      1.0 GB (MIRRORBALL_CACHE_SIZE)")));
  drawMetal();
  write("cache/mine.txt", std::string("no map"));
  EXPECT_THAT(succeed("cache show", how), HasSubstr("holds        2 files, "));
  EXPECT_THAT(succeed("cache clear", how), HasSubstr("removed      2 files, "));
  EXPECT_EQ(filesOf("cache").size(), 1u) << "what is not ours stays";
  how.environment["MIRRORBALL_CACHE_SIZE"] = "0";
  EXPECT_THAT(succeed("cache", how), HasSubstr("at most      nothing"));
  succeed("render sphere -e map.exr --material rough-metal --size 8x8 -o metal.exr", how);
  EXPECT_EQ(filesOf("cache").size(), 1u) << "nothing is kept";
  how.environment["MIRRORBALL_CACHE_SIZE"] = "much";
  EXPECT_THAT(refuse(2, "cache", how), HasSubstr("MIRRORBALL_CACHE_SIZE: 'much'"));
  EXPECT_THAT(refuse(2, "render sphere -e map.exr --size 8x8 -o metal.exr", how), HasSubstr("MIRRORBALL_CACHE_SIZE"));
  EXPECT_THAT(refuse(2, "cache empty", withCache("cache")), HasSubstr("show, clear, warm"));
  EXPECT_THAT(succeed("cache", {.environment = {{"MIRRORBALL_CACHE", ""}}}), HasSubstr("there is no cache"));
}

TEST_F(CacheCliTest, RenderKeepsTheOcclusionOfAModel) {
  write("map.exr", smoothPanorama());
  const auto draw = [&](const std::string& options = {}) {
    succeed("render teapot -e map.exr --size 33x33 --samples 1 --occlusion vertex -o teapot.exr " + options,
            withCache("cache"));
    return bytes("teapot.exr");
  };
  const auto occlusionFiles = [&] {
    std::vector<fs::path> found;
    for (const auto& [name, unused] : filesOf("cache"))
      if (name.ends_with("-occlusion.bin")) found.push_back(path("cache") / name);
    return found;
  };
  const Bytes without = draw("--no-cache");
  EXPECT_FALSE(fs::exists(path("cache")));
  draw();
  ASSERT_EQ(occlusionFiles().size(), 1u);
  const fs::path file = occlusionFiles().front();
  const fs::file_time_type long_ago = fs::last_write_time(file) - std::chrono::hours(24);
  fs::last_write_time(file, long_ago);
  EXPECT_TRUE(draw() == without);
  EXPECT_GT(fs::last_write_time(file), long_ago) << "it is used";
  draw("--self-reflection");
  EXPECT_EQ(occlusionFiles().size(), 2u) << "which asks for more";
  EXPECT_THAT(succeed("cache clear", withCache("cache")), ::testing::HasSubstr("removed      4 files, "));
}

/// With a folder for the driver's own cache.
class DriverCacheCliTest : public CacheCliTest {
 protected:
  void SetUp() override {
    CacheCliTest::SetUp();
    write("map.exr", smoothPanorama());
    succeed("cache show", withBoth("probe"));
    if (!fs::exists(path("probe-driver"))) GTEST_SKIP() << "this driver does not go by MESA_SHADER_CACHE_DIR";
  }

  /// Fresh folders for the program and for Mesa, unless there are some of that name.
  Start withBoth(const std::string& name) const {
    return {.environment = {{"MIRRORBALL_CACHE", path(name).string()},
                            {"MESA_SHADER_CACHE_DIR", path(name + "-driver").string()},
                            {"MESA_SHADER_CACHE_DISABLE", "false"}}};
  }

  /// The files that are there of both.
  std::set<std::string> keptIn(const std::string& name) const {
    std::set<std::string> kept;
    for (const std::string& folder : {name, name + "-driver"})
      if (fs::exists(path(folder)))
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path(folder)))
          if (entry.is_regular_file()) kept.insert(fs::relative(entry.path(), path("")).string());
    return kept;
  }
};

TEST_F(DriverCacheCliTest, ShowTellsOfItAndClearLeavesIt) {
  using ::testing::HasSubstr;
  Start how = withBoth("cache");
  succeed("render sphere -e map.exr --material rough-metal --size 8x8 -o metal.exr", how);
  const std::set<std::string> kept = keptIn("cache");
  const std::string folder = (path("cache-driver") / "mesa_shader_cache").string();
  const std::string shown = succeed("cache", how);
  EXPECT_THAT(shown, HasSubstr("\nfolder       " + folder));
  EXPECT_THAT(shown, HasSubstr("is           on (MESA_SHADER_CACHE_DISABLE)"));
  EXPECT_THAT(shown, HasSubstr("holds        " + std::to_string(kept.size() - 2) + " files, ")) << "without our 2";
  EXPECT_THAT(shown, HasSubstr("compiled shaders"));
  succeed("cache clear", how);
  EXPECT_EQ(keptIn("cache").size(), kept.size() - 2);
  how.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  EXPECT_THAT(succeed("cache", how), HasSubstr("is           off (MESA_SHADER_CACHE_DISABLE)"));
}

TEST_F(DriverCacheCliTest, AfterWarmARenderHasNothingToCompileOrToPrepare) {
  for (const std::string line : {"sphere -e map.exr --material rough-metal --quality draft --size 256x128",
                                 "teapot -e map.exr --material glass --stand --quality good --size 320x180",
                                 "sphere -e map.exr --quality draft --samples 1 --size 64x64 --primaries rec2020",
                                 "sphere -e map.exr --quality draft --samples 1 --size 64x64 --gain-map",
                                 "sphere -e map.exr --probes 1 --quality draft --samples 1 --size 320x240"}) {
    for (const char* name : {"cold", "warm"})
      for (const char* of : {"", "-driver"}) fs::remove_all(path(name + std::string(of)));
    const std::string extension = line.ends_with("--gain-map") ? ".jpg" : ".png";
    succeed("render " + line + " --quiet -o cold" + extension, withBoth("cold"));
    EXPECT_GT(keptIn("cold").size(), 5u) << "else nothing is compared: " << line;
    EXPECT_EQ(succeed("cache warm " + line + " --quiet", withBoth("warm")), "");
    const std::set<std::string> prepared = keptIn("warm");
    succeed("render " + line + " --quiet -o warm" + extension, withBoth("warm"));
    EXPECT_EQ(keptIn("warm"), prepared) << line;
    EXPECT_TRUE(bytes("warm" + extension) == bytes("cold" + extension)) << line;
  }
}

// Several threads compile a frame's programs, each with a context of its own; where the driver keeps none, one does.
TEST_F(DriverCacheCliTest, APictureIsTheSameForAnyNumberOfThreadsThatCompile) {
  const std::string line = "render -e map.exr --quality draft --size 64x36 --quiet --threads ";
  succeed(line + "1 -o one.png", withBoth("one"));
  succeed(line + "4 -o four.png", withBoth("four"));
  Start how = withBoth("none");
  how.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  succeed(line + "4 -o none.png", how);
  EXPECT_TRUE(bytes("four.png") == bytes("one.png"));
  EXPECT_TRUE(bytes("none.png") == bytes("one.png"));
}

TEST_F(DriverCacheCliTest, WarmTellsOfEachModelAndWritesNoPicture) {
  const std::vector<std::string> before = files();
  EXPECT_EQ(succeed("cache warm sphere cube -e map.exr --quality draft --size 64x64", withBoth("probe")),
            "ready        sphere\nready        cube\n");
  for (const std::string& name : files())
    EXPECT_TRUE(name.starts_with("probe") || std::ranges::find(before, name) != before.end()) << name;
  Start how = withBoth("probe");
  how.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  EXPECT_THAT(run("cache warm sphere -e map.exr --quality draft --size 8x8", how).err,
              ::testing::HasSubstr("note: the driver's cache is off (MESA_SHADER_CACHE_DISABLE)"));
}

TEST_F(CacheCliTest, WhatWarmTakesIsForWarmAlone) {
  using ::testing::HasSubstr;
  EXPECT_THAT(refuse(2, "cache show teapot"), HasSubstr("'teapot' is for `cache warm`"));
  EXPECT_THAT(refuse(2, "cache clear --env studio"), HasSubstr("--env is for `cache warm`"));
  EXPECT_THAT(refuse(2, "cache warm teapot --no-cache"), HasSubstr("--no-cache leaves the cache as it is"));
  EXPECT_THAT(refuse(1, "cache warm missing.glb"), HasSubstr("missing.glb: no such file"));
}

TEST_F(CacheCliTest, BakeNeitherReadsNorFillsIt) {
  write("map.exr", smoothPanorama());
  const std::string bake = "bake map.exr --size 32 --irradiance-size 8 --brdf-size 8 -o ";
  succeed(bake + "before", withCache("unused"));
  EXPECT_FALSE(fs::exists(path("unused")));
  drawMetal();
  makeRed("cache");
  const std::map<std::string, Bytes> cached = filesOf("cache");
  succeed(bake + "after", withCache("cache"));
  EXPECT_EQ(filesOf("after"), filesOf("before"));
  EXPECT_EQ(filesOf("cache"), cached);
}

}  // namespace
}  // namespace mirrorball::testing
