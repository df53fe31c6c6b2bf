/// Untrusted texture files: small ones of every kind, damaged in every way. None may crash, hang or read outside its
/// bytes; the sanitizers' build is where these tests bite.

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/texture/zstandard.h"

namespace mirrorball {
namespace {

using testing::bytesOfTexture;
using testing::textureOf;

Bytes ktx1Cube() {
  Bytes file = testing::ktx1Header({.width = 2, .height = 2, .faces = 6, .levels = 2, .big_endian = true});
  for (const std::uint32_t size : {64u, 16u}) {
    testing::appendU32(file, size, true);
    file.insert(file.end(), 6 * size, std::uint8_t{0x3f});
  }
  return file;
}

struct Kind {
  const char* name;
  std::function<Bytes()> bytes;
  bool is_packed = false;  ///< by Zstandard
};

class TextureDamage : public ::testing::TestWithParam<Kind> {
 protected:
  void SetUp() override {
    if (GetParam().is_packed) MIRRORBALL_NEEDS(checkZstandard());
  }
};

TEST_P(TextureDamage, TheFileItselfIsRead) {
  const auto result = decodeImageSet(GetParam().bytes());
  EXPECT_TRUE(result) << result.error().message;
}

TEST_P(TextureDamage, EveryTruncationIsAnErrorOrTold) {
  const Bytes bytes = GetParam().bytes();
  const int levels = decodeImageSet(bytes)->images.levels();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    // A copy of its own, so that the sanitizer sees a read past its end.
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    const auto result = decodeImageSet(part);
    if (result) {
      ASSERT_LT(result->images.levels(), levels) << length << " of " << bytes.size() << " bytes";
      ASSERT_EQ(result->oddities.size(), 1u) << length;
      continue;
    }
    EXPECT_FALSE(result.error().message.empty());
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
  }
}

TEST_P(TextureDamage, RandomBytesAreSurvived) {
  const Bytes bytes = GetParam().bytes();
  std::mt19937 random(20240501);
  const auto below = [&](std::size_t bound) { return random() % bound; };
  constexpr std::uint8_t kEvil[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
  for (int variant = 0; variant < 5000; ++variant) {
    Bytes damaged = bytes;
    for (std::size_t count = 1 + below(4); count > 0; --count) {
      // Most of the damage goes where sizes and offsets stand.
      std::uint8_t& byte = damaged[below(below(4) > 0 ? std::min<std::size_t>(damaged.size(), 200) : damaged.size())];
      byte = below(2) > 0 ? kEvil[below(std::size(kEvil))] : static_cast<std::uint8_t>(random());
    }
    const auto result = decodeImageSet(damaged);
    EXPECT_TRUE(!result || !result->images.at(0, 0).empty());
  }
}

TEST_P(TextureDamage, GarbageBehindTheMagicIsAnError) {
  const Bytes bytes = GetParam().bytes();
  std::mt19937 random(7);
  for (int variant = 0; variant < 200; ++variant) {
    Bytes garbage = bytes;
    for (std::size_t i = 12; i < garbage.size(); ++i) garbage[i] = static_cast<std::uint8_t>(random());
    EXPECT_FALSE(decodeImageSet(garbage));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, TextureDamage,
    ::testing::Values(
        Kind{"Ktx2Half", [] { return bytesOfTexture(writeKtx2, textureOf(3, 6, 2, 3, 4, 4)); }},
        Kind{"Ktx2Packed",
             [] { return bytesOfTexture(writeKtx2, textureOf(2, 1, 1, 3, 5, 3), {.format = TexelFormat::e5b9g9r9}); }},
        Kind{"Ktx2TwoChannels",
             [] { return bytesOfTexture(writeKtx2, textureOf(2, 1, 1, 2, 5, 3), {.format = TexelFormat::rg_half}); }},
        Kind{"Ktx2Zstandard",
             [] { return bytesOfTexture(writeKtx2, textureOf(3, 6, 1, 4, 4, 4), {.zstandard_level = 3}); }, true},
        Kind{"Ktx2Bc6h",
             [] { return bytesOfTexture(writeKtx2, textureOf(3, 6, 1, 3, 9, 9), {.format = TexelFormat::bc6h}); }},
        Kind{"Ktx2UastcHdr",
             [] { return bytesOfTexture(writeKtx2, textureOf(3, 6, 1, 3, 9, 9), {.format = TexelFormat::uastc_hdr}); }},
        Kind{"Ktx1Cube", ktx1Cube},
        Kind{"DdsCube",
             [] { return bytesOfTexture(writeDds, textureOf(2, 6, 2, 3, 4, 4), {.format = TexelFormat::b10g11r11}); }},
        Kind{"DdsBc6h",
             [] { return bytesOfTexture(writeDds, textureOf(2, 1, 2, 3, 6, 5), {.format = TexelFormat::bc6h}); }},
        Kind{"DdsMasks",
             [] {
               return testing::oldDds(
                   {.width = 5, .height = 3, .flags = 0x41, .bits = 32, .masks = {0xff0000, 0xff00, 0xff, 0xff000000}},
                   Bytes(60, 99));
             }}),
    [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace mirrorball
