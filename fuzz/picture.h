#pragma once

#include "fuzz.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball::fuzz {

/// Gives a picture's bytes to both ways to read it: to light, and to samples as stored. What claims more memory than
/// 256 MB is refused, so that a large picture of one colour, which some formats write in a few bytes,
/// does not take all the time.
inline int readPicture(const std::uint8_t* data, std::size_t size) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(std::uint64_t{1} << 28);
  checkError(decodeImage({data, size}));
  checkError(decodeTexture({data, size}));
  setMemoryLimit(before);
  return 0;
}

}  // namespace mirrorball::fuzz
