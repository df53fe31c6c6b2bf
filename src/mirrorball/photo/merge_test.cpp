#include "mirrorball/photo/merge.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel_testing.h"
#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/photo/photo_testing.h"

namespace mirrorball {
namespace {

using ::testing::Each;
using testing::exposed;
using ::testing::HasSubstr;

using Curve = std::function<double(double)>;

double srgb(double light) { return double(formula::srgbFromLinear1(static_cast<float>(light))); }
double gamma18(double light) { return std::pow(light, 1.0 / 1.8); }
/// As cameras grade: sRGB with more contrast in the middle, softened towards black and white.
double contrasty(double light) {
  const double encoded = srgb(light);
  return encoded + 0.12 * std::sin(glm::two_pi<double>() * (encoded - 0.5)) * 0.9;
}

/// Smooth light over six decades: bright to the right, of slightly different colours from top to bottom.
Image rampOfLight(double min, double max) {
  Image light(300, 120, 3);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const double share = (x + 0.5) / light.width();
        const double tint = 1.0 + 0.3 * std::sin(y * 0.05 + 2.0 * c);
        light.texel(x, y)[c] = static_cast<float>(tint * min * std::pow(max / min, share));
      }
  return light;
}

std::vector<Photograph> bracketedSeries(const Image& light, const std::vector<double>& exposures, const Curve& curve) {
  std::vector<Photograph> series;
  for (const double exposure : exposures)
    series.push_back({"photo_" + std::to_string(series.size()) + ".jpg", exposed(light, exposure, curve), {}, {}});
  return series;
}

const std::vector<double> kExposures{1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0};

/// The root mean square of ln(recovered / true) over the codes 16 … 240, at its best scale.
double responseError(const Response& response, const Curve& curve) {
  // The light of a code, by bisection of the curve.
  const auto lightOf = [&](double code) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) (curve((low + high) / 2.0) * 255.0 < code ? low : high) = (low + high) / 2.0;
    return high;
  };
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (int code = 16; code <= 240; ++code) {
      const double ratio = std::log(double(response.light[c][std::size_t(code)]) / lightOf(code));
      sum += ratio;
      squares += ratio * ratio;
      ++count;
    }
  return std::sqrt(squares / count - (sum / count) * (sum / count));
}

TEST(Response, KnownCurvesAreRecovered) {
  const Image light = rampOfLight(1e-3, 300.0);
  for (const auto& [name, curve] :
       {std::pair<const char*, Curve>{"sRGB", srgb}, {"gamma 1.8", gamma18}, {"contrasty", contrasty}}) {
    SCOPED_TRACE(name);
    const auto series = bracketedSeries(light, kExposures, curve);
    std::vector<const Image8*> codes;
    for (const Photograph& photograph : series) codes.push_back(&photograph.codes);
    const auto response = recoverResponse(codes, kExposures);
    ASSERT_TRUE(response) << response.error().message;
    // 4 %, 0.06 stops: rounding to codes alone is 1 … 6 % of the light at code 16.
    RecordProperty(name, std::to_string(responseError(*response, curve)));
    EXPECT_LT(responseError(*response, curve), 0.04);
    for (const auto& channel : response->light) EXPECT_TRUE(std::ranges::is_sorted(channel));
    EXPECT_NEAR(response->light[1][128], 0.2159f, 1e-3f);
  }
}

TEST(Response, AssumedCurvesMeetAtGrey) {
  for (const ResponseKind kind : {ResponseKind::srgb, ResponseKind::gamma, ResponseKind::linear}) {
    const Response response = assumedResponse(kind);
    EXPECT_NEAR(response.light[0][128], 0.2159f, 1e-4f);
    EXPECT_TRUE(std::ranges::is_sorted(response.light[2]));
  }
  EXPECT_NEAR(assumedResponse(ResponseKind::srgb).light[0][255], 1.0f, 1e-6f);
  EXPECT_NEAR(assumedResponse(ResponseKind::linear).light[0][64], 0.2159f / 2.0f, 1e-4f);
}

