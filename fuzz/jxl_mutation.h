#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "boxes.h"
#include "file_mutation.h"
#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// How many pictures anyJxl makes. All were made with libjxl 0.7, which ends the program at some settings.
constexpr std::uint32_t kAnyJxls = 4096;

/// A small picture of anything that libjxl writes: with and without loss, progressive, of layers, animated, of any
/// colour and depth, with further channels, from a JPEG.
Bytes anyJxl(std::uint32_t number);

/// A JPEG XL file: its code stream, and the boxes beside it.
struct JxlParts {
  Bytes code;
  std::vector<FileBox> boxes = {};  ///< but for those that say that this is JPEG XL
};

/// Nothing where it is neither a code stream nor boxes with one.
std::optional<JxlParts> jxlPartsIn(std::span<const std::uint8_t> bytes);

/// As a file: bare, or in one box or several.
Bytes jxlOfParts(const JxlParts& parts, std::mt19937& random);

/// Another file with the same boxes around a code stream, most of whose changes are behind its headers. Other bytes
/// are changed anywhere.
Bytes changedJxl(const Bytes& file, std::mt19937& random);

inline constexpr FileMutation kJxlMutation{.any = [](std::uint32_t number) { return Bytes(anyJxl(number)); },
                                           .changed = changedJxl};

}  // namespace mirrorball::fuzz
