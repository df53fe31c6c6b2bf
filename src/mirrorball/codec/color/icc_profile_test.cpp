#include "mirrorball/codec/color/icc_profile.h"

#include <gtest/gtest.h>

#include "mirrorball/codec/color/icc_testing.h"

namespace mirrorball {
namespace {

using testing::iccProfile;

TEST(IccProfile, IsKnownByItsDescription) {
  EXPECT_EQ(iccDescription(iccProfile("Adobe RGB (1998)")), "Adobe RGB (1998)");
  EXPECT_EQ(iccDescription(testing::iccProfile4(u"Display P3")), "Display P3");
  EXPECT_EQ(iccDescription(testing::iccProfile4(u"Écran 2")), "?cran 2");
}

TEST(IccProfile, DamageLeavesItUnnamed) {
  const Bytes profile = iccProfile("Adobe RGB");
  const std::size_t end_of_name = profile.size() - 3;  // behind it stand its zero and two bytes of padding
  for (std::size_t size = 0; size < end_of_name; ++size)
    EXPECT_NE(iccDescription(std::span(profile).first(size)), "Adobe RGB") << size;
  EXPECT_EQ(iccDescription(std::span(profile).first(140)), "unnamed");
  EXPECT_EQ(iccDescription({}), "unnamed");
  EXPECT_EQ(iccDescription(iccProfile("\n")), "?") << "one line";
}

TEST(IccProfile, OnlySrgbsOwnNeedsNoWord) {
  EXPECT_EQ(describeIccColor("sRGB IEC61966-2.1"), "sRGB");
  EXPECT_EQ(describeIccColor("Display P3"), "sRGB assumed: its ICC profile (Display P3) is not applied");
}

}  // namespace
}  // namespace mirrorball
