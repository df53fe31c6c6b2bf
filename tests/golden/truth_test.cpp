// A golden picture is only yesterday's. So what the renderer draws of each case is compared with what the path tracer
// says too, where light does no more than an environment map can know of. The traced pictures are kept
// (tests/golden/truths); after a change of what they depend on one command traces them anew:
//
//     MIRRORBALL_UPDATE_TRUTHS=1 ./test --module golden

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "golden/cases.h"
#include "golden/golden_picture.h"
#include "golden/kept_truth.h"
#include "golden/made_picture.h"
#include "mirrorball/base/text.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::golden {
namespace {

std::future<Result<Image>> making(std::string command) {
  return std::async(std::launch::async, [command = std::move(command)] { return imageMadeBy(command); });
}

/// The picture as a mirror shows it.
Image leftIsRight(const Image& picture) {
  Image turned = picture;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      std::copy_n(picture.texel(picture.width() - 1 - x, y), picture.channels(), turned.texel(x, y));
  return turned;
}

std::vector<Case> casesWithTruth() {
  std::vector<Case> chosen;
  std::ranges::copy_if(cases(), std::back_inserter(chosen), [](const Case& each) { return each.truth.has_value(); });
  return chosen;
}

class GoldenTruth : public ::testing::TestWithParam<Case> {};

TEST_P(GoldenTruth, IsAsNearAsItIsSaidToBeAndAMistakeIsNot) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  const Case& golden_case = GetParam();
  const Truth& truth = *golden_case.truth;
  const std::string commands = "mirrorball " + drawnCommandOf(golden_case) + "\nmirrorball " +
                               tracedCommandOf(golden_case) + "\nwhy there is a distance: " + truth.reason;
  SCOPED_TRACE(commands);
  const bool tries_mistake = !std::string_view(truth.mistake).empty();
  if (isUpdatingTruths()) {
    const Result<void> kept = keepTruth(golden_case);
    ASSERT_TRUE(kept) << kept.error().message;
  }
  std::future<Result<Image>> erring;
  if (tries_mistake) erring = making(drawnCommandOf(golden_case, truth.mistake));
  const Result<Image> drawn = imageMadeBy(drawnCommandOf(golden_case));
  const Result<Image> traced = keptTruth(golden_case.name);
  ASSERT_TRUE(drawn) << drawn.error().message;
  ASSERT_TRUE(traced) << traced.error().message;
  EXPECT_GE(psnrOf_db(*drawn, *traced), truth.psnr_db) << "the drawn picture is farther from the truth";
  EXPECT_LT(psnrOf_db(leftIsRight(*drawn), *traced), truth.psnr_db) << "a picture the wrong way round passes";
  if (!tries_mistake) return;
  const Result<Image> wrong = erring.get();
  ASSERT_TRUE(wrong) << wrong.error().message;
  EXPECT_LT(psnrOf_db(*wrong, *traced), truth.psnr_db) << truth.mistake << " passes";
}
INSTANTIATE_TEST_SUITE_P(Program, GoldenTruth, ::testing::ValuesIn(casesWithTruth()), caseName);

// A new case that draws must say how near the truth it is, if there is one.
TEST(GoldenTruths, AreStatedForWhatIsDrawn) {
  for (const Case& golden_case : cases())
    EXPECT_EQ(golden_case.truth.has_value(), needsGl(golden_case) && !wrapsPicture(golden_case)) << golden_case.name;
}

TEST(GoldenTruths, AreTracedFromTheSourcesThatThereAre) {
  if (isUpdatingTruths() || isUpdating()) GTEST_SKIP() << "the truths, or what they are made of, are being made";
  for (const Case& golden_case : casesWithTruth())
    EXPECT_EQ(keptHash(golden_case.name), truthHash(golden_case))
        << golden_case.name
        << ": what its truth is traced from has changed since; to trace all anew: " << kUpdateTruths;
}

TEST(GoldenTruths, BelongToACaseAndAreSmall) {
  if (isUpdatingTruths()) GTEST_SKIP() << "the truths are being traced";
  std::set<std::string> wanted = {"hashes.txt"};
  for (const Case& golden_case : casesWithTruth()) wanted.insert(truthPath(golden_case.name).filename());
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(truthPath("any").parent_path())) {
    EXPECT_TRUE(wanted.contains(entry.path().filename())) << entry.path() << " belongs to no case";
    bytes += entry.file_size();
  }
  EXPECT_LE(bytes, 750'000u) << "every clone carries these pictures, and every version of them";
}

class GoldenTracing : public ::testing::TestWithParam<Case> {};

// Another processor may round a ray to the other side of an edge.
TEST_P(GoldenTracing, IsStillTheKeptTruth) {
  const Case& golden_case = GetParam();
  const Result<Image> kept = keptTruth(golden_case.name);
  const Result<Image> now = imageMadeBy(tracedCommandOf(golden_case));
  ASSERT_TRUE(kept) << kept.error().message;
  ASSERT_TRUE(now) << now.error().message;
  EXPECT_GE(psnrOf_db(*now, *kept), 50.0) << "mirrorball " << tracedCommandOf(golden_case);
}
INSTANTIATE_TEST_SUITE_P(Program, GoldenTracing, ::testing::ValuesIn(casesWithTruth()), caseName);

}  // namespace
}  // namespace mirrorball::golden
