#include "mirrorball/codec/ldr/png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string_view>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "formula/color.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/png_testing.h"
#include "mirrorball/codec/written_format_testing.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using testing::gradient;
using ::testing::HasSubstr;

/// What a hand-made PNG is made of.
struct Recipe {
  int width = 1;
  int height = 1;
  int depth = 8;
  int color_type = PNG_COLOR_TYPE_RGB;
  bool interlaced = false;
  std::vector<png_color> palette = {};
  std::vector<png_byte> palette_alpha = {};
  std::vector<Bytes> rows = {};                               ///< as they stand in the file
  std::function<void(png_structp, png_infop)> describe = {};  ///< sets other chunks before the texels
};

Bytes made(const Recipe& recipe) {
  Bytes bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp writer, png_bytep from, std::size_t count) {
        auto* to = static_cast<Bytes*>(png_get_io_ptr(writer));
        to->insert(to->end(), from, from + count);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(recipe.width), static_cast<png_uint_32>(recipe.height), recipe.depth,
               recipe.color_type, recipe.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!recipe.palette.empty()) png_set_PLTE(png, info, recipe.palette.data(), static_cast<int>(recipe.palette.size()));
  if (!recipe.palette_alpha.empty())
    png_set_tRNS(png, info, recipe.palette_alpha.data(), static_cast<int>(recipe.palette_alpha.size()), nullptr);
  if (recipe.describe) recipe.describe(png, info);
  png_write_info(png, info);
  std::vector<Bytes> rows = recipe.rows;
  std::vector<png_bytep> pointers;
  for (Bytes& row : rows) pointers.push_back(row.data());
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

Image8 texture(const Bytes& bytes) {
  auto result = decodeTexture(bytes);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return Image8(1, 1, 4);
  }
  return std::move(*result);
}

DecodedImage light(const Bytes& bytes) {
  auto result = decodeImage(bytes);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return {Image(1, 1, 4), {}, ""};
  }
  return std::move(*result);
}

float linear(float encoded) { return formula::linearFromSrgb1(encoded); }

class PngSize : public ::testing::TestWithParam<std::tuple<glm::ivec2, int>> {};

TEST_P(PngSize, CodesComeBack) {
  const auto [size, channels] = GetParam();
  const Image8 picture = pictureFromLinear(gradient(size.x, size.y, channels), channels);
  const auto bytes = encodePng(picture, {});
  ASSERT_TRUE(bytes);
  const DecodedImage back = light(*bytes);
  ASSERT_EQ(back.image.channels(), channels);
  EXPECT_THAT(pictureFromLinear(back.image, channels).samples(), ::testing::ElementsAreArray(picture.samples()));
  EXPECT_EQ(back.format, "PNG, 8 bit");
  EXPECT_EQ(back.color, channels == 1 ? "sRGB, grey" : "sRGB");

  const Image8 rgba = texture(*bytes);
  const std::size_t last = rgba.samples().size() - 4;
  EXPECT_EQ(rgba.samples()[last], picture.samples()[picture.samples().size() - std::size_t(channels)]);
  EXPECT_EQ(rgba.samples()[last + 3], channels == 4 ? picture.samples().back() : 255);
}

INSTANTIATE_TEST_SUITE_P(SizesAndChannels, PngSize,
                         ::testing::Combine(::testing::Values(glm::ivec2{1, 1}, glm::ivec2{7, 3}, glm::ivec2{200, 90}),
                                            ::testing::Values(1, 3, 4)));

TEST(Png, MetadataComesBackAndForeignTextsDoNot) {
  const Metadata metadata{{"mirrorball:projection", "sphere"}, {"mirrorball:layout", ""}};
  EXPECT_EQ(light(*encodePng(Image8(1, 1, 3), metadata)).metadata, metadata);
  EXPECT_TRUE(light(*encodePng(Image8(1, 1, 3), {{"Software", "x"}})).metadata.empty());
}

