#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mirrorball/codec/stored_format.h"

namespace mirrorball {

/// The format that a DXGI_FORMAT stands for; nothing where it is none that is read.
std::optional<StoredFormat> storedFormatOfDxgi(std::uint32_t dxgi_format);

/// The DXGI_FORMAT of a format that is written.
std::uint32_t dxgiFormat(TexelFormat format);

/// What an unreadable DXGI_FORMAT is called: "BC6H block compression", else "DXGI_FORMAT 45".
std::string dxgiFormatName(std::uint32_t dxgi_format);

}  // namespace mirrorball
