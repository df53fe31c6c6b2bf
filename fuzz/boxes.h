#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// A box of which AVIF and JPEG XL files consist (ISO/IEC 14496-12, 4.2).
struct FileBox {
  std::string type;    ///< four characters
  Bytes content = {};  ///< of a box of boxes what stands before them
  std::vector<FileBox> boxes = {};
};

/// Takes bytes to their boxes, and those of `meta`, `iprp`, `ipco`, `iinf` and `iref` to what is in them. Nothing where
/// a box is longer than what it is in.
std::optional<std::vector<FileBox>> boxesIn(std::span<const std::uint8_t> bytes);

/// Boxes as bytes, each with its right size.
Bytes bytesOfBoxes(const std::vector<FileBox>& boxes);

/// The first box of this type, or null.
FileBox* firstBox(std::vector<FileBox>& boxes, std::string_view type);

/// Appends the lowest `count` bytes of a number, the highest first.
void appendBig(Bytes& bytes, std::uint64_t number, std::size_t count);

}  // namespace mirrorball::fuzz
