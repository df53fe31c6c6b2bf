#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"

namespace mirrorball {

enum class PlyEncoding { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a binary value.
std::size_t byteSize(PlyType type);

/// The largest value of an integer type; 1 for a float.
double fullScale(PlyType type);

bool isFloat(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  bool isVertices() const { return name == "vertex" || name == "vertices"; }
  bool isFaces() const { return name == "face" || name == "faces"; }
  bool has(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> pictures;  ///< "comment TextureFile NAME", as MeshLab and Agisoft write it
  std::size_t size = 0;               ///< bytes
};

/// Parses the header of a PLY, whose lines end with LF, CR LF or CR; a byte-order mark before it is passed over.
///
/// errors   bad_file (the line is named)
/// from     Greg Turk, "The PLY Polygon File Format" (1994)
Result<PlyHeader> parsePlyHeader(std::string_view text);

}  // namespace mirrorball
