// The maps that an engine loads, from one environment.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "mirrorball/bake/prefilter/prefilter_testing.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class BakeTest : public CliTest {};

TEST_F(BakeTest, AFolderHasAllThatAnEngineLoads) {
  write("map.exr", smoothPanorama());
  succeed("bake map.exr -o out --size 32 --irradiance-size 8 --brdf-size 16");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path("out"))) names.push_back(entry.path().filename());
  std::ranges::sort(names);
  EXPECT_THAT(names, ElementsAre("brdf.ktx2", "irradiance.ktx2", "lobe_rows.json", "lobe_rows.ktx2", "manifest.json",
                                 "sh.h", "sh.json", "specular.ktx2"));

  const ImageSet specular = texture("out/specular.ktx2");
  ASSERT_EQ(specular.faces(), 6);
  ASSERT_EQ(specular.levels(), 4);
  EXPECT_EQ(specular.at(0, 0).width(), 32);
  EXPECT_EQ(specular.at(3, 5).width(), 4);
  EXPECT_EQ(texture("out/irradiance.ktx2").at(0, 0).width(), 8);
  EXPECT_EQ(texture("out/brdf.ktx2").at(0, 0).width(), 16);
}

TEST_F(BakeTest, ThePublishedSumIsInTheFiles) {
  write("map.exr", smoothPanorama());
  succeed("bake map.exr -o out --size 32 --format float32");
  const LoadedEnvironment map = environment("map.exr");
  const EnvironmentMap panorama = *convert(map.environment, Projection::equirect, 128);
  const ImageSet specular = texture("out/specular.ktx2");
  const ImageSet irradiance = texture("out/irradiance.ktx2");
  const nlohmann::json manifest = jsonIn("out/manifest.json");
  for (int level = 1; level < specular.levels(); ++level) {
    const double roughness = manifest["specular"]["levels"][std::size_t(level)]["perceptual_roughness"];
    const int size = specular.at(level, 0).width();
    for (int face = 0; face < 6; ++face) {
      const glm::vec3 direction = directionAt(Projection::cube, {face, glm::vec2(1.5f, 0.5f) / float(size)});
      const glm::dvec3 truth = meanOfTexels(panorama, ggxKernel(roughness), direction);
      // The file's map is laid out once more for the truth.
      EXPECT_LT(glm::distance(glm::dvec3(rgbAt(specular.at(level, face), 1, 0)), truth), 2e-3 * glm::length(truth));
    }
  }
  const auto cosine = [](double s) { return std::max(1.0 - 2.0 * s, 0.0); };
  for (int face = 0; face < 6; ++face) {
    const int size = irradiance.at(0, 0).width();
    const glm::vec3 direction = directionAt(Projection::cube, {face, glm::vec2(1.5f, 0.5f) / float(size)});
    const glm::dvec3 truth = meanOfTexels(panorama, cosine, direction);
    EXPECT_LT(glm::distance(glm::dvec3(rgbAt(irradiance.at(0, face), 1, 0)), truth), 1e-3 * glm::length(truth));
  }
}

TEST_F(BakeTest, TheManifestSaysWhatIsWhat) {
  succeed("bake sky -o out --size 16 --mip-mapping frostbite --distribution charlie --brdf-size 8 --sh-degree 4");
  const nlohmann::json manifest = jsonIn("out/manifest.json");
  EXPECT_EQ(manifest["source"], "sky");
  EXPECT_EQ(manifest["specular"]["file"], "specular.ktx2");
  EXPECT_EQ(manifest["specular"]["mip_mapping"], "frostbite");
  EXPECT_EQ(manifest["specular"]["look_up"], "lod = M sqrt(r), r the perceptual roughness, M = 2");
  EXPECT_EQ(manifest["specular"]["distribution"], "charlie");
  EXPECT_EQ(manifest["specular"]["levels"].size(), 3u);
  EXPECT_EQ(manifest["specular"]["levels"][0]["perceptual_roughness"], 0.0);
  EXPECT_EQ(manifest["specular"]["levels"][2]["perceptual_roughness"], 1.0);
  EXPECT_EQ(manifest["brdf"]["size"], 8);
  EXPECT_EQ(manifest["harmonics"]["degree"], 4);
  EXPECT_EQ(jsonIn("out/sh.json")["radiance"].size(), 25u);
}

