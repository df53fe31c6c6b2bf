#include "mirrorball/scene/mesh_file/ply.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/mesh_file/named_pictures.h"
#include "mirrorball/scene/mesh_file/ply_content.h"
#include "mirrorball/scene/mesh_file/ply_header.h"
#include "mirrorball/scene/mesh_file/points_alone.h"
#include "mirrorball/scene/mesh_file/smoothing.h"
#include "mirrorball/scene/mesh_file/vertex_colors.h"
#include "mirrorball/scene/mesh_repair.h"
#include "mirrorball/scene/model_origin.h"
#include "mirrorball/scene/tangents.h"

namespace mirrorball {
namespace {

/// Why a file without triangles cannot be drawn, and what helps.
tl::unexpected<Error> noSurface(const PlyHeader& header, const PlyContent& content) {
  if (!content.truncation.empty())
    return fail(ErrorCode::bad_file, content.truncation + " before its first face; download or export it again");
  const std::string repairs = remarkOn(content.repair);
  if (!repairs.empty()) return fail(ErrorCode::bad_file, "holds no face that can be drawn: " + repairs);
  for (const PlyElement& element : header.elements)
    if (element.isVertices() && element.has("f_dc_0") && element.has("scale_0"))  // Kerbl et al. 2023
      return fail(ErrorCode::unsupported,
                  "holds Gaussian splats, " + std::to_string(content.vertices.size()) +
                      " of them, and no faces; only surfaces can be drawn: make a mesh of them");
  return pointsAlone(content.vertices.size());
}

/// Gives a mesh the normals of its smooth parts: a vertex at a sharp edge becomes several. Its corners stay in order.
void addNormals(Mesh& mesh) {
  std::vector<glm::vec3> positions;
  for (const Vertex& vertex : mesh.vertices) positions.push_back(vertex.position);
  std::vector<PolygonFace> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    triangles.push_back({std::span(mesh.indices).subspan(i, 3)});
  CornerNormals made = cornerNormals(positions, triangles);
  // All corners that share a normal are of one vertex.
  std::vector<Vertex> vertices(made.normals.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    const std::uint32_t normal = made.of_corner[corner];
    vertices[normal] = mesh.vertices[mesh.indices[corner]];
    vertices[normal].normal = made.normals[normal];
  }
  mesh.vertices = std::move(vertices);
  mesh.indices = std::move(made.of_corner);
}

/// The mesh of all triangles, with vertices as the file has them: where each is, and with a normal.
Mesh wholeMesh(PlyContent& content, glm::dvec3 origin) {
  Mesh mesh;
  mesh.vertices = std::move(content.vertices);
  mesh.indices = std::move(content.indices);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].position = glm::vec3(content.positions[i] - origin);
  content.positions = {};
  const bool has_some =
      content.has_normals && std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Vertex& v) {
        return glm::length(v.normal) > 0.0f;  // not NaN either
      });
  if (!has_some) addNormals(mesh);
  content.repair += repairMesh(mesh);
  for (Vertex& vertex : mesh.vertices) vertex.normal = glm::vec3(glm::normalize(glm::dvec3(vertex.normal)));
  return mesh;
}

/// A vertex with what a face adds to it.
struct OwnVertex {
  std::uint32_t vertex;
  glm::vec2 uv;
  glm::vec4 color;
  bool operator==(const OwnVertex&) const = default;
};

struct OwnVertexHash {
  std::size_t operator()(const OwnVertex& own) const {
    std::size_t hash = own.vertex;
    for (const float number : {own.uv.x, own.uv.y, own.color.r, own.color.g, own.color.b, own.color.a}) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &number, sizeof bits);
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;  // Fibonacci hashing (Knuth, TAOCP 6.4)
    }
    return hash ^ (hash >> 32);
  }
};

