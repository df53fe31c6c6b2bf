#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

// Sizes in bytes (PNG, third edition, 5.2 and 5.3).
inline constexpr std::size_t kPngSignature = 8;
inline constexpr std::size_t kPngChunkHead = 8;                   // a chunk's length and its type
inline constexpr std::size_t kPngChunkFrame = kPngChunkHead + 4;  // and its checksum behind the data

/// Checks the chunks' sizes against the file's, up to its end chunk: libpng takes a chunk's memory, and clears it,
/// before it finds that the bytes are not there.
///
/// returns  nothing for a file that has its end chunk. One that ends earlier, but behind the first bytes of its texels,
///          comes back with what of its chunks is there and an end chunk, so that libpng decodes it as far as it goes
/// errors   bad_file: the file ends before its texels
/// from     PNG, third edition, 5.3, "Chunk layout"
Result<std::optional<Bytes>> completedPng(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
