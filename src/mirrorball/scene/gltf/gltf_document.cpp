#include "mirrorball/scene/gltf/gltf_document.h"

#include <algorithm>
#include <set>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "mirrorball/base/json_memory.h"
#include "mirrorball/base/json_reader.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_camera.h"
#include "mirrorball/scene/gltf/gltf_document_animation.h"
#include "mirrorball/scene/gltf/gltf_document_material.h"
#include "mirrorball/scene/gltf/gltf_extensions.h"
#include "mirrorball/scene/gltf/gltf_light.h"

// Khronos, "glTF 2.0 Specification" (ISO/IEC 12113:2022).

namespace mirrorball::gltf {
namespace {

/// The accessors of a primitive by attribute, or the ids of a compressed mesh.
std::map<std::string, int> indicesByName(const JsonReader& object) {
  std::map<std::string, int> indices;
  for (const auto& [name, index] : object.members()) indices[name] = index.index();
  return indices;
}

std::vector<int> indicesOf(const JsonReader& array) {
  std::vector<int> indices;
  for (const JsonReader& index : array.elements()) indices.push_back(index.index());
  return indices;
}

Accessor parseAccessor(const JsonReader& json) {
  Accessor accessor;
  accessor.buffer_view = json["bufferView"].index();
  accessor.byte_offset = json["byteOffset"].size(0);
  accessor.count = json["count"].required().size(0);
  accessor.component_type = json["componentType"].required().index();
  accessor.normalized = json["normalized"].flag(false);
  const std::string type = json["type"].required().text("");
  if (type == "SCALAR") accessor.components = 1;
  if (type == "VEC2") accessor.components = 2;
  if (type == "VEC3") accessor.components = 3;
  if (type == "VEC4") accessor.components = 4;
  if (type == "MAT4") accessor.components = 16;
  if (const JsonReader sparse = json["sparse"]; sparse.exists()) {
    const JsonReader indices = sparse["indices"].required();
    const JsonReader values = sparse["values"].required();
    accessor.sparse = Sparse{sparse["count"].required().size(0),      indices["bufferView"].required().index(),
                             indices["byteOffset"].size(0),           indices["componentType"].required().index(),
                             values["bufferView"].required().index(), values["byteOffset"].size(0)};
  }
  return accessor;
}

BufferView parseBufferView(const JsonReader& json) {
  BufferView view{json["buffer"].required().index(), json["byteOffset"].size(0), json["byteLength"].required().size(0),
                  json["byteStride"].size(0)};
  if (const JsonReader how = json["extensions"]["EXT_meshopt_compression"]; how.exists())
    view.compression = Compression{.buffer = how["buffer"].required().index(),
                                   .byte_offset = how["byteOffset"].size(0),
                                   .byte_length = how["byteLength"].required().size(0),
                                   .byte_stride = how["byteStride"].required().size(0),
                                   .count = how["count"].required().size(0),
                                   .mode = how["mode"].required().text(""),
                                   .filter = how["filter"].text("NONE")};
  return view;
}

/// Marks the buffers that nothing is read of: they stand for what compressed views hold.
void markFallbacks(Document& document) {
  std::set<int> read, replaced;
  for (const BufferView& view : document.buffer_views) {
    if (view.compression) replaced.insert(view.buffer);
    read.insert(view.compression ? view.compression->buffer : view.buffer);
  }
  for (std::size_t i = 0; i < document.buffers.size(); ++i) {
    const int index = static_cast<int>(i);
    document.buffers[i].is_fallback = replaced.contains(index) && !read.contains(index);
  }
}

std::optional<std::string> parseUri(const JsonReader& json) {
  if (!json.exists()) return {};
  return json.text("");
}

Buffer parseBuffer(const JsonReader& json) {
  return {.uri = parseUri(json["uri"]), .byte_length = json["byteLength"].required().size(0)};
}

Image parseImage(const JsonReader& json) {
  Image image{json["bufferView"].index(), parseUri(json["uri"])};
  if (image.buffer_view < 0 && !image.uri) json.refuse("has neither a bufferView nor a uri");
  return image;
}

Sampler parseSampler(const JsonReader& json) {
  constexpr int kNearest = 9728;
  const auto wrap = [](const JsonReader& mode) {
    constexpr int kClampToEdge = 33071;
    constexpr int kMirroredRepeat = 33648;
    if (mode.index() == kClampToEdge) return Wrap::clamp_to_edge;
    return mode.index() == kMirroredRepeat ? Wrap::mirrored_repeat : Wrap::repeat;
  };
  return {wrap(json["wrapS"]), wrap(json["wrapT"]), json["magFilter"].index() == kNearest};
}

/// EXT_texture_webp names the picture itself, and its source beside the extension one for readers that
/// do not know WebP.
Texture parseTexture(const JsonReader& json) {
  const int webp = json["extensions"]["EXT_texture_webp"]["source"].index();
  return {webp >= 0 ? webp : json["source"].index(), json["sampler"].index()};
}

Primitive parsePrimitive(const JsonReader& json) {
  Primitive primitive;
  primitive.attributes = indicesByName(json["attributes"].required());
  primitive.indices = json["indices"].index();
  primitive.material = json["material"].index();
  primitive.mode = static_cast<int>(std::min<std::size_t>(json["mode"].size(kTriangles), 1000));
  for (const JsonReader& target : json["targets"].elements()) primitive.targets.push_back(indicesByName(target));
  const JsonReader draco = json["extensions"]["KHR_draco_mesh_compression"];
  if (draco.exists()) {
    primitive.draco_view = draco["bufferView"].required().index();
    primitive.draco_attributes = indicesByName(draco["attributes"].required());
  }
  for (const JsonReader& mapping : json["extensions"]["KHR_materials_variants"]["mappings"].elements())
    primitive.variant_mappings.push_back({mapping["material"].required().index(), indicesOf(mapping["variants"])});
  return primitive;
}

std::vector<float> floatsOf(const JsonReader& array) {
  std::vector<float> floats;
  for (const JsonReader& number : array.elements()) floats.push_back(static_cast<float>(number.number(0.0)));
  return floats;
}

FileMesh parseMesh(const JsonReader& json) {
  FileMesh mesh{.primitives = {}, .weights = floatsOf(json["weights"])};
  for (const JsonReader& primitive : json["primitives"].required().elements())
    mesh.primitives.push_back(parsePrimitive(primitive));
  return mesh;
}

/// A node's matrix, or translation · rotation · scale.
NodePlace parsePlace(const JsonReader& json) {
  NodePlace place;
  if (json["matrix"].exists()) {
    const std::vector<double> numbers = json["matrix"].numbers(std::vector<double>(16, 0.0));
    for (int i = 0; i < 16; ++i) place.matrix[i / 4][i % 4] = numbers[std::size_t(i)];  // column by column
    return place;
  }
  const std::vector<double> translation = json["translation"].numbers({0, 0, 0});
  const std::vector<double> rotation = json["rotation"].numbers({0, 0, 0, 1});
  const std::vector<double> scale = json["scale"].numbers({1, 1, 1});
  const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
  if (glm::length(quaternion) > 0.0)
    place.rotation = glm::normalize(quaternion);
  else
    json["rotation"].refuse("has no length");
  place.translation = {translation[0], translation[1], translation[2]};
  place.scale = {scale[0], scale[1], scale[2]};
  return place;
}

Node parseNode(const JsonReader& json) {
  return {.place = parsePlace(json),
          .mesh = json["mesh"].index(),
          .children = indicesOf(json["children"]),
          .name = printable(json["name"].text("")),
          .camera = json["camera"].index(),
          .light = json["extensions"]["KHR_lights_punctual"]["light"].index(),
          .skin = json["skin"].index(),
          .weights = floatsOf(json["weights"])};
}

FileSkin parseSkin(const JsonReader& json) {
  return {.inverse_bind_matrices = json["inverseBindMatrices"].index(), .joints = indicesOf(json["joints"].required())};
}

std::string parseVariant(const JsonReader& json) { return printable(json["name"].required().text("")); }

std::vector<int> parseScene(const JsonReader& json) { return indicesOf(json["nodes"]); }

/// Reads the lists of a document, and asks for the memory of each before it is taken.
class PartReader {
 public:
  /// tree     bytes of the parsed JSON. What the parts have of lists and texts of their own takes no more than that,
  ///          since each element and member of it is larger than what becomes of it
  explicit PartReader(std::uint64_t tree) : tree_(tree), document_(tree) {}

