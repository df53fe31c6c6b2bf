#include "mirrorball/codec/ldr/av1_size.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/file.h"

namespace mirrorball {
namespace {

/// Writes numbers of any count of bits, the highest first.
class BitWriter {
 public:
  BitWriter& add(unsigned count, std::uint32_t value) {
    for (; count > 0; --count) {
      if (next_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() |= static_cast<std::uint8_t>((value >> (count - 1) & 1u) << (7 - next_ % 8));
      ++next_;
    }
    return *this;
  }
  Bytes bytes() const { return bytes_; }

 private:
  Bytes bytes_;
  std::size_t next_ = 0;
};

/// A unit of a type, with its size.
Bytes obu(unsigned type, const Bytes& payload) {
  Bytes unit{static_cast<std::uint8_t>(type << 3 | 2u), static_cast<std::uint8_t>(payload.size())};
  unit.insert(unit.end(), payload.begin(), payload.end());
  return unit;
}

void addSize(BitWriter& bits, std::uint32_t width, std::uint32_t height) {
  bits.add(4, 15).add(4, 15).add(16, width - 1).add(16, height - 1);
}

Bytes stillHeader(std::uint32_t width, std::uint32_t height) {
  BitWriter bits;
  bits.add(3, 1).add(1, 1).add(1, 1).add(5, 8);
  addSize(bits, width, height);
  return bits.bytes();
}

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

constexpr unsigned kSequence = 1, kTemporalDelimiter = 2;

TEST(Av1Size, IsThatOfTheLargestHeader) {
  EXPECT_EQ(sizeInAv1(obu(kSequence, stillHeader(6000, 4000))), glm::uvec2(6000, 4000));
  const Bytes several = joined({obu(kTemporalDelimiter, {}), obu(kSequence, stillHeader(30, 40)),
                                obu(kTemporalDelimiter, {1, 2, 3}), obu(kSequence, stillHeader(65536, 20))});
  EXPECT_EQ(sizeInAv1(several), glm::uvec2(65536, 40));
  EXPECT_EQ(sizeInAv1(obu(kTemporalDelimiter, {})), std::nullopt);
  EXPECT_EQ(sizeInAv1({}), std::nullopt);
}

// A video's header has times, a model of the decoder and several operating points before its size.
TEST(Av1Size, StandsBehindWhatVideosHave) {
  BitWriter bits;
  bits.add(3, 0).add(1, 0).add(1, 0);                               // profile, neither still nor reduced
  bits.add(1, 1).add(32, 1).add(32, 25).add(1, 1).add(5, 0b00101);  // times; a variable number of two zeros
  bits.add(1, 1).add(5, 9).add(32, 1).add(5, 7).add(5, 7);          // a model with delays of 10 bits
  bits.add(1, 1).add(5, 1);                                         // display delays; two operating points
  bits.add(12, 3).add(5, 9).add(1, 0).add(1, 1).add(21, 5).add(1, 1).add(4, 3);
  bits.add(12, 1).add(5, 4).add(1, 0).add(1, 0);
  addSize(bits, 1920, 1080);
  EXPECT_EQ(sizeInAv1(obu(kSequence, bits.bytes())), glm::uvec2(1920, 1080));
}

TEST(Av1Size, IsUnknownOfDataThatEnds) {
  const Bytes whole = obu(kSequence, stillHeader(6000, 4000));
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_EQ(sizeInAv1(std::span(whole).first(size)), std::nullopt) << size;
  EXPECT_EQ(sizeInAv1(obu(kSequence, {0x38, 0x00})), std::nullopt) << "a header that ends";
  EXPECT_EQ(sizeInAv1(Bytes{0x0E}), std::nullopt) << "an extension that is not there";
}

}  // namespace
}  // namespace mirrorball
