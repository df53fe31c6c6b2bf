/// The decoder of BC6H gives the same numbers as the OpenGL driver, for every mode, partition and index. Drivers differ
/// in the sign of 0.

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/codec/bc6h/bc6h_block.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/image/small_float.h"

namespace mirrorball {
namespace {

constexpr int kBlocksAcross = 256;
constexpr int kBlocksDown = 160;
constexpr std::size_t kBlocks = std::size_t(kBlocksAcross) * kBlocksDown;

/// Random bits with each of the 32 codes of five bits in turn, which are all modes and the reserved codes; in every
/// fourth block most bytes are 0 or 255, which are the ends of each range.
std::vector<std::uint8_t> blocksOfEveryMode() {
  std::mt19937 random(20261122);
  std::vector<std::uint8_t> bytes(kBlocks * kBc6hBlockSize);
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const std::span<std::uint8_t> bits = std::span(bytes).subspan(block * kBc6hBlockSize, kBc6hBlockSize);
    for (std::uint8_t& byte : bits) {
      byte = static_cast<std::uint8_t>(random());
      if (block / 32 % 4 == 3 && random() % 4 > 0) byte = random() % 2 > 0 ? 255 : 0;
    }
    bits[0] = static_cast<std::uint8_t>((bits[0] & ~31u) | block % 32);
  }
  return bytes;
}

/// What the driver makes of the blocks: red, green and blue of every texel.
std::vector<float> decodedByDriver(const std::vector<std::uint8_t>& blocks, GLenum format) {
  constexpr int kWidth = 4 * kBlocksAcross;
  constexpr int kHeight = 4 * kBlocksDown;
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, format, kWidth, kHeight, 0, static_cast<GLsizei>(blocks.size()),
                         blocks.data());
  std::vector<float> texels(std::size_t(kWidth) * kHeight * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, texels.data());
  glDeleteTextures(1, &texture);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  return texels;
}

class Bc6hParity : public ::testing::TestWithParam<bool> {};

TEST_P(Bc6hParity, EveryNumberIsTheDrivers) {
  MIRRORBALL_NEEDS_GL(context, gl::Api::desktop43);
  const bool is_signed = GetParam();
  const std::vector<std::uint8_t> blocks = blocksOfEveryMode();
  const std::vector<float> expected =
      decodedByDriver(blocks, is_signed ? GL_COMPRESSED_RGB_BPTC_SIGNED_FLOAT : GL_COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT);
  std::array<std::uint16_t, 48> halves;
  for (std::size_t block = 0; block < kBlocks; ++block) {
    const std::span bytes(blocks.data() + block * kBc6hBlockSize, kBc6hBlockSize);
    decodeBc6hBlock(bytes.first<kBc6hBlockSize>(), is_signed, halves);
    const std::size_t x = block % kBlocksAcross * 4;
    const std::size_t y = block / kBlocksAcross * 4;
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const float driver = expected[((y + i / 12) * kBlocksAcross * 4 + x) * 3 + i % 12];
      ASSERT_EQ(floatFromHalf(halves[i]), driver)
          << "code " << (bytes[0] & 31) << ", block " << block << ", sample " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, Bc6hParity, ::testing::Bool(),
                         [](const auto& form) { return std::string(form.param ? "Signed" : "Unsigned"); });

}  // namespace
}  // namespace mirrorball