TEST(Merge, KeepsTheRangeOfASeriesWithARecoveredCurve) {
  const Image light = rampOfLight(1e-2, 2e2);
  const auto series = bracketedSeries(light, kExposures, srgb);
  const auto merged = mergePhotographs(series, {.exposures = kExposures, .response = {}});
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->response, "recovered");
  EXPECT_EQ(merged->reference, 2u);
  // What no exposure shows between black and clipped is left out: the longest shows from 0.01, the shortest to 220.
  std::vector<double> ratios;
  double min = 1e30, max = 0.0;
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const double truth = light.texel(x, y)[1];
      if (truth > 200.0) continue;
      ratios.push_back(std::log2(merged->light.texel(x, y)[1] / (truth * kExposures[2])));
      min = std::min(min, truth);
      max = std::max(max, truth);
    }
  EXPECT_GT(max / min, 1e4);
  // In stops: half a code at the dark end (code 25, 4 % of the light) and just below clipping, both ways.
  EXPECT_LT(std::ranges::max(ratios) - std::ranges::min(ratios), 0.15);
  EXPECT_THAT(merged->contradicts_stops, Each(::testing::DoubleNear(0.0, 0.1)));
}

/// A series of linear codes of 16 bits, in a file's own primaries.
std::vector<Photograph> linearSeries(const Image& light, const std::vector<double>& exposures) {
  std::vector<Photograph> series;
  for (const double exposure : exposures) {
    Image codes = light;
    for (float& sample : codes.samples())
      sample = std::round(65535.0f * std::min(1.0f, static_cast<float>(exposure) * sample)) / 65535.0f;
    series.push_back({.name = "photo_" + std::to_string(series.size()) + ".tif",
                      .codes = {},
                      .light = std::move(codes),
                      .color = {.transfer = Transfer::linear},
                      .is_clipped_at_1 = true});
  }
  return series;
}

// They need no response. Of 16 bits, a thousandth is 65 codes: 8 would leave a quarter.
TEST(Merge, LinearCodesAreLight) {
  const Image light = rampOfLight(1e-3, 150.0);
  const auto merged = mergePhotographs(linearSeries(light, kExposures), {.exposures = kExposures});
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->response, "linear light");
  EXPECT_FALSE(merged->curve);
  EXPECT_EQ(merged->clipped, 0u);
  for (int y = 0; y < light.height(); ++y)
    for (int x = 0; x < light.width(); ++x) {
      const double expected = kExposures[2] * double(light.texel(x, y)[1]);
      ASSERT_NEAR(merged->light.texel(x, y)[1], expected, 0.015 * expected) << x << ", " << y;
    }
  EXPECT_THAT(merged->contradicts_stops, Each(::testing::DoubleNear(0.0, 0.1)));
}

TEST(Merge, LinearCodesThatContradictOrClipAreReported) {
  std::vector<double> wrong = kExposures;
  wrong[3] *= 4.0;
  const Image light = rampOfLight(1e-3, 2e3);
  const auto merged = mergePhotographs(linearSeries(light, kExposures), {.exposures = wrong});
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_GT(std::abs(merged->contradicts_stops[3]), kContradiction_stops);
  EXPECT_GT(merged->clipped, 0u);
  // An option counts more than the file.
  const auto assumed =
      mergePhotographs(linearSeries(light, kExposures), {.exposures = kExposures, .response = ResponseKind::srgb});
  ASSERT_TRUE(assumed) << assumed.error().message;
  EXPECT_EQ(assumed->response, "assumed sRGB");
}

