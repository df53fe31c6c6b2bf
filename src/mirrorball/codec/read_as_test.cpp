// Every format that can state a colour space, in a build that has them all: the same file as colours and as numbers.
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/color.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/avif_testing.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/ldr/jxl_testing.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/tiff/tiff_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const glm::vec3 kNumbers(0.25f, 0.5f, 0.75f);   // what formats of floats hold
const glm::vec3 kCodes(51.0f, 102.0f, 204.0f);  // what formats of 8 bits hold
const glm::vec3 kFractions = kCodes / 255.0f;

/// A file of one colour that states a colour space.
struct Stated {
  std::string name;
  Bytes bytes;
  glm::vec3 stored;   ///< its numbers
  std::string space;  ///< as the remark names it; empty: the file states none
  bool has_srgb_curve = false;
  std::optional<Primaries> primaries = kDisplayP3;
  float tolerance = 1e-6f;  ///< of numbers, in a lossy format
};

template <typename Sample>
ImageOf<Sample> flat(glm::vec3 color) {
  ImageOf<Sample> image(8, 8, 3);
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    image.samples()[i] = static_cast<Sample>(color[static_cast<int>(i % 3)]);
  return image;
}

/// Its first texel alone has the color: libjxl 0.7 writes others where a picture of floats has few of them.
Image varied(glm::vec3 color) {
  Image image = flat<float>(color);
  for (std::size_t i = 3; i < image.samples().size(); ++i) image.samples()[i] = static_cast<float>(i) / 256.0f;
  return image;
}

Bytes repeated(const Bytes& texel) {
  Bytes bytes;
  for (int i = 0; i < 64; ++i) bytes.insert(bytes.end(), texel.begin(), texel.end());
  return bytes;
}

Bytes tiff(int bits, const Bytes& samples) {
  testing::TiffForm form{.width = 8, .height = 8, .bits = static_cast<std::uint16_t>(bits)};
  form.kind = bits == 32 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT;
  form.profile = testing::iccDisplayP3();
  return testing::tiffFile(form, samples);
}

Bytes bmp() {
  const testing::BmpForm form{.header = 124, .width = 8, .height = 8, .profile = testing::iccDisplayP3()};
  return testing::bmpFile(form, repeated({204, 102, 51}));
}

Bytes xyze() {
  const Bytes rgbe = encodeHdr(flat<float>(kNumbers), {}, OutputPrimaries::rec709);
  std::string text(rgbe.begin(), rgbe.end());
  text.replace(text.find("rle_rgbe"), 8, "rle_xyze");
  return testing::bytesOf(text);
}

/// Floats of one texture under another format of the same size, whose texels are the four bytes.
Bytes relabelled(Bytes file, std::size_t at, std::uint8_t format, bool has_descriptor) {
  file[at] = format;
  for (std::size_t i = 0; i < 64; ++i)
    std::copy_n(Bytes{51, 102, 204, 255}.begin(), 4, file.end() - 4 * std::ptrdiff_t(i + 1));
  if (has_descriptor) file[std::size_t{file[48]} + 14] = 2;  // sRGB
  return file;
}

Bytes ktx1() {
  Bytes file = testing::ktx1Header(
      {.type = 0x1401, .type_size = 1, .internal_format = 0x8c43, .width = 8, .height = 8});  // GL_SRGB8_ALPHA8
  testing::appendU32(file, 4 * 64, false);
  const Bytes texels = repeated({51, 102, 204, 255});
  file.insert(file.end(), texels.begin(), texels.end());
  return file;
}

