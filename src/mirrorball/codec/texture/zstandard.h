#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mirrorball/base/file.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"

namespace mirrorball {

/// Fails where the build is one without Zstandard.
///
/// errors   unsupported
Result<void> checkZstandard();

/// Unpacks what fills `to` exactly.
///
/// errors   bad_file: "is not sound Zstandard data", or unpacks to another size; unsupported, as checkZstandard
Result<void> unpackZstandard(std::span<const std::uint8_t> packed, std::span<std::uint8_t> to);

/// Packs the bytes as one Zstandard frame, whose blocks are compressed on all cores where the library can. The result
/// does not depend on the number of cores.
///
/// level     1 to 22
/// progress  of bytes that the compressor has taken, which is some pieces ahead of its work
/// errors    too_large (memory); interrupted; unsupported, as checkZstandard
Result<Bytes> packZstandard(std::span<const std::uint8_t> bytes, int level, const ProgressFunction& progress = {});

}  // namespace mirrorball
