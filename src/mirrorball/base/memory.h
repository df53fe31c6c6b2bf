#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mirrorball/base/result.h"

namespace mirrorball {

/// The maximum memory for the images of one task [bytes]: initially 3/4 of the machine's memory, or of what its control
/// group allows.
std::uint64_t memoryLimit();

/// Changes this limit for the whole process.
void setMemoryLimit(std::uint64_t bytes);

/// Refuses to take more memory than the limit. Called before memory is taken whose size a file states.
///
/// errors   too_large
Result<void> checkMemory(std::uint64_t bytes);

/// "1.5 GB", "320 MB"; a GB is 2³⁰ bytes.
std::string textOfBytes(std::uint64_t bytes);

/// The bytes of "1.5G", "1.5GB", "800M", "2e9".
///
/// errors   usage
Result<std::uint64_t> parseBytes(std::string_view written);

}  // namespace mirrorball