// Unpacked, many of them would be a thousand times as large as their file.
TEST(Png, MetadataIsInTextsThatAreNeverCompressed) {
  const std::string key("mirrorball:projection\0", 22);
  EXPECT_EQ(light(testing::pngWithChunk("tEXt", key + "sphere")).metadata,
            (Metadata{{"mirrorball:projection", "sphere"}}));
  const std::string packed = testing::deflated("sphere");
  EXPECT_TRUE(light(testing::pngWithChunk("zTXt", key + std::string(1, '\0') + packed)).metadata.empty());
  EXPECT_TRUE(light(testing::pngWithChunk("iTXt", key + std::string("\1\0en\0\0", 6) + packed)).metadata.empty());
}

TEST(Png, GreyOfEveryDepth) {
  // Two texels: black and the brightest.
  for (const auto& [depth, row] : {std::pair{1, Bytes{0x40}},
                                   {2, Bytes{0x30}},
                                   {4, Bytes{0x0f}},
                                   {8, Bytes{0, 255}},
                                   {16, Bytes{0, 0, 255, 255}}}) {
    const Bytes bytes = made({.width = 2, .depth = depth, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {row}});
    EXPECT_THAT(light(bytes).image.samples(), ElementsAre(0.0f, 1.0f)) << depth;
    EXPECT_THAT(texture(bytes).samples(), ElementsAre(0, 0, 0, 255, 255, 255, 255, 255)) << depth;
  }
}

TEST(Png, GreyWithAlphaBecomesFourChannels) {
  const Bytes bytes = made({.color_type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {{128, 51}}});
  const float grey = linear(128.0f / 255.0f);
  EXPECT_THAT(light(bytes).image.samples(), ElementsAre(grey, grey, grey, 0.2f));
  EXPECT_THAT(texture(bytes).samples(), ElementsAre(128, 128, 128, 51));
}

TEST(Png, PalettesWithAlpha) {
  const Bytes bytes = made({.width = 2,
                            .depth = 4,
                            .color_type = PNG_COLOR_TYPE_PALETTE,
                            .palette = {{10, 20, 30}, {255, 0, 0}},
                            .palette_alpha = {0},
                            .rows = {{0x10}}});
  EXPECT_THAT(texture(bytes).samples(), ElementsAre(255, 0, 0, 255, 10, 20, 30, 0));
  EXPECT_EQ(light(bytes).image.channels(), 4);
  EXPECT_EQ(light(bytes).format, "PNG, 4 bit");
}

TEST(Png, SixteenBitsKeepTheirPrecisionAndRoundForTextures) {
  const Bytes bytes = made({.width = 2,
                            .depth = 16,
                            .rows = {{0x80, 0x00, 0x80, 0x01, 0x00, 0x81,  //
                                      0x12, 0x34, 0xff, 0xff, 0x00, 0x80}}});
  const Image image = light(bytes).image;
  EXPECT_FLOAT_EQ(image.samples()[0], linear(0x8000 / 65535.0f));
  EXPECT_FLOAT_EQ(image.samples()[1], linear(0x8001 / 65535.0f));
  EXPECT_NE(image.samples()[0], image.samples()[1]);
  EXPECT_FLOAT_EQ(image.samples()[3], linear(0x1234 / 65535.0f));
  // 0x0081/257 = 0.502 rounds up, 0x0080/257 = 0.498 down.
  EXPECT_THAT(texture(bytes).samples(), ElementsAre(128, 128, 1, 255, 18, 255, 0, 255));
}

TEST(Png, InterlacedRowsComeInOrder) {
  Recipe recipe{.width = 9, .height = 9, .color_type = PNG_COLOR_TYPE_GRAY, .interlaced = true};
  for (int y = 0; y < 9; ++y) {
    recipe.rows.emplace_back();
    for (int x = 0; x < 9; ++x) recipe.rows.back().push_back(static_cast<std::uint8_t>(10 * y + x));
  }
  const Image8 picture = texture(made(recipe));
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x) ASSERT_EQ(picture.texel(x, y)[0], 10 * y + x);
}

/// One texel of (255, 128, 0) with chunks that say what it means.
DecodedImage orangeWith(std::function<void(png_structp, png_infop)> describe) {
  return light(made({.rows = {{255, 128, 0}}, .describe = std::move(describe)}));
}

