#include "mirrorball/study/page/plot.h"

#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

/// What a pattern's first group is, wherever it matches.
std::vector<std::string> allInPlot(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

TEST(Plot, EachPointIsWhereItsNumbersAre) {
  const Plot plot{.title = "T", .x_label = "x", .y_label = "y", .curves = {{"a", {{0, 0}, {1, 5}, {2, 10}}}}};
  const std::string svg = svgOf(plot, "p");
  EXPECT_EQ(allInPlot(svg, "<title>(a: [^<]+)</title>"),
            (std::vector<std::string>{"a: 0 at 0", "a: 5 at 1", "a: 10 at 2"}));
  const auto x = allInPlot(svg, "<circle cx=\"([0-9.]+)\"");
  const auto y = allInPlot(svg, "<circle cx=\"[0-9.]+\" cy=\"([0-9.]+)\"");
  ASSERT_EQ(x.size(), 3u);
  EXPECT_NEAR(std::stod(x[1]), (std::stod(x[0]) + std::stod(x[2])) / 2, 0.1);
  EXPECT_NEAR(std::stod(y[1]), (std::stod(y[0]) + std::stod(y[2])) / 2, 0.1);
  EXPECT_GT(std::stod(y[0]), std::stod(y[2])) << "y grows upwards";
}

TEST(Plot, MarksAreRoundNumbersAroundAllPoints) {
  const Plot plot{.x_label = "x", .y_from_zero = false, .y_label = "y", .curves = {{"a", {{3, 21.5}, {97, 38.2}}}}};
  const auto marks = allInPlot(svgOf(plot, "p"), "<text class=\"mark of-y\"[^>]*>([^<]+)<");
  ASSERT_GE(marks.size(), 3u);
  EXPECT_EQ(marks.front(), "20");
  EXPECT_EQ(marks.back(), "40");
}

TEST(Plot, OfNothingOrOfOnePointIsStillAPlot) {
  EXPECT_THAT(svgOf({.title = "a < b", .x_label = "x", .y_label = "y"}, "p"), HasSubstr("a &lt; b"));
  const std::string one = svgOf({.x_label = "x", .y_label = "y", .curves = {{"a", {{2, 0}}}}}, "p");
  EXPECT_EQ(one.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace mirrorball
