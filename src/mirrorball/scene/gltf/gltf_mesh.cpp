#include "mirrorball/scene/gltf/gltf_mesh.h"

#include <numeric>
#include <optional>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball::gltf {
namespace {

/// An attribute of a primitive, if it has it: as many elements as there are vertices,
/// of a fitting number of components.
Result<Numbers> readAttribute(const File& file, const Primitive& primitive, DracoMesh& draco, const std::string& name,
                              std::size_t min_components, std::size_t max_components,
                              std::optional<std::size_t> vertices, const std::string& primitive_key) {
  const std::string key = primitive_key + ".attributes." + name;
  Numbers numbers;
  if (const auto compressed = draco.attributes.find(name); compressed != draco.attributes.end()) {
    numbers = std::move(compressed->second);
  } else {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return numbers;
    MIRRORBALL_TRY(read, readNumbers(file, found->second, key));
    numbers = std::move(read);
  }
  if (numbers.components < min_components || numbers.components > max_components)
    return fail(ErrorCode::bad_file, key + " has " + counted(numbers.components, "component"));
  if (vertices && numbers.count() != *vertices)
    return fail(ErrorCode::bad_file, key + " has " + counted(numbers.count(), "element") + ", but POSITION has " +
                                         std::to_string(*vertices));
  return numbers;
}

/// Calls `set(vertex, numbers of its element)` for all vertices if the attribute is there.
template <typename Set>
void forEachVertex(Mesh& mesh, const Numbers& numbers, Set&& set) {
  for (std::size_t i = 0; i < numbers.count(); ++i)
    set(mesh.vertices[i], numbers.values.data() + i * numbers.components);
}

/// The corners of the triangles that a strip, a fan or a list of `corners` stands for (glTF 2.0, section 3.7.2.1).
std::vector<std::uint32_t> triangleCorners(std::vector<std::uint32_t> corners, int mode) {
  if (mode == kTriangles) {
    corners.resize(corners.size() - corners.size() % 3);
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    const std::size_t odd = i % 2;
    if (mode == kTriangleStrip)
      triangles.insert(triangles.end(), {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    else
      triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
  }
  return triangles;
}

/// Gives every triangle corners of its own with the triangle's normal. One without an area has none, and is left out.
///
/// returns  of each vertex, the one that it was
std::vector<std::uint32_t> makeFlat(Mesh& mesh) {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> sources;
  vertices.reserve(mesh.indices.size());
  for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
    const auto corner = [&](std::size_t i) -> const Vertex& { return mesh.vertices[mesh.indices[first + i]]; };
    const glm::dvec3 origin(corner(0).position);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(corner(1).position) - origin, glm::dvec3(corner(2).position) - origin);
    const double length = glm::length(normal);
    if (length == 0.0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.emplace_back(corner(i)).normal = glm::vec3(normal / length);
      sources.push_back(mesh.indices[first + i]);
    }
  }
  mesh.vertices = std::move(vertices);
  mesh.indices.resize(mesh.vertices.size());
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  return sources;
}

/// Computes tangents; the vertices that this adds have the same sources as those that they are split from.
void addTangents(Mesh& mesh, int uv_set, std::vector<std::uint32_t>& sources) {
  const std::vector<std::uint32_t> corners = mesh.indices;
  computeTangents(mesh, uv_set);
  sources.resize(mesh.vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) sources[mesh.indices[i]] = sources[corners[i]];
}

/// Sets unit normals from the file's; returns whether all of them have a direction.
bool setNormals(Mesh& mesh, const Numbers& normals) {
  bool all = true;
  forEachVertex(mesh, normals, [&](Vertex& vertex, const float* n) {
    const glm::dvec3 normal(n[0], n[1], n[2]);
    const double length = glm::length(normal);
    if (length > 0.0)
      vertex.normal = glm::vec3(normal / length);
    else
      all = false;
  });
  return all;
}

bool setTangents(Mesh& mesh, const Numbers& tangents) {
  bool all = true;
  forEachVertex(mesh, tangents, [&](Vertex& vertex, const float* t) {
    const glm::dvec3 tangent(t[0], t[1], t[2]);
    const double length = glm::length(tangent);
    if (length > 0.0)
      vertex.tangent = glm::vec4(glm::vec3(tangent / length), t[3] < 0.0f ? -1.0f : 1.0f);
    else
      all = false;
  });
  return all;
}

Result<std::vector<std::uint32_t>> readCorners(const File& file, const Primitive& primitive, std::size_t vertices,
                                               const std::string& key) {
  std::vector<std::uint32_t> corners;
  if (primitive.indices == -1) {
    corners.resize(vertices);
    std::iota(corners.begin(), corners.end(), 0u);
  } else {
    MIRRORBALL_TRY(read, readIntegers(file, primitive.indices, key + ".indices"));
    corners = std::move(read);
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] >= vertices)
      return fail(ErrorCode::bad_file, "accessors[" + std::to_string(primitive.indices) + "] (" + key +
                                           ".indices) names vertex " + std::to_string(corners[i]) + " in element " +
                                           std::to_string(i) + ", but POSITION has " + counted(vertices, "element"));
  return triangleCorners(std::move(corners), primitive.mode);
}

}  // namespace

