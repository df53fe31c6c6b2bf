#include "mirrorball/codec/ldr/av1_size.h"

#include <cstddef>

#include <glm/common.hpp>

namespace mirrorball {
namespace {

constexpr unsigned kSequenceHeader = 1;  // obu_type

/// Bits from the highest of each byte on; behind the end they are 0.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t read(unsigned count) {
    std::uint32_t value = 0;
    for (; count > 0; --count, ++next_) value = value << 1 | bit(next_);
    return value;
  }
  bool readFlag() { return read(1) != 0; }
  /// A number whose length its leading zeros tell: uvlc() of the specification.
  void skipVariable() {
    unsigned zeros = 0;
    while (zeros < 32 && next_ < 8 * bytes_.size() && !readFlag()) ++zeros;
    if (zeros < 32) next_ += zeros;
  }
  void skip(unsigned count) { next_ += count; }
  bool isBehindEnd() const { return next_ > 8 * bytes_.size(); }

 private:
  std::uint32_t bit(std::size_t place) const {
    const std::size_t byte = place / 8;
    return byte < bytes_.size() ? bytes_[byte] >> (7 - place % 8) & 1u : 0u;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// What the operating points of a sequence header need of what stands before them.
struct DecoderModel {
  bool is_present = false;
  unsigned delay_bits = 0;
};

DecoderModel readTiming(BitReader& bits) {
  if (!bits.readFlag()) return {};  // timing_info_present_flag
  bits.skip(32 + 32);               // num_units_in_display_tick, time_scale
  if (bits.readFlag()) bits.skipVariable();
  if (!bits.readFlag()) return {};  // decoder_model_info_present_flag
  const DecoderModel model{true, bits.read(5) + 1};
  bits.skip(32 + 5 + 5);  // num_units_in_decoding_tick, two lengths
  return model;
}

void skipOperatingPoints(BitReader& bits, const DecoderModel& model) {
  const bool has_display_delay = bits.readFlag();
  const unsigned count = bits.read(5) + 1;
  for (unsigned i = 0; i < count; ++i) {
    bits.skip(12);                       // operating_point_idc
    if (bits.read(5) > 7) bits.skip(1);  // seq_level_idx, seq_tier
    if (model.is_present && bits.readFlag()) bits.skip(2 * model.delay_bits + 1);
    if (has_display_delay && bits.readFlag()) bits.skip(4);
  }
}

std::optional<glm::uvec2> sizeInSequenceHeader(std::span<const std::uint8_t> payload) {
  BitReader bits(payload);
  bits.skip(3 + 1);       // seq_profile, still_picture
  if (bits.readFlag()) {  // reduced_still_picture_header
    bits.skip(5);         // seq_level_idx
  } else {
    const DecoderModel model = readTiming(bits);
    skipOperatingPoints(bits, model);
  }
  const unsigned width_bits = bits.read(4) + 1;
  const unsigned height_bits = bits.read(4) + 1;
  const std::uint32_t width = bits.read(width_bits) + 1;
  const glm::uvec2 size(width, bits.read(height_bits) + 1);
  return bits.isBehindEnd() ? std::nullopt : std::optional(size);
}

/// A number of seven bits a byte, the lowest first: leb128() of the specification.
std::optional<std::size_t> readSize(std::span<const std::uint8_t>& bytes) {
  std::size_t size = 0;
  for (unsigned i = 0; i < 8 && i < bytes.size(); ++i) {
    size |= std::size_t{bytes[i] & 0x7Fu} << 7 * i;
    if (bytes[i] < 0x80) {
      bytes = bytes.subspan(i + 1);
      return size;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<glm::uvec2> sizeInAv1(std::span<const std::uint8_t> obus) {
  std::optional<glm::uvec2> largest;
  while (!obus.empty()) {
    const unsigned header = obus.front();
    const bool has_extension = (header & 4u) != 0, has_size = (header & 2u) != 0;
    if (obus.size() < (has_extension ? 2u : 1u)) return largest;
    obus = obus.subspan(has_extension ? 2 : 1);
    const std::optional<std::size_t> size = has_size ? readSize(obus) : std::optional(obus.size());
    if (!size || *size > obus.size()) return largest;
    if ((header >> 3 & 15u) == kSequenceHeader) {
      const std::optional<glm::uvec2> found = sizeInSequenceHeader(obus.first(*size));
      if (!found) return largest;
      largest = glm::max(largest.value_or(glm::uvec2(0u)), *found);
    }
    obus = obus.subspan(*size);
  }
  return largest;
}

}  // namespace mirrorball
