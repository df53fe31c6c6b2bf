// A page may be cut out of a larger picture, which is what its file means.

#include "mirrorball/codec/tiff/tiff_window.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/tiff/tiff_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOfNumbers;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::tiffFile;
using testing::tiffFloats;
using testing::TiffForm;
using testing::tiffSamples;

/// A page of floats in a picture of 32 × 16 texels.
TiffForm croppedForm(glm::vec2 texels, float resolution = 150.0f) {
  return {.width = 16,
          .height = 8,
          .bits = 32,
          .kind = SAMPLEFORMAT_IEEEFP,
          .whole = glm::uvec2(32, 16),
          .position = texels / (resolution == 0.0f ? 1.0f : resolution),
          .resolution = resolution};
}

DecodedImage decodedPage(const TiffForm& form) {
  auto image = decodeImage(tiffFile(form, bytesOfNumbers(tiffFloats(form))));
  EXPECT_TRUE(image) << image.error().message;
  return image ? std::move(*image) : DecodedImage{};
}

/// That a sample is the page's where the page lies, and 0 elsewhere.
void expectInPlace(const Image& whole, const TiffForm& form, glm::ivec2 corner) {
  const std::vector<float> floats = tiffFloats(form);
  ASSERT_EQ(glm::ivec2(whole.width(), whole.height()), glm::ivec2(*form.whole));
  for (int y = 0; y < whole.height(); ++y)
    for (int x = 0; x < whole.width(); ++x)
      for (int c = 0; c < 3; ++c) {
        const glm::ivec2 at = glm::ivec2(x, y) - corner;
        const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < int(form.width) && at.y < int(form.height);
        ASSERT_EQ(whole.texel(x, y)[c], is_inside ? floats[std::size_t((at.y * int(form.width) + at.x) * 3 + c)] : 0.0f)
            << x << ", " << y;
      }
}

// As Hugin's nona writes them: the position in inches, rounded to a float.
TEST(TiffWindow, APageLiesInItsPlace) {
  for (const float resolution : {150.0f, 72.0f, 0.0f})
    for (const glm::ivec2 corner : {glm::ivec2(8, 4), glm::ivec2(0, 0), glm::ivec2(16, 8), glm::ivec2(7, 3)}) {
      const TiffForm form = croppedForm(corner, resolution);
      const DecodedImage image = decodedPage(form);
      expectInPlace(image.image, form, corner);
      ASSERT_TRUE(image.window);
      EXPECT_EQ(image.window->corner, corner);
      EXPECT_EQ(image.window->size, glm::ivec2(16, 8));
      EXPECT_EQ(image.window->whole, glm::ivec2(32, 16));
      EXPECT_THAT(image.oddities, ElementsAre("holds 16x8 of the 32x16 texels of its full image: what lies outside is "
                                              "black"));
    }
}

TEST(TiffWindow, WhatReachesBeyondIsCutOff) {
  const TiffForm form = croppedForm({24, 12});
  const DecodedImage image = decodedPage(form);
  expectInPlace(image.image, form, {24, 12});
  EXPECT_THAT(image.oddities, ElementsAre("holds 16x8 texels, beyond its full image of 32x16: what lies outside is cut "
                                          "off, and what it lacks is black"));
}

TEST(TiffWindow, IntegersAndAlphaToo) {
  TiffForm form = croppedForm({8, 4});
  form.bits = 8;
  form.kind = SAMPLEFORMAT_UINT;
  form.samples = 4;
  form.extras = {EXTRASAMPLE_UNASSALPHA};
  const Bytes samples = tiffSamples(form);
  const Bytes file = tiffFile(form, samples);
  const auto image = decodeImage(file);
  ASSERT_TRUE(image) << image.error().message;
  ASSERT_EQ(image->image.width(), 32);
  ASSERT_EQ(image->image.channels(), 4);
  const auto alpha = [&](int x, int y) { return image->image.texel(x, y)[3]; };
  EXPECT_EQ(alpha(8, 4), static_cast<float>(samples[3]) / 255.0f);
  EXPECT_EQ(alpha(23, 11), static_cast<float>(samples[(7 * 16 + 15) * 4 + 3]) / 255.0f);
  EXPECT_EQ(alpha(7, 4), 0.0f);
  EXPECT_EQ(alpha(24, 11), 0.0f);
  const auto codes = decodeCodes(file);
  ASSERT_TRUE(codes) << codes.error().message;
  ASSERT_EQ(codes->codes.width(), 32);
  EXPECT_EQ(codes->codes.texel(8, 4)[0], samples[0]);
  EXPECT_EQ(codes->codes.texel(7, 4)[3], 0);
  EXPECT_EQ(codes->oddities, image->oddities);
}

TEST(TiffWindow, ThatIsTheWholeOrNowhereIsThePage) {
  TiffForm form = croppedForm({0, 0});
  form.whole = glm::uvec2(16, 8);
  EXPECT_FALSE(decodedPage(form).window);
  EXPECT_THAT(decodedPage(form).oddities, IsEmpty());
  form = croppedForm({32, 0});
  EXPECT_EQ(decodedPage(form).image.width(), 16);
  EXPECT_THAT(decodedPage(form).oddities, ElementsAre("has no texel in its full image: read without that window"));
  form = croppedForm({8, 4});
  form.orientation = ORIENTATION_BOTRIGHT;
  EXPECT_EQ(decodedPage(form).image.width(), 16);
  EXPECT_THAT(decodedPage(form).oddities,
              ::testing::Contains("is a part of a larger picture, and not stored upright: read without the rest"));
}

TEST(TiffWindow, FarLargerThanTheFileIsRefused) {
  TiffForm form = croppedForm({8, 4});
  form.whole = glm::uvec2(1 << 18, 1 << 9);
  auto image = decodeImage(tiffFile(form, bytesOfNumbers(tiffFloats(form))));
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::bad_file);
  EXPECT_THAT(image.error().message, HasSubstr("says its full image is 262144x512"));
  form.whole = glm::uvec2(0xffffffffu, 0xffffffffu);
  image = decodeImage(tiffFile(form, bytesOfNumbers(tiffFloats(form))));
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::too_large);
}

}  // namespace
}  // namespace mirrorball