// In the file's primaries, in which a channel is clipped or not.
TEST(Merge, LinearCodesAreConvertedOnceTheyAreMerged) {
  auto series = linearSeries(Image(8, 8, 3, 0.5f), {1.0, 0.25});
  for (Photograph& photograph : series) {
    photograph.color.primaries = kDisplayP3;
    for (std::size_t i = 0; i < photograph.light.samples().size(); i += 3) photograph.light.samples()[i + 1] = 0.0f;
  }
  const auto merged = mergePhotographs(series, {.exposures = {1.0, 0.25}});
  ASSERT_TRUE(merged) << merged.error().message;
  const glm::vec3 expected = *rec709FromPrimaries(kDisplayP3) * glm::vec3(0.5f, 0.0f, 0.5f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(merged->light.texel(3, 3)[c], expected[c], 1e-5f);
}

TEST(Merge, MemoryIsCheckedBeforeItIsTaken) {
  const auto series = linearSeries(Image(256, 256, 3, 0.5f), kExposures);
  const std::uint64_t usual = memoryLimit();
  const std::uint64_t needed = 256 * 256 * (12 + 4 * kExposures.size());
  setMemoryLimit(needed);
  const auto merged = mergePhotographs(series, {.exposures = kExposures});
  setMemoryLimit(needed - 1);
  const auto refused = mergePhotographs(series, {.exposures = kExposures});
  setMemoryLimit(usual);
  EXPECT_TRUE(merged) << merged.error().message;
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_THAT(refused.error().message, ::testing::StartsWith(series.front().name + ": needs "));
}

TEST(Merge, FloatsOfASeriesDoNotSayWhereTheyAreClipped) {
  auto series = linearSeries(Image(8, 8, 3, 0.5f), {1.0, 0.25});
  for (Photograph& photograph : series) photograph.is_clipped_at_1 = false;
  const auto merged = mergePhotographs(series, {.exposures = {1.0, 0.25}});
  ASSERT_FALSE(merged);
  EXPECT_THAT(merged.error().message, HasSubstr("give it alone, or a series of integers"));
}

TEST(Merge, KeepsARangeOfAHundredThousand) {
  const Image light = rampOfLight(2e-2, 2.4e3);
  const std::vector<double> exposures{1.0 / 4096, 1.0 / 256, 1.0 / 16, 1.0};
  const auto merged = mergePhotographs(bracketedSeries(light, exposures, srgb),
                                       {.exposures = exposures, .response = ResponseKind::srgb});
  ASSERT_TRUE(merged);
  double worst = 0.0;
  for (std::size_t i = 0; i < light.samples().size(); ++i)
    worst = std::max(worst, std::abs(std::log(merged->light.samples()[i] / (light.samples()[i] / 16.0))));
  // At light 0.014 the longest exposure has code 33, where half a code is 3 % of the light.
  EXPECT_LT(worst, 0.05);
  EXPECT_EQ(merged->clipped, 0u);
}

TEST(Merge, ClippedEverywhereIsCountedAndTheShortestDecides) {
  Image light(64, 64, 3, 0.3f);
  for (int y = 10; y < 14; ++y)
    for (int x = 20; x < 25; ++x) std::fill_n(light.texel(x, y), 3, 1000.0f);
  const std::vector<double> exposures{0.5, 1.0};
  const auto merged = mergePhotographs(bracketedSeries(light, exposures, srgb),
                                       {.exposures = exposures, .response = ResponseKind::srgb});
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->clipped, 20u);
  // The brighter, 1 s, is the reference: its white is 1, and that of half the time is 2.
  EXPECT_EQ(merged->reference, 1u);
  EXPECT_NEAR(merged->light.texel(22, 12)[0], 2.0f, 1e-5f);
  EXPECT_NEAR(merged->light.texel(40, 40)[0], 0.3f, 0.004f);
}

