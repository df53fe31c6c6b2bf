#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/texture_file.h"

namespace mirrorball {

/// Whether the bytes begin as a KTX 1 file does.
bool isKtx1(std::span<const std::uint8_t> bytes);

/// Decodes a KTX 1 file of either byte order: uncompressed formats.
///
/// errors   as decodeImageSet
/// from     KTX File Format Specification, version 1 (Khronos, 2013)
Result<DecodedImageSet> decodeKtx1(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace mirrorball
