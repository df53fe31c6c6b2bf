#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {

/// What stands before the texels of a Radiance picture.
struct HdrHeader {
  bool xyz = false;          ///< FORMAT=32-bit_rle_xyze
  glm::vec3 exposure{1.0f};  ///< product of all EXPOSURE and COLORCORR lines
  std::optional<Primaries> primaries;
  Metadata metadata;
  int width = 0;
  int height = 0;
  bool columns = false;                    ///< scan lines run along Y: "+X 4 -Y 2"
  bool x_descends = false;                 ///< "-X": from right to left
  bool y_ascends = false;                  ///< "+Y": from the bottom up
  std::size_t size = 0;                    ///< bytes, with the resolution line: the texels begin here
  std::vector<std::string> oddities = {};  ///< what is unusual in it and how it was read: DecodedImage::oddities

  std::size_t lineCount() const { return std::size_t(columns ? width : height); }
  std::size_t lineLength() const { return std::size_t(columns ? height : width); }
};

/// "PRIMARIES=0.68 0.32 …": x and y of red, green, blue and white.
std::string primariesLine(const Primaries& primaries);

/// Whether bytes begin with such a header: with "#?" and a program's name, or with lines of text of which one says
/// FORMAT=32-bit_rle_…, which is all that Radiance's own programs ask for (checkheader in its header.c). A byte-order
/// mark of UTF-8 may stand before both.
bool beginsWithHdrHeader(std::span<const std::uint8_t> bytes);

/// Parses the header: text lines, an empty line, the resolution line. Blanks around values, and between and behind
/// numbers, are read over; lines that Radiance does not define say nothing, and neither does a line that other readers
/// pass over and that cannot be meant: `oddities` has it.
///
/// errors   bad_file, too_large or unsupported, with the line's number
/// from     G. Ward, "The RADIANCE Picture File Format"; Radiance's "File formats"
Result<HdrHeader> parseHdrHeader(std::span<const std::uint8_t> bytes);

}  // namespace mirrorball