TEST(PngColor, GammaIsThePowerOfTheSamples) {
  const DecodedImage linear_light = orangeWith([](auto png, auto info) { png_set_gAMA_fixed(png, info, 100000); });
  EXPECT_THAT(linear_light.image.samples(), ElementsAre(1.0f, 128.0f / 255.0f, 0.0f));
  EXPECT_EQ(linear_light.color, "linear, Rec.709");
  const DecodedImage mac = orangeWith([](auto png, auto info) { png_set_gAMA_fixed(png, info, 55556); });
  EXPECT_NEAR(mac.image.samples()[1], 0.28921f, 1e-5f);  // (128/255)^1.8
  EXPECT_EQ(mac.color, "gamma 1.8, Rec.709");
}

TEST(PngColor, GammaOfSixteenBitsToo) {
  const Bytes bytes =
      made({.depth = 16, .rows = {{0x80, 0x01, 0xff, 0xff, 0x00, 0x01}}, .describe = [](auto png, auto info) {
              png_set_gAMA_fixed(png, info, 100000);
            }});
  EXPECT_THAT(light(bytes).image.samples(), ElementsAre(0x8001 / 65535.0f, 1.0f, 1 / 65535.0f));
}

TEST(PngColor, TheGammaThatStandsForSrgbIsSrgb) {
  const DecodedImage back = orangeWith([](auto png, auto info) { png_set_gAMA_fixed(png, info, 45455); });
  EXPECT_EQ(back.image.samples()[1], linear(128.0f / 255.0f));
  EXPECT_EQ(back.color, "sRGB");
}

TEST(PngColor, PrimariesAreConverted) {
  const DecodedImage back = orangeWith([](auto png, auto info) {
    png_set_gAMA_fixed(png, info, 100000);
    png_set_cHRM_fixed(png, info, 31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600);
  });
  const glm::vec3 expected = *rec709FromPrimaries(kRec2020) * glm::vec3(1.0f, 128.0f / 255.0f, 0.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.image.samples()[std::size_t(c)], expected[c], 1e-5f);
  EXPECT_EQ(back.color, "linear, primaries of the file (Rec.2020): converted");
}

/// Adds a chunk cICP: primaries, curve, matrix and range by ITU-T H.273.
void addCodePoints(png_structp png, png_infop info, std::array<png_byte, 4> numbers) {
  png_unknown_chunk chunk{{'c', 'I', 'C', 'P', 0}, numbers.data(), numbers.size(), PNG_HAVE_IHDR};
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, chunk.name, 1);
  png_set_unknown_chunks(png, info, &chunk, 1);
}

TEST(PngColor, CodePointsGoBeforeAllOthers) {
  const DecodedImage back = orangeWith([](auto png, auto info) {
    addCodePoints(png, info, {12, 13, 0, 1});
    png_set_gAMA_fixed(png, info, 100000);
    png_set_cHRM_fixed(png, info, 31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600);
  });
  const glm::vec3 expected = *rec709FromPrimaries(kDisplayP3) * glm::vec3(1.0f, linear(128.0f / 255.0f), 0.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.image.samples()[std::size_t(c)], expected[c], 1e-6f);
  EXPECT_EQ(back.color, "sRGB, primaries of the file (Display P3): converted");
  // PQ's greatest code is 10000 cd/m², and 1 is graphics white.
  const DecodedImage pq = orangeWith([](auto png, auto info) { addCodePoints(png, info, {9, 16, 0, 1}); });
  EXPECT_NEAR(pq.image.samples()[0], 1.6605f * 10000.0f / 203.0f, 0.6f);
  EXPECT_EQ(pq.color, "PQ, primaries of the file (Rec.2020): converted");
}

TEST(PngColor, CodePointsOfOtherThanFullRgbArePassedOver) {
  for (const std::array<png_byte, 4> numbers : {std::array<png_byte, 4>{9, 16, 1, 1}, {9, 16, 0, 0}})
    EXPECT_EQ(orangeWith([&](auto png, auto info) { addCodePoints(png, info, numbers); }).color, "sRGB");
}

