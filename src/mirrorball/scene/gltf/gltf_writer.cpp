#include "mirrorball/scene/gltf/gltf_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/glb_builder.h"
#include "mirrorball/scene/gltf/gltf_camera.h"
#include "mirrorball/scene/gltf/gltf_document.h"
#include "mirrorball/scene/gltf/gltf_file.h"
#include "mirrorball/scene/gltf/gltf_light.h"
#include "mirrorball/scene/gltf/gltf_material_writer.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball {
namespace gltf {
namespace {

// What OpenGL would bind a buffer view to.
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

template <typename Element>
std::span<const std::uint8_t> bytesOf(const std::vector<Element>& elements) {
  return {reinterpret_cast<const std::uint8_t*>(elements.data()), elements.size() * sizeof(Element)};
}

template <int kComponents>
OutputJson componentsOf(const glm::vec<kComponents, float>& vector) {
  return std::vector<float>(&vector.x, &vector.x + kComponents);
}

class SceneWriter {
 public:
  explicit SceneWriter(const Scene& scene) : scene_(scene) {}

  Result<EncodedScene> write(const std::optional<Camera>& camera) {
    file_.json["asset"] = {{"version", "2.0"}, {"generator", "Mirrorball"}};
    EncodedScene encoded;
    for (const Mesh& mesh : scene_.meshes) writeMesh(mesh);
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) writeInstance(i, encoded.left_out);
    writeLights();
    writeVariants();
    writeCameras();
    if (camera) writePicturesCamera(*camera);
    writeRoots(encoded.left_out);
    file_.json["scene"] = 0;
    MIRRORBALL_TRY_VOID(writeMaterials(scene_, file_, encoded.left_out));
    if (!scene_.rig.animations.empty())
      encoded.left_out.emplace_back("the model's animations are left out; it keeps the pose that it is in");
    MIRRORBALL_TRY(bytes, file_.finish());
    encoded.bytes = std::move(bytes);
    return encoded;
  }

