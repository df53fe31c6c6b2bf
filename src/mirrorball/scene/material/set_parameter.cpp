#include "mirrorball/scene/material/set_parameter.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/scene/material/builtin_picture.h"
#include "mirrorball/scene/relief/slope_texture.h"

namespace mirrorball {
namespace {

/// A built-in picture by its name, or that of a file, which then counts as read.
Result<Image8> pictureOf(Scene& scene, const std::string& path) {
  const auto names = builtinPictureNames();
  if (std::ranges::find(names, path) != names.end()) return builtinPicture(path);
  MIRRORBALL_TRY(bytes, readRegularFile(path));
  MIRRORBALL_TRY(image, withName(path, decodeTexture(bytes)));
  scene.files.push_back(path);
  return image;
}

Result<void> setMap(Scene& scene, const MaterialMap& map, const std::string& path) {
  const std::string name(map.name);
  if (path.empty())
    return fail(ErrorCode::usage, "the material parameter " + name + " needs a picture: " + name + "=FILE");
  MIRRORBALL_TRY(image, pictureOf(scene, path));
  if (!scene.meshes.empty() && std::ranges::none_of(scene.meshes, hasTextureCoordinates))
    scene.warnings.push_back(name + ": the model has no texture coordinates; all of it shows one texel of " + path);
  scene.textures.push_back({.image = std::move(image), .srgb = map.srgb});
  for (Material& material : scene.materials)
    material.*map.slot = {.texture = static_cast<int>(scene.textures.size()) - 1};
  return {};
}

/// Whether the value of `height` is a picture and not a choice: names of files have a dot or a folder.
bool isFileOfHeights(const Scene& scene, std::string_view key, std::string_view value) {
  return (key == "height" || key == "bump") && !scene.materials.empty() &&
         value.find_first_of("./") != std::string_view::npos;
}

/// Brings heights into [0, 1], where some are not.
///
/// returns  whether some were not
bool stretchToUnit(Image& heights) {
  const auto [low, high] = std::ranges::minmax(heights.samples());
  if (low >= 0.0f && high <= 1.0f) return false;
  const float range = high > low ? high - low : 1.0f;
  for (float& height : heights.samples()) height = std::clamp((height - low) / range, 0.0f, 1.0f);
  return true;
}

Result<void> setHeights(Scene& scene, const std::string& path) {
  MIRRORBALL_TRY(bytes, readRegularFile(path));
  MIRRORBALL_TRY(numbers, withName(path, decodeNumbers(bytes)));
  PictureHeights of_picture = heightsOfPicture(numbers);
  MIRRORBALL_TRY_VOID(withName(path, checkHeights(of_picture.heights)));
  MIRRORBALL_TRY_VOID(withName(path, checkRange(of_picture.heights)));
  if (!of_picture.is_grey)
    scene.warnings.push_back("height: " + path + " is in colour; its red channel is taken for the heights");
  if (stretchToUnit(of_picture.heights))
    scene.warnings.push_back("height: " + path +
                             " has heights outside of 0 to 1; its lowest is taken as 0, its highest as 1");
  MIRRORBALL_TRY(texture, withName(path, heightTexture(std::move(of_picture.heights), MapEdges::tiled)));
  if (!scene.meshes.empty() && std::ranges::none_of(scene.meshes, hasTextureCoordinates))
    scene.warnings.push_back("height: the model has no texture coordinates; all of it has one height of " + path);
  scene.height_textures.push_back(std::move(texture));
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
  if (path.empty())
    return fail(ErrorCode::usage, "the material parameter derivative_map needs a picture: derivative_map=FILE");
  MIRRORBALL_TRY(bytes, readRegularFile(path));
  MIRRORBALL_TRY(numbers, withName(path, decodeNumbers(bytes)));
  MIRRORBALL_TRY(slopes, withName(path, slopesOfPicture(numbers, holdsCodes(bytes))));
  if (!scene.meshes.empty() && std::ranges::none_of(scene.meshes, hasTextureCoordinates))
    scene.warnings.push_back("derivative_map: the model has no texture coordinates, along which slopes are told");
  scene.slope_textures.push_back(std::move(slopes));
  scene.files.push_back(path);
  for (Material& material : scene.materials) material.slope_texture = static_cast<int>(scene.slope_textures.size()) - 1;
  return {};
}

}  // namespace

Result<void> setParameter(Scene& scene, std::string_view assignment) {
  const std::size_t equals = std::min(assignment.find('='), assignment.size());
  std::vector<std::string_view> names;
  for (const MaterialMap& map : materialMaps()) names.push_back(map.name);
  if (const auto index = indexOfName(assignment.substr(0, equals), names))
    return setMap(scene, materialMaps()[*index],
                  std::string(assignment.substr(std::min(equals + 1, assignment.size()))));
  const std::string_view value = assignment.substr(std::min(equals + 1, assignment.size()));
  if (isFileOfHeights(scene, assignment.substr(0, equals), value)) return setHeights(scene, std::string(value));
  if (indexOfName(assignment.substr(0, equals), kSlopesName) && value != "none")
    return setSlopes(scene, std::string(value));
  for (Material& material : scene.materials) MIRRORBALL_TRY_VOID(setParameter(material, assignment));
  return {};
}

}  // namespace mirrorball
