#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  Descriptor() = default;
  /// number   −1: none
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }

  /// Closes it now.
  ///
  /// returns  false: errno says why
  bool close();

 private:
  int number_ = -1;
};

/// Reads bytes from a place counted from the file's beginning.
///
/// returns  how many were read: fewer than `bytes` has room for only at the file's end
/// errors   io; without the file's name
Result<std::size_t> readAt(const Descriptor& file, std::uint64_t offset, std::span<std::uint8_t> bytes);

/// Writes bytes at a place counted from the file's beginning.
///
/// errors   io; without the file's name
Result<void> writeAt(const Descriptor& file, std::uint64_t offset, std::span<const std::uint8_t> bytes);

/// Writes bytes behind what was written before, as into a pipe.
///
/// errors   io; without the file's name
Result<void> writeOn(int to, std::span<const std::uint8_t> bytes);

/// The error for what could not be written.
///
/// number   of errno
tl::unexpected<Error> cannotBeWritten(int number);

}  // namespace mirrorball
