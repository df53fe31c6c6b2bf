// A golden picture that lets mistakes pass is worth nothing. So each case is drawn once more with the smallest mistake
// that it must find, a parameter off by a few per cent, and has to be refused.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "golden/cases.h"
#include "golden/comparison.h"
#include "golden/golden_picture.h"
#include "golden/made_picture.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::golden {
namespace {

class GoldenMinError : public ::testing::TestWithParam<Case> {};

TEST_P(GoldenMinError, IsFound) {
  if (isUpdating()) GTEST_SKIP() << "the golden pictures are being made";
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  const Case& golden_case = GetParam();
  const Result<Image8> golden = readGolden(goldenPath(golden_case.name));
  ASSERT_TRUE(golden) << golden.error().message;
  const Result<Bytes> file = pictureMadeBy(commandOf(golden_case, golden_case.min_error));
  ASSERT_TRUE(file) << file.error().message;
  const Result<Image8> wrong = decodeTexture(*file);
  ASSERT_TRUE(wrong) << wrong.error().message;
  const Difference difference = differenceOf(*golden, *wrong);
  EXPECT_FALSE(isWithin(difference, *golden_case.tolerance))
      << golden_case.min_error << " changes the picture by " << textOf(difference) << ", which is allowed";
}

std::vector<Case> casesWithMinError() {
  std::vector<Case> chosen;
  std::ranges::copy_if(cases(), std::back_inserter(chosen),
                       [](const Case& each) { return !std::string_view(each.min_error).empty(); });
  return chosen;
}

/// Every eighth of them.
std::vector<Case> someCasesWithMinError() {
  const std::vector<Case> all = casesWithMinError();
  std::vector<Case> chosen;
  for (std::size_t i = 0; i < all.size(); i += 8) chosen.push_back(all[i]);
  return chosen;
}

// All of them take minutes, and are left to ./test --long.
INSTANTIATE_TEST_SUITE_P(Every, GoldenMinError, ::testing::ValuesIn(casesWithMinError()), caseName);
INSTANTIATE_TEST_SUITE_P(Some, GoldenMinError, ::testing::ValuesIn(someCasesWithMinError()), caseName);

}  // namespace
}  // namespace mirrorball::golden
