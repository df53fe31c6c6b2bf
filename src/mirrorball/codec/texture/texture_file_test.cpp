#include "mirrorball/codec/texture/texture_file.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;
using testing::textureOf;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class TextureFileTest : public testing::FolderTest {
 protected:
  /// The error of writing one texel of red, green and blue.
  Error errorOf(glm::vec3 color, TexelFormat format) {
    Image image(3, 2, 3, 1.0f);
    for (int c = 0; c < 3; ++c) image.texel(2, 1)[c] = color[c];
    const auto result = writeImageSet(folder_ / "a.ktx2", ImageSet(std::move(image)), {.format = format});
    return result ? Error{ErrorCode::usage, ""} : result.error();
  }
};

bool hasAlpha(TexelFormat format) { return format == TexelFormat::half || format == TexelFormat::float32; }

/// What a file gives back of a texel: red, green, blue and, where the format has it, alpha.
void expectTexel(const Image& read, const Image& written, int x, int y) {
  EXPECT_EQ(rgbAt(read, x, y), rgbAt(written, x, y));
  // A format without alpha gives back 1.
  EXPECT_EQ(rgbaAt(read, x, y).w, read.channels() == 4 ? rgbaAt(written, x, y).w : 1.0f);
}

void expectSame(const ImageSet& read, const ImageSet& written) {
  ASSERT_EQ(read.levels(), written.levels());
  ASSERT_EQ(read.layers(), written.layers());
  ASSERT_EQ(read.faces(), written.faces());
  for (int level = 0; level < read.levels(); ++level)
    for (int layer = 0; layer < read.layers(); ++layer)
      for (int face = 0; face < read.faces(); ++face) {
        const Image& a = read.at(level, face, layer);
        const Image& b = written.at(level, face, layer);
        ASSERT_EQ(a.width(), b.width());
        ASSERT_EQ(a.height(), b.height());
        for (int y = 0; y < a.height(); ++y)
          for (int x = 0; x < a.width(); ++x) expectTexel(a, b, x, y);
      }
}

/// Every format and shape comes back from that file.
void expectComesBack(const std::filesystem::path& file, int zstandard_level) {
  for (const TexelFormat format :
       {TexelFormat::half, TexelFormat::float32, TexelFormat::b10g11r11, TexelFormat::e5b9g9r9})
    for (const int faces : {1, 6})
      for (const int levels : {1, 2, 4})
        for (const int layers : {1, 3})
          for (const int channels : {1, 3, 4}) {
            SCOPED_TRACE(file.string() + " format " + std::to_string(static_cast<int>(format)) + " faces " +
                         std::to_string(faces) + " levels " + std::to_string(levels) + " layers " +
                         std::to_string(layers) + " channels " + std::to_string(channels));
            const ImageSet images = textureOf(levels, faces, layers, channels, faces == 6 ? 9 : 11, 9);
            ASSERT_TRUE(writeImageSet(file, images, {.format = format, .zstandard_level = zstandard_level}));
            const auto read = readImageSet(file);
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_EQ(read->images.at(0, 0).channels(), hasAlpha(format) ? 4 : 3);
            expectSame(read->images, images);
          }
}

TEST_F(TextureFileTest, EveryFormatContainerAndShapeComesBack) {
  for (const char* file : {"a.ktx2", "a.ktx", "a.dds"}) expectComesBack(folder_ / file, 0);
}

TEST_F(TextureFileTest, EveryFormatAndShapeComesBackFromZstandard) {
  MIRRORBALL_NEEDS(checkZstandard());
  expectComesBack(folder_ / "a.ktx2", 3);
}

/// Two channels come back as red and green, of whatever was written; blue is 0.
TEST_F(TextureFileTest, FormatsOfTwoChannelsKeepRedAndGreen) {
  for (const char* file : {"a.ktx2", "a.ktx", "a.dds"})
    for (const TexelFormat format : {TexelFormat::rg_half, TexelFormat::rg_float32})
      for (const int channels : {1, 2, 3, 4}) {
        SCOPED_TRACE(file + std::string(" channels ") + std::to_string(channels));
        const ImageSet images = textureOf(3, 6, 2, channels, 9, 9);
        ASSERT_TRUE(writeImageSet(folder_ / file, images, {.format = format}));
        const auto read = readImageSet(folder_ / file);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_THAT(read->format, HasSubstr(format == TexelFormat::rg_half ? ", r16g16 sfloat" : ", r32g32 sfloat"));
        for (int level = 0; level < 3; ++level)
          for (int y = 0; y < images.at(level, 5, 1).height(); ++y) {
            const float* texel = images.at(level, 5, 1).texel(0, y);
            EXPECT_EQ(rgbaAt(read->images.at(level, 5, 1), 0, y),
                      glm::vec4(texel[0], texel[channels == 1 ? 0 : 1], 0.0f, 1.0f));
          }
      }
}