TEST(PngColor, WiderPrimariesAreStatedForOldReadersToo) {
  const auto has = [](const Bytes& bytes, std::string_view chunk) {
    return std::search(bytes.begin(), bytes.end(), chunk.begin(), chunk.end()) != bytes.end();
  };
  using namespace std::string_view_literals;
  const Image8 picture = pictureFromLinear(gradient(7, 3, 4), 4);
  for (const auto& [primaries, chunk, name] :
       {std::tuple(OutputPrimaries::p3, "\0\0\0\4cICP\x0c\x0d\0\1"sv, "Display P3"),
        std::tuple(OutputPrimaries::rec2020, "\0\0\0\4cICP\x09\x0d\0\1"sv, "Rec.2020")}) {
    const Bytes bytes = *encodePng(picture, {}, primaries);
    EXPECT_TRUE(has(bytes, chunk)) << name;
    EXPECT_TRUE(has(bytes, "cHRM") && has(bytes, "gAMA") && !has(bytes, "sRGB")) << name;
    EXPECT_EQ(light(bytes).color, std::string("sRGB, primaries of the file (") + name + "): converted");
    EXPECT_THAT(texture(bytes).samples(), ::testing::ElementsAreArray(picture.samples()));
    Image back = light(bytes).image;
    convertFromRec709(back, primaries);
    EXPECT_THAT(pictureFromLinear(back, 4).samples(), ::testing::ElementsAreArray(picture.samples()));
  }
  const Bytes plain = *encodePng(picture, {});
  EXPECT_TRUE(has(plain, "sRGB") && !has(plain, "cICP") && !has(plain, "cHRM"));
}

TEST(PngColor, TheChunkSrgbGoesBeforeTheOthers) {
  const DecodedImage back =
      orangeWith([](auto png, auto info) { png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL); });
  EXPECT_EQ(back.image.samples()[1], linear(128.0f / 255.0f));
  EXPECT_EQ(back.color, "sRGB");
}

TEST(PngColor, AProfileOfAMatrixIsConverted) {
  const DecodedImage back = orangeWith([](auto png, auto info) {
    const Bytes profile = testing::iccDisplayP3();
    png_set_iCCP(png, info, "any", PNG_COMPRESSION_TYPE_BASE, profile.data(), static_cast<png_uint_32>(profile.size()));
  });
  EXPECT_EQ(back.color, "sRGB, primaries of the file (Display P3): converted");
  const glm::vec3 expected = *rec709FromPrimaries(kDisplayP3) * glm::vec3(1.0f, linear(128.0f / 255.0f), 0.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.image.samples()[std::size_t(c)], expected[c], 1e-3f);
}

TEST(PngColor, AProfileOfANameAloneIsNotApplied) {
  const DecodedImage back = orangeWith([](auto png, auto info) {
    const Bytes profile = testing::iccProfile("Display P3");
    png_set_text_compression_level(png, 0);  // libpng takes a chunk of less than 92 bytes for none
    png_set_iCCP(png, info, "any", PNG_COMPRESSION_TYPE_BASE, profile.data(), static_cast<png_uint_32>(profile.size()));
    png_set_gAMA_fixed(png, info, 100000);
  });
  EXPECT_EQ(back.color, "sRGB assumed: its ICC profile (Display P3) is not applied");
  EXPECT_EQ(back.image.samples()[1], linear(128.0f / 255.0f));
}

TEST(PngColor, OfGreyOnlyTheGammaCounts) {
  const DecodedImage back =
      light(made({.color_type = PNG_COLOR_TYPE_GRAY, .rows = {{51}}, .describe = [](auto png, auto info) {
                    png_set_gAMA_fixed(png, info, 100000);
                    png_set_cHRM_fixed(png, info, 31270, 32900, 70800, 29200, 17000, 79700, 13100, 4600);
                  }}));
  EXPECT_THAT(back.image.samples(), ElementsAre(0.2f));
  EXPECT_EQ(back.color, "linear, grey");
}

TEST(PngColor, TexturesOfNumbersAreLeftAsTheyStand) {
  const Bytes bytes =
      made({.rows = {{255, 128, 0}}, .describe = [](auto png, auto info) { png_set_gAMA_fixed(png, info, 100000); }});
  EXPECT_THAT(texture(bytes).samples(), ElementsAre(255, 128, 0, 255));
  EXPECT_THAT(std::get<Image8>(decodeDataTexture(bytes)->picture).samples(), ElementsAre(255, 128, 0, 255));
  const auto colors = decodeColorTexture(bytes);
  EXPECT_THAT(std::get<Image8>(colors->picture).samples(), ElementsAre(255, srgb8FromLinear(128.0f / 255.0f), 0, 255));
  EXPECT_THAT(colors->oddities, ElementsAre("its colours are not sRGB's: linear, Rec.709"));
}

