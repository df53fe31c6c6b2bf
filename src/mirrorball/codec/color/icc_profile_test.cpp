#include "mirrorball/codec/color/icc_profile.h"

#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"

namespace mirrorball {
namespace {

using testing::iccDisplayP3;
using testing::iccMatrixProfile;
using testing::iccProfile;
using testing::iccValue;

std::string nameOf(std::span<const std::uint8_t> profile) { return readIccProfile(profile).description; }

const std::array<std::vector<double>, 3> kSrgbColumns{
    {{0.43607, 0.22249, 0.01392}, {0.38515, 0.71687, 0.09708}, {0.14307, 0.06061, 0.71410}}};

TEST(IccProfile, IsKnownByItsDescription) {
  EXPECT_EQ(nameOf(iccProfile("Adobe RGB (1998)")), "Adobe RGB (1998)");
  EXPECT_EQ(nameOf(testing::iccProfile4(u"Display P3")), "Display P3");
  EXPECT_EQ(nameOf(testing::iccProfile4(u"Écran 2")), "?cran 2");
}

TEST(IccProfile, DamageLeavesItUnnamed) {
  const Bytes profile = iccProfile("Adobe RGB");
  const std::size_t end_of_name = profile.size() - 3;  // behind it stand its zero and two bytes of padding
  for (std::size_t size = 0; size < end_of_name; ++size)
    EXPECT_NE(nameOf(std::span(profile).first(size)), "Adobe RGB") << size;
  EXPECT_EQ(nameOf(std::span(profile).first(140)), "unnamed");
  EXPECT_EQ(nameOf({}), "unnamed");
  EXPECT_EQ(nameOf(iccProfile("\n")), "?") << "one line";
}

TEST(IccProfile, OnlySrgbsOwnNeedsNoWord) {
  EXPECT_EQ(describeColor(codedColor(readIccProfile(iccProfile("sRGB IEC61966-2.1"))), 3), "sRGB");
  EXPECT_EQ(describeColor(codedColor(readIccProfile(iccProfile("Display P3"))), 3),
            "sRGB assumed: its ICC profile (Display P3) is not applied");
  EXPECT_EQ(describeColor(codedColor(IccProfile{}), 3), "sRGB");
}

TEST(IccProfile, AMatrixIsPrimaries) {
  const IccProfile p3 = readIccProfile(iccDisplayP3());
  ASSERT_TRUE(p3.is_understood);
  EXPECT_FALSE(p3.curve.power) << "sRGB's";
  EXPECT_NEAR(p3.primaries->green.x, 0.265, 1e-4);
  EXPECT_NEAR(p3.primaries->green.y, 0.690, 1e-4);
  EXPECT_EQ(describeColor(codedColor(p3), 3), "sRGB, primaries of the file (Display P3): converted");
  const IccProfile srgb = readIccProfile(iccMatrixProfile("camera", kSrgbColumns, testing::iccSrgbCurve()));
  EXPECT_EQ(describeColor(codedColor(srgb), 3), "sRGB");
  EXPECT_FALSE(rec709FromPrimaries(*srgb.primaries)) << "nothing is converted";
}

TEST(IccProfile, CurvesArePowersOrSrgbs) {
  const auto curveOf = [](const Bytes& value) {
    const IccProfile profile = readIccProfile(iccMatrixProfile("x", kSrgbColumns, value));
    return profile.is_understood ? std::optional(profile.curve.power.value_or(0.0)) : std::nullopt;
  };
  Bytes adobe = iccValue("curv", {}, {1});
  adobe.insert(adobe.end(), {0x02, 0x33});  // 2.19921875
  EXPECT_EQ(curveOf(adobe), 2.19921875);
  EXPECT_EQ(curveOf(iccValue("curv", {}, {0})), 1.0);
  EXPECT_NEAR(*curveOf(iccValue("para", {1.8}, {0})), 1.8, 1e-5);
  EXPECT_EQ(curveOf(testing::iccSrgbCurve()), 0.0);
  EXPECT_EQ(curveOf(testing::iccSrgbCurveOfForm4()), 0.0);
  Bytes short_form = testing::iccSrgbCurveOfForm4();
  short_form.resize(36);
  EXPECT_FALSE(curveOf(short_form)) << "without its last number";
  EXPECT_FALSE(curveOf(iccValue("para", {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045, 0.1, 0.1}, {0x00040000})));
  const auto table = [](double (*lightOf)(double)) {
    Bytes value = iccValue("curv", {}, {1024});
    for (int i = 0; i < 1024; ++i) {
      const auto light = static_cast<int>(std::lround(65535.0 * lightOf(i / 1023.0)));
      value.insert(value.end(), {static_cast<std::uint8_t>(light >> 8), static_cast<std::uint8_t>(light)});
    }
    return value;
  };
  const auto srgb = [](double x) { return x < 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  EXPECT_EQ(curveOf(table(srgb)), 0.0);
  EXPECT_EQ(curveOf(table([](double x) { return x; })), 1.0);
  EXPECT_FALSE(curveOf(table([](double x) { return x * x * x; }))) << "a table of another curve";
  EXPECT_FALSE(curveOf(iccValue("para", {50.0}, {0})));
  EXPECT_FALSE(curveOf(iccValue("curv", {}, {4000000000u}))) << "longer than the file";
}

TEST(IccProfile, WhatIsNotUnderstoodIsNotApplied) {
  const Bytes whole = iccDisplayP3();
  for (std::size_t size = 0; size < whole.size(); size += 3)
    EXPECT_FALSE(readIccProfile(std::span(whole).first(size)).is_understood) << size;
  Bytes lab = whole;
  lab[20] = 'L';  // its space of connection
  EXPECT_FALSE(readIccProfile(lab).is_understood);
  const std::vector<double> x{0.5, 0.5, 0.5};
  EXPECT_FALSE(readIccProfile(iccMatrixProfile("flat", {x, x, x}, testing::iccSrgbCurve())).is_understood);
}

}  // namespace
}  // namespace mirrorball
