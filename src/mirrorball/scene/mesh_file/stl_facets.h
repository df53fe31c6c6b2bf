#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/mesh_repair.h"

namespace mirrorball {

/// What an STL holds.
struct StlFacets {
  std::vector<glm::dvec3> corners;   ///< three of each facet, in the file's coordinates, all of them numbers
  std::vector<glm::vec3> colors;     ///< linear, of the facets; empty: the file has none
  MeshRepair repair;                 ///< of the facets that were left out
  std::vector<std::string> remarks;  ///< on what else is unusual, how it was read
};

/// The text of an STL in words; nothing where it is none: where there is a byte of 0 near its beginning, as in all
/// binary ones, or no facet.
std::optional<std::string_view> stlText(std::span<const std::uint8_t> bytes);

/// Reads an STL in words, of capital or small letters: each three that follow 'vertex' are a corner, and all else is
/// passed over. A facet that has not three corners, or one that is not a number, is left out.
///
/// errors   too_large
/// from     3D Systems, "StereoLithography Interface Specification" (1988)
Result<StlFacets> readStlText(std::string_view text);

/// Reads a binary STL: 80 bytes of free text, the number of facets as uint32, then for each the normal and three
/// corners as float32 and two bytes of attributes; little-endian. Where the number does not fit the file, the facets
/// are read that the file holds. Attributes with their highest bit set are colours: of SolidView and VisCAM, or, where
/// the free text has "COLOR=", of Materialise Magics, in which that bit stands for the colour that follows there.
///
/// errors   bad_file (its bytes are not facets); too_large
/// from     the same; Wikipedia, "STL (file format)", section "Color in binary"
Result<StlFacets> readStlBinary(std::span<const std::uint8_t> bytes);

/// Whether the number of facets of a binary STL fits its size.
bool hasStlSize(std::span<const std::uint8_t> bytes);

/// Refuses more corners than fit into the memory with their tangents.
///
/// errors   too_large
Result<void> checkStlMemory(std::uint64_t corners);

}  // namespace mirrorball
