#include "mirrorball/codec/ldr/png_xmp.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

#include "mirrorball/codec/compressed_xmp.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/codec/ldr/png_testing.h"

namespace mirrorball {
namespace {

using testing::deflated;
using testing::pngWithChunk;
using testing::rawProfile;

const std::string kPacket = "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">" + std::string(3000, 'x') + "</x:xmpmeta>";
const std::string kKeyword("XML:com.adobe.xmp\0", 18);

std::string xmpIn(std::string_view type, const std::string& data) { return compressedXmp(pngWithChunk(type, data)); }

TEST(PngXmp, ThatIsCompressedIsUnpacked) {
  const std::string international = kKeyword + std::string("\1\0en\0\0", 6) + deflated(kPacket);
  EXPECT_EQ(xmpIn("iTXt", international), kPacket);
  EXPECT_EQ(xmpIn("zTXt", kKeyword + std::string(1, '\0') + deflated(kPacket)), kPacket);
}

TEST(PngXmp, OfImageMagicksProfilesIsReadFromItsDigits) {
  for (const std::string name : {"xmp", "APP1"}) {
    const std::string keyword = "Raw profile type " + name + std::string(1, '\0');
    EXPECT_EQ(xmpIn("zTXt", keyword + std::string(1, '\0') + deflated(rawProfile(name, kPacket))), kPacket);
    EXPECT_EQ(xmpIn("tEXt", keyword + rawProfile(name, kPacket)), kPacket);
  }
  const std::string exif = "Raw profile type exif" + std::string(1, '\0');
  EXPECT_EQ(xmpIn("tEXt", exif + rawProfile("exif", kPacket)), "") << "another profile";
}

TEST(PngXmp, DamageIsNone) {
  const std::string whole = kKeyword + std::string("\1\0en\0\0", 6) + deflated(kPacket);
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_EQ(xmpIn("iTXt", whole.substr(0, size)), "") << size;
  const Bytes file = pngWithChunk("iTXt", whole);
  for (std::size_t size = 8; size < 100; ++size) EXPECT_EQ(compressedXmpInPng(std::span(file).first(size)), "");
}

/// A PNG with several chunks, in this order.
Bytes pngWithChunks(const std::vector<std::pair<std::string_view, std::string>>& chunks) {
  Bytes png = *encodePng(Image8(2, 1, 3, 99), {});
  for (auto chunk = chunks.rbegin(); chunk != chunks.rend(); ++chunk)
    png = testing::withPngChunk(std::move(png), chunk->first, chunk->second);
  return png;
}

// ImageMagick stores EXIF under the same keyword as XMP, as both are a JPEG's APP1.
TEST(PngXmp, IsFoundBehindOtherProfiles) {
  const std::string packed = kKeyword + std::string("\1\0en\0\0", 6) + deflated(kPacket);
  const std::string raw = "Raw profile type APP1" + std::string(1, '\0');
  const std::string exif = rawProfile("exif", "Exif" + std::string(200, '\0'));
  EXPECT_EQ(compressedXmp(pngWithChunks({{"tEXt", raw + exif}, {"iTXt", packed}})), kPacket);
  EXPECT_EQ(compressedXmp(pngWithChunks({{"zTXt", raw + std::string(1, '\0') + deflated(exif)},
                                         {"tEXt", raw + rawProfile("xmp", kPacket)},
                                         {"iTXt", packed}})),
            kPacket);
  EXPECT_EQ(compressedXmp(pngWithChunks({{"tEXt", raw + exif}})), "") << "no packet is in it";
}

// Else each would be unpacked for nothing: a thousand times the work of reading the file.
TEST(PngXmp, OfManyTextsNoMoreIsUnpackedThanOfOne) {
  const std::string packed = kKeyword + std::string(1, '\0') + deflated(kPacket);
  const auto behind = [&](std::size_t count, std::size_t size) {
    const std::string other = kKeyword + std::string(1, '\0') + deflated(std::string(size, ' '));
    std::vector<std::pair<std::string_view, std::string>> chunks(count, {"zTXt", other});
    chunks.emplace_back("zTXt", packed);
    return compressedXmp(pngWithChunks(chunks));
  };
  EXPECT_EQ(behind(8, 100'000), kPacket);
  EXPECT_EQ(behind(12, 100'000), "");
  EXPECT_EQ(behind(1, 4 * kLongestCompressedXmp), "");
  EXPECT_EQ(behind(60, 1), kPacket);
  EXPECT_EQ(behind(70, 1), "") << "small ones count, too";
  const std::string digits =
      "Raw profile type APP1" + std::string(1, '\0') + rawProfile("exif", std::string(600'000, 'x'));
  EXPECT_EQ(compressedXmp(pngWithChunks({{"tEXt", digits}, {"zTXt", packed}})), kPacket);
  EXPECT_EQ(compressedXmp(pngWithChunks({{"tEXt", digits}, {"tEXt", digits}, {"zTXt", packed}})), kPacket)
      << "what is too long is passed over";
}

TEST(PngXmp, WhatUnpacksToMoreThanAnyPacketIsLeft) {
  const std::string bomb = kKeyword + std::string(1, '\0') + deflated(std::string(4 * kLongestCompressedXmp, ' '));
  EXPECT_EQ(xmpIn("zTXt", bomb), "");
}

}  // namespace
}  // namespace mirrorball