// ∫ 1 · Y00 = √4π, irradiance π.
TEST_F(BakeTest, HarmonicsOfWhiteHaveOneCoefficient) {
  succeed("bake white -o out --size 8 --brdf-size 8");
  const nlohmann::json harmonics = jsonIn("out/sh.json");
  EXPECT_NEAR(harmonics["radiance"][0][0].get<double>(), std::sqrt(4.0 * std::numbers::pi), 1e-4);
  EXPECT_NEAR(harmonics["irradiance"][0][1].get<double>() * std::sqrt(1.0 / (4.0 * std::numbers::pi)), std::numbers::pi,
              1e-4);
  for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(harmonics["radiance"][i][0].get<double>(), 0.0, 3e-4);
  const Bytes header = bytes("out/sh.h");
  EXPECT_THAT(std::string(header.begin(), header.end()), HasSubstr("static const float mirrorball_radiance[9][3] = {"));
}

TEST_F(BakeTest, AFileHoldsTheChainOnly) {
  write("map.exr", smoothPanorama());
  for (const std::string name : {"chain.ktx2", "chain.dds"}) {
    succeed("bake map.exr --size 16 -o " + name);
    EXPECT_EQ(texture(name).levels(), 3) << name;
  }
  EXPECT_THAT(files(), ElementsAre("chain.dds", "chain.ktx2", "map.exr"));
}