  template <typename Part>
  void read(const JsonReader& array, Part (*parse)(const JsonReader&), std::vector<Part>& parts) {
    const JsonReader::Elements elements = array.elements();
    document_ += elements.size() * sizeof(Part);
    if (memory_) memory_ = checkMemory(tree_ + document_);
    if (!memory_) return;
    parts.reserve(elements.size());
    for (const JsonReader& element : elements) parts.push_back(parse(element));
  }

  /// Bytes of all that was read.
  std::uint64_t bytes() const { return document_; }

  /// errors   too_large
  const Result<void>& memory() const { return memory_; }

 private:
  std::uint64_t tree_;
  std::uint64_t document_;
  Result<void> memory_;
};

Result<void> checkVersion(const JsonReader& root) {
  const std::string version = root["asset"].required()["version"].required().text("");
  if (!version.empty() && (!version.starts_with("2.") || root["asset"]["minVersion"].text("2.0") > "2.0"))
    return fail(ErrorCode::unsupported, "asset.version is '" + excerpt(version) + "'; only glTF 2.0 is read");
  return {};
}

}  // namespace

Result<Document> parseDocument(std::string_view text, MemoryBudget& budget) {
  MemoryShare share(budget);
  const JsonMemory needed = jsonMemory(text);
  MIRRORBALL_TRY_VOID(checkMemory(needed.tree + needed.parsing));
  nlohmann::json parsed;
  try {
    parsed = nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::parse_error& error) {
    return fail(ErrorCode::bad_file,
                "is no valid JSON at byte " + std::to_string(error.byte) + " of it; the file is damaged or not glTF");
  } catch (const nlohmann::json::exception&) {
    return fail(ErrorCode::bad_file, "its JSON holds a number out of range");
  }
  JsonProblem problem;
  const JsonReader root(&parsed, "", problem);
  MIRRORBALL_TRY_VOID(checkVersion(root));
  MIRRORBALL_TRY(unread, unreadExtensions(root));

  PartReader parts(needed.tree);
  Document document;
  document.unread_extensions = std::move(unread);
  parts.read(root["accessors"], parseAccessor, document.accessors);
  parts.read(root["bufferViews"], parseBufferView, document.buffer_views);
  parts.read(root["buffers"], parseBuffer, document.buffers);
  markFallbacks(document);
  parts.read(root["images"], parseImage, document.images);
  parts.read(root["samplers"], parseSampler, document.samplers);
  parts.read(root["textures"], parseTexture, document.textures);
  parts.read(root["materials"], parseMaterial, document.materials);
  parts.read(root["meshes"], parseMesh, document.meshes);
  parts.read(root["cameras"], parseCamera, document.cameras);
  parts.read(root["extensions"]["KHR_lights_punctual"]["lights"], parseLight, document.lights);
  parts.read(root["extensions"]["KHR_materials_variants"]["variants"], parseVariant, document.variants);
  parts.read(root["nodes"], parseNode, document.nodes);
  parts.read(root["skins"], parseSkin, document.skins);
  parts.read(root["animations"], parseAnimation, document.animations);
  parts.read(root["scenes"], parseScene, document.scenes);
  document.scene = root["scene"].index();
  MIRRORBALL_TRY_VOID(parts.memory());
  if (problem.any()) return fail(ErrorCode::bad_file, problem.message);
  MIRRORBALL_TRY_VOID(share.keep(parts.bytes()));
  return document;
}

}  // namespace mirrorball::gltf
