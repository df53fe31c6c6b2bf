/// Untrusted bytes: small files of every format, damaged in every way. None may crash, hang or read
/// outside its bytes; the sanitizers' build is where these tests bite.

#include <random>

#include <gtest/gtest.h>

#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/picture_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using testing::Damage;
using testing::gradient;
using testing::inPart;

Bytes oldRleHdr() {
  Bytes bytes = bytesOf("#?RGBE\nEXPOSURE=2\n\n+X 9 -Y 4\n");
  for (int column = 0; column < 9; ++column) bytes.insert(bytes.end(), {9, 8, 7, 130, 1, 1, 1, 3});
  return bytes;
}

/// Packets of one and of two texels of 24 bits.
Bytes colorRuns(int texels) {
  Bytes packets;
  for (int i = 0; i < texels; i += 3) packets.insert(packets.end(), {129, 9, 8, 7, 0, 1, 2, 3});
  return packets;
}

TEST_P(Damage, TheFileItselfIsRead) {
  const auto result = decodeImage(GetParam().bytes());
  EXPECT_TRUE(result) << result.error().message;
}

TEST_P(Damage, EveryTruncationIsAnErrorOrTold) {
  const Bytes bytes = GetParam().bytes();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    // A copy of its own, so that the sanitizer sees a read past its end.
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    const auto result = decodeImage(part);
    if (result && GetParam().is_read_in_part) {
      EXPECT_FALSE(result->oddities.empty()) << length;
      continue;
    }
    ASSERT_FALSE(result) << length << " of " << bytes.size() << " bytes";
    EXPECT_FALSE(result.error().message.empty());
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
  }
}

TEST_P(Damage, RandomBytesAreSurvived) {
  const Bytes bytes = GetParam().bytes();
  std::mt19937 random(20240501);
  const auto below = [&](std::size_t bound) { return random() % bound; };
  constexpr std::uint8_t kEvil[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
  for (int variant = 0; variant < 3000; ++variant) {
    Bytes damaged = bytes;
    for (std::size_t count = 1 + below(4); count > 0; --count) {
      std::uint8_t& byte = damaged[below(damaged.size())];
      switch (below(3)) {
        case 0:
          byte = static_cast<std::uint8_t>(byte ^ (1u << below(8)));
          break;
        case 1:
          byte = kEvil[below(std::size(kEvil))];
          break;
        default:
          byte = static_cast<std::uint8_t>(random());
      }
    }
    const auto result = decodeImage(damaged);
    if (result) {
      EXPECT_FALSE(result->image.empty());
      EXPECT_NE(result->image.channels(), 2);
    }
    static_cast<void>(decodeTexture(damaged).has_value());
  }
}

TEST_P(Damage, GarbageBehindTheMagicIsAnError) {
  const Bytes bytes = GetParam().bytes();
  std::mt19937 random(7);
  for (int variant = 0; variant < 200; ++variant) {
    Bytes garbage = bytes;
    for (std::size_t i = 10; i < garbage.size(); ++i) garbage[i] = static_cast<std::uint8_t>(random());
    EXPECT_FALSE(decodeImage(garbage));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Damage,
    ::testing::Values(inPart("HdrNewRle",
                             [] {
                               return encodeHdr(gradient(13, 5, 3), {{"envmap", "cube"}});
                             }),
                      inPart("HdrOldRle", oldRleHdr),
                      inPart("Tga",
                             [] { return testing::tgaFile({.type = 10, .width = 9, .height = 4}, colorRuns(36)); }),
                      inPart("Bmp", [] { return testing::bmpFile({.width = 9, .height = 4}, Bytes(4 * 28, 77)); }),
                      inPart("BmpRle",
                             [] {
                               return testing::bmpFile(
                                   {.width = 3, .height = 2, .bits = 8, .compression = 1, .palette = {0, 0xff}},
                                   {0, 3, 1, 0, 1, 0, 0, 0, 2, 1, 0, 1});
                             }),
                      inPart("Pgm", [] { return bytesOf("P5 5 3 65535\n" + std::string(30, 'x')); }),
                      inPart("PpmText", [] { return bytesOf("P3\n2 2\n255\n1 2 3 4 5 6 7 8 9 10 11 5"); }),
                      inPart("Pfm", [] { return bytesOf("PF  3  2  -1\n" + std::string(72, 'x')); })),
    testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
