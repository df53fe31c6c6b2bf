#include "mirrorball/scene/gltf/gltf_document.h"

#include <algorithm>
#include <iterator>
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
#include "mirrorball/scene/gltf/gltf_json_text.h"
#include "mirrorball/scene/gltf/gltf_light.h"
#include "mirrorball/scene/gltf/gltf_vertex_color.h"

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

Image parseImage(const JsonReader& json) { return {json["bufferView"].index(), parseUri(json["uri"])}; }

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

/// Some extensions name the picture itself, and its source beside the extension one for readers that do not know its
/// format. The last are of formats that are not read: they count where there is no other.
Texture parseTexture(const JsonReader& json) {
  const auto named = [&](const char* extension) { return json["extensions"][extension]["source"].index(); };
  Texture texture{.image = -1, .sampler = json["sampler"].index()};
  for (const int image : {named("EXT_texture_webp"), named("EXT_texture_avif"), json["source"].index(),
                          named("KHR_texture_basisu"), named("MSFT_texture_dds")})
    if (texture.image < 0) texture.image = image;
  return texture;
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

/// The numbers of a node's place. Where programs have NaN they write null, since JSON has no word for it.
///
/// has_nan  becomes true if one of them is
std::vector<double> placeNumbers(const JsonReader& array, std::vector<double> otherwise, bool& has_nan) {
  for (const JsonReader& number : array.elements())
    if (number.isNull()) return has_nan = true, otherwise;
  return array.numbers(std::move(otherwise));
}

/// Reads a node's matrix, or translation · rotation · scale.
void readPlace(const JsonReader& json, Node& node) {
  bool is_nowhere = false, is_not_turned = false;
  if (json["matrix"].exists()) {
    const std::vector<double> numbers = placeNumbers(json["matrix"], std::vector<double>(16, 0.0), is_nowhere);
    for (int i = 0; i < 16; ++i) node.place.matrix[i / 4][i % 4] = numbers[std::size_t(i)];  // column by column
    const glm::dmat4& matrix = node.place.matrix;
    const glm::dvec4 last_row(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3] - 1.0);
    node.is_affine = glm::length(last_row) < 1e-6;
    for (int column = 0; column < 4; ++column) node.place.matrix[column][3] = column == 3 ? 1.0 : 0.0;
    node.is_somewhere = !is_nowhere;
    return;
  }
  const std::vector<double> translation = placeNumbers(json["translation"], {0, 0, 0}, is_nowhere);
  const std::vector<double> rotation = placeNumbers(json["rotation"], {0, 0, 0, 1}, is_not_turned);
  const std::vector<double> scale = placeNumbers(json["scale"], {1, 1, 1}, is_nowhere);
  node.is_somewhere = !is_nowhere;
  const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
  node.has_rotation = !is_not_turned && glm::length(quaternion) > 0.0;
  if (node.has_rotation) node.place.rotation = glm::normalize(quaternion);
  node.place.translation = {translation[0], translation[1], translation[2]};
  node.place.scale = {scale[0], scale[1], scale[2]};
}

Node parseNode(const JsonReader& json) {
  Node node;
  readPlace(json, node);
  node.mesh = json["mesh"].index();
  node.children = indicesOf(json["children"]);
  node.name = printable(json["name"].text(""));
  node.camera = json["camera"].index();
  node.light = json["extensions"]["KHR_lights_punctual"]["light"].index();
  node.skin = json["skin"].index();
  node.weights = floatsOf(json["weights"]);
  return node;
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
  /// problem  of the reader whose lists are read
  PartReader(std::uint64_t tree, JsonProblem& problem, Remarks& remarks)
      : tree_(tree), document_(tree), problem_(problem), remarks_(remarks) {}

  template <typename Part>
  void read(const JsonReader& array, Part (*parse)(const JsonReader&), std::vector<Part>& parts) {
    const JsonReader::Elements elements = array.elements();
    document_ += elements.size() * sizeof(Part);
    if (memory_) memory_ = checkMemory(tree_ + document_);
    if (!memory_) return;
    parts.reserve(elements.size());
    for (const JsonReader& element : elements) {
      const JsonProblem of_all = std::exchange(problem_, {});
      parts.push_back(parse(element));
      if (problem_.any()) remarks_.leaveOut({ErrorCode::bad_file, problem_.message}, "value");
      problem_ = of_all;
    }
  }

  /// Bytes of all that was read.
  std::uint64_t bytes() const { return document_; }

  /// errors   too_large
  const Result<void>& memory() const { return memory_; }

 private:
  std::uint64_t tree_;
  std::uint64_t document_;
  JsonProblem& problem_;
  Remarks& remarks_;
  Result<void> memory_;
};

