#include "mirrorball/codec/ldr/coded_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

Image8 codedPicture(int channels) { return pictureFromLinear(testing::gradient(7, 5, channels), channels); }

CodedFile fileWith(CodedPicture codes, CodedColor color = {}, int orientation = 1) {
  return {.codes = std::move(codes), .color = std::move(color), .orientation = orientation};
}

const CodedColor kP3{.primaries = kDisplayP3};

// Everywhere a picture is read, and of every kind of codes.
TEST(CodedFile, IsTurnedUprightOnce) {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Image8 expected = upright(codedPicture(3), orientation);
    const auto file = [&] { return fileWith(codedPicture(3), {}, orientation); };
    const auto expectRemark = [&](const std::vector<std::string>& oddities) {
      if (orientation == 1)
        EXPECT_THAT(oddities, IsEmpty());
      else
        EXPECT_THAT(oddities,
                    ElementsAre("turned upright, as its EXIF says (orientation " + std::to_string(orientation) + ")"));
    };
    const DecodedImage image = asImage(file());
    EXPECT_THAT(image.image.samples(), ElementsAreArray(linearFromPicture(expected).samples()));
    expectRemark(image.oddities);
    const DecodedImage numbers = asImage(file(), ReadAs::numbers);
    EXPECT_EQ(numbers.image.texel(2, 3)[1], static_cast<float>(expected.texel(2, 3)[1]) / 255.0f);
    expectRemark(numbers.oddities);
    for (const Decoded<Texels>& texture : {*asTexels(file()), *asTexels(file(), ReadAs::numbers)}) {
      EXPECT_EQ(std::get<Image8>(texture.picture).texel(2, 3)[1], expected.texel(2, 3)[1]);
      expectRemark(texture.oddities);
    }
    const PictureCodes codes = asCodes(file());
    EXPECT_EQ(codes.codes.texel(2, 3)[1], expected.texel(2, 3)[1]);
    expectRemark(codes.oddities);
  }
  EXPECT_THAT(asImage(fileWith(codedPicture(1), {}, 0)).oddities, IsEmpty());
  EXPECT_THAT(asImage(fileWith(codedPicture(1), {}, 9)).oddities, IsEmpty());
}

// Display P3's (0.6, 0.3, 0.2) of Rec.709: the light, and as a texture the nearest of sRGB's codes.
TEST(CodedFile, OtherPrimariesBecomeSrgbsCodes) {
  const glm::vec3 light(0.6f, 0.3f, 0.2f);
  const glm::vec3 p3 = glm::inverse(*rec709FromPrimaries(kDisplayP3)) * light;
  Image8 codes(1, 1, 4, 77);
  for (int c = 0; c < 3; ++c) codes.texel(0, 0)[c] = srgb8FromLinear(p3[c]);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(asImage(fileWith(codes, kP3)).image.texel(0, 0)[c], light[c], 0.004f);
  const Decoded<Texels> texture = *asTexels(fileWith(codes, kP3));
  ASSERT_TRUE(std::holds_alternative<Image8>(texture.picture));
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(std::get<Image8>(texture.picture).texel(0, 0)[c], srgb8FromLinear(light[c]), 1);
  EXPECT_EQ(std::get<Image8>(texture.picture).texel(0, 0)[3], 77);
  EXPECT_THAT(texture.oddities, ElementsAre("its colours are not sRGB's: sRGB, primaries of the file (Display P3): "
                                            "converted"));
}

TEST(CodedFile, LightBeyondCodesBecomesFloats) {
  Image8 red(2, 1, 3, 0);
  red.texel(1, 0)[0] = 255;
  const Decoded<Texels> texture = *asTexels(fileWith(red, kP3));
  ASSERT_TRUE(std::holds_alternative<Image>(texture.picture));
  const Image& light = std::get<Image>(texture.picture);
  EXPECT_NEAR(light.texel(1, 0)[0], 1.2249f, 1e-3f);
  EXPECT_NEAR(light.texel(1, 0)[1], -0.0421f, 1e-3f);
  EXPECT_EQ(light.texel(1, 0)[3], 1.0f);
  // White stays white, whatever its primaries.
  EXPECT_EQ(std::get<Image8>(asTexels(fileWith(Image8(1, 1, 3, 255), kP3))->picture).texel(0, 0)[0], 255);
}

// Codes, their light and the codes that become of it stand side by side.
TEST(CodedFile, TheMemoryOfAConvertedTextureIsCounted) {
  const Image8 codes(64, 64, 3, 100);
  const std::uint64_t usual = memoryLimit();
  setMemoryLimit(64 * 64 * (3 + 3 * 4 + 4 * 4));
  const auto texture = asTexels(fileWith(codes, kP3));
  const auto plain = asTexels(fileWith(codes));
  setMemoryLimit(usual);
  ASSERT_FALSE(texture);
  EXPECT_EQ(texture.error().code, ErrorCode::too_large);
  EXPECT_TRUE(plain);
}