std::vector<Stated> everyFormat() {
  const Image floats = flat<float>(kNumbers);
  const Image8 codes = flat<std::uint8_t>(kCodes);
  const Bytes profile = testing::iccDisplayP3();
  const TextureWriteOptions packed{.format = TexelFormat::e5b9g9r9};
  const ImageSet texture(floats);
  const std::string p3 = "sRGB, Display P3", linear_p3 = "linear, Display P3";
  return {
      {"OpenEXR", *encodeExr(floats, {.primaries = OutputPrimaries::p3}), kNumbers, linear_p3},
      {"Radiance", encodeHdr(floats, {}, OutputPrimaries::p3), kNumbers, linear_p3},
      {"Radiance, XYZE", xyze(), kNumbers, "linear, CIE XYZ", false, std::nullopt},
      {"PNG", *encodePng(codes, {}, OutputPrimaries::p3), kFractions, p3, true},
      {"JPEG", testing::jpegWithProfile(*encodeJpeg(codes, {}), profile), kFractions, p3, true, kDisplayP3, 0.01f},
      {"TIFF", tiff(8, repeated({51, 102, 204})), kFractions, p3, true},
      {"TIFF of floats",
       tiff(32, testing::bytesOfNumbers(std::vector(floats.samples().begin(), floats.samples().end()))), kNumbers,
       linear_p3},
      {"WebP", testing::extendedWebp(codes, 0x20, "ICCP", profile), kFractions, p3, true},
      {"AVIF", testing::avifFile(codes, {.primaries = 12}), kFractions, p3, true},
      {"JPEG XL", testing::jxlFile(codes, {.primaries = JXL_PRIMARIES_P3}), kFractions, p3, true},
      {"JPEG XL of floats",
       testing::jxlFile(varied(kNumbers), {.transfer = JXL_TRANSFER_FUNCTION_LINEAR, .primaries = JXL_PRIMARIES_P3}),
       kNumbers, linear_p3},
      {"BMP", bmp(), kFractions, p3, true},
      {"KTX2", testing::bytesOfTexture(writeKtx2, texture, {.primaries = OutputPrimaries::p3}), kNumbers, linear_p3},
      {"KTX2, sRGB", relabelled(testing::bytesOfTexture(writeKtx2, texture, packed), 12, 43, true), kFractions, "sRGB",
       true, std::nullopt},
      {"KTX", ktx1(), kFractions, "sRGB", true, std::nullopt},
      {"DDS, sRGB", relabelled(testing::bytesOfTexture(writeDds, texture, packed), 128, 29, false), kFractions, "sRGB",
       true, std::nullopt},
      {"DDS before DX10",
       testing::oldDds(
           {.width = 8, .height = 8, .flags = 0x41, .bits = 32, .masks = {0xff, 0xff00, 0xff0000, 0xff000000}},
           repeated({51, 102, 204, 255})),
       kFractions, "", true, std::nullopt},
  };
}

glm::vec3 firstTexel(const Image& image) { return rgbAt(image, 0, 0); }

glm::vec3 firstTexel(const Texels& texels) {
  if (const auto* floats = std::get_if<Image>(&texels)) return firstTexel(*floats);
  const std::uint8_t* code = std::get<Image8>(texels).texel(0, 0);
  return glm::vec3(code[0], code[1], code[2]) / 255.0f;
}

void expectNear(glm::vec3 actual, glm::vec3 expected, float tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

TEST(ReadAs, NumbersAreTheFilesWhateverItSaysOfColors) {
  for (const Stated& file : everyFormat()) {
    SCOPED_TRACE(file.name);
    const auto numbers = decodeNumbers(file.bytes);
    const auto texture = decodeDataTexture(file.bytes);
    ASSERT_TRUE(numbers && texture);
    expectNear(firstTexel(numbers->picture), file.stored, file.tolerance);
    expectNear(firstTexel(texture->picture), file.stored, file.tolerance);
    const std::string remark = "states a colour space (" + file.space +
                               "), which does not count for numbers: they are read as they are stored";
    for (const auto& oddities : {numbers->oddities, texture->oddities}) {
      if (file.space.empty())
        EXPECT_THAT(oddities, IsEmpty());
      else
        EXPECT_THAT(oddities, ElementsAre(remark));
    }
    EXPECT_FALSE(texture->is_converted);
    EXPECT_EQ(decodeImage(file.bytes, {.as = ReadAs::numbers})->color, "none: numbers as they are stored");
  }
}

TEST(ReadAs, ColorsAreConverted) {
  for (const Stated& file : everyFormat()) {
    SCOPED_TRACE(file.name);
    const auto image = decodeImage(file.bytes);
    const auto texture = decodeColorTexture(file.bytes);
    ASSERT_TRUE(image && texture);
    glm::vec3 light = file.has_srgb_curve ? formula::linearFromSrgb(file.stored) : file.stored;
    if (file.primaries) light = *rec709FromPrimaries(*file.primaries) * light;
    if (file.name == "Radiance, XYZE") light = formula::rec709FromXyz(light);
    expectNear(firstTexel(image->image), light, file.tolerance + 1e-5f);
    const bool is_coded = std::holds_alternative<Image8>(texture->picture);
    const glm::vec3 shown =
        is_coded ? formula::linearFromSrgb(firstTexel(texture->picture)) : firstTexel(texture->picture);
    expectNear(shown, light, 0.01f);
    EXPECT_TRUE(texture->is_converted);
  }
}

// A picture of numbers with a channel of its own beside them: light would be multiplied by it.
TEST(ReadAs, StraightAlphaOfATiffOfFloatsLeavesNumbersAlone) {
  testing::TiffForm form{.width = 1, .height = 1, .samples = 4, .bits = 32, .kind = SAMPLEFORMAT_IEEEFP};
  form.extras = {EXTRASAMPLE_UNASSALPHA};
  const Bytes file = testing::tiffFile(form, testing::bytesOfNumbers(std::vector<float>{0.25f, 0.5f, 1.0f, 0.5f}));
  EXPECT_THAT(decodeNumbers(file)->picture.samples(), ElementsAre(0.25f, 0.5f, 1.0f, 0.5f));
  EXPECT_THAT(decodeImage(file)->image.samples(), ElementsAre(0.125f, 0.25f, 0.5f, 0.5f));
}

}  // namespace
}  // namespace mirrorball
