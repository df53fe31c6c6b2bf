#include "mirrorball/scene/load_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/base/unicode.h"
#include "mirrorball/codec/foreign_file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/scene/animation/pose.h"
#include "mirrorball/scene/closed_surface.h"
#include "mirrorball/scene/gltf/gltf.h"
#include "mirrorball/scene/material/texture_numbers.h"
#include "mirrorball/scene/mesh_file/obj.h"
#include "mirrorball/scene/mesh_file/ply.h"
#include "mirrorball/scene/mesh_file/stl.h"
#include "mirrorball/scene/mesh_file/stl_facets.h"
#include "mirrorball/scene/model_origin.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/scene/shapes/faceted.h"
#include "mirrorball/scene/shapes/interreflection.h"
#include "mirrorball/scene/shapes/material_grid.h"
#include "mirrorball/scene/shapes/showcase.h"
#include "mirrorball/scene/shapes/teapot.h"
#include "mirrorball/scene/shapes/tumbler.h"

namespace mirrorball {
namespace {

// Beyond them squares of distances overflow in a shader's floats, or are 0.
constexpr float kLargestRadius = 1e15f;
constexpr float kLeastRadius = 1e-15f;

Material doubleSided() {
  Material material;
  material.double_sided = true;
  return material;
}

struct BuiltinModel {
  std::string_view name;
  Scene (*make)();
};

constexpr std::array kBuiltins = {
    BuiltinModel{"none", [] { return Scene{}; }},
    BuiltinModel{"sphere", [] { return meshScene(sphereMesh()); }},
    BuiltinModel{"torus", [] { return meshScene(torusMesh()); }},
    BuiltinModel{"knot", [] { return meshScene(knotMesh()); }},
    // The spout is open: one sees its inside.
    BuiltinModel{"teapot", [] { return meshScene(teapotMesh(), doubleSided()); }},
    BuiltinModel{"plane", [] { return meshScene(planeMesh(), doubleSided()); }},
    BuiltinModel{"cube", [] { return meshScene(cubeMesh()); }},
    BuiltinModel{"brilliant", [] { return meshScene(brilliantMesh()); }},
    BuiltinModel{"prism", [] { return meshScene(prismMesh()); }},
    BuiltinModel{"tumbler", [] { return meshScene(tumblerMesh()); }},
    BuiltinModel{"tumbler-water", tumblerWaterScene},
    BuiltinModel{"spheres", [] { return spheresScene(); }},
    BuiltinModel{"bowl", bowlScene},
    BuiltinModel{"showcase", showcaseScene},
};

/// The names of those and of the grids of materials.
const std::vector<std::string_view>& builtinNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const BuiltinModel& builtin : kBuiltins) list.push_back(builtin.name);
    for (const MaterialGrid& grid : materialGrids()) list.push_back(grid.name);
    return list;
  }();
  return names;
}

Scene builtinScene(std::size_t index) {
  return index < kBuiltins.size() ? kBuiltins[index].make()
                                  : materialGridScene(materialGrids()[index - kBuiltins.size()]);
}

/// A kind of file.
struct ModelFormat {
  std::string_view extension;
  std::string_view name;                      ///< with its article
  bool (*isBegunBy)(std::string_view begin);  ///< by the first bytes, whatever the name says; nullptr: they do not tell
  Result<Scene> (*decode)(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                          const ModelLoadOptions& options);
};

/// Binary glTF of a version that there is: a text may begin with the word.
bool isBinaryGltf(std::string_view begin) {
  constexpr std::string_view kMagic = "glTF";
  if (!begin.starts_with(kMagic)) return false;
  const std::string_view version = begin.substr(kMagic.size(), 4);
  return version == std::string_view("\1\0\0\0", 4) || version == std::string_view("\2\0\0\0", 4);
}

/// The first line of a PLY is that word alone.
bool isPly(std::string_view begin) { return begin.starts_with("ply\n") || begin.starts_with("ply\r"); }

/// A format whose files name no others.
template <Result<Scene> (*decode)(std::span<const std::uint8_t>, const std::filesystem::path&)>
Result<Scene> withoutOptions(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                             const ModelLoadOptions&) {
  return decode(bytes, path);
}

constexpr std::array<ModelFormat, 5> kFormats{{{"glb", "a glTF", isBinaryGltf, decodeGltf},
                                               {"gltf", "a glTF", nullptr, decodeGltf},
                                               {"obj", "an OBJ", nullptr, decodeObj},
                                               {"ply", "a PLY", isPly, decodePly},
                                               {"stl", "an STL", nullptr, withoutOptions<decodeStl>}}};

