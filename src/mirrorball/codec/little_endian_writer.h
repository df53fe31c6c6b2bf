#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"

namespace mirrorball {

/// Puts a file's header together, number by number.
class LittleEndianWriter {
 public:
  void u8(std::uint8_t number) { bytes_.push_back(number); }
  void u16(std::uint16_t number) { put(number, 2); }
  void u32(std::uint32_t number) { put(number, 4); }
  void u64(std::uint64_t number) { put(number, 8); }
  void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
  void append(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// A text with a zero behind it.
  void text(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
  }
  /// Zeros up to a multiple of so many bytes from the beginning.
  void alignTo(std::size_t alignment) { zeros((alignment - bytes_.size() % alignment) % alignment); }

  std::size_t size() const { return bytes_.size(); }
  Bytes takeBytes() { return std::move(bytes_); }

 private:
  void put(std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
  }

  Bytes bytes_;
};

}  // namespace mirrorball
