#include "mirrorball/scene/gltf/gltf_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
///
/// restart   an index that begins a strip or a fan anew, as WebGL has it
std::vector<std::uint32_t> triangleCorners(std::vector<std::uint32_t> corners, int mode, std::uint32_t restart) {
  if (mode == kTriangles) {
    corners.resize(corners.size() - corners.size() % 3);
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  auto begin = corners.begin();
  while (begin != corners.end()) {
    const auto end = std::find(begin, corners.end(), restart);
    for (auto corner = begin; end - corner > 2; ++corner) {
      const std::ptrdiff_t odd = (corner - begin) % 2;
      if (mode == kTriangleStrip)
        triangles.insert(triangles.end(), {corner[0], corner[1 + odd], corner[2 - odd]});
      else
        triangles.insert(triangles.end(), {corner[1], corner[2], *begin});
    }
    begin = end == corners.end() ? end : end + 1;
  }
  return triangles;
}

/// The greatest index of an accessor's type, which restarts strips and fans unless there is such a vertex.
std::uint32_t restartIndex(const File& file, int accessor, std::size_t vertices) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  if (accessor < 0 || std::size_t(accessor) >= file.document.accessors.size()) return kNone;
  const int type = file.document.accessors[std::size_t(accessor)].component_type;
  const std::uint32_t greatest = type == kByte || type == kUnsignedByte     ? 0xFF
                                 : type == kShort || type == kUnsignedShort ? 0xFFFF
                                                                            : kNone;
  return greatest < vertices ? kNone : greatest;
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

/// The direction of a file's normal or tangent; 0 where it has none.
glm::vec3 unitDirection(const float* numbers) {
  const glm::dvec3 direction(numbers[0], numbers[1], numbers[2]);
  const double length = glm::length(direction);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(direction / length) : glm::vec3(0.0f);
}

/// Sets tangents from the file's, and has those computed that have no direction.
///
/// sources  of each vertex, the one of the file that it was
/// returns  how many had none
std::size_t setTangents(Mesh& mesh, const Numbers& tangents, int uv_set, std::vector<std::uint32_t>& sources) {
  const auto readTangent = [&](std::size_t source) {
    const float* t = tangents.values.data() + source * tangents.components;
    return glm::vec4(unitDirection(t), t[3] < 0.0f ? -1.0f : 1.0f);
  };
  std::size_t lacking = 0;
  for (std::size_t i = 0; i < tangents.count(); ++i)
    if (glm::vec3(readTangent(i)) == glm::vec3(0.0f)) ++lacking;
  if (lacking > 0) addTangents(mesh, uv_set, sources);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (const glm::vec4 own = readTangent(sources[i]); glm::vec3(own) != glm::vec3(0.0f))
      mesh.vertices[i].tangent = own;
  return lacking;
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
  return triangleCorners(std::move(corners), primitive.mode, restartIndex(file, primitive.indices, vertices));
}

/// Reads the attributes of a primitive, and leaves out those that are damaged.
class Attributes {
 public:
  Attributes(const File& file, const Primitive& primitive, const std::string& key, std::vector<Damage>& damage)
      : file_(file), primitive_(primitive), key_(key), damage_(damage) {}

  /// Decodes what the primitive keeps compressed. Where that is damaged, or this build cannot, it may be in the
  /// accessors as well.
  Result<void> decompress() {
    if (primitive_.draco_view < 0) return {};
    Result<DracoMesh> decoded = decodeDraco(file_, primitive_, key_);
    if (decoded) {
      draco_ = std::move(*decoded);
      is_compressed_ = true;
      return {};
    }
    const auto position = primitive_.attributes.find("POSITION");
    const std::vector<Accessor>& accessors = file_.document.accessors;
    const bool has_both = position != primitive_.attributes.end() && position->second >= 0 &&
                          std::size_t(position->second) < accessors.size() &&
                          accessors[std::size_t(position->second)].buffer_view >= 0;
    if (!has_both) return fail(std::move(decoded));
    return notedIn(damage_, "compressed form of the primitive", fail(std::move(decoded)));
  }

  /// The corners of the triangles of so many vertices.
  Result<std::vector<std::uint32_t>> corners(std::size_t vertices) {
    if (is_compressed_) return std::move(draco_.corners);
    return readCorners(file_, primitive_, vertices, key_);
  }

  Result<Numbers> read(const std::string& name, std::size_t min_components, std::size_t max_components,
                       std::optional<std::size_t> vertices) {
    return readAttribute(file_, primitive_, draco_, name, min_components, max_components, vertices, key_);
  }

  /// Reads what a mesh can do without: nothing where it is damaged.
  Result<Numbers> readIfSound(const std::string& name, std::size_t min_components, std::size_t max_components,
                              std::size_t vertices) {
    Result<Numbers> numbers = read(name, min_components, max_components, vertices);
    if (numbers) return numbers;
    MIRRORBALL_TRY_VOID(notedIn(damage_, "attribute", fail(std::move(numbers))));
    return Numbers{};
  }

  /// Reads two texture coordinates, of which some programs write three (assimp issue 2615).
  Result<Numbers> readTexCoords(int set, std::size_t vertices) {
    const std::string name = "TEXCOORD_" + std::to_string(set);
    MIRRORBALL_TRY(numbers, readIfSound(name, 2, 3, vertices));
    if (numbers.components == 3) tellOfComponents(name, numbers, "third coordinate");
    return numbers;
  }

  /// Notes that an attribute has a component too many, which is not used.
  void tellOfComponents(const std::string& name, const Numbers& numbers, const char* left_out) {
    damage_.push_back(
        {{ErrorCode::bad_file, key_ + ".attributes." + name + " has " + counted(numbers.components, "component")},
         left_out});
  }

 private:
  const File& file_;
  const Primitive& primitive_;
  const std::string& key_;
  std::vector<Damage>& damage_;
  DracoMesh draco_;
  bool is_compressed_ = false;
};

/// An accessor without bytes is all zeros, which cannot be positions: those are in an extension that is not read.
Result<void> checkPositions(const File& file, const Primitive& primitive, const std::string& key) {
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) return {};
  const auto index = static_cast<std::size_t>(position->second);
  if (position->second < 0 || index >= file.document.accessors.size()) return {};
  const Accessor& accessor = file.document.accessors[index];
  if (accessor.buffer_view >= 0 || accessor.sparse || accessor.count == 0 || primitive.draco_view >= 0) return {};
  return fail(ErrorCode::unsupported,
              quoted("accessors", index) + " (" + key + ".attributes.POSITION) has no bytes: " +
                  "its places are in an extension that this program does not read; export the model without it");
}

}  // namespace