TEST(Png, IsUprightAsItsExifSays) {
  Bytes exif{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0};
  const auto file = [&] {
    return made(
        {.width = 2, .color_type = PNG_COLOR_TYPE_GRAY, .rows = {{51, 102}}, .describe = [&](auto png, auto info) {
           png_set_eXIf_1(png, info, static_cast<png_uint_32>(exif.size()), exif.data());
         }});
  };
  const auto turned = decodeImage(file());
  ASSERT_TRUE(turned) << turned.error().message;
  EXPECT_EQ(turned->image.height(), 2);
  EXPECT_EQ(turned->image.channels(), 1);
  EXPECT_THAT(turned->image.samples(), ElementsAre(linear(0.2f), linear(0.4f)));
  EXPECT_THAT(turned->oddities, ElementsAre("turned upright, as its EXIF says (orientation 6)"));
  exif[19] = 3;
  EXPECT_THAT(decodeImage(file())->image.samples(), ElementsAre(linear(0.4f), linear(0.2f)));
}

/// A PNG whose IHDR says another size, with the right checksum.
Bytes pngWithSize(Bytes bytes, std::uint32_t width, std::uint32_t height) {
  png_save_uint_32(bytes.data() + 16, width);
  png_save_uint_32(bytes.data() + 20, height);
  std::uint32_t crc = ~0u;  // PNG's annex D, bit by bit over the chunk's name and its 13 bytes
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  png_save_uint_32(bytes.data() + 29, ~crc);
  return bytes;
}

TEST(Png, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
  const Bytes bytes = *encodePng(Image8(4, 4, 3), {});
  ASSERT_TRUE(decodePng(pngWithSize(bytes, 4, 4)));
  EXPECT_EQ(decodePng(pngWithSize(bytes, 0, 4)).error().code, ErrorCode::bad_file);
  EXPECT_EQ(decodePng(pngWithSize(bytes, 1u << 31, 4)).error().code, ErrorCode::bad_file);
  EXPECT_EQ(decodePng(pngWithSize(bytes, 1u << 20, 1u << 20)).error().code, ErrorCode::too_large);
  EXPECT_THAT(decodePng(pngWithSize(bytes, 10000, 10000)).error().message, HasSubstr("cannot hold"));
}

TEST(Png, DamageNamesTheByte) {
  const Bytes bytes = *encodePng(Image8(40, 40, 3), {});
  const Bytes truncated(bytes.begin(), bytes.begin() + 42);
  EXPECT_EQ(decodePng(truncated).error().message.substr(0, 23), "the chunk at byte 33 sa");  // sRGB, behind IHDR
  const Bytes endless(bytes.begin(), bytes.begin() + 46);
  EXPECT_THAT(decodePng(endless).error().message, HasSubstr("no end chunk"));
  Bytes changed = bytes;
  changed[60] ^= 1;
  EXPECT_THAT(decodePng(changed).error().message, ::testing::StartsWith("is a damaged PNG, at byte "));
}

/// The first bytes of a file.
Bytes firstBytes(const Bytes& bytes, std::size_t count) {
  return Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(count));
}

/// Rows of texels without any order, which deflate cannot shorten: bytes of the file are bytes of rows.
Recipe noise(int width, int height, int channels, int depth = 8) {
  const int color_type = channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
  Recipe recipe{.width = width, .height = height, .depth = depth, .color_type = color_type};
  std::uint32_t state = 1;
  for (int y = 0; y < height; ++y) {
    recipe.rows.emplace_back(std::size_t(width * channels * depth / 8));
    for (std::uint8_t& byte : recipe.rows.back()) byte = static_cast<std::uint8_t>((state = state * 1664525 + 1) >> 24);
  }
  return recipe;
}