TEST(CodedFile, OtherCurvesBecomeSrgbsCodes) {
  const Image8 grey(1, 1, 1, 128);
  const CodedColor gamma{Transfer::gamma, 1.8};
  const float light = std::pow(128.0f / 255.0f, 1.8f);
  EXPECT_NEAR(asImage(fileWith(grey, gamma)).image.texel(0, 0)[0], light, 1e-6f);
  EXPECT_EQ(std::get<Image8>(asTexels(fileWith(grey, gamma))->picture).texel(0, 0)[2], srgb8FromLinear(light));
  const CodedColor pq{Transfer::pq};
  EXPECT_NEAR(std::get<Image>(asTexels(fileWith(Image8(1, 1, 3, 255), pq))->picture).texel(0, 0)[0], 10000.0f / 203.0f,
              1e-2f);
}

// What the file states of its colours is named once, and not applied.
TEST(CodedFile, NumbersKnowNoColours) {
  const Image8 source = codedPicture(3);
  const std::pair<CodedColor, const char*> stated[]{
      {kP3, "sRGB, Display P3"},
      {{Transfer::gamma, 1.8, kAdobeRgb}, "gamma 1.8, Adobe RGB"},
      {{Transfer::pq}, "PQ"},
      {{.unread_profile = "Camera RGB"}, "an ICC profile, Camera RGB"},
  };
  for (const auto& [color, space] : stated) {
    const auto remark = ElementsAre("states a colour space (" + std::string(space) +
                                    "), which does not count for numbers: they are read as they are stored");
    const auto data = asTexels(fileWith(source, color), ReadAs::numbers);
    EXPECT_EQ(std::get<Image8>(data->picture).texel(3, 2)[1], source.texel(3, 2)[1]);
    EXPECT_THAT(data->oddities, remark);
    EXPECT_FALSE(data->is_converted);
    EXPECT_TRUE(asTexels(fileWith(source, color))->is_converted != !color.unread_profile.empty());
    const DecodedImage numbers = asImage(fileWith(source, color), ReadAs::numbers);
    EXPECT_EQ(numbers.image.texel(3, 2)[1], static_cast<float>(source.texel(3, 2)[1]) / 255.0f);
    EXPECT_THAT(numbers.oddities, remark);
  }
  const ImageOf<std::uint16_t> fine(1, 1, 1, 12345);
  const auto data = asTexels(fileWith(fine), ReadAs::numbers);
  EXPECT_THAT(std::get<Image>(data->picture).samples(),
              ElementsAre(12345 / 65535.0f, 12345 / 65535.0f, 12345 / 65535.0f, 1.0f));
}

// sRGB's codes and plain linear numbers are what formats mean without a word.
TEST(CodedFile, NumbersOfUsualColoursNeedNoRemark) {
  for (const CodedColor& color : {CodedColor{}, CodedColor{Transfer::linear}, CodedColor{.primaries = kRec709},
                                  CodedColor{.unread_profile = "sRGB IEC61966-2.1"}})
    EXPECT_THAT(asTexels(fileWith(codedPicture(3), color), ReadAs::numbers)->oddities, IsEmpty());
  EXPECT_THAT(asTexels(fileWith(codedPicture(1), kP3), ReadAs::numbers)->oddities, IsEmpty()) << "grey has no hue";
}

TEST(CodedFile, AProfileThatIsNotAppliedIsReported) {
  const CodedColor unread{.unread_profile = "Camera RGB"};
  const auto remark = ElementsAre(
      "has an ICC profile (Camera RGB) without a matrix and one curve, which is not applied: "
      "taken as sRGB");
  EXPECT_THAT(asImage(fileWith(codedPicture(3), unread)).oddities, remark);
  EXPECT_THAT(asTexels(fileWith(codedPicture(3), unread))->oddities, remark);
  EXPECT_THAT(asCodes(fileWith(codedPicture(3), unread)).oddities, remark);
  const CodedColor srgb{.unread_profile = "sRGB IEC61966-2.1"};
  EXPECT_THAT(asImage(fileWith(codedPicture(3), srgb)).oddities, IsEmpty());
}

// A camera's curve is found by its codes, so that these stay.
TEST(CodedFile, CodesOfACameraStay) {
  const PictureCodes read = asCodes(fileWith(codedPicture(3), kP3));
  EXPECT_EQ(read.codes.texel(3, 2)[1], codedPicture(3).texel(3, 2)[1]);
  EXPECT_EQ(read.color.primaries, kDisplayP3);
  EXPECT_EQ(read.oddities.size(), 1u);
}

}  // namespace
}  // namespace mirrorball
