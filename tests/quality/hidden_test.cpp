// The scenes of hidden_scenes.h: how near `good` draws them to their references, beside what is recorded, and whether
// the path tracer still makes those references. After a change `hidden_light measure` and `hidden_light page` record
// the new numbers, and `hidden_light trace` with `hidden_light one-bounce` the references.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/gl/gl_testing.h"
#include "quality/hidden_figures.h"
#include "quality/hidden_scenes.h"
#include "quality/number_table.h"

namespace mirrorball::quality {
namespace {

/// What another driver's filtering may add.
constexpr double kMore = 1.03, kMoreOfWhite = 0.0005;

std::vector<HiddenScene> oftenMeasured() {
  std::vector<HiddenScene> chosen;
  std::copy_if(hiddenScenes().begin(), hiddenScenes().end(), std::back_inserter(chosen),
               [](const HiddenScene& scene) { return scene.is_measured_often; });
  return chosen;
}

std::string nameOfScene(const ::testing::TestParamInfo<HiddenScene>& tested) { return tested.param.name; }

bool isWorse(double now, double recorded) { return now > kMore * recorded + kMoreOfWhite; }

TEST(HiddenTables, HaveAllScenesAndNoMore) {
  std::set<std::string> names;
  for (const HiddenScene& scene : hiddenScenes())
    EXPECT_TRUE(names.insert(scene.name).second) << "two scenes are called " << scene.name;
  const auto expectNames = [&](const std::filesystem::path& file, std::size_t columns) {
    const auto table = readNumberTable(file, columns);
    ASSERT_TRUE(table) << table.error().message;
    std::set<std::string> rows;
    for (const auto& row : *table) rows.insert(row.first);
    EXPECT_EQ(rows, names) << file;
  };
  expectNames(referenceTablePath(), kReferenceColumns);
  expectNames(figureTablePath(), kFigureColumns);
  expectNames(firstFigureTablePath(), kFigureColumns);
}

TEST(HiddenTables, HaveAPictureForEachSceneAndAllAreSmall) {
  std::set<std::string> wanted, there;
  for (const HiddenScene& scene : hiddenScenes()) wanted.insert(referencePath(scene.name).filename());
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(referencePath("any").parent_path())) {
    there.insert(entry.path().filename());
    bytes += entry.file_size();
  }
  EXPECT_EQ(there, wanted);
  EXPECT_LE(bytes, 2'000'000u) << "every clone carries these pictures, and every version of them";
}

TEST(NumberTable, IsReadAsItIsWritten) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "number_table.txt";
  ASSERT_TRUE(writeText(file, "# a comment\nold\t1\t2\n"));
  ASSERT_TRUE(writeNumberTable(file, {{"b", {0.5, 0.25}}, {"a", {1.0, 0.00004}}}));
  EXPECT_EQ(*readText(file), "# a comment\na\t1.0000\t0.0000\nb\t0.5000\t0.2500\n");
  EXPECT_EQ(*readNumberTable(file, 2), (NumberTable{{"a", {1.0, 0.0}}, {"b", {0.5, 0.25}}}));
  EXPECT_FALSE(readNumberTable(file, 3));
  ASSERT_TRUE(writeText(file, "a\t1\ttwo\n"));
  EXPECT_FALSE(readNumberTable(file, 2));
}

TEST(NoiseOfReference, IsWhatIsPrinted) {
  EXPECT_DOUBLE_EQ(*parseNoise("1024 paths a pixel, standard error at most 0.0031 of white\n"), 0.0031);
  EXPECT_FALSE(parseNoise("standard error at most much"));
  EXPECT_FALSE(parseNoise(""));
}

/// The figures of a scene that are recorded, and those of a picture of it now.
struct Compared {
  std::vector<double> recorded;
  PictureError now;
};

void compare(const HiddenScene& scene, const std::string& how, Compared& compared) {
  const auto table = readNumberTable(figureTablePath(), kFigureColumns);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_TRUE(table->contains(scene.name));
  const auto reference = readReference(scene.name);
  ASSERT_TRUE(reference) << reference.error().message;
  const auto drawn = makePicture(scene, how);
  ASSERT_TRUE(drawn) << drawn.error().message;
  const auto error = findError(drawn->image, *reference);
  ASSERT_TRUE(error) << error.error().message;
  compared = {table->at(scene.name), *error};
}

class HiddenLight : public ::testing::TestWithParam<HiddenScene> {};