/// Cuts a mesh into those of its pictures, and gives vertices what their faces have for themselves.
std::map<int, Mesh> meshesOfPictures(const Mesh& whole, const PlyContent& content, std::size_t pictures) {
  std::map<int, Mesh> meshes;
  std::map<int, std::unordered_map<OwnVertex, std::uint32_t, OwnVertexHash>> known;
  for (std::size_t corner = 0; corner < whole.indices.size(); ++corner) {
    const PlyFace face = content.faces.empty() ? PlyFace{} : content.faces[corner / 3];
    const int picture = face.picture >= 0 && std::size_t(face.picture) < pictures ? face.picture : 0;
    const std::uint32_t index = whole.indices[corner];
    Vertex vertex = whole.vertices[index];
    if (!content.corner_uvs.empty()) vertex.uv[0] = vertex.uv[1] = content.corner_uvs[corner];
    if (content.has_face_colors) vertex.color = face.color;
    Mesh& mesh = meshes[picture];
    const auto [found, is_new] = known[picture].try_emplace({index, vertex.uv[0], vertex.color},
                                                            static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(vertex);
    mesh.indices.push_back(found->second);
  }
  return meshes;
}

/// Gives each mesh a material with its picture.
void addMaterials(std::map<int, Mesh> meshes, const PlyHeader& header, bool has_uvs, bool has_colors, NamedFiles& named,
                  Scene& scene) {
  NamedPictures pictures(named, scene);
  std::vector<MtlMap> names(header.pictures.size());
  for (std::size_t i = 0; i < names.size(); ++i) names[i].readings = readingsOfName(header.pictures[i]);
  bool hides_colors = false;
  for (auto& [picture, mesh] : meshes) {
    Material material = materialOfColors(has_colors);
    if (has_uvs && std::size_t(picture) < names.size())
      material.base_color_map = pictures.colors(names[std::size_t(picture)], TextureUse::factors);
    if (material.base_color_map.texture >= 0) {
      material.base_color = glm::vec3(1.0f);
      // They are the same colours once more, which MeshLab keeps beside a picture.
      for (Vertex& vertex : mesh.vertices) vertex.color = glm::vec4(1.0f);
      hides_colors = hides_colors || has_colors;
    }
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::mat4(1.0f)});
    scene.meshes.push_back(std::move(mesh));
  }
  pictures.decode();
  if (hides_colors) scene.warnings.emplace_back("has colours beside its picture, which alone is shown");
}

}  // namespace

Result<Scene> decodePly(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                        const ModelLoadOptions& options) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  MIRRORBALL_TRY(header, parsePlyHeader(text));
  ModelFiles files(path, options);
  const MemoryShare share(files.budget());  // of the mesh, while pictures are read
  MIRRORBALL_TRY(content, readPlyContent(bytes, header));
  if (content.indices.empty()) return noSurface(header, content);
  const glm::dvec3 origin = originFor(content.positions);
  Mesh whole = wholeMesh(content, origin);

  const bool has_uvs = content.has_uvs || !content.corner_uvs.empty();
  const bool has_colors = content.has_colors || content.has_face_colors;
  std::map<int, Mesh> meshes;
  if (content.faces.empty() && content.corner_uvs.empty())
    meshes[0] = std::move(whole);
  else
    meshes = meshesOfPictures(whole, content, header.pictures.size());
  for (auto& [picture, mesh] : meshes) {
    content.repair += repairMesh(mesh);
    computeTangents(mesh);
  }

  Scene scene;
  NamedFiles named(path, files);
  addMaterials(std::move(meshes), header, has_uvs, has_colors, named, scene);
  if (content.has_colors && content.has_face_colors)
    scene.warnings.emplace_back("has colours of vertices and of faces; those of the faces are shown");
  for (const std::string& remark : named.remarks()) scene.warnings.push_back(remark);
  if (!content.truncation.empty())
    scene.warnings.push_back(content.truncation + ", and its faces up to there are shown");
  for (std::string& remark : content.remarks) scene.warnings.push_back(std::move(remark));
  if (std::string repairs = remarkOn(content.repair); !repairs.empty()) scene.warnings.push_back(std::move(repairs));
  for (std::string& warning : scene.warnings) warning.insert(0, path.string() + ": ");
  tellOfFiles(files, scene);
  setOrigin(scene, origin, content.positions_are_floats);
  return scene;
}

}  // namespace mirrorball
