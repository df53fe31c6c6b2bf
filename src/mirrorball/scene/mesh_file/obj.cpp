#include "mirrorball/scene/mesh_file/obj.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <istream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <streambuf>
#include <unordered_map>
#include <utility>
#include <vector>

#include <tiny_obj_loader.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/obj_material.h"
#include "mirrorball/scene/mesh_file/polygon.h"
#include "mirrorball/scene/mesh_file/smoothing.h"
#include "mirrorball/scene/mesh_file/text_scanner.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball {
namespace {

/// One corner of a face: indices from 0; −1 where it has no such attribute.
struct Corner {
  int position = -1;
  int uv = -1;
  int normal = -1;
  bool operator==(const Corner&) const = default;
};

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::size_t hash = 0;
    for (const int index : {corner.position, corner.uv, corner.normal})
      hash = (hash ^ static_cast<std::size_t>(index)) * 0x9E3779B97F4A7C15u;  // Fibonacci hashing (Knuth, TAOCP 6.4)
    return hash ^ (hash >> 32);
  }
};

struct Face {
  std::size_t first_corner;
  std::size_t corner_count;
  int material;  // of the .mtl; −1: none
  int smoothing;
};

/// The file's bytes as a stream, without a copy.
class ByteStream : private std::streambuf, public std::istream {
 public:
  explicit ByteStream(std::span<const std::uint8_t> bytes) : std::istream(static_cast<std::streambuf*>(this)) {
    // A stream buffer takes pointers that it could write through; this one is only read.
    char* begin = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
    setg(begin, begin, begin + bytes.size());
  }

  /// What was read of it.
  std::string_view consumed() const { return {eback(), static_cast<std::size_t>(gptr() - eback())}; }
};

/// The lines `s N` and `s off`, which the parser does not tell of. It has read a face's line and none after it when it
/// calls back, so that all of them before the face lie in what was consumed.
class SmoothingLines {
 public:
  explicit SmoothingLines(const ByteStream& stream) : stream_(stream) {}

  /// The group of a face that was read just now.
  int here() {
    const std::string_view text = stream_.consumed();
    while (at_ < text.size()) {
      const std::size_t end = std::min(text.find_first_of("\r\n", at_), text.size());
      read(text.substr(at_, end - at_));
      at_ = end + 1;
    }
    return group_;
  }

  bool hasAny() const { return has_any_; }

 private:
  void read(std::string_view line) {
    const auto skipSpace = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
    skipSpace();
    if (line.size() < 2 || line[0] != 's' || (line[1] != ' ' && line[1] != '\t')) return;
    line.remove_prefix(1);
    skipSpace();
    const std::optional<double> group = parseNumber(line.substr(0, line.find_first_not_of("0123456789")));
    const bool is_number = group && *group <= std::numeric_limits<int>::max();
    if (!is_number && !line.starts_with("off")) return;
    has_any_ = true;
    group_ = is_number ? static_cast<int>(*group) : kFlat;
  }

  const ByteStream& stream_;
  std::size_t at_ = 0;
  int group_ = kFlat;  // "the default value for s is off" (Wavefront, Object Files)
  bool has_any_ = false;
};

/// What the parser's callbacks collect.
struct Geometry {
  explicit Geometry(const ByteStream& stream) : smoothing(stream) {}

  SmoothingLines smoothing;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec3> normals;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<tinyobj::material_t> materials;
  int material = -1;
  std::set<std::string> unknown_materials;
  std::string problem;  // the first one; what follows it is not looked at

  void refuse(const std::string& what) {
    if (problem.empty()) problem = what;
  }
};

/// An index as OBJ counts it: from 1, or from the last one backwards; 0 stands for none.
int fromZero(int index, std::size_t count) { return index > 0 ? index - 1 : static_cast<int>(count) + index; }

void addVector(void* user_data, std::vector<glm::vec3> Geometry::*list, const char* what, glm::vec3 vector) {
  auto& geometry = *static_cast<Geometry*>(user_data);
  if (!std::isfinite(vector.x + vector.y + vector.z))
    geometry.refuse(std::string(what) + " " + std::to_string((geometry.*list).size() + 1) + " is not finite");
  (geometry.*list).push_back(vector);
}