bool hasTriangles(const Primitive& primitive) {
  return primitive.mode == kTriangles || primitive.mode == kTriangleStrip || primitive.mode == kTriangleFan;
}

Result<PrimitiveMesh> readPrimitive(const File& file, const Primitive& primitive, int tangent_uv_set,
                                    WantedDeformation wanted, const std::string& key) {
  PrimitiveMesh result;
  MIRRORBALL_TRY_VOID(checkPositions(file, primitive, key));
  Attributes attributes(file, primitive, key, result.damage);
  MIRRORBALL_TRY_VOID(attributes.decompress());
  MIRRORBALL_TRY(positions, attributes.read("POSITION", 3, 4, {}));
  if (positions.components == 4) attributes.tellOfComponents("POSITION", positions, "fourth coordinate");
  const std::size_t count = positions.count();
  const auto attribute = [&](const std::string& name, std::size_t min_components, std::size_t max_components) {
    return attributes.readIfSound(name, min_components, max_components, count);
  };
  const TexCoordSets& sets = file.document.tex_coord_sets;
  MIRRORBALL_TRY(normals, attribute("NORMAL", 3, 4));
  if (normals.components == 4) attributes.tellOfComponents("NORMAL", normals, "fourth coordinate");
  MIRRORBALL_TRY(tangents, attribute("TANGENT", 4, 4));
  MIRRORBALL_TRY(uv0, attributes.readTexCoords(sets[0], count));
  MIRRORBALL_TRY(uv1, attributes.readTexCoords(sets[1], count));
  MIRRORBALL_TRY(colors, attribute("COLOR_0", 3, 4));
  result.colors = bringIntoRange(colors);
  MIRRORBALL_TRY(corners, attributes.corners(count));

  Mesh& mesh = result.mesh;
  mesh.vertices.resize(count);
  mesh.indices = std::move(corners);
  forEachVertex(mesh, positions, [](Vertex& vertex, const float* p) { vertex.position = {p[0], p[1], p[2]}; });
  forEachVertex(mesh, normals, [](Vertex& vertex, const float* n) { vertex.normal = unitDirection(n); });
  forEachVertex(mesh, uv0, [](Vertex& vertex, const float* t) { vertex.uv[0] = {t[0], t[1]}; });
  forEachVertex(mesh, uv1, [](Vertex& vertex, const float* t) { vertex.uv[1] = {t[0], t[1]}; });
  forEachVertex(mesh, colors, [&](Vertex& vertex, const float* c) {
    vertex.color = glm::vec4(c[0], c[1], c[2], colors.components == 4 ? c[3] : 1.0f);
  });
  result.repair = repairMesh(mesh);

  const bool has_normals = normals.count() > 0;
  std::vector<std::uint32_t> sources(count);
  std::iota(sources.begin(), sources.end(), 0u);
  if (!has_normals) sources = makeFlat(mesh);
  // Tangents without normals are to be ignored (section 3.7.2.1).
  if (!has_normals || tangents.count() == 0)
    addTangents(mesh, tangent_uv_set, sources);
  else
    result.tangents_made = setTangents(mesh, tangents, tangent_uv_set, sources);
  MIRRORBALL_TRY(deformation, readDeformation(
                                  file, primitive, wanted, {mesh, sources, count, !has_normals},
                                  [&](const std::string& name, std::size_t min, std::size_t max) {
                                    return attributes.read(name, min, max, count);
                                  },
                                  key, result.damage));
  result.deformation = std::move(deformation);
  return result;
}

}  // namespace mirrorball::gltf
