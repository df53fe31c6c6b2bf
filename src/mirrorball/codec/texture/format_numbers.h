#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mirrorball/codec/texture/stored_format.h"

namespace mirrorball {

/// The format that a VkFormat or a DXGI_FORMAT stands for; nothing where it is none that is read.
std::optional<StoredFormat> formatOfVulkan(std::uint32_t vk_format);
std::optional<StoredFormat> formatOfDxgi(std::uint32_t dxgi_format);

/// The DXGI_FORMAT that is taken for one of the _TYPELESS, which leave open what their samples are; others as they are.
std::uint32_t typedDxgi(std::uint32_t dxgi_format);

/// The VkFormat or DXGI_FORMAT of a format that is written.
std::uint32_t vulkanNumber(TexelFormat format);
std::uint32_t dxgiNumber(TexelFormat format);

/// What an unreadable format is called: "BC7 block compression", else "VkFormat 64", "DXGI_FORMAT 45".
std::string nameOfVulkan(std::uint32_t vk_format);
std::string nameOfDxgi(std::uint32_t dxgi_format);

/// The block compression of a glInternalFormat: "ETC1 block compression"; nothing where it is none.
std::optional<std::string> blockCompressionOfGl(std::uint32_t gl_internal_format);

/// The error for a texture that is well-formed but not read.
///
/// what     "BC7 block compression"
/// instead  the name of a format that is read, in the words of the container
tl::unexpected<Error> unsupportedTexture(const std::string& what, const std::string& instead);

}  // namespace mirrorball
