#include "mirrorball/gl/texture.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/buffer.h"
#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"

namespace mirrorball::gl {
namespace {

using ::testing::HasSubstr;

/// An image in which no two texels or channels are alike, with values in [0, 1).
Image patternImage(int width, int height, int channels, float seed = 0.0f) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.samples().size(); ++i) {
    const float x = 0.37f * static_cast<float>(i) + 0.11f * seed;
    image.samples()[i] = x - std::floor(x);
  }
  return image;
}

/// The largest difference between an image and a texture that should hold it.
float largestDifference(const Image& expected, const Image& actual) {
  float largest = 0.0f;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x) {
      const glm::vec4 difference = glm::abs(rgbaAt(expected, x, y) - rgbaAt(actual, x, y));
      largest = std::max({largest, difference.x, difference.y, difference.z, difference.w});
    }
  }
  return largest;
}

class TextureTest : public GlTest {};

MIRRORBALL_WITH_BOTH_APIS(TextureTest);

TEST_P(TextureTest, KeepsFloatsAsEachFormatCan) {
  // Half of a step: of 8 bits; of 8 bits where light rises most with the sRGB code, by 2.4 / 1.055
  // at 1; of the 11 bits of a half float below 1.
  const std::array<std::pair<Format, float>, 4> kCases = {{{Format::rgba8, 0.5f / 255.0f},
                                                           {Format::srgb8_alpha8, 1.15f / 255.0f},
                                                           {Format::rgba16f, 1.0f / 4096.0f},
                                                           {Format::rgba32f, 0.0f}}};
  for (const auto& [format, tolerance] : kCases) {
    for (int channels : {1, 3, 4}) {
      const Image image = patternImage(5, 3, channels);
      auto texture = Texture::make2d(format, 5, 3);
      ASSERT_TRUE(texture) << texture.error().message;
      texture->upload(0, 0, image);
      EXPECT_LE(largestDifference(image, texture->read()), tolerance + 1e-7f)
          << "format " << static_cast<int>(format) << ", channels " << channels;
    }
  }
}

// Of odd widths, whose rows are no whole words of the driver's.
TEST_P(TextureTest, KeepsTheFirstChannelsAlone) {
  const Image image = patternImage(37, 5, 3);
  for (const auto& [format, channels] : {std::pair(Format::r32f, 1), std::pair(Format::rg32f, 2)}) {
    auto texture = Texture::fromImages(format, ImageSet(image));
    ASSERT_TRUE(texture) << texture.error().message;
    EXPECT_EQ(texture->bytes(), 37u * 5u * 4u * unsigned(channels));
    const Image read = texture->read();
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < 37; ++x)
        for (int channel = 0; channel < 3; ++channel)
          EXPECT_EQ(read.texel(x, y)[channel], channel < channels ? image.texel(x, y)[channel] : 0.0f);
  }
}

TEST_P(TextureTest, KeepsBytesAsTheyAre) {
  Image8 image(3, 2, 3);
  for (std::size_t i = 0; i < image.samples().size(); ++i) {
    image.samples()[i] = static_cast<std::uint8_t>(i * 14);
  }
  auto texture = Texture::make2d(Format::rgba8, 3, 2);
  ASSERT_TRUE(texture);
  texture->upload(image);
  const Image read = texture->read();
  EXPECT_FLOAT_EQ(read.texel(0, 0)[0], 0.0f);
  EXPECT_FLOAT_EQ(read.texel(2, 1)[1], static_cast<float>(16 * 14) / 255.0f);
  EXPECT_FLOAT_EQ(read.texel(2, 1)[3], 1.0f);
}

TEST_P(TextureTest, DecodesSrgbBytes) {
  Image8 image(1, 1, 4, 188);  // the code that stands for half of the light
  auto texture = Texture::make2d(Format::srgb8_alpha8, 1, 1);
  ASSERT_TRUE(texture);
  texture->upload(image);
  EXPECT_NEAR(texture->read().texel(0, 0)[0], 0.5f, 0.005f);
  EXPECT_FLOAT_EQ(texture->read().texel(0, 0)[3], 188.0f / 255.0f);
}

TEST_P(TextureTest, KeepsEveryFaceAndLevelOfACube) {
  ImageSet images(3, 6);
  for (int level = 0; level < 3; ++level) {
    for (int face = 0; face < 6; ++face) {
      images.at(level, face) = patternImage(4 >> level, 4 >> level, 3, static_cast<float>(6 * level + face));
    }
  }
  auto cube = Texture::fromImages(Format::rgba32f, images);
  ASSERT_TRUE(cube) << cube.error().message;
  EXPECT_TRUE(cube->isCube());
  EXPECT_EQ(cube->levels(), 3);
  for (int level = 0; level < 3; ++level) {
    for (int face = 0; face < 6; ++face) {
      EXPECT_EQ(largestDifference(images.at(level, face), cube->read(level, face)), 0.0f)
          << "level " << level << ", face " << face;
    }
  }
}