bool hasTriangles(const Primitive& primitive) {
  return primitive.mode == kTriangles || primitive.mode == kTriangleStrip || primitive.mode == kTriangleFan;
}

Result<PrimitiveMesh> readPrimitive(const File& file, const Primitive& primitive, int tangent_uv_set,
                                    WantedDeformation wanted, const std::string& key) {
  DracoMesh draco;
  if (primitive.draco_view >= 0) {
    MIRRORBALL_TRY(decoded, decodeDraco(file, primitive, key));
    draco = std::move(decoded);
  }
  const auto attribute = [&](const std::string& name, std::size_t min_components, std::size_t max_components,
                             std::optional<std::size_t> vertices) {
    return readAttribute(file, primitive, draco, name, min_components, max_components, vertices, key);
  };
  MIRRORBALL_TRY(positions, attribute("POSITION", 3, 3, {}));
  const std::size_t count = positions.count();
  MIRRORBALL_TRY(normals, attribute("NORMAL", 3, 3, count));
  MIRRORBALL_TRY(tangents, attribute("TANGENT", 4, 4, count));
  MIRRORBALL_TRY(uv0, attribute("TEXCOORD_0", 2, 2, count));
  MIRRORBALL_TRY(uv1, attribute("TEXCOORD_1", 2, 2, count));
  MIRRORBALL_TRY(colors, attribute("COLOR_0", 3, 4, count));
  std::vector<std::uint32_t> corners = std::move(draco.corners);
  if (primitive.draco_view < 0) {
    MIRRORBALL_TRY(read, readCorners(file, primitive, count, key));
    corners = std::move(read);
  }

  Mesh mesh;
  mesh.vertices.resize(count);
  mesh.indices = std::move(corners);
  forEachVertex(mesh, positions, [](Vertex& vertex, const float* p) { vertex.position = {p[0], p[1], p[2]}; });
  forEachVertex(mesh, uv0, [](Vertex& vertex, const float* t) { vertex.uv[0] = {t[0], t[1]}; });
  forEachVertex(mesh, uv1, [](Vertex& vertex, const float* t) { vertex.uv[1] = {t[0], t[1]}; });
  forEachVertex(mesh, colors, [&](Vertex& vertex, const float* c) {
    vertex.color = glm::vec4(c[0], c[1], c[2], colors.components == 4 ? c[3] : 1.0f);
  });

  const bool has_normals = normals.count() > 0;
  std::vector<std::uint32_t> sources(count);
  std::iota(sources.begin(), sources.end(), 0u);
  if (!has_normals)
    sources = makeFlat(mesh);
  else if (!setNormals(mesh, normals))
    computeNormals(mesh);
  // Tangents without normals are to be ignored (section 3.7.2.1).
  if (!has_normals || tangents.count() == 0 || !setTangents(mesh, tangents)) addTangents(mesh, tangent_uv_set, sources);
  MIRRORBALL_TRY(deformation, readDeformation(
                                  file, primitive, wanted, {mesh, sources, count, !has_normals},
                                  [&](const std::string& name, std::size_t min, std::size_t max) {
                                    return attribute(name, min, max, count);
                                  },
                                  key));
  return PrimitiveMesh{std::move(mesh), std::move(deformation)};
}

}  // namespace mirrorball::gltf
