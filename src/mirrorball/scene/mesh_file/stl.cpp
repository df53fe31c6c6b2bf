#include "mirrorball/scene/mesh_file/stl.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"
#include "mirrorball/scene/tangents.h"

// The formats: 3D Systems, "StereoLithography Interface Specification" (1988). Binary: 80 bytes of free text, the
// number of facets as uint32, then for each the normal and three corners as float32 and two bytes of
// attributes; little-endian.

namespace mirrorball {
namespace {

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kFacetSize = 50;
constexpr std::size_t kCornersAt = 12;  // after the facet's normal

static_assert(std::endian::native == std::endian::little, "binary STL is read without swapping bytes");

using Corners = std::array<glm::dvec3, 3>;

void addFacet(Mesh& mesh, const Corners& corners) {
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(normal);
  if (length == 0.0) return;
  for (const glm::dvec3& corner : corners) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    Vertex& vertex = mesh.vertices.emplace_back();
    vertex.position = glm::vec3(corner);
    vertex.normal = glm::vec3(normal / length);
  }
}

Result<Mesh> decodeBinary(std::span<const std::uint8_t> bytes) {
  Mesh mesh;
  const std::size_t count = (bytes.size() - kHeaderSize) / kFacetSize;
  mesh.vertices.reserve(3 * count);
  mesh.indices.reserve(3 * count);
  for (std::size_t facet = 0; facet < count; ++facet) {
    const std::size_t at = kHeaderSize + facet * kFacetSize + kCornersAt;
    std::array<float, 9> numbers;
    std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
    for (const float number : numbers)
      if (!std::isfinite(number))
        return fail(ErrorCode::bad_file, "facet " + std::to_string(facet) + " (byte " + std::to_string(at) +
                                             ") has a corner that is not finite");
    addFacet(mesh, {glm::dvec3(numbers[0], numbers[1], numbers[2]), glm::dvec3(numbers[3], numbers[4], numbers[5]),
                    glm::dvec3(numbers[6], numbers[7], numbers[8])});
  }
  return mesh;
}

/// Refuses more corners than fit into the memory with their tangents.
///
/// errors   too_large
Result<void> checkCorners(std::uint64_t corners) {
  constexpr std::uint64_t kOfCorner = 150;  // bytes, measured, in lists that grow
  return checkMemory(corners * kOfCorner);
}

Result<Mesh> decodeAscii(std::string_view text) {
  Mesh mesh;
  TextScanner scanner(text);
  scanner.restOfLine();  // solid NAME
  Corners corners;
  std::size_t corner = 0;
  bool ended = false;
  for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
    if (word == "facet" || word == "endsolid") {
      if (corner != 0)
        return fail(ErrorCode::bad_file,
                    "line " + std::to_string(scanner.line()) + ": the facet before it has not three corners");
      ended = word == "endsolid";
    }
    if (word != "vertex") continue;
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<double> number = scanner.number();
      if (!number || std::abs(*number) > std::numeric_limits<float>::max())
        return fail(ErrorCode::bad_file,
                    "line " + std::to_string(scanner.line()) + ": a corner needs three finite numbers");
      // Through float, so that facets without area are found as they are stored.
      corners[corner][axis] = static_cast<float>(*number);
    }
    if (++corner == 3) {
      addFacet(mesh, corners);
      corner = 0;
    }
  }
  if (!ended) return fail(ErrorCode::bad_file, "'endsolid' is missing; the file is truncated");
  return mesh;
}

/// How many facets the binary header names; nothing where the file has no such header.
std::optional<std::uint32_t> facetCount(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderSize) return {};
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderSize - sizeof count, sizeof count);
  return count;
}

}  // namespace

Result<Scene> decodeStl(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::optional<std::uint32_t> count = facetCount(bytes);
  const std::uint64_t binary_size = count ? kHeaderSize + std::uint64_t{kFacetSize} * *count : 0;
  const bool is_binary = count && binary_size == bytes.size();
  if (!is_binary && !text.starts_with("solid")) {
    if (!count) return fail(ErrorCode::bad_file, "is too short for an STL file");
    return fail(ErrorCode::bad_file, "its header names " + counted(*count, "facet") + ", which take " +
                                         std::to_string(binary_size) + " bytes, but it has " +
                                         std::to_string(bytes.size()) + "; it is truncated or no STL file");
  }
  MIRRORBALL_TRY_VOID(checkCorners(is_binary ? std::uint64_t{3} * *count : occurrences(text, "vertex")));
  MIRRORBALL_TRY(mesh, is_binary ? decodeBinary(bytes) : decodeAscii(text));
  if (mesh.indices.empty()) return fail(ErrorCode::bad_file, "holds no facet with an area");
  computeTangents(mesh);
  return meshScene(std::move(mesh));
}

}  // namespace mirrorball