/// The first bytes of a file: as many as tell what it is.
std::vector<std::uint8_t> firstBytes(const std::string& path) {
  std::vector<std::uint8_t> bytes(kForeignFileBytes);
  const auto file = FileReader::open(path);
  const auto count = file ? file->readAt(0, bytes) : Result<std::size_t>(0);
  bytes.resize(count ? *count : 0);
  return bytes;
}

const ModelFormat* formatOfName(const std::filesystem::path& path) {
  const std::string extension = extensionOf(path);
  for (const ModelFormat& format : kFormats)
    if (extension == format.extension) return &format;
  return nullptr;
}

const ModelFormat* formatBegunBy(std::span<const std::uint8_t> begin) {
  const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
  for (const ModelFormat& format : kFormats)
    if (format.isBegunBy != nullptr && format.isBegunBy(text)) return &format;
  return nullptr;
}

/// The format of a file by its first bytes where these tell it, whatever its name says; else by its name.
const ModelFormat* formatOf(const std::string& path, std::span<const std::uint8_t> begin) {
  const ModelFormat* format = formatBegunBy(begin);
  return format != nullptr ? format : formatOfName(path);
}

/// The names of the models in a folder, in the alphabet's order.
std::vector<std::string> modelsIn(const std::filesystem::path& folder) {
  std::vector<std::string> models;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status))
    if (formatOfName(entry.path()) != nullptr && entry.is_regular_file(status)) models.push_back(entry.path().string());
  std::sort(models.begin(), models.end());
  return models;
}

/// The error for a folder in a model's place. Who names one has unpacked a model into it.
tl::unexpected<Error> folderForModel(const std::string& folder) {
  constexpr std::size_t kMaxNamed = 4;
  std::vector<std::string> models = modelsIn(folder);
  if (models.empty())
    return fail(ErrorCode::unsupported, folder + ": is a folder without a model (" + modelExtensions() + ")");
  const bool is_one = models.size() == 1;
  if (models.size() > kMaxNamed) {
    models.resize(kMaxNamed);
    models.emplace_back("…");
  }
  return fail(ErrorCode::unsupported, folder + ": is a folder; name " +
                                          (is_one ? "the model in it: " : "one of the models in it: ") + join(models));
}

/// Whether any of its triangles covers anything.
bool hasArea(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) {
    const auto place = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      if (glm::cross(place(i + 1) - place(i), place(i + 2) - place(i)) != glm::dvec3(0.0)) return true;
    return false;
  });
}

/// Whether some one-sided mesh shows its inside alone.
bool someFaceInwards(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return !scene.materials[std::size_t(mesh.material)].double_sided && facesInwards(mesh);
  });
}

/// A model's error is about its file, and a model is not smaller in a smaller picture.
template <typename Value>
Result<Value> ofModel(const std::string& path, Result<Value> result) {
  if (!result && result.error().fix_hint == FixHint::raise_memory_or_shrink)
    result.error().fix_hint = FixHint::raise_memory;
  return withName(path, std::move(result));
}

/// The bytes of a model's file; of a text in UTF-16 those of the same in UTF-8.
Result<Bytes> readModelFile(const std::string& path, const ModelFormat& format, bool& is_utf16) {
  MIRRORBALL_TRY(bytes, readFile(path));
  if (bytes.empty()) return fail(ErrorCode::bad_file, path + ": is empty");
  // The free text with which a binary one begins may be in UTF-16 as well.
  const bool is_stl = format.decode == withoutOptions<decodeStl>;
  is_utf16 = isUtf16(bytes) && !(is_stl && hasStlSize(bytes));
  if (!is_utf16) return bytes;
  MIRRORBALL_TRY_VOID(ofModel(path, checkMemory(std::uint64_t{bytes.size()} + utf8Size(bytes))));
  Bytes text = utf8FromUtf16(bytes);
  is_utf16 = !is_stl || stlText(text).has_value();
  return is_utf16 ? std::move(text) : std::move(bytes);
}

}  // namespace

std::span<const std::string_view> builtinModelNames() { return builtinNames(); }