/// Whether the file is of a version that is read; one that has meshes and says none is taken for it.
Result<void> checkVersion(const JsonReader& root, Remarks& remarks) {
  const JsonReader version = root["asset"]["version"];
  if (!version.exists() && root["meshes"].isArray()) {
    remarks.tell("names no version of glTF; it is read as glTF 2.0");
    return {};
  }
  root["asset"].required();
  // As a number it is of programs whose words have no types.
  const std::string name = version.isNumber() ? formatNumber(version.number(0.0)) : version.required().text("");
  const bool is_second = name == "2" || name.starts_with("2.");
  if (name.empty() || (is_second && root["asset"]["minVersion"].text("2.0") <= "2.0")) return {};
  return fail(ErrorCode::unsupported, "asset.version is '" + excerpt(name) + "'; only glTF 2.0 is read" +
                                          (name.starts_with("1") ? ", which gltf-pipeline makes of glTF 1.0" : ""));
}

/// The two lowest sets of texture coordinates that a file's materials use.
TexCoordSets texCoordSets(std::span<const FileMaterial> materials) {
  std::set<int> used;
  for (const FileMaterial& material : materials)
    for (const MaterialMap& map : materialMaps())
      if (const TextureSlot& slot = material.material.*map.slot; slot.texture >= 0) used.insert(slot.uv_set);
  for (const int usual : {0, 1})
    if (used.size() < 2) used.insert(usual);
  return {*used.begin(), *std::next(used.begin())};
}

/// Parses a text that is not JSON as what it is once it is mended.
///
/// problem   what is wrong with it, the continuation of "NAME: "
/// needed    gets the memory that it takes
Result<nlohmann::json> parseMended(std::string_view text, const std::string& problem, JsonMemory& needed,
                                   Remarks& remarks) {
  MIRRORBALL_TRY_VOID(checkMemory(mostMended(text.size())));
  const auto failure = [&] { return fail(ErrorCode::bad_file, problem + "; the file is damaged or not glTF"); };
  const std::optional<MendedJson> mended = mendJson(text);
  if (!mended) return failure();
  needed = jsonMemory(mended->text);
  MIRRORBALL_TRY_VOID(checkMemory(needed.tree + needed.parsing + mended->text.size()));
  auto parsed = nlohmann::json::parse(mended->text, nullptr, /*allow_exceptions=*/false);
  if (parsed.is_discarded()) return failure();
  remarks.tell(problem + ": " + mended->how);
  return parsed;
}

/// Parses a text as JSON, and as what is JSON once it is mended.
///
/// needed   gets the memory that it takes
Result<nlohmann::json> parseJson(std::string_view text, JsonMemory& needed, Remarks& remarks) {
  needed = jsonMemory(text);
  MIRRORBALL_TRY_VOID(checkMemory(needed.tree + needed.parsing));
  std::string problem;
  try {
    return nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::parse_error& error) {
    problem = "is not valid JSON at byte " + std::to_string(error.byte) + " of it";
    if (error.byte > text.size()) problem += ", where it ends";
  } catch (const nlohmann::json::exception&) {
    problem = "its JSON holds a number out of range";
  }
  return parseMended(text, problem, needed, remarks);
}

}  // namespace

Result<Document> parseDocument(std::string_view text, MemoryBudget& budget, Remarks& remarks) {
  MemoryShare share(budget);
  JsonMemory needed;
  MIRRORBALL_TRY(parsed, parseJson(text, needed, remarks));
  JsonProblem problem;
  const JsonReader root(&parsed, "", problem);
  MIRRORBALL_TRY_VOID(checkVersion(root, remarks));

  PartReader parts(needed.tree, problem, remarks);
  Document document;
  document.unread_extensions = unreadExtensions(parsed, remarks);
  parts.read(root["accessors"], parseAccessor, document.accessors);
  parts.read(root["bufferViews"], parseBufferView, document.buffer_views);
  parts.read(root["buffers"], parseBuffer, document.buffers);
  markFallbacks(document);
  parts.read(root["images"], parseImage, document.images);
  parts.read(root["samplers"], parseSampler, document.samplers);
  parts.read(root["textures"], parseTexture, document.textures);
  parts.read(root["materials"], parseMaterial, document.materials);
  tellOfMiscounted(document.materials, remarks);
  document.tex_coord_sets = texCoordSets(document.materials);
  parts.read(root["meshes"], parseMesh, document.meshes);
  normalizeColors(document, remarks);
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
