#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "boxes.h"
#include "file_mutation.h"
#include "mirrorball/base/file.h"

namespace mirrorball::fuzz {

/// How many pictures anyAvif makes.
constexpr std::uint32_t kAnyAvifs = 256;

/// A small picture of anything that libavif writes: of any depth, sampling of chroma and colour, with alpha or without,
/// with a profile, turned, mirrored and cut, of several tiles or of a grid, now and then animated. Each is encoded once
/// in a program, which takes milliseconds.
const Bytes& anyAvif(std::uint32_t number);

/// What an AVIF holds outside its boxes: AV1 data, a grid's shape, Exif.
struct AvifItem {
  std::uint32_t number = 0;
  Bytes data = {};
};

struct AvifParts {
  std::vector<FileBox> boxes = {};  ///< without `mdat` and `idat`; what `iloc` holds is left out
  std::vector<AvifItem> items = {};
};

/// How a file says where its items are (ISO/IEC 14496-12, 8.11.3).
struct AvifPlaces {
  int version = 0;          ///< of the box `iloc`, 0 to 2
  bool is_in_meta = false;  ///< in a box `idat` within `meta`; from version 1 on
  bool has_base = false;    ///< offsets are from the item's first byte
  bool goes_back = false;   ///< the last item's data stands first
  std::size_t extents = 1;  ///< pieces that each item is in, one behind the other
};

/// Nothing for bytes other than an AVIF of items that are all within the file.
std::optional<AvifParts> avifPartsIn(std::span<const std::uint8_t> bytes);

Bytes avifOfParts(const AvifParts& parts, const AvifPlaces& places = {});

/// Another file in which boxes, items and AV1 data have the right sizes. Other bytes are changed anywhere.
Bytes changedAvif(const Bytes& file, std::mt19937& random);

inline constexpr FileMutation kAvifMutation{.any = [](std::uint32_t number) { return Bytes(anyAvif(number)); },
                                            .changed = changedAvif};

}  // namespace mirrorball::fuzz