TEST_F(BakeTest, PresetsTurnTheFacesOfEveryLevel) {
  succeed("bake uv --size 16 -o ours.ktx2 --format float32");
  succeed("bake uv --size 16 -o seen.ktx2 --format float32 --as-seen");
  const ImageSet ours = texture("ours.ktx2");
  const ImageSet seen = texture("seen.ktx2");
  for (int level = 0; level < ours.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      for (int x = 0; x < ours.at(level, face).width(); ++x)
        EXPECT_EQ(rgbAt(seen.at(level, face), ours.at(level, face).width() - 1 - x, 1),
                  rgbAt(ours.at(level, face), x, 1));
}

TEST_F(BakeTest, TheWayRoundIsTheEnvironments) {
  succeed("bake uv --size 32 -o chain.ktx2");
  const ImageSet chain = texture("chain.ktx2");
  // uv is red, green and blue towards +X, +Y and +Z.
  for (int level = 0; level < chain.levels(); ++level) {
    EXPECT_GT(texelTowards(chain, level, {1, 0, 0}).x, texelTowards(chain, level, {-1, 0, 0}).x) << level;
    EXPECT_GT(texelTowards(chain, level, {0, 1, 0}).y, texelTowards(chain, level, {0, -1, 0}).y) << level;
    EXPECT_GT(texelTowards(chain, level, {0, 0, 1}).z, texelTowards(chain, level, {0, 0, -1}).z) << level;
  }
}

TEST_F(BakeTest, ASunThatHalfFloatsDoNotHoldIsKeptAndTold) {
  Image map(64, 32, 3, 0.5f);
  for (int c = 0; c < 3; ++c) map.texel(20, 10)[c] = 3e6f;
  write("sun.exr", map);
  const Outcome outcome = run("bake sun.exr --size 64 -o chain.ktx2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("32-bit floats"));
  float max = 0.0f;
  const ImageSet chain = texture("chain.ktx2");
  for (int face = 0; face < 6; ++face)
    for (const float sample : chain.at(0, face).samples()) max = std::max(max, sample);
  EXPECT_GT(max, 65504.0f);
}

TEST_F(BakeTest, NegativeLightIsTakenAsDarkAndTold) {
  Image map(64, 32, 3, 0.5f);
  map.texel(3, 3)[1] = -100.0f;
  write("negative.exr", map);
  const Outcome outcome = run("bake negative.exr --size 16 -o chain.ktx2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("negative.exr: 1 value is negative"), HasSubstr("taken as 0")));
  const ImageSet chain = texture("chain.ktx2");
  for (int level = 0; level < chain.levels(); ++level)
    for (int face = 0; face < 6; ++face)
      for (const float sample : chain.at(level, face).samples()) EXPECT_GE(sample, 0.0f);
}

TEST_F(BakeTest, TooDarkForHalfFloatsIsTold) {
  Image map(64, 32, 3, 1e-6f);
  map.texel(3, 3)[1] = 1.0f;
  write("dark.exr", map);
  const Outcome outcome = run("bake dark.exr --size 16 -o chain.ktx2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("dark.exr: is so dark that half floats hold few of its digits; --format float32"));
  EXPECT_EQ(run("bake dark.exr --size 16 --format float32 -o chain.ktx2").err.find("so dark"), std::string::npos);
}

// A manifest is JSON, which is UTF-8.
TEST_F(BakeTest, ANameThatIsNotUtf8IsTold) {
  write("caf\xe9.exr", smoothPanorama());
  succeed("bake caf\xe9.exr --size 8 --brdf-size 8 -o out");
  EXPECT_THAT(std::string(jsonIn("out/manifest.json")["source"]), HasSubstr("caf"));
}

TEST_F(BakeTest, BadTexelsAreRefusedUnlessRepaired) {
  Image map(64, 32, 3, 0.5f);
  map.texel(5, 6)[0] = std::numeric_limits<float>::quiet_NaN();
  write("bad.exr", map);
  EXPECT_THAT(refuse(1, "bake bad.exr -o out"),
              AllOf(HasSubstr("bad.exr"), HasSubstr("(5, 6)"), HasSubstr("--repair")));
  succeed("bake bad.exr --repair --size 8 --brdf-size 8 -o out");
}

TEST_F(BakeTest, ABlackMapAndOneOfTwoTexelsAreBaked) {
  write("black.exr", Image(64, 32, 3, 0.0f));
  write("two.exr", Image(2, 1, 3, 0.25f));
  succeed("bake black.exr --size 16 -o black.ktx2");
  succeed("bake two.exr --size 16 -o two.ktx2");
  const ImageSet black = texture("black.ktx2");
  const ImageSet two = texture("two.ktx2");
  for (int level = 0; level < 3; ++level) {
    EXPECT_EQ(rgbAt(black.at(level, 2), 1, 1).x, 0.0f);
    EXPECT_NEAR(rgbAt(two.at(level, 2), 1, 1).x, 0.25f, 2e-4f);
  }
}

TEST_F(BakeTest, LightThatCannotBeSummedIsRefused) {
  write("bright.exr", Image(64, 32, 3, 1e38f));
  EXPECT_THAT(refuse(1, "bake bright.exr --size 16 -o out"), AllOf(HasSubstr("bright.exr"), HasSubstr("too bright")));
  write("bright.exr", Image(64, 32, 3, 1e35f));
  run("bake bright.exr --size 16 --brdf-size 8 -o out");  // says that half floats do not hold it
  const ImageSet irradiance = texture("out/irradiance.ktx2");
  EXPECT_NEAR(rgbAt(irradiance.at(0, 2), 1, 1).x, 1e35f, 1e31f);
  EXPECT_TRUE(jsonIn("out/sh.json")["irradiance"][0][0].is_number());
}

TEST_F(BakeTest, NoFileOfASetOverwritesTheInput) {
  write("map.exr", smoothPanorama());
  std::filesystem::create_directory(path("out"));
  for (const std::string name : {"sh.json", "sh.h", "lobe_rows.json", "manifest.json"}) {
    std::filesystem::copy_file(path("map.exr"), path("out/" + name));
    EXPECT_THAT(refuse(2, "bake out/" + name + " --size 8 --brdf-size 8 -o out"), HasSubstr("is the input itself"));
    std::filesystem::remove(path("out/" + name));
  }
}

TEST_F(BakeTest, WrongWishesAreToldBeforeAnythingIsMade) {
  write("map.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "bake map.exr"), HasSubstr("-o FOLDER"));
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.exr"), AllOf(HasSubstr("chain.exr"), HasSubstr(".ktx2")));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --extension png"), HasSubstr("ktx2"));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --distribution beckmann"), HasSubstr("charlie"));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --sh-degree 7"), HasSubstr("sh-degree"));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --distribution charlie --brdf-axes warped"), HasSubstr("charlie"));
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.ktx2 --brdf-size 64"), HasSubstr("--brdf-size"));
  EXPECT_THAT(refuse(2, "bake map.exr -o chain.ktx2 --lobe-rows 4"), HasSubstr("--lobe-rows"));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --lobe-rows 3"), HasSubstr("--lobe-rows"));
  EXPECT_THAT(refuse(2, "bake map.exr -o out --lobe-rows 4 --distribution charlie"),
              HasSubstr("rows of lobes are known for ggx only, not for charlie"));
  write("file", "not a folder");
  EXPECT_THAT(refuse(2, "bake map.exr -o file"), HasSubstr("is a file"));
  EXPECT_THAT(refuse(1, "bake missing.exr -o out"), HasSubstr("missing.exr"));
  EXPECT_THAT(refuse(1, "bake map.exr -o missing/chain.ktx2"), HasSubstr("missing/chain.ktx2"));
}

TEST_F(BakeTest, TwoRunsGiveTheSameBytes) {
  write("map.exr", smoothPanorama());
  succeed("bake map.exr --size 32 -o a.ktx2");
  succeed("bake map.exr --size 32 -o b.ktx2", {.cores = 1});
  EXPECT_EQ(bytes("a.ktx2"), bytes("b.ktx2"));
}

}  // namespace
}  // namespace mirrorball::testing
