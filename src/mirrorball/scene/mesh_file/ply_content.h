#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/mesh.h"
#include "mirrorball/scene/mesh_file/ply_header.h"
#include "mirrorball/scene/mesh_repair.h"

namespace mirrorball {

/// What a triangle of a PLY has for itself.
struct PlyFace {
  glm::vec4 color{1.0f};  ///< linear
  int picture = 0;        ///< index into PlyHeader::pictures, from "texnumber"; maybe of none
  bool operator==(const PlyFace&) const = default;
};

/// What a PLY holds, triangle by triangle.
struct PlyContent {
  std::vector<glm::dvec3> positions;   ///< of the vertices, as the file has them
  std::vector<Vertex> vertices;        ///< without their positions; normals of any length, NaN too; colours linear
  std::vector<std::uint32_t> indices;  ///< three a triangle, each of a vertex at a place that is a number
  std::vector<glm::vec2> corner_uvs;   ///< of the indices, v growing downwards; empty: the file has none
  std::vector<PlyFace> faces;          ///< of the triangles; empty: they have nothing for themselves
  bool has_normals = false;
  bool has_uvs = false;
  bool has_colors = false;
  bool has_face_colors = false;
  bool positions_are_floats = false;  ///< 32 bits each
  MeshRepair repair;                  ///< of the triangles that were left out
  std::vector<std::string> remarks;   ///< on what else is unusual, how it was read
  std::string truncation;  ///< where the file ends before it should: "ends in row 2 of 9 …"; empty: nowhere
};

/// Reads the elements of a PLY: vertices with their properties in any order and of any type, faces of any number of
/// corners, triangle strips.
///
/// returns  colours, of vertices and faces, from integers as sRGB, of floats as linear; codes of 255 in a wider type
///          as those (ChannelRange); each element's for itself, and alpha by its own type. Triangles that name no
///          vertex, or one that is nowhere, are left out and counted. Of a file that ends early the rows that are whole
/// errors   bad_file (the line or byte is named; a list or number that is none); too_large
Result<PlyContent> readPlyContent(std::span<const std::uint8_t> file, const PlyHeader& header);

}  // namespace mirrorball