void addFace(void* user_data, tinyobj::index_t* indices, int count) {
  auto& geometry = *static_cast<Geometry*>(user_data);
  const std::size_t first = geometry.corners.size();
  for (int i = 0; i < count; ++i) {
    const tinyobj::index_t& index = indices[i];
    Corner corner;
    corner.position = fromZero(index.vertex_index, geometry.positions.size());
    if (index.texcoord_index != 0) corner.uv = fromZero(index.texcoord_index, geometry.uvs.size());
    if (index.normal_index != 0) corner.normal = fromZero(index.normal_index, geometry.normals.size());
    const bool before_first = index.vertex_index == 0 || corner.position < 0 ||
                              (index.texcoord_index != 0 && corner.uv < 0) ||
                              (index.normal_index != 0 && corner.normal < 0);
    if (before_first)
      geometry.refuse("face " + std::to_string(geometry.faces.size() + 1) +
                      " has an index that is 0, no number, or before the first");
    geometry.corners.push_back(corner);
  }
  geometry.faces.push_back({first, static_cast<std::size_t>(count), geometry.material, geometry.smoothing.here()});
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* data, float x, float y, float z, float) {
    addVector(data, &Geometry::positions, "vertex", {x, y, z});
  };
  callback.normal_cb = [](void* data, float x, float y, float z) {
    addVector(data, &Geometry::normals, "normal", {x, y, z});
  };
  callback.texcoord_cb = [](void* data, float u, float v, float) {
    auto& geometry = *static_cast<Geometry*>(data);
    if (!std::isfinite(u + v))
      geometry.refuse("texture coordinate " + std::to_string(geometry.uvs.size() + 1) + " is not finite");
    geometry.uvs.emplace_back(u, 1.0f - v);
  };
  callback.index_cb = addFace;
  callback.usemtl_cb = [](void* data, const char* name, int material) {
    auto& geometry = *static_cast<Geometry*>(data);
    if (material < 0) geometry.unknown_materials.insert(name);
    geometry.material = material;
  };
  callback.mtllib_cb = [](void* data, const tinyobj::material_t* materials, int count) {
    // All that are known so far: they only grow more.
    auto& known = static_cast<Geometry*>(data)->materials;
    known.insert(known.end(), materials + known.size(), materials + count);
  };
  return callback;
}

/// The first coordinate that is no number, which the parser would take as 0: "line 7: 'nan' is no number".
std::optional<std::string> wordThatIsNoNumber(std::string_view text) {
  std::size_t line_number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line_number) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view key = line.substr(0, line.find_first_of(" \t"));
    if (key != "v" && key != "vn" && key != "vt") continue;
    const std::string_view values = line.substr(key.size(), line.find('#') - key.size());
    const std::size_t wrong = values.find_first_not_of(" \t+-.0123456789eE");
    if (wrong == std::string_view::npos) continue;
    const std::size_t first = values.find_last_of(" \t", wrong) + 1;
    const std::string_view word = values.substr(first, values.find_first_of(" \t", wrong) - first);
    return "line " + std::to_string(line_number) + ": '" + excerpt(word) + "' is no number";
  }
  return {};
}

/// The memory that a file of these lines takes at most [bytes], until its meshes have normals and tangents.
std::uint64_t memoryFor(std::string_view text) {
  constexpr std::uint64_t kOfCorner = 300;  // measured with triangles that share nothing, whose normals are computed
  constexpr std::uint64_t kOfElement = 2 * sizeof(glm::vec3);  // a position, normal or coordinate in a growing list
  std::uint64_t bytes = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.starts_with('v')) bytes += kOfElement;
    if (!line.starts_with('f')) continue;
    for (std::size_t i = 1; i < line.size(); ++i)
      if ((line[i - 1] == ' ' || line[i - 1] == '\t') && line[i] != ' ' && line[i] != '\t') bytes += kOfCorner;
  }
  return bytes;
}

/// Reads a .mtl beside the model.
class MaterialReader : public tinyobj::MaterialReader {
 public:
  MaterialReader(ModelFiles& named, Scene& scene) : named_(named), scene_(scene) {}

  bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* indices, std::string*, std::string*) override {
    const auto [known, is_new] = was_read_.try_emplace(name, false);
    if (!is_new) return known->second;
    const auto bytes = readNamed(named_, name);
    if (!bytes) {
      scene_.warnings.push_back(bytes.error().message + "; its materials are left out");
      return false;
    }
    known->second = true;
    if (!tables_.insert(bytes->data()).second) return true;  // it was read by another name
    // The parser keeps them in a growing list, of which the model gets a copy.
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    if (memory_) memory_ = named_.budget().take(occurrences(text, "newmtl") * 3 * sizeof(tinyobj::material_t));
    if (!memory_) return false;
    ByteStream stream(*bytes);
    std::string warning;
    std::string problem;
    tinyobj::LoadMtl(indices, materials, &stream, &warning, &problem);
    return true;
  }

  /// errors   too_large: a table was not read
  const Result<void>& memory() const { return memory_; }

 private:
  ModelFiles& named_;
  Scene& scene_;
  Result<void> memory_;
  std::map<std::string, bool> was_read_;  // of each name that there was
  std::set<const std::uint8_t*> tables_;  // where those lie that were read
};

/// Refuses indices past the last element; positive ones may name elements that come later in the file.
Result<void> checkIndices(const Geometry& geometry) {
  for (std::size_t face = 0; face < geometry.faces.size(); ++face) {
    for (std::size_t i = 0; i < geometry.faces[face].corner_count; ++i) {
      const Corner& corner = geometry.corners[geometry.faces[face].first_corner + i];
      const auto past = [&](int index, std::size_t count, const char* what) -> std::optional<std::string> {
        if (index < static_cast<long long>(count)) return {};
        return "face " + std::to_string(face + 1) + " uses " + what + " " + std::to_string(index + 1LL) + " of " +
               std::to_string(count);
      };
      for (const auto& wrong : {past(corner.position, geometry.positions.size(), "vertex"),
                                past(corner.uv, geometry.uvs.size(), "texture coordinate"),
                                past(corner.normal, geometry.normals.size(), "normal")})
        if (wrong) return fail(ErrorCode::bad_file, *wrong);
    }
  }
  return {};
}

/// Calls `take(three indices into geometry.corners)` for each triangle of a face.
template <typename Take>
void forEachTriangle(const Geometry& geometry, const Face& face, Take&& take) {
  if (face.corner_count < 3) return;
  std::vector<glm::vec3> polygon;
  for (std::size_t i = 0; i < face.corner_count; ++i)
    polygon.push_back(geometry.positions[std::size_t(geometry.corners[face.first_corner + i].position)]);
  for (const auto& triangle : triangulate(polygon))
    take({face.first_corner + triangle[0], face.first_corner + triangle[1], face.first_corner + triangle[2]});
}

bool hasNormal(const Geometry& geometry, const Corner& corner) {
  return corner.normal >= 0 && geometry.normals[std::size_t(corner.normal)] != glm::vec3(0.0f);
}

/// Gives normals to corners that have none. They go by position,
/// so that a seam of the texture coordinates does not show.
void addMissingNormals(Geometry& geometry) {
  const auto lacks_normal = [&](const Corner& corner) { return !hasNormal(geometry, corner); };
  if (std::none_of(geometry.corners.begin(), geometry.corners.end(), lacks_normal)) return;
  std::vector<std::uint32_t> positions;
  positions.reserve(geometry.corners.size());
  for (const Corner& corner : geometry.corners) positions.push_back(static_cast<std::uint32_t>(corner.position));
  std::vector<PolygonFace> faces;
  for (const Face& face : geometry.faces)
    if (face.corner_count >= 3)
      faces.push_back({std::span(positions).subspan(face.first_corner, face.corner_count),
                       geometry.smoothing.hasAny() ? face.smoothing : kSmoothByAngle});
  const CornerNormals made = cornerNormals(geometry.positions, faces);

  const std::size_t first_made = geometry.normals.size();
  auto normal = made.of_corner.begin();
  for (const Face& face : geometry.faces) {
    if (face.corner_count < 3) continue;
    for (std::size_t i = 0; i < face.corner_count; ++i, ++normal)
      if (Corner& corner = geometry.corners[face.first_corner + i]; lacks_normal(corner))
        corner.normal = static_cast<int>(first_made + *normal);
  }
  geometry.normals.insert(geometry.normals.end(), made.normals.begin(), made.normals.end());
}

