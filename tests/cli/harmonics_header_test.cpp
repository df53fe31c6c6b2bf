// The header of spherical harmonics that `bake` writes: it was compiled with this test, and holds what sh.json does.

#include <cstddef>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "baked/sh.h"
#include "mirrorball/base/file.h"

namespace mirrorball::testing {
namespace {

template <std::size_t kCount>
void expectSame(const float (&header)[kCount][3], const nlohmann::json& rows) {
  ASSERT_EQ(rows.size(), kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(header[i][c], rows[i][c].get<float>()) << "coefficient " << i;
}

TEST(HarmonicsHeader, HasTheNumbersOfTheJson) {
  const auto text = readFile(MIRRORBALL_BAKED_HARMONICS);
  ASSERT_TRUE(text);
  const nlohmann::json json = nlohmann::json::parse(text->begin(), text->end());
  expectSame(mirrorball_radiance, json["radiance"]);
  expectSame(mirrorball_irradiance, json["irradiance"]);
  expectSame(mirrorball_radiance_windowed, json["radiance_windowed"]);
  expectSame(mirrorball_irradiance_windowed, json["irradiance_windowed"]);
  EXPECT_NE(mirrorball_radiance[24][0], 0.0f) << "of light that has all bands";
}

}  // namespace
}  // namespace mirrorball::testing
