#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/scene/mesh_repair.h"

namespace mirrorball {

/// One corner of a face: indices from 0; −1 where it has no such attribute.
struct ObjCorner {
  int position = -1;
  int uv = -1;
  int normal = -1;
  bool operator==(const ObjCorner&) const = default;
};

struct ObjFace {
  std::size_t first_corner;
  std::size_t corner_count;  ///< 3 at least
  int material;              ///< index into ObjGeometry::material_names; −1: none
  int smoothing;             ///< as PolygonFace::smoothing
};

/// What an OBJ file says, before anything that it names is read.
struct ObjGeometry {
  std::vector<glm::dvec3> positions;  ///< as the file has them: NaN where they are not numbers
  std::vector<glm::vec3> colors;      ///< linear, of the positions; empty: the file has none
  std::vector<glm::vec2> uvs;         ///< v turned to grow downwards
  std::vector<glm::vec3> normals;     ///< of any length, NaN too
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;  ///< whose corners all are at places that are numbers
  std::vector<std::string> material_names;
  std::vector<std::string> tables;   ///< what follows `mtllib`, in order, each once
  MeshRepair repair;                 ///< of what was left out
  std::vector<std::string> remarks;  ///< on what else is unusual, how it was read
};

/// Reads the statements of an OBJ. None of them is refused: a face that names no vertex, or one that is nowhere, is
/// left out and counted, as is one of fewer corners than three; indices of normals and texture coordinates that name
/// none count as absent.
///
/// cost     30 ns a number
/// from     Wavefront, "Object Files (.obj)", appendix B1 of the Advanced Visualizer's manual; colours behind a
///          position (MeshLab, Blender 3.6) are sRGB from 0 to 1, as three.js' OBJLoader and Blender read them, and in
///          comments `#MRGB` as ZBrush writes them
ObjGeometry readObjGeometry(std::string_view text);

/// The memory that a file of these statements takes at most [bytes], until its meshes have normals and tangents.
std::uint64_t memoryForObj(std::string_view text);

}  // namespace mirrorball