TEST_P(TextureTest, ALayerOfAnArrayTakesASmallerImageInItsCorner) {
  auto array = Texture::makeArray(Format::rgba8, 4, 3, 3, Texture::kAllLevels);
  ASSERT_TRUE(array) << array.error().message;
  EXPECT_FALSE(array->isCube());
  EXPECT_EQ(array->levels(), 3);
  Image8 small(2, 1, 3);
  for (std::size_t i = 0; i < small.samples().size(); ++i) small.samples()[i] = static_cast<std::uint8_t>(40 * i);
  for (int layer = 0; layer < 3; ++layer) array->upload(0, layer, Image8(4, 3, 4, std::uint8_t(17 * layer)));
  array->upload(0, 1, small);
  array->upload(1, 2, Image8(2, 1, 4, 255));
  for (int layer = 0; layer < 3; ++layer) {
    const Image read = array->read(0, layer);
    EXPECT_FLOAT_EQ(read.texel(3, 2)[0], static_cast<float>(17 * layer) / 255.0f) << layer;
    EXPECT_FLOAT_EQ(read.texel(1, 0)[1], static_cast<float>(layer == 1 ? 160 : 17 * layer) / 255.0f) << layer;
  }
  EXPECT_FLOAT_EQ(array->read(1, 2).texel(1, 0)[3], 1.0f);
}

TEST_P(TextureTest, UploadsInSeveralBands) {
  // Taller than one band of 2 MiB, with a last band of another height.
  const Image image = patternImage(1024, 517, 3);
  auto texture = Texture::make2d(Format::rgba16f, 1024, 517);
  ASSERT_TRUE(texture);
  texture->upload(0, 0, image);
  EXPECT_LE(largestDifference(image, texture->read()), 1.0f / 4096.0f);
}

TEST_P(TextureTest, AllLevelsEndInOneTexel) {
  auto texture = Texture::make2d(Format::rgba16f, 4, 4, Texture::kAllLevels);
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->levels(), 3);
  texture->upload(2, 0, Image(1, 1, 3, 0.25f));
  EXPECT_EQ(texture->read(2).texel(0, 0)[0], 0.25f);
}

TEST_P(TextureTest, RefusesWhatTheDriverCannotTake) {
  const auto texture = Texture::make2d(Format::rgba8, 1 << 20, 1);
  ASSERT_FALSE(texture);
  EXPECT_EQ(texture.error().code, ErrorCode::too_large);
  EXPECT_THAT(texture.error().message, HasSubstr("1048576 × 1 texels is larger than"));
}

constexpr std::string_view kScreenVertex =
    "void main() {\n"
    "  gl_Position = vec4(float(gl_VertexID % 2) * 4.0 - 1.0,\n"
    "                     float(gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n"
    "}\n";
constexpr std::string_view kCubeFragment =
    "uniform samplerCube cube;\n"
    "uniform vec3 direction;\n"
    "out vec4 color;\n"
    "void main() { color = sampleLod(cube, direction, 0.0); }\n";

TEST_P(TextureTest, CubesAreFilteredAcrossTheirEdges) {
  const auto find = [](std::string_view name) -> std::optional<std::string_view> {
    return name == "v" ? kScreenVertex : kCubeFragment;
  };
  const auto vertex = shaderSource(GetParam(), "v", {}, find);
  const auto fragment = shaderSource(GetParam(), "f", {}, find);
  ASSERT_TRUE(vertex && fragment);
  auto program = Program::build(*vertex, *fragment, "cube");
  ASSERT_TRUE(program) << program.error().message;
  auto cube = Texture::makeCube(Format::rgba8, 2);
  ASSERT_TRUE(cube);
  for (int face = 0; face < 6; ++face) {
    cube->upload(0, face, Image(2, 2, 1, face == 0 ? 1.0f : 0.0f));  // +X is white
  }
  auto framebuffer = Framebuffer::make(Format::rgba8, 1, 1);
  ASSERT_TRUE(framebuffer);
  const VertexArray triangle;
  const auto seenAlong = [&](glm::vec3 direction) {
    framebuffer->bind();
    cube->bind(3);
    program->set("cube", 3);
    program->set("direction", direction);
    triangle.draw(3);
    return framebuffer->readFloat().texel(0, 0)[0];
  };
  EXPECT_FLOAT_EQ(seenAlong({1.0f, 0.0f, 0.0f}), 1.0f);
  EXPECT_FLOAT_EQ(seenAlong({0.0f, 0.0f, 1.0f}), 0.0f);
  EXPECT_NEAR(seenAlong({1.0f, 0.0f, 0.9999f}), 0.5f, 0.01f);
}

}  // namespace
}  // namespace mirrorball::gl