/// Builds the meshes, one for each material that is used. All corners have normals.
class MeshBuilder {
 public:
  explicit MeshBuilder(const Geometry& geometry) : geometry_(geometry) {}

  /// The meshes by material of the .mtl; −1: none.
  std::map<int, Mesh> build() {
    for (const Face& face : geometry_.faces) {
      Part& part = parts_[face.material];
      forEachTriangle(geometry_, face, [&](std::array<std::size_t, 3> triangle) {
        for (const std::size_t corner : triangle)
          part.mesh.indices.push_back(vertexOf(geometry_.corners[corner], part));
      });
    }
    std::map<int, Mesh> meshes;
    for (auto& [material, part] : parts_) {
      if (part.mesh.indices.empty()) continue;
      computeTangents(part.mesh);
      meshes[material] = std::move(part.mesh);
    }
    return meshes;
  }

 private:
  struct Part {
    Mesh mesh;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices;
  };

  std::uint32_t vertexOf(const Corner& corner, Part& part) {
    const auto [found, is_new] = part.vertices.emplace(corner, static_cast<std::uint32_t>(part.mesh.vertices.size()));
    if (!is_new) return found->second;
    Vertex& vertex = part.mesh.vertices.emplace_back();
    vertex.position = geometry_.positions[std::size_t(corner.position)];
    if (corner.uv >= 0) vertex.uv[0] = vertex.uv[1] = geometry_.uvs[std::size_t(corner.uv)];
    vertex.normal = glm::vec3(glm::normalize(glm::dvec3(geometry_.normals[std::size_t(corner.normal)])));
    return found->second;
  }

  const Geometry& geometry_;
  std::map<int, Part> parts_;
};

}  // namespace

Result<Scene> decodeObj(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                        const ModelLoadOptions& options) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (const auto wrong = wordThatIsNoNumber(text)) return fail(ErrorCode::bad_file, *wrong);
  Scene scene;
  ByteStream stream(bytes);
  Geometry geometry(stream);
  ModelFiles named(path, options);
  MIRRORBALL_TRY_VOID(named.budget().take(bytes.size() + memoryFor(text)));
  MaterialReader reader(named, scene);
  try {
    tinyobj::LoadObjWithCallback(stream, callbacks(), &geometry, &reader);
  } catch (const std::exception& exception) {
    geometry.refuse(excerpt(exception.what()));
  }
  MIRRORBALL_TRY_VOID(reader.memory());
  if (!geometry.problem.empty()) return fail(ErrorCode::bad_file, geometry.problem);
  MIRRORBALL_TRY_VOID(checkIndices(geometry));
  if (geometry.faces.empty())
    return fail(ErrorCode::bad_file, "holds no faces; it is no OBJ file, or only points and lines");
  for (const std::string& material : geometry.unknown_materials)
    scene.warnings.push_back(path.string() + ": no .mtl has the material '" + excerpt(material) + "'");

  addMissingNormals(geometry);
  std::map<int, Mesh> meshes = MeshBuilder(geometry).build();
  if (meshes.empty()) return fail(ErrorCode::bad_file, "none of its faces has three corners");
  std::vector<tinyobj::material_t> used;
  for (auto& [material, mesh] : meshes) {
    mesh.material = static_cast<int>(scene.meshes.size());
    scene.instances.push_back({mesh.material, glm::mat4(1.0f)});
    scene.meshes.push_back(std::move(mesh));
    if (material >= 0)
      used.push_back(geometry.materials[std::size_t(material)]);
    else
      scene.materials.emplace_back();  // the least key comes first, and so does its material
  }
  addObjMaterials(used, named, scene);
  tellOfFiles(named, scene);
  return scene;
}

}  // namespace mirrorball