Result<void> checkExtent(const Scene& scene) {
  const BoundingSphere bounds = boundingSphere(scene);
  const float reach = glm::length(bounds.center) + bounds.radius;
  if (bounds.radius > 0.0f && bounds.radius < kLeastRadius)
    return fail(ErrorCode::bad_file, "has a radius of " + formatNumber(bounds.radius) +
                                         " units, less than can be drawn; scale the model up");
  if (reach <= kLargestRadius) return {};
  return fail(ErrorCode::bad_file, "reaches " + formatNumber(reach) +
                                       " units from the origin, more than can be drawn; scale the model down");
}

Result<Scene> atMoment(Scene scene, const AnimationChoice& choice) {
  if (!choice.name.empty()) {
    MIRRORBALL_TRY(animation, chosenAnimation(scene, choice));
    MIRRORBALL_TRY(moment, posed(std::move(scene), animation, double(choice.seconds.value_or(0.0f))));
    scene = std::move(moment);
  }
  MIRRORBALL_TRY_VOID(checkExtent(scene));
  addNodes(scene);
  return scene;
}

Result<Scene> loadModel(const std::string& name_or_path, const ModelLoadOptions& options) {
  if (const auto index = indexOfName(name_or_path, builtinNames()))
    return atMoment(builtinScene(*index), options.animation);
  if (isUrl(name_or_path)) return tl::unexpected<Error>(downloadsNothing(name_or_path));

  std::error_code status;
  if (std::filesystem::is_directory(name_or_path, status)) return folderForModel(name_or_path);
  const std::vector<std::uint8_t> begin = firstBytes(name_or_path);
  const bool is_picture = isImage(begin) || isImageSet(begin);
  if (!begin.empty() && !is_picture && !formatBegunBy(begin))
    // Also what bears a model's name, such as a server's page: it is not called a damaged one.
    if (std::optional<Error> foreign = foreignFileError(FileUse::model, begin, extensionOf(name_or_path)))
      return tl::unexpected<Error>(withName(name_or_path, std::move(*foreign)));
  if (const ModelFormat* format = formatOf(name_or_path, begin)) {
    bool is_utf16 = false;
    MIRRORBALL_TRY(bytes, readModelFile(name_or_path, *format, is_utf16));
    MIRRORBALL_TRY(decoded, ofModel(name_or_path, format->decode(bytes, name_or_path, options)));
    findNormalZeros(decoded, name_or_path);
    MIRRORBALL_TRY_VOID(ofModel(name_or_path, drawAboutMiddle(decoded)));
    MIRRORBALL_TRY(scene, withName(name_or_path, atMoment(std::move(decoded), options.animation)));
    if (is_utf16) scene.warnings.push_back(name_or_path + ": " + std::string(kIsUtf16));
    if (const ModelFormat* named = formatOfName(name_or_path); named != nullptr && named->decode != format->decode)
      scene.warnings.push_back(name_or_path + ": is " + std::string(format->name) + " by its first bytes, and read so");
    if (!hasArea(scene))
      scene.warnings.push_back(name_or_path + ": none of its triangles has an area; nothing is seen");
    else if (const auto remark = remarkOnOrigin(scene))
      scene.warnings.push_back(name_or_path + ": " + *remark);
    if (someFaceInwards(scene))
      scene.warnings.push_back(
          name_or_path +
          ": triangles of a closed surface face its inside, and that alone is seen; if that is not "
          "meant, turn its normals outwards in the program that it comes from");
    return scene;
  }
  if (is_picture)
    return fail(
        ErrorCode::unsupported,
        name_or_path + ": is a picture, no model; for the light in it try `mirrorball render -e " + name_or_path + "`");
  if (std::filesystem::exists(name_or_path, status))
    return fail(ErrorCode::unsupported, name_or_path + ": is no model that can be read (" + modelExtensions() + ")");
  std::string message = unknownName("model", name_or_path, builtinModelNames()).message;
  return fail(ErrorCode::not_found, message + ", nor is there such a file (" + modelExtensions() + ")");
}

std::string modelExtensions() {
  std::string extensions;
  for (const ModelFormat& format : kFormats)
    extensions += (extensions.empty() ? "." : " .") + std::string(format.extension);
  return extensions;
}

bool isModel(std::span<const std::uint8_t> begin) { return formatBegunBy(begin) != nullptr; }

std::optional<std::string_view> modelFormatOf(const std::string& path) {
  const std::vector<std::uint8_t> begin = firstBytes(path);
  const ModelFormat* format = begin.empty() ? nullptr : formatOf(path, begin);
  return format == nullptr ? std::nullopt : std::optional(format->name);
}

}  // namespace mirrorball
