// What `render` keeps in the user's cache folder and takes from there: prefiltered environments, which `bake` never
// does, and the occlusion of models.

#include <chrono>
#include <filesystem>
#include <map>
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
  EXPECT_THAT(refuse(2, "cache empty", withCache("cache")), HasSubstr("show, clear"));
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
