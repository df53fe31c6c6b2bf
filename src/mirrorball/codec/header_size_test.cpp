#include "mirrorball/codec/header_size.h"

#include <string>

#include <gtest/gtest.h>

#include "mirrorball/codec/ldr/jpeg_segments.h"

namespace mirrorball {
namespace {

/// A PNG up to its header's sizes.
Bytes pngOfSize(const std::string& width, const std::string& height) {
  using namespace std::string_literals;
  const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"s + width + height;
  return {png.begin(), png.end()};
}

/// A JPEG up to its frame header: a segment of tables, fill bytes and the size.
Bytes jpegOfSize(std::uint8_t width, std::uint8_t height) {
  constexpr std::uint8_t kTables = 0xc4, kBaseline = 0xc0;
  Bytes jpeg{0xff, 0xd8};
  for (const Bytes& part : {jpegSegment(kTables, Bytes(9, 0x11)), Bytes{0xff, 0xff},
                            jpegSegment(kBaseline, Bytes{8, 1, height, 2, width, 1, 1, 0x11, 0})})
    jpeg.insert(jpeg.end(), part.begin(), part.end());
  return jpeg;
}

TEST(HeaderSize, IsAPngsAndAJpegs) {
  using namespace std::string_literals;
  EXPECT_EQ(sizeInHeader(pngOfSize("\0\1\0\2"s, "\0\0\0\3"s)), glm::ivec2(0x10002, 3));
  EXPECT_EQ(sizeInHeader(jpegOfSize(7, 9)), glm::ivec2(0x207, 0x109));
  EXPECT_FALSE(sizeInHeader(Bytes(100, 'x')));
  EXPECT_FALSE(sizeInHeader({}));
}

TEST(HeaderSize, IsNoneThatNoImageMayHave) {
  using namespace std::string_literals;
  EXPECT_FALSE(sizeInHeader(pngOfSize("\x40\0\0\0"s, "\0\0\0\2"s))) << "too large";
  EXPECT_FALSE(sizeInHeader(pngOfSize("\xff\xff\xff\xff"s, "\0\0\0\1"s)));
  EXPECT_FALSE(sizeInHeader(pngOfSize("\0\0\0\0"s, "\0\0\0\1"s)));
}

TEST(HeaderSize, IsNoneInAHeaderThatIsCut) {
  using namespace std::string_literals;
  const Bytes jpeg = jpegOfSize(7, 9);
  for (std::size_t size = 0; size < jpeg.size(); ++size) EXPECT_FALSE(sizeInHeader(std::span(jpeg).first(size)));
  const Bytes png = pngOfSize("\0\0\0\2"s, "\0\0\0\3"s);
  for (std::size_t size = 0; size < png.size(); ++size) EXPECT_FALSE(sizeInHeader(std::span(png).first(size)));
}

}  // namespace
}  // namespace mirrorball
