// A golden picture is only yesterday's. So what the renderer draws of each case is compared with what the path tracer
// says too, where light does no more than an environment map can know of. Nothing of this is stored: both pictures are
// made.

#include <algorithm>
#include <future>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "golden/cases.h"
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
  std::future<Result<Image>> tracing = making(tracedCommandOf(golden_case));
  std::future<Result<Image>> erring;
  if (tries_mistake) erring = making(drawnCommandOf(golden_case, truth.mistake));
  const Result<Image> drawn = imageMadeBy(drawnCommandOf(golden_case));
  const Result<Image> traced = tracing.get();
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

}  // namespace
}  // namespace mirrorball::golden
