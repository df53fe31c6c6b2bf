#pragma once

#include "fuzz.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/relief/height_texture.h"
#include "mirrorball/scene/relief/slope_texture.h"

namespace mirrorball::fuzz {

/// Reads a picture as numbers, and a small one as heights and as slopes of a material.
inline void readHeights(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMostTexels = 1 << 14;
  const auto numbers = decodeNumbers({data, size});
  checkError(numbers);
  if (!numbers || numbers->picture.texelCount() > kMostTexels) return;
  checkError(heightTexture(heightsOfPicture(numbers->picture).heights, MapEdges::tiled));
  checkError(slopesOfPicture(numbers->picture, holdsCodes({data, size})));
}

/// Gives a picture's bytes to all ways to read it: to light, to samples as stored, and to numbers. What claims more
/// memory than 256 MB is refused, so that a large picture of one colour, which some formats write in a few bytes, does
/// not take all the time.
inline int readPicture(const std::uint8_t* data, std::size_t size) {
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(std::uint64_t{1} << 28);
  checkError(decodeImage({data, size}));
  checkError(decodeColorTexture({data, size}));
  readHeights(data, size);
  setMemoryLimit(before);
  return 0;
}

}  // namespace mirrorball::fuzz
