#include "mirrorball/output/baked/baked_set.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/output/output_testing.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

class BakedSetTest : public testing::InFolder {
 protected:
  static LoadedEnvironment light() {
    LoadedEnvironment loaded{.environment = Environment(testing::smoothRadiance, 32)};
    loaded.name = "room.hdr";
    return loaded;
  }
  static BakedSetSettings small() { return {.size = 16, .irradiance_size = 4, .brdf_size = 4}; }
};

TEST_F(BakedSetTest, AFolderHasTheMapsOfTheEngine) {
  const auto saved = saveBakedSet(path("set"), light(), small());
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_THAT(saved->remarks, IsEmpty());
  EXPECT_THAT(saved->paths,
              UnorderedElementsAre(path("set/specular.ktx2"), path("set/irradiance.ktx2"), path("set/brdf.ktx2"),
                                   path("set/lobe_rows.ktx2"), path("set/lobe_rows.json"), path("set/sh.json"),
                                   path("set/sh.h"), path("set/manifest.json")));
  for (const std::string& file : saved->paths) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  const auto specular = loadEnvironment(path("set/specular.ktx2"));
  ASSERT_TRUE(specular);
  EXPECT_EQ(specular->levels, 3);
}

TEST_F(BakedSetTest, ATextureHoldsTheChainAlone) {
  const auto saved = saveBakedSet(path("chain.ktx2"), light(), small());
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_THAT(saved->paths, ElementsAre(path("chain.ktx2")));
  EXPECT_TRUE(std::filesystem::exists(path("chain.ktx2")));
}

// `--only` refuses options of parts that it leaves out: a new option belongs to parts, or to those of the whole set.
TEST_F(BakedSetTest, OptionsDescribePartsOrTheWholeSet) {
  std::vector<std::string_view> of_all;
  const auto add = [&](std::string_view name) {
    if (partsDescribedBy(name).empty()) of_all.push_back(name);
  };
  for (const auto& option : bakedSetOptions()) add(option.text.name);
  for (const auto& option : textureFileOptions()) add(option.text.name);
  for (const char* const name : {"rotate", "min-share", "max-size"}) add(name);
  EXPECT_THAT(of_all, ElementsAre("only", "for"));
  EXPECT_THAT(partsDescribedBy("size"), ElementsAre(BakedPart::specular));
  EXPECT_THAT(partsDescribedBy("clamp-light"), Not(Contains(BakedPart::brdf)));
}

TEST_F(BakedSetTest, OtherPrimariesThanRec709AreRefused) {
  BakedSetSettings settings = small();
  settings.file.primaries = OutputPrimaries::acescg;
  const auto saved = saveBakedSet(path("set"), light(), settings);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::usage);
  EXPECT_THAT(saved.error().message, HasSubstr("baked maps have Rec.709's primaries"));
  EXPECT_FALSE(std::filesystem::exists(path("set")));
}

// No other format says that its texels lie on OpenEXR's edges.
TEST_F(BakedSetTest, OpenexrGetsItsOwnFiles) {
  BakedSetSettings settings = small();
  settings.file.program = "openexr";
  const auto set = BakedSet::resolve(path("set"), settings);
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_THAT(set->paths(), IsSupersetOf({path("set/m0_+X.exr"), path("set/brdf.exr")}));
}

TEST_F(BakedSetTest, WhatTheReaderMissesIsARemark) {
  BakedSetSettings settings = small();
  settings.file.program = "unity";
  // 16² texels have five levels.
  for (const auto& [size, advice] : {std::pair(16, ""), std::pair(64, "7")}) {
    settings.size = size;
    const auto saved = saveBakedSet(path("set"), light(), settings);
    ASSERT_TRUE(saved) << saved.error().message;
    ASSERT_EQ(saved->remarks.size(), 1u);
    EXPECT_EQ(saved->remarks[0].kind, RemarkKind::levels_few);
    EXPECT_EQ(saved->remarks[0].detail, advice);
  }
}

TEST_F(BakedSetTest, NoLevelsAreAdvisedWhereThereAreNoMore) {
  BakedSetSettings settings = small();
  for (const auto& [size, advice] : {std::pair(1, ""), std::pair(4, "3")}) {
    settings.size = size;
    const auto saved = saveBakedSet(path("chain.ktx2"), light(), settings);
    ASSERT_TRUE(saved) << saved.error().message;
    ASSERT_EQ(saved->remarks.size(), 1u);
    EXPECT_EQ(saved->remarks[0].detail, advice) << size;
  }
}

// roughness² = 2^(i / 0.8) / 64 is 1 in level 4.8.
TEST_F(BakedSetTest, BabylonsMappingReachesRoughness1) {
  BakedSetSettings settings = small();
  settings.size = 64;
  settings.mip_mapping = MipMapping::babylon;
  const auto whole = saveBakedSet(path("chain.ktx2"), light(), settings);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_THAT(whole->remarks, IsEmpty());
  EXPECT_EQ(loadEnvironment(path("chain.ktx2"))->levels, 7);
  settings.levels = 5;
  const auto few = saveBakedSet(path("chain.ktx2"), light(), settings);
  ASSERT_TRUE(few) << few.error().message;
  ASSERT_EQ(few->remarks.size(), 1u);
  EXPECT_EQ(few->remarks[0].kind, RemarkKind::levels_few);
  EXPECT_EQ(few->remarks[0].detail, "6");
  settings.levels = 6;
  EXPECT_THAT(saveBakedSet(path("chain.ktx2"), light(), settings)->remarks, IsEmpty());
}

