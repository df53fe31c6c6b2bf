#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole file.
///
/// errors   not_found; io (a folder, no permission); too_large (above `largest`)
Result<Bytes> readFile(const std::filesystem::path& path, std::uintmax_t largest = std::uintmax_t{1} << 34);

/// The same for a file that another file names: a device or a pipe is refused, since it may never end.
Result<Bytes> readRegularFile(const std::filesystem::path& path);

/// Writes a file so that it is either wholly there or not at all: to a temporary name beside it, then renamed.
///
/// errors   io (no such folder, no permission, disk full); the temporary file is removed
Result<void> writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The file name extension, lower case, without its dot: "hdr" of "Photo.HDR".
std::string extensionOf(const std::filesystem::path& path);

}  // namespace mirrorball
