#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mirrorball/codec/stored_format.h"

namespace mirrorball {

/// The format that a VkFormat stands for; nothing where it is none that is read.
std::optional<StoredFormat> storedFormatOfVulkan(std::uint32_t vk_format);

/// The VkFormat of a format that is written.
std::uint32_t vulkanFormat(TexelFormat format);

/// What an unreadable VkFormat is called: "BC6H block compression", else "VkFormat 64".
std::string vulkanFormatName(std::uint32_t vk_format);

}  // namespace mirrorball