 private:
  /// Appends one number or vector of every vertex; returns the index of its accessor.
  template <typename Element, typename Get>
  std::size_t writeAttribute(const Mesh& mesh, Get&& get) {
    std::vector<Element> elements(mesh.vertices.size());
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), elements.begin(), get);
    const std::size_t view = file_.appendView(bytesOf(elements), kArrayBuffer);
    return file_.append("accessors", {{"bufferView", view},
                                      {"componentType", static_cast<int>(kFloat)},
                                      {"count", elements.size()},
                                      {"type", "VEC" + std::to_string(Element::length())}});
  }

  /// The same, unless all vertices have what a reader takes where there is no such attribute.
  template <typename Element, typename Get>
  void writeUnlessDefault(const Mesh& mesh, const char* name, Element usual, Get&& get, OutputJson& attributes) {
    const bool is_usual = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                      [&](const Vertex& vertex) { return get(vertex) == usual; });
    if (!is_usual) attributes[name] = writeAttribute<Element>(mesh, get);
  }

  std::size_t writePositions(const Mesh& mesh) {
    glm::vec3 min = mesh.vertices.front().position, max = min;
    for (const Vertex& vertex : mesh.vertices) {
      min = glm::min(min, vertex.position);
      max = glm::max(max, vertex.position);
    }
    const std::size_t accessor = writeAttribute<glm::vec3>(mesh, [](const Vertex& vertex) { return vertex.position; });
    file_.json["accessors"][accessor]["min"] = componentsOf(min);
    file_.json["accessors"][accessor]["max"] = componentsOf(max);
    return accessor;
  }

  std::size_t writeIndices(const Mesh& mesh) {
    const std::size_t view = file_.appendView(bytesOf(mesh.indices), kElementArrayBuffer);
    return file_.append("accessors", {{"bufferView", view},
                                      {"componentType", static_cast<int>(kUnsignedInt)},
                                      {"count", mesh.indices.size()},
                                      {"type", "SCALAR"}});
  }

  void writeMesh(const Mesh& mesh) {
    OutputJson attributes{{"POSITION", writePositions(mesh)}};
    attributes["NORMAL"] = writeAttribute<glm::vec3>(mesh, [](const Vertex& vertex) { return vertex.normal; });
    writeUnlessDefault(
        mesh, "TANGENT", Vertex{}.tangent, [](const Vertex& vertex) { return vertex.tangent; }, attributes);
    const auto uv = [](std::size_t set) { return [set](const Vertex& vertex) { return vertex.uv[set]; }; };
    writeUnlessDefault(mesh, "TEXCOORD_0", Vertex{}.uv[0], uv(0), attributes);
    writeUnlessDefault(mesh, "TEXCOORD_1", Vertex{}.uv[1], uv(1), attributes);
    // The sets' numbers may not begin with 1.
    if (attributes.contains("TEXCOORD_1") && !attributes.contains("TEXCOORD_0"))
      attributes["TEXCOORD_0"] = writeAttribute<glm::vec2>(mesh, uv(0));
    writeUnlessDefault(
        mesh, "COLOR_0", Vertex{}.color, [](const Vertex& vertex) { return vertex.color; }, attributes);
    const std::size_t indices = writeIndices(mesh);
    OutputJson primitive{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", mesh.material}};
    if (!mesh.material_of_variant.empty())
      primitive["extensions"]["KHR_materials_variants"]["mappings"] = mappingsOf(mesh);
    file_.append("meshes", {{"primitives", OutputJson::array({std::move(primitive)})}});
  }

  void writeInstance(std::size_t index, std::vector<std::string>& left_out) {
    const Instance& instance = scene_.instances[index];
    const glm::mat4& matrix = instance.world_from_object;
    OutputJson node{{"mesh", instance.mesh}};
    if (matrix != glm::mat4(1.0f)) node["matrix"] = matrixOf(matrix);
    const std::size_t place = file_.append("nodes", std::move(node));
    if (isSheared(matrix))
      left_out.push_back(quoted("nodes", place) +
                         ": its transform has shear, which glTF does not allow and some programs leave out");
  }

  /// Makes nodes without a parent of all, or of two that bring them back to where the scene's file had them: the
  /// numbers written here are whole, or floats.
  void writeRoots(std::vector<std::string>& left_out) {
    OutputJson nodes = OutputJson::array();
    for (std::size_t i = 0; i < file_.json["nodes"].size(); ++i) nodes.push_back(i);
    const auto moveBy = [&](OutputJson translation) {
      const std::size_t parent = file_.append(
          "nodes", {{"name", "Origin"}, {"translation", std::move(translation)}, {"children", std::move(nodes)}});
      nodes = OutputJson::array({parent});
    };
    const glm::dvec3 origin = writtenOrigin(left_out);
    const glm::dvec3 whole = glm::round(origin);
    if (origin != whole) moveBy(componentsOf(glm::vec3(origin - whole)));
    if (whole != glm::dvec3(0.0))
      moveBy(OutputJson::array({std::int64_t(whole.x), std::int64_t(whole.y), std::int64_t(whole.z)}));
    file_.append("scenes", {{"nodes", std::move(nodes)}});
  }

  /// The scene's origin, or 0 where it is beyond whole numbers of 64 bits, which end at 9.22e18.
  glm::dvec3 writtenOrigin(std::vector<std::string>& left_out) const {
    constexpr double kLargest = 9e18;
    const glm::dvec3 origin = scene_.origin;
    if (std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}) <= kLargest) return origin;
    left_out.push_back("its place in its file, " + writtenPlace(origin) + ", is left out, as all beyond " +
                       formatNumber(kLargest) + " are: it stands about 0,0,0");
    return glm::dvec3(0.0);
  }

  static OutputJson matrixOf(const glm::mat4& matrix) { return std::vector<float>(&matrix[0].x, &matrix[0].x + 16); }

  static bool isSheared(const glm::mat4& matrix) {
    constexpr float kRightAngle = 1e-4f;  // a cosine: rounding leaves less
    const auto cosine = [&](int a, int b) {
      return glm::dot(glm::normalize(glm::vec3(matrix[a])), glm::normalize(glm::vec3(matrix[b])));
    };
    return std::max({std::abs(cosine(0, 1)), std::abs(cosine(1, 2)), std::abs(cosine(2, 0))}) > kRightAngle;
  }

  /// The camera of the picture, as a model's: m[0][0] and m[1][1] of a projection are 1 / tan of half the angle, or 1
  /// over half the width and height.
  void writePicturesCamera(const Camera& camera) {
    const glm::mat4& clip = camera.clip_from_view;
    ModelCamera written{.name = "Camera",
                        .world_from_view = glm::inverse(camera.view_from_world),
                        .orthographic = camera.orthographic,
                        .aspect = clip[1][1] / clip[0][0]};
    if (camera.orthographic) {
      const float depth = -2.0f / clip[2][2];
      const float nearest = (clip[3][2] + 1.0f) / clip[2][2];
      // glTF's depths begin at 0 or behind; where a camera stands along its axis makes no difference to this one.
      if (nearest < 0.0f) written.world_from_view[3] += written.world_from_view[2] * -nearest;
      written.nearest = std::max(nearest, 0.0f);
      written.height = 2.0f / clip[1][1];
      writeCamera(written, written.nearest + depth);
    } else {
      written.nearest = clip[3][2] / (clip[2][2] - 1.0f);
      written.fov_rad = 2.0f * std::atan(1.0f / clip[1][1]);
      writeCamera(written, clip[3][2] / (clip[2][2] + 1.0f));
    }
  }

  void writeCamera(const ModelCamera& camera, std::optional<float> farthest) {
    const std::size_t index = file_.append("cameras", jsonOf(camera, farthest));
    file_.append("nodes", {{"name", camera.name}, {"camera", index}, {"matrix", matrixOf(camera.world_from_view)}});
  }

  void writeCameras() {
    const BoundingSphere bounds = boundingSphere(scene_);
    for (const ModelCamera& camera : scene_.cameras) {
      const float depth =
          glm::dot(glm::vec3(camera.world_from_view[3]) - bounds.center, glm::vec3(camera.world_from_view[2]));
      writeCamera(camera, camera.orthographic ? std::optional(depth + 1.01f * bounds.radius) : std::nullopt);
    }
  }

  void writeLights() {
    if (scene_.lights.empty()) return;
    OutputJson& lights = file_.extension("KHR_lights_punctual")["lights"];
    for (const ModelLight& light : scene_.lights) {
      const OutputJson index{{"light", lights.size()}};
      lights.push_back(jsonOf(light));
      file_.append("nodes",
                   {{"extensions", {{"KHR_lights_punctual", index}}}, {"matrix", matrixOf(worldFromNode(light))}});
    }
  }

  void writeVariants() {
    if (scene_.variants.empty()) return;
    OutputJson& variants = file_.extension("KHR_materials_variants")["variants"];
    for (const std::string& name : scene_.variants) variants.push_back({{"name", name}});
  }

  /// A mapping for each material that some variants give a mesh.
  static OutputJson mappingsOf(const Mesh& mesh) {
    std::map<int, std::vector<std::size_t>> variants_of;
    for (std::size_t variant = 0; variant < mesh.material_of_variant.size(); ++variant)
      variants_of[mesh.material_of_variant[variant]].push_back(variant);
    OutputJson mappings = OutputJson::array();
    for (const auto& [material, variants] : variants_of)
      mappings.push_back({{"material", material}, {"variants", variants}});
    return mappings;
  }

  const Scene& scene_;
  GlbBuilder file_;
};

/// The largest part of what encodeGlb takes: the buffer, and the file that it is copied into.
std::uint64_t memoryFor(const Scene& scene) {
  std::uint64_t bytes = 0;
  for (const Mesh& mesh : scene.meshes)
    bytes += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(std::uint32_t);
  return 2 * bytes;
}

}  // namespace
}  // namespace gltf

Result<EncodedScene> encodeGlb(const Scene& scene, const std::optional<Camera>& camera) {
  if (scene.empty()) return fail(ErrorCode::bad_shape, "there are no triangles to export");
  for (const Mesh& mesh : scene.meshes)
    if (mesh.indices.empty()) return fail(ErrorCode::bad_shape, "a mesh of the scene has no triangles");
  MIRRORBALL_TRY_VOID(checkMemory(gltf::memoryFor(scene)));
  return gltf::SceneWriter(scene).write(camera);
}

}  // namespace mirrorball