TEST_P(HiddenLight, GoodIsNotFartherThanRecorded) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  Compared compared;
  ASSERT_NO_FATAL_FAILURE(compare(GetParam(), "--quality good", compared));
  const double flip = compared.recorded[kGoodFlip], rmse = compared.recorded[kGoodRmse];
  EXPECT_FALSE(isWorse(compared.now.flip, flip)) << "FLIP " << compared.now.flip << ", recorded " << flip;
  EXPECT_FALSE(isWorse(compared.now.rmse, rmse)) << "RMSE " << compared.now.rmse << ", recorded " << rmse;
  if (isWorse(flip, compared.now.flip) && isWorse(rmse, compared.now.rmse))
    std::printf("nearer than recorded: `hidden_light measure %s` guards it better\n", GetParam().name);
}
INSTANTIATE_TEST_SUITE_P(Some, HiddenLight, ::testing::ValuesIn(oftenMeasured()), nameOfScene);
INSTANTIATE_TEST_SUITE_P(Every, HiddenLight, ::testing::ValuesIn(hiddenScenes().begin(), hiddenScenes().end()),
                         nameOfScene);

// A picture from another side, and one without what objects hide, are found to be farther.
TEST(WorseHiddenLight, IsFound) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  const HiddenScene& scene = hiddenSceneNamed("fine_balls");
  for (const char* how : {"--quality good --env-rotation 20", "--quality draft"}) {
    Compared compared;
    ASSERT_NO_FATAL_FAILURE(compare(scene, how, compared));
    EXPECT_TRUE(isWorse(compared.now.flip, compared.recorded[kGoodFlip])) << how;
    EXPECT_TRUE(isWorse(compared.now.rmse, compared.recorded[kGoodRmse])) << how;
  }
}

/// The root of the mean square of the difference of two pictures, each of whose 8 × 8 pixels have become one: sRGB,
/// 0 to 1.
double compareBlocks(const Image& a, const Image& b) {
  constexpr int kBlock = 8;
  const Image8 codes_a = pictureFromLinear(a, 3), codes_b = pictureFromLinear(b, 3);
  double squares = 0.0;
  int blocks = 0;
  for (int top = 0; top + kBlock <= codes_a.height(); top += kBlock)
    for (int left = 0; left + kBlock <= codes_a.width(); left += kBlock)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (int y = top; y < top + kBlock; ++y)
          for (int x = left; x < left + kBlock; ++x) sum += codes_a.texel(x, y)[channel] - codes_b.texel(x, y)[channel];
        const double mean = sum / (255.0 * kBlock * kBlock);
        squares += mean * mean;
        ++blocks;
      }
  return std::sqrt(squares / blocks);
}

/// How far a picture that is traced by few paths is from the kept reference of a scene, in the noise that both together
/// have in blocks of 64 pixels, where an eighth is left of it.
void traceAnew(const HiddenScene& scene, const std::string& changed, double& noises) {
  constexpr int kPaths = 64;
  const auto table = readNumberTable(referenceTablePath(), kReferenceColumns);
  ASSERT_TRUE(table) << table.error().message;
  ASSERT_TRUE(table->contains(scene.name));
  const auto kept = readReference(scene.name);
  ASSERT_TRUE(kept) << kept.error().message;
  const auto now = makePicture(scene, tracedBy(kPaths) + changed);
  ASSERT_TRUE(now) << now.error().message;
  const std::vector<double>& row = table->at(scene.name);
  const double noise = row[kNoiseColumn] * std::sqrt(1.0 + row[kPathsColumn] / kPaths) / 8.0;
  noises = compareBlocks(now->image, *kept) / noise;
}

constexpr double kMostNoises = 2.5;

class HiddenReference : public ::testing::TestWithParam<HiddenScene> {};

TEST_P(HiddenReference, IsStillTraced) {
  double noises = 0.0;
  ASSERT_NO_FATAL_FAILURE(traceAnew(GetParam(), "", noises));
  EXPECT_LT(noises, kMostNoises) << "the kept reference is another picture: `hidden_light trace " << GetParam().name
                                 << "`";
}
INSTANTIATE_TEST_SUITE_P(Every, HiddenReference, ::testing::ValuesIn(hiddenScenes().begin(), hiddenScenes().end()),
                         nameOfScene);

TEST(StaleHiddenReference, IsFound) {
  double noises = 0.0;
  ASSERT_NO_FATAL_FAILURE(traceAnew(hiddenSceneNamed("sheet_down"), " --env-intensity 1.05", noises));
  EXPECT_GT(noises, kMostNoises);
}

}  // namespace
}  // namespace mirrorball::quality