TEST_F(TextureFileTest, TwoChannelsNeedAFormatOfTwo) {
  for (const TexelFormat format : {TexelFormat::half, TexelFormat::float32, TexelFormat::b10g11r11}) {
    const auto result = writeImageSet(folder_ / "a.ktx2", textureOf(1, 1, 1, 2, 3, 3), {.format = format});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::bad_shape);
    EXPECT_THAT(result.error().message, HasSubstr("2 channels"));
  }
}

/// Large enough for many pieces and threads, and rows that do not end where a piece ends.
TEST_F(TextureFileTest, LargeImagesComeBack) {
  const ImageSet images = textureOf(2, 1, 1, 3, 1021, 517);
  for (const char* file : {"a.ktx2", "a.ktx", "a.dds"}) {
    ASSERT_TRUE(writeImageSet(folder_ / file, images));
    const auto read = readImageSet(folder_ / file);
    ASSERT_TRUE(read) << read.error().message;
    expectSame(read->images, images);
  }
}

TEST_F(TextureFileTest, MetadataTravelsInKtx) {
  const Metadata metadata{{"envmap", "cube"}, {"mirrorball:projection", "cube"}, {"sh", "1 0.5 0.25"}};
  for (const char* file : {"a.ktx2", "a.ktx"}) {
    ASSERT_TRUE(writeImageSet(folder_ / file, textureOf(1, 6, 1, 3, 2, 2), {.metadata = metadata}));
    EXPECT_EQ(readImageSet(folder_ / file)->metadata, metadata) << file;
  }
}

TEST_F(TextureFileTest, TheFormatIsNamed) {
  const ImageSet images = textureOf(1, 1, 1, 3, 2, 2);
  ASSERT_TRUE(writeImageSet(folder_ / "a.dds", images, {.format = TexelFormat::b10g11r11}));
  EXPECT_EQ(readImageSet(folder_ / "a.dds")->format, "DDS, b10g11r11 ufloat");
  MIRRORBALL_NEEDS(checkZstandard());
  ASSERT_TRUE(writeImageSet(folder_ / "a.ktx2", images, {.zstandard_level = 1}));
  EXPECT_EQ(readImageSet(folder_ / "a.ktx2")->format, "KTX2, r16g16b16a16 sfloat, Zstandard");
}

TEST_F(TextureFileTest, WhatDoesNotFitIsRefusedAndNamed) {
  const Error error = errorOf({1.0f, 65505.0f, 2.0f}, TexelFormat::half);
  EXPECT_EQ(error.code, ErrorCode::out_of_range);
  EXPECT_THAT(error.message, HasSubstr("a.ktx2: texel (2, 1) of level 0 is 1 65505 2, but half floats hold -65504"));
  EXPECT_THAT(error.message, ::testing::EndsWith("; scale the light"));
  EXPECT_EQ(error.fix_hint, FixHint::store_floats);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.ktx2"));

  for (const TexelFormat format : {TexelFormat::b10g11r11, TexelFormat::e5b9g9r9})
    EXPECT_EQ(errorOf({-1e-30f, 0.0f, 0.0f}, format).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({65025.0f, 0.0f, 0.0f}, TexelFormat::b10g11r11).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({0.0f, 0.0f, 64513.0f}, TexelFormat::b10g11r11).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({0.0f, -kInfinity, 0.0f}, TexelFormat::b10g11r11).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({0.0f, 65409.0f, 0.0f}, TexelFormat::e5b9g9r9).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({0.0f, kInfinity, 0.0f}, TexelFormat::e5b9g9r9).code, ErrorCode::out_of_range);
  EXPECT_EQ(errorOf({0.0f, 0.0f, kNan}, TexelFormat::e5b9g9r9).code, ErrorCode::out_of_range);

  EXPECT_EQ(errorOf({0.0f, 65505.0f, 0.0f}, TexelFormat::rg_half).code, ErrorCode::out_of_range);

  // What fits, up to the brim.
  EXPECT_EQ(errorOf({65504.0f, -65504.0f, 1e6f}, TexelFormat::rg_half).message, "");
  EXPECT_EQ(errorOf({65504.0f, -65504.0f, kInfinity}, TexelFormat::half).message, "");
  EXPECT_EQ(errorOf({1e38f, kNan, -kInfinity}, TexelFormat::float32).message, "");
  EXPECT_EQ(errorOf({65024.0f, kInfinity, 64512.0f}, TexelFormat::b10g11r11).message, "");
  EXPECT_EQ(errorOf({kNan, -0.0f, 0.0f}, TexelFormat::b10g11r11).message, "");
  EXPECT_EQ(errorOf({65408.0f, -0.0f, 0.0f}, TexelFormat::e5b9g9r9).message, "");
}

