#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace mirrorball {

/// What tells the formats that a build may leave out (format_registry.h) by their first bytes: it is known in every
/// build, so that a file can be answered by what is missing.

/// Whether the bytes begin as an OpenEXR file does.
bool isExr(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a JPEG does.
bool isJpeg(std::span<const std::uint8_t> bytes);

/// Where a JPEG begins that up to 64 other bytes stand before, such as lines of a server's response; 0 where it is the
/// first. Nothing where none begins there.
std::optional<std::size_t> beginOfJpeg(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a PNG does.
bool isPng(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a TIFF or a BigTIFF does.
bool isTiff(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a WebP does.
bool isWebp(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as an AVIF does: a box that names its kinds, one of which is "avif", or "avis" for
/// animations.
bool isAvif(std::span<const std::uint8_t> bytes);

/// Whether the bytes begin as a JPEG XL does, alone or in boxes.
bool isJxl(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