TEST(PngEnd, AsFarAsItGoes) {
  const Recipe recipe = noise(16, 20, 3);
  const Bytes bytes = made(recipe);
  const Image8 whole = texture(bytes);
  int rows_before = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const auto cut = decodeCodes(firstBytes(bytes, length));
    if (!cut) {
      EXPECT_EQ(rows_before, 0) << length;
      continue;
    }
    ASSERT_EQ(cut->oddities.size(), 1u) << length;
    int rows = 20;
    if (std::sscanf(cut->oddities[0].c_str(), "ends before its last row: the %d rows", &rows) == 1) rows = 20 - rows;
    if (cut->oddities[0] == "ends before its last row: the row that is missing is black") rows = 19;
    ASSERT_GE(rows, rows_before) << length;
    rows_before = rows;
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 16; ++x) {
        ASSERT_EQ(cut->codes.texel(x, y)[1], y < rows ? whole.texel(x, y)[1] : 0) << length;
        ASSERT_EQ(cut->codes.texel(x, y)[3], 255);
      }
  }
  EXPECT_EQ(rows_before, 20);
  EXPECT_THAT(decodeImage(firstBytes(bytes, bytes.size() / 2))->oddities[0],
              ::testing::MatchesRegex("ends before its last row: the 1[01] rows that are missing are black"));
}

TEST(PngEnd, WithoutItsEndChunkAllRowsAreThere) {
  const Bytes bytes = made(noise(16, 20, 3));
  const auto image = decodeImage(firstBytes(bytes, bytes.size() - 12));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_THAT(image->oddities, ElementsAre("lacks its end chunk; all of its rows are there"));
  EXPECT_THAT(image->image.samples(), ::testing::ElementsAreArray(light(bytes).image.samples()));
}

TEST(PngEnd, RowsThatAreMissingAreOpaque) {
  for (const int depth : {8, 16}) {
    const Bytes bytes = made(noise(16, 20, 4, depth));
    const auto image = decodeImage(firstBytes(bytes, bytes.size() / 2));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_THAT(std::vector<float>(image->image.texel(7, 19), image->image.texel(7, 19) + 4),
                ElementsAre(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(image->image.texel(7, 3)[3], light(bytes).image.texel(7, 3)[3]);
  }
}

// The last of the seven passes has half of the texels, in every other row; the fifth ends with a quarter of them.
TEST(PngEnd, AnInterlacedFileIsCoarser) {
  Recipe recipe = noise(32, 32, 3);
  recipe.interlaced = true;
  const Bytes bytes = made(recipe);
  const Image8 whole = texture(bytes);
  const auto cut = decodeCodes(firstBytes(bytes, bytes.size() / 2));
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_THAT(cut->oddities, ElementsAre("ends before its last pass: it is coarser than it was meant to be"));
  for (int y = 0; y < 32; y += 2)
    for (int x = 0; x < 32; x += 2) {
      ASSERT_EQ(cut->codes.texel(x, y)[2], whole.texel(x, y)[2]) << x << ", " << y;
      ASSERT_EQ(cut->codes.texel(x, y + 1)[2], whole.texel(x, y)[2])
          << x << ", " << y;  // stands in for what is missing
    }
  const auto first_pass = decodeCodes(firstBytes(bytes, 80));
  ASSERT_TRUE(first_pass) << first_pass.error().message;
  EXPECT_THAT(first_pass->oddities[0], ::testing::EndsWith("rows that are missing are black"));
  EXPECT_EQ(first_pass->codes.texel(7, 7)[1], whole.texel(0, 0)[1]);
  EXPECT_EQ(first_pass->codes.texel(31, 31)[1], 0);
}

TEST(PngEnd, DamagedTexelsAreNoEnd) {
  Bytes bytes = made(noise(16, 20, 3));
  bytes[60] ^= 0x40;
  EXPECT_FALSE(decodePng(firstBytes(bytes, bytes.size() - 12)));
}

using testing::Damage;

INSTANTIATE_TEST_SUITE_P(Png, Damage,
                         ::testing::Values(testing::inPart(
                             "Png",
                             [] {
                               return *encodePng(pictureFromLinear(gradient(13, 11, 3), 3), {{"envmap", "cube"}});
                             })),
                         testing::nameOfDamaged);

using testing::CodecFormat;

INSTANTIATE_TEST_SUITE_P(Png, CodecFormat, ::testing::Values(testing::WrittenFormat{"a.png", 0.005f, true}));

}  // namespace
}  // namespace mirrorball