TEST_F(TextureFileTest, TheFirstMisfitIsNamedWhateverThreadFindsOne) {
  ImageSet images = textureOf(2, 6, 2, 3, 512, 512);
  images.at(1, 5, 1).texel(0, 0)[0] = 1e6f;
  images.at(0, 3, 1).texel(500, 511)[2] = 1e6f;
  images.at(0, 3, 1).texel(499, 511)[2] = -1e6f;
  for (const char* file : {"a.ktx2", "a.ktx", "a.dds"}) {
    const auto result = writeImageSet(folder_ / file, images);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("texel (499, 511) of level 0, layer 1, face -Y"));
  }
}

TEST_F(TextureFileTest, WrongUsesAreNamed) {
  const ImageSet images = textureOf(1, 1, 1, 3, 4, 4);
  const auto codeOf = [&](const char* file, const ImageSet& set, const TextureWriteOptions& options = {}) {
    const auto result = writeImageSet(folder_ / file, set, options);
    return result ? ErrorCode::interrupted : result.error().code;
  };
  EXPECT_EQ(codeOf("a.png", images), ErrorCode::usage);
  for (const char* file : {"a.ktx", "a.dds"})
    EXPECT_EQ(codeOf(file, images, {.zstandard_level = 3}), ErrorCode::usage) << file;
  EXPECT_EQ(codeOf("a.ktx2", images, {.zstandard_level = 23}), ErrorCode::usage);
  EXPECT_EQ(codeOf("a.ktx2", images, {.metadata = {{"KTXwriter", "me"}}}), ErrorCode::usage);
  EXPECT_EQ(codeOf("a.ktx2", ImageSet()), ErrorCode::bad_shape);
  EXPECT_EQ(codeOf("a.ktx2", textureOf(1, 1, 1, 2, 4, 4)), ErrorCode::bad_shape);
  EXPECT_EQ(codeOf("a.ktx2", textureOf(1, 6, 1, 3, 4, 3)), ErrorCode::bad_shape);
  EXPECT_EQ(codeOf("a.ktx2", textureOf(1, 2, 1, 3, 4, 4)), ErrorCode::bad_shape);
  EXPECT_EQ(codeOf("a.ktx2", textureOf(4, 1, 1, 3, 4, 4)), ErrorCode::bad_shape);
  ImageSet uneven = textureOf(2, 1, 1, 3, 4, 4);
  uneven.at(1, 0) = Image(3, 2, 3);
  EXPECT_EQ(codeOf("a.ktx2", uneven), ErrorCode::bad_shape);
  EXPECT_EQ(codeOf("none/a.ktx2", images), ErrorCode::io);
}

TEST_F(TextureFileTest, ForeignBytesAreRefused) {
  EXPECT_EQ(decodeImageSet({}).error().code, ErrorCode::bad_file);
  EXPECT_EQ(decodeImageSet(testing::bytesOf("#?RADIANCE\n")).error().code, ErrorCode::bad_file);
  EXPECT_EQ(readImageSet(folder_ / "none.dds").error().code, ErrorCode::not_found);
}

/// Writing some pieces tells how far it is, and stops when it is told.
void expectProgress(const std::filesystem::path& folder, const TextureWriteOptions& format) {
  const ImageSet cube = textureOf(7, 6, 1, 3, 64, 64);
  std::mutex guard;
  std::size_t max = 0;
  TextureWriteOptions options = format;
  options.progress = [&](std::size_t done, std::size_t total) {
    const std::scoped_lock lock(guard);
    EXPECT_LE(done, total);
    max = std::max(max, done == total ? total : 0);
    return true;
  };
  ASSERT_TRUE(writeImageSet(folder / "whole.ktx2", cube, options));
  EXPECT_GT(max, 0u) << "it is told when all is done";

  options.progress = [](std::size_t done, std::size_t) { return done == 0; };
  const auto stopped = writeImageSet(folder / "stopped.ktx2", cube, options);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped.ktx2"));
}

TEST_F(TextureFileTest, TellsHowFarItIsAndStopsWhenItIsTold) { expectProgress(folder_, {.format = TexelFormat::bc6h}); }

TEST_F(TextureFileTest, ZstandardTellsHowFarItIsAndStopsWhenItIsTold) {
  MIRRORBALL_NEEDS(checkZstandard());
  expectProgress(folder_, {.zstandard_level = 1});
}

}  // namespace
}  // namespace mirrorball