TEST(Merge, BlackEverywhereIsCounted) {
  Image light(32, 32, 3, 0.3f);
  std::fill_n(light.texel(3, 3), 3, 0.0f);
  const std::vector<double> exposures{0.5, 1.0};
  const auto merged = mergePhotographs(bracketedSeries(light, exposures, srgb),
                                       {.exposures = exposures, .response = ResponseKind::srgb});
  EXPECT_EQ(merged->black, 1u);
  EXPECT_EQ(merged->light.texel(3, 3)[1], 0.0f);
}

TEST(Merge, OneThatContradictsTheOthersIsNamed) {
  const Image light = rampOfLight(1e-2, 100.0);
  for (const double factor : {0.25, 3.0})  // two stops less or 1.6 more than is said
    for (std::size_t wrong = 0; wrong < kExposures.size(); ++wrong) {
      SCOPED_TRACE(wrong);
      auto taken = kExposures;
      taken[wrong] *= factor;
      const auto merged =
          mergePhotographs(bracketedSeries(light, taken, srgb), {.exposures = kExposures, .response = {}});
      ASSERT_TRUE(merged);
      for (std::size_t i = 0; i < kExposures.size(); ++i)
        EXPECT_NEAR(merged->contradicts_stops[i], i == wrong ? std::log2(factor) : 0.0, 0.3) << i;
    }
}

TEST(Merge, OneIsNamedWhereTheResponseCouldBendToIt) {
  // Two shades only: some curve agrees with any exposures.
  Image light(100, 100, 3, 0.05f);
  for (int y = 0; y < 50; ++y) std::fill_n(light.row(y).data(), 300, 2.0f);
  const std::vector<double> taken{1.0 / 64, 1.0 / 8, 1.0}, said{1.0 / 64, 1.0 / 2, 1.0};
  const auto merged = mergePhotographs(bracketedSeries(light, taken, srgb), {.exposures = said, .response = {}});
  ASSERT_TRUE(merged);
  EXPECT_NEAR(merged->contradicts_stops[1], -2.0, 0.3);
  // A camera unlike sRGB contradicts nothing.
  const auto linear = [](double l) { return l; };
  const auto right = mergePhotographs(bracketedSeries(rampOfLight(1e-2, 100.0), kExposures, linear),
                                      {.exposures = kExposures, .response = {}});
  EXPECT_THAT(right->contradicts_stops, Each(::testing::DoubleNear(0.0, kContradiction_stops)));
}

TEST(Merge, OnePhotographNeedsNoTime) {
  const auto merged = mergePhotographs(bracketedSeries(Image(8, 8, 3, 0.3f), {1.0}, srgb), {});
  ASSERT_TRUE(merged);
  EXPECT_NEAR(*merged->light.texel(2, 2), 0.3f, 0.003f);
  EXPECT_EQ(merged->response, "assumed sRGB");
}

TEST(Merge, IsTheSameForAnyNumberOfThreads) {
  const auto series = bracketedSeries(rampOfLight(1e-2, 100.0), kExposures, srgb);
  const auto many = mergePhotographs(series, {.exposures = kExposures, .response = {}});
  const testing::OneThread one;
  const auto single = mergePhotographs(series, {.exposures = kExposures, .response = {}});
  EXPECT_TRUE(std::ranges::equal(many->light.samples(), single->light.samples()));
}

