#include "mirrorball/scene/material/set_parameter.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/material/builtin_picture.h"
#include "mirrorball/scene/material/texture_numbers.h"
#include "mirrorball/scene/relief/slope_texture.h"

namespace mirrorball {
namespace {

/// Reports what is odd about a picture's file.
void warnAbout(const std::vector<std::string>& oddities, const std::string& path, Scene& scene) {
  for (const std::string& oddity : oddities) scene.warnings.push_back(path + ": " + oddity);
}

/// A built-in picture by its name, or that of a file, which then counts as read.
Result<Texels> pictureOf(Scene& scene, const MaterialMap& map, const std::string& path) {
  const auto names = builtinPictureNames();
  if (contains(names, path)) return Texels(builtinPicture(path));
  MIRRORBALL_TRY(bytes, readImageFile(path));
  MIRRORBALL_TRY(read, withName(path, map.srgb ? decodeColorTexture(bytes) : decodeDataTexture(bytes)));
  warnAbout(read.oddities, path, scene);
  scene.files.push_back(path);
  return Result<Texels>(std::move(read.picture));
}

Result<void> checkGiven(const std::string& name, const std::string& path) {
  if (!path.empty()) return {};
  return fail(ErrorCode::usage, "the material parameter " + name + " needs a picture: " + name + "=FILE");
}

Result<void> setMap(Scene& scene, const MaterialMap& map, const std::string& path) {
  const std::string name(map.name);
  MIRRORBALL_TRY_VOID(checkGiven(name, path));
  MIRRORBALL_TRY(texels, pictureOf(scene, map, path));
  Texture texture{.srgb = map.srgb};
  MIRRORBALL_TRY(changes, withName(path, setTexels(std::move(texels), useOf(map), texture)));
  for (const std::string& change : changes) scene.warnings.push_back(name + ": " + path + " " + change);
  if (!scene.meshes.empty() && std::none_of(scene.meshes.begin(), scene.meshes.end(), hasTextureCoordinates))
    scene.warnings.push_back(name + ": the model has no texture coordinates; all of it shows one texel of " + path);
  scene.textures.push_back(std::move(texture));
  for (Material& material : scene.materials)
    material.*map.slot = {.texture = static_cast<int>(scene.textures.size()) - 1};
  if (map.holdsNormals()) findNormalZeros(scene, path, &map);
  return {};
}

/// Whether the value of `height` is a picture and not a choice: names of files have a dot or a folder.
bool isFileOfHeights(std::string_view key, std::string_view value) {
  return (key == "height" || key == "bump") && value.find_first_of("./") != std::string_view::npos;
}

/// Brings heights into [0, 1], where some are not.
///
/// returns  whether some were not
bool stretchToUnit(Image& heights) {
  const auto [least, most] = std::minmax_element(heights.samples().begin(), heights.samples().end());
  const float low = *least;
  const float high = *most;
  if (low >= 0.0f && high <= 1.0f) return false;
  const float range = high > low ? high - low : 1.0f;
  for (float& height : heights.samples()) height = std::clamp((height - low) / range, 0.0f, 1.0f);
  return true;
}

Result<PictureHeights> readHeights(const std::string& path, Scene& scene) {
  MIRRORBALL_TRY(bytes, readImageFile(path));
  MIRRORBALL_TRY(read, withName(path, decodeNumbers(bytes)));
  warnAbout(read.oddities, path, scene);
  PictureHeights of_picture = heightsOfPicture(std::move(read.picture));
  MIRRORBALL_TRY_VOID(withName(path, checkHeights(of_picture.heights)));
  MIRRORBALL_TRY_VOID(withName(path, checkRange(of_picture.heights)));
  return of_picture;
}

Result<void> setHeights(Scene& scene, const std::string& path) {
  MIRRORBALL_TRY(of_picture, readHeights(path, scene));
  if (!of_picture.is_grey)
    scene.warnings.push_back("height: " + path + " is in colour; its red channel is taken for the heights");
  if (stretchToUnit(of_picture.heights))
    scene.warnings.push_back("height: " + path +
                             " has heights outside of 0 to 1; its lowest is taken as 0, its highest as 1");
  if (!scene.meshes.empty() && std::none_of(scene.meshes.begin(), scene.meshes.end(), hasTextureCoordinates))
    scene.warnings.push_back("height: the model has no texture coordinates; all of it has one height of " + path);
  scene.height_textures.push_back(HeightTexture{.heights = std::move(of_picture.heights)});
  scene.files.push_back(path);
  const HeightSize own = ownSize(HeightKind::map);
  for (Material& material : scene.materials) {
    material.height = HeightKind::map;
    material.height_texture = static_cast<int>(scene.height_textures.size()) - 1;
    material.height_scale = own.scale;
    material.height_frequency = own.frequency;
  }
  return {};
}

constexpr std::array<std::string_view, 1> kSlopesName{"derivative_map"};

Result<void> setSlopes(Scene& scene, const std::string& path) {
  MIRRORBALL_TRY_VOID(checkGiven("derivative_map", path));
  MIRRORBALL_TRY(bytes, readImageFile(path));
  MIRRORBALL_TRY(read, withName(path, decodeNumbers(bytes)));
  warnAbout(read.oddities, path, scene);
  MIRRORBALL_TRY(slopes, withName(path, slopesOfPicture(read.picture, holdsCodes(bytes))));
  if (!scene.meshes.empty() && std::none_of(scene.meshes.begin(), scene.meshes.end(), hasTextureCoordinates))
    scene.warnings.push_back("derivative_map: the model has no texture coordinates, along which slopes are told");
  scene.slope_textures.push_back(std::move(slopes));
  scene.files.push_back(path);
  for (Material& material : scene.materials) material.slope_texture = static_cast<int>(scene.slope_textures.size()) - 1;
  return {};
}

/// What "key=value" says.
struct Assignment {
  enum class Kind { number, map, heights, slopes };
  Kind kind;
  std::string key;
  std::string value;
  const MaterialMap* map = nullptr;  ///< of Kind::map
};

Assignment assignmentOf(std::string_view written) {
  const std::size_t equals = std::min(written.find('='), written.size());
  Assignment made{Assignment::Kind::number, std::string(written.substr(0, equals)),
                  std::string(written.substr(std::min(equals + 1, written.size())))};
  std::vector<std::string_view> names;
  for (const MaterialMap& map : materialMaps()) names.push_back(map.name);
  if (const auto index = indexOfName(made.key, names)) {
    made.kind = Assignment::Kind::map;
    made.map = &materialMaps()[*index];
  } else if (isFileOfHeights(made.key, made.value)) {
    made.kind = Assignment::Kind::heights;
  } else if (indexOfName(made.key, kSlopesName) && made.value != "none") {
    made.kind = Assignment::Kind::slopes;
  }
  return made;
}

}  // namespace

Result<void> setParameter(Scene& scene, std::string_view assignment) {
  const Assignment parts = assignmentOf(assignment);
  switch (parts.kind) {
    case Assignment::Kind::map:
      return setMap(scene, *parts.map, parts.value);
    case Assignment::Kind::heights:
      return scene.materials.empty() ? Result<void>() : setHeights(scene, parts.value);
    case Assignment::Kind::slopes:
      return setSlopes(scene, parts.value);
    case Assignment::Kind::number:
      break;
  }
  for (Material& material : scene.materials) MIRRORBALL_TRY_VOID(setParameter(material, assignment));
  return {};
}

Result<void> checkParameter(std::string_view assignment) {
  const Assignment parts = assignmentOf(assignment);
  if (parts.kind == Assignment::Kind::number) {
    Material material;
    return setParameter(material, assignment);
  }
  const auto names = builtinPictureNames();
  if (parts.kind == Assignment::Kind::map && contains(names, parts.value)) return {};
  MIRRORBALL_TRY_VOID(checkGiven(parts.map ? std::string(parts.map->name) : parts.key, parts.value));
  MIRRORBALL_TRY(reader, FileReader::open(parts.value));
  return {};
}

}  // namespace mirrorball
