#include "mirrorball/output/baked/lobe_row_files.h"

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "formula/bsdf.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/zstandard.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/image/small_float.h"
#include "mirrorball/output/baked/baked_set.h"
#include "mirrorball/output/output_testing.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr int kSize = formula::kLobeRowSize;

class LobeRowFilesTest : public testing::InFolder {
 protected:
  static BakedSetSettings small() { return {.size = 8, .irradiance_size = 4, .brdf_size = 4}; }

  Result<SavedMap> save(const BakedSetSettings& settings, const std::string& output = "set") const {
    LoadedEnvironment light{.environment = Environment(testing::smoothRadiance, 32)};
    light.name = "room.hdr";
    return saveBakedSet(path(output), std::move(light), settings);
  }

  std::string errorOf(const BakedSetSettings& settings) const {
    const auto set = BakedSet::resolve(path("set"), settings);
    return set ? std::string("resolved") : set.error().message;
  }

  Json json(const std::string& name) const {
    const auto text = readFile(path(name));
    return text ? Json::parse(text->begin(), text->end()) : Json();
  }

  bool hasRows() const {
    const bool has_texture = std::filesystem::exists(path("set/lobe_rows.ktx2"));
    EXPECT_EQ(std::filesystem::exists(path("set/lobe_rows.json")), has_texture);
    EXPECT_EQ(json("set/manifest.json").contains("lobe_rows"), has_texture);
    return has_texture;
  }

  /// Whether both files hold the program's own table of so many lobes.
  void expectTable(int lobes) const {
    SCOPED_TRACE(std::to_string(lobes) + " lobes");
    const Image table = *lobeRowTable(lobes);
    const auto texture = readImageSet(path("set/lobe_rows.ktx2"));
    ASSERT_TRUE(texture) << texture.error().message;
    const Image& found = texture->images.at(0, 0);
    const Json text = json("set/lobe_rows.json");
    ASSERT_EQ(found.width(), lobes * kSize);
    ASSERT_EQ(found.height(), kSize);
    ASSERT_EQ(text["rows"].size(), std::size_t(lobes));
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < found.width(); ++x)
        for (int c = 0; c < 4; ++c) {
          const std::uint16_t half = halfFromFloat(table.texel(x, y)[c]);
          ASSERT_EQ(halfFromFloat(found.texel(x, y)[c]), half) << x << ", " << y << ", " << c;
          const float number =
              text["rows"][std::size_t(x / kSize)][std::size_t(y)][std::size_t(x % kSize)][std::size_t(c)];
          ASSERT_EQ(halfFromFloat(number), half) << x << ", " << y << ", " << c;
        }
  }
};

TEST_F(LobeRowFilesTest, HoldTheTableBitForBit) {
  for (const int lobes : {2, 4, 6}) {
    BakedSetSettings settings = small();
    settings.lobe_rows = lobes;
    const auto saved = save(settings);
    ASSERT_TRUE(saved) << saved.error().message;
    expectTable(lobes);
  }
}

TEST_F(LobeRowFilesTest, OfAGgxSetHaveFourLobesUnlessAskedFor) {
  const auto saved = save(small());
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_THAT(saved->paths, Contains(path("set/lobe_rows.ktx2")));
  EXPECT_THAT(saved->paths, Contains(path("set/lobe_rows.json")));
  expectTable(4);
}

TEST_F(LobeRowFilesTest, AreStoredAsTheOtherTextures) {
  MIRRORBALL_NEEDS(checkZstandard());
  BakedSetSettings settings = small();
  settings.file.zstandard_level = 9;
  settings.file.format = TexelFormat::float32;
  ASSERT_TRUE(save(settings));
  EXPECT_EQ(readImageSet(path("set/lobe_rows.ktx2"))->format, "KTX2, r16g16b16a16 sfloat, Zstandard");
  expectTable(4);
}

TEST_F(LobeRowFilesTest, AndTheManifestSayWhatTheyAre) {
  ASSERT_TRUE(save(small()));
  const Json manifest = json("set/manifest.json")["lobe_rows"];
  EXPECT_EQ(manifest["file"], "lobe_rows.ktx2");
  EXPECT_EQ(manifest["json"], "lobe_rows.json");
  EXPECT_EQ(manifest["format"], "r16g16b16a16 sfloat");
  const Json text = json("set/lobe_rows.json");
  for (const Json& said : {manifest, text}) {
    EXPECT_EQ(said["distribution"], "ggx");
    EXPECT_EQ(said["lobes"], 4);
    EXPECT_EQ(said["size"], kSize);
    EXPECT_EQ(said["channels"].size(), 4u);
    EXPECT_THAT(said["axes"].get<std::string>(), HasSubstr("sqrt(n.v) to the right"));
  }
  const Metadata metadata = readImageSet(path("set/lobe_rows.ktx2"))->metadata;
  EXPECT_EQ(metadata.at("mirrorball:table"), "lobe rows");
  EXPECT_EQ(metadata.at("mirrorball:lobe_rows_lobes"), "4");
  EXPECT_EQ(metadata.at("mirrorball:lobe_rows_distribution"), "ggx");
}

TEST_F(LobeRowFilesTest, AreKnownByWhatTheFileSays) {
  BakedSetSettings settings = small();
  settings.lobe_rows = 6;
  ASSERT_TRUE(save(settings));
  const auto rows = lobeRowsIn(path("set/lobe_rows.ktx2"));
  ASSERT_TRUE(rows && *rows);
  EXPECT_EQ((*rows)->lobes, 6);
  EXPECT_EQ((*rows)->size, glm::ivec2(6 * kSize, kSize));
  for (const std::string other : {"set/brdf.ktx2", "set/specular.ktx2", "set/missing.ktx2"}) {
    const auto none = lobeRowsIn(path(other));
    EXPECT_TRUE(none && !*none) << other;
  }
}

// A set without rows takes those of an older one away.
TEST_F(LobeRowFilesTest, AreNotThereWhereNobodyWantsThem) {
  BakedSetSettings none = small();
  none.lobe_rows = 0;
  BakedSetSettings phong = small();
  phong.distribution = Distribution::phong;
  for (const BakedSetSettings& settings : {none, phong}) {
    ASSERT_TRUE(save(small()));
    EXPECT_TRUE(hasRows());
    ASSERT_TRUE(save(settings));
    EXPECT_FALSE(hasRows());
  }
  BakedSetSettings filament = small();
  filament.file.program = "filament";
  ASSERT_TRUE(save(filament));
  EXPECT_FALSE(hasRows());
  const auto chain = save(small(), "chain.ktx2");
  ASSERT_TRUE(chain);
  EXPECT_EQ(chain->paths.size(), 1u);
}

TEST_F(LobeRowFilesTest, ThatAreNotKnownAreRefused) {
  BakedSetSettings settings = small();
  settings.lobe_rows = 3;
  EXPECT_EQ(errorOf(settings), "rows have 2, 4 or 6 lobes, or 0 for no such table, not 3");
  settings.lobe_rows = 2;
  EXPECT_EQ(errorOf(settings), "resolved");
  for (const auto& [distribution, name] :
       {std::pair(Distribution::phong, "phong"), std::pair(Distribution::blinn, "blinn"),
        std::pair(Distribution::charlie, "charlie")}) {
    settings.distribution = distribution;
    EXPECT_EQ(errorOf(settings),
              std::string("rows of lobes are known for ggx only, not for ") + name + "; ask for none");
  }
  settings.lobe_rows = 0;
  EXPECT_EQ(errorOf(settings), "resolved");
}

}  // namespace
}  // namespace mirrorball