TEST(Merge, WrongSeriesAreRefusedInOneLine) {
  const auto errorOf = [](const std::vector<Photograph>& series, const MergeOptions& options, ErrorCode code) {
    const auto merged = mergePhotographs(series, options);
    EXPECT_FALSE(merged);
    if (merged) return Error{};
    EXPECT_EQ(merged.error().code, code);
    EXPECT_EQ(merged.error().message.find('\n'), std::string::npos);
    return merged.error();
  };
  const Image light(40, 40, 3, 0.2f);
  auto series = bracketedSeries(light, {0.5, 1.0}, srgb);
  EXPECT_EQ(errorOf(series, {}, ErrorCode::usage).fix_hint, FixHint::give_exposures);
  EXPECT_THAT(errorOf(series, {.exposures = {1.0}, .response = {}}, ErrorCode::usage).message,
              HasSubstr("1 exposure is given for 2 photographs"));
  EXPECT_THAT(errorOf(series, {.exposures = {1.0, 1.0}, .response = {}}, ErrorCode::usage).message,
              HasSubstr("different"));
  const auto black = bracketedSeries(Image(40, 40, 3, 0.0f), {0.5, 1.0}, srgb);
  EXPECT_EQ(errorOf(black, {.exposures = {0.5, 1.0}, .response = {}}, ErrorCode::bad_shape).fix_hint,
            FixHint::name_response);
  auto mixed = series;
  mixed[1] = {"b.exr", {}, light, {}};
  EXPECT_THAT(errorOf(mixed, {.exposures = {0.5, 1.0}, .response = {}}, ErrorCode::usage).message, HasSubstr("b.exr"));
  auto colors = series;
  colors[1].color.primaries = kDisplayP3;
  EXPECT_THAT(errorOf(colors, {.exposures = {0.5, 1.0}, .response = {}}, ErrorCode::bad_shape).message,
              HasSubstr("photo_1.jpg: says of its colours sRGB, primaries of the file (Display P3)"));
  // Some programs state sRGB, some state nothing: that is the same.
  auto stated = series;
  stated[1].color.primaries = kRec709;
  EXPECT_TRUE(mergePhotographs(stated, {.exposures = {0.5, 1.0}, .response = ResponseKind::srgb}));
  auto gammas = series;
  gammas[0].color = {Transfer::gamma, 1.8};
  gammas[1].color = {Transfer::gamma, 2.2};
  EXPECT_EQ(mergePhotographs(gammas, {.exposures = {0.5, 1.0}, .response = {}}).error().code, ErrorCode::bad_shape);
  series[1] = bracketedSeries(Image(40, 41, 3, 0.2f), {1.0}, srgb)[0];
  const std::string sizes = errorOf(series, {.exposures = {0.5, 1.0}, .response = {}}, ErrorCode::bad_shape).message;
  EXPECT_THAT(sizes, HasSubstr("40x41"));
  EXPECT_THAT(sizes, HasSubstr("40x40"));
}

// The light of a phone's photograph in Display P3, whatever curve its codes have.
TEST(Merge, PrimariesAreConvertedOnceCodesAreLight) {
  const glm::vec3 light(0.5f, 0.2f, 0.15f);
  const glm::vec3 stored = glm::inverse(*rec709FromPrimaries(kDisplayP3)) * light;
  Image p3(40, 40, 3);
  for (std::size_t i = 0; i < p3.samples().size(); ++i) p3.samples()[i] = stored[int(i % 3)];
  auto single = bracketedSeries(p3, {1.0}, srgb);
  single[0].color.primaries = kDisplayP3;
  const auto merged = mergePhotographs(single, {});
  ASSERT_TRUE(merged) << merged.error().message;
  EXPECT_EQ(merged->response, "assumed sRGB");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(merged->light.texel(20, 20)[c], light[c], 0.003f);

  const double power = 1.8;
  auto of_power = bracketedSeries(p3, {1.0}, gamma18);
  of_power[0].color = {Transfer::gamma, power, kDisplayP3};
  const auto by_file = mergePhotographs(of_power, {});
  ASSERT_TRUE(by_file);
  EXPECT_EQ(by_file->response, "the file's gamma 1.8");
  // A response is scaled to sRGB's light at code 128.
  const float scale = formula::linearFromSrgb1(128.0f / 255.0f) / static_cast<float>(std::pow(128.0 / 255.0, power));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(by_file->light.texel(20, 20)[c], scale * light[c], 0.004f);
  EXPECT_EQ(mergePhotographs(of_power, {.exposures = {}, .response = ResponseKind::srgb})->response, "assumed sRGB");
}

}  // namespace
}  // namespace mirrorball