TEST_F(BakedSetTest, AProgramsOwnMappingLeavesItsOwnFile) {
  BakedSetSettings settings = small();
  settings.size = 32;
  for (const auto& [program, mapping, file] : {std::tuple("babylon", MipMapping::babylon, "set/environment.env"),
                                               std::tuple("playcanvas", MipMapping::linear, "set/environment.png"),
                                               std::tuple("three", MipMapping::filament, "set/brdf.ktx2")}) {
    settings.file.program = program;
    settings.mip_mapping = mapping;
    const auto set = BakedSet::resolve(path("set"), settings);
    ASSERT_TRUE(set) << set.error().message;
    EXPECT_THAT(set->paths(), IsSupersetOf({path(file)}));
  }
}

// The advice is 32-bit floats, which no PNG has.
TEST_F(BakedSetTest, DarkLightIsToldOfTexturesOnly) {
  BakedSetSettings settings = small();
  settings.size = 32;
  for (const auto& [program, remarks] :
       {std::pair("gltf", 0u), std::pair("playcanvas", 0u), std::pair("babylon", 1u)}) {
    settings.file.program = program;
    ImageSet images(1, 1);
    images.at(0, 0) = Image(8, 4, 3, 1e-7f);
    LoadedEnvironment dark{.environment = Environment(EnvironmentMap(Projection::equirect, std::move(images)))};
    const auto saved = saveBakedSet(path(program), std::move(dark), settings);
    ASSERT_TRUE(saved) << saved.error().message;
    EXPECT_EQ(saved->remarks.size(), remarks) << program;
  }
}

TEST_F(BakedSetTest, OnlyWhatIsReadIsBaked) {
  BakedSetSettings settings = small();
  settings.size = 32;
  for (const auto& [program, expected] :
       {std::pair("gltf", false), std::pair("three", false), std::pair("babylon", true)}) {
    settings.file.program = program;
    bool is_baked = false;
    Observer observer;
    observer.progress = [&is_baked](std::string_view stage) {
      if (stage == "irradiance") is_baked = true;
      return ProgressFunction();
    };
    ASSERT_TRUE(saveBakedSet(path(program), light(), settings, observer));
    EXPECT_EQ(is_baked, expected) << program;
  }
}

TEST_F(BakedSetTest, PackingStopsAndLeavesTheOlderSetWhole) {
  BakedSetSettings settings = small();
  settings.size = 32;
  settings.file.program = "babylon";
  const auto older = saveBakedSet(path("set"), light(), settings);
  ASSERT_TRUE(older) << older.error().message;
  Observer observer;
  observer.progress = [](std::string_view stage) -> ProgressFunction {
    return [is_packing = stage == "pack"](std::size_t done, std::size_t) { return !is_packing || done < 3; };
  };
  for (const std::string program : {"babylon", "playcanvas", "gltf"})
    for (const std::string output : {"set", program == "babylon" ? "x.env" : program == "gltf" ? "x.glb" : "x.png"}) {
      settings.file.program = program;
      const auto saved = saveBakedSet(path(output), light(), settings, observer);
      ASSERT_FALSE(saved) << output;
      EXPECT_EQ(saved.error().code, ErrorCode::interrupted);
      EXPECT_EQ(saved.error().message, "interrupted; nothing was written");
    }
  for (const std::string& file : older->paths) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_FALSE(std::filesystem::exists(path("x.env")));
}

TEST_F(BakedSetTest, NegativeLightIsTakenAsNoneAndTold) {
  ImageSet images(1, 1);
  images.at(0, 0) = Image(8, 4, 3);
  for (float& sample : images.at(0, 0).samples()) sample = 1.0f;
  images.at(0, 0).texel(2, 1)[1] = -1.0f;
  LoadedEnvironment loaded{.environment = Environment(EnvironmentMap(Projection::equirect, std::move(images)))};
  loaded.name = "sharp.exr";
  const auto saved = saveBakedSet(path("chain.ktx2"), std::move(loaded), small());
  ASSERT_TRUE(saved) << saved.error().message;
  ASSERT_EQ(saved->remarks.size(), 1u);
  EXPECT_EQ(saved->remarks[0].kind, RemarkKind::negative_raised);
  EXPECT_THAT(saved->remarks[0].message, HasSubstr("sharp.exr: 1 value is negative"));
}

TEST_F(BakedSetTest, AWorkThatIsStoppedLeavesNoNewFolder) {
  Observer observer;
  observer.progress = [](std::string_view stage) -> ProgressFunction {
    return [is_writing = stage == "write"](std::size_t done, std::size_t) { return !is_writing || done < 2; };
  };
  const auto saved = saveBakedSet(path("new/set"), light(), small(), observer);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::interrupted);
  EXPECT_FALSE(std::filesystem::exists(path("new")));
}

TEST_F(BakedSetTest, WhatCannotBeIsRefusedBeforeAnythingIsMade) {
  const auto errorOf = [&](const std::string& output, const BakedSetSettings& settings) {
    const auto set = BakedSet::resolve(output, settings);
    return set ? std::string("resolved") : set.error().message;
  };
  BakedSetSettings settings = small();
  settings.levels = 6;
  EXPECT_THAT(errorOf(path("set"), settings), HasSubstr("at most 5"));
  settings = small();
  settings.extension = "png";
  EXPECT_THAT(errorOf(path("set"), settings), HasSubstr("'png'"));
  settings.extension = "ktx2";
  settings.file.program = "filament";
  EXPECT_THAT(errorOf(path("set"), settings), HasSubstr("Filament reads .ktx, no .ktx2"));
  settings.extension = "";
  settings.file.format = TexelFormat::e5b9g9r9;
  EXPECT_THAT(errorOf(path("set"), settings), HasSubstr("Filament reads b10g11r11"));
  EXPECT_THAT(errorOf(path("chain.exr"), small()), HasSubstr("name a folder"));
  EXPECT_FALSE(std::filesystem::exists(path("set")));
}

}  // namespace
}  // namespace mirrorball
