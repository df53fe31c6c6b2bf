#include "mirrorball/codec/ldr/png_xmp.h"

#include <string>
#include <string_view>

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

TEST(PngXmp, WhatUnpacksToMoreThanAnyPacketIsLeft) {
  const std::string bomb = kKeyword + std::string(1, '\0') + deflated(std::string(4 * kLongestCompressedXmp, ' '));
  EXPECT_EQ(xmpIn("zTXt", bomb), "");
}

}  // namespace
}  // namespace mirrorball
