#include "mirrorball/scene/material/set_parameter.h"

#include <algorithm>
#include <string>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"

namespace mirrorball {
namespace {

Result<void> setMap(Scene& scene, const MaterialMap& map, const std::string& path) {
  const std::string name(map.name);
  if (path.empty())
    return fail(ErrorCode::usage, "the material parameter " + name + " needs a picture: " + name + "=FILE");
  MIRRORBALL_TRY(bytes, readRegularFile(path));
  MIRRORBALL_TRY(image, withName(path, decodeTexture(bytes)));
  if (!scene.meshes.empty() && std::ranges::none_of(scene.meshes, hasTextureCoordinates))
    scene.warnings.push_back(name + ": the model has no texture coordinates; all of it shows one texel of " + path);
  scene.textures.push_back({.image = std::move(image), .srgb = map.srgb});
  scene.files.push_back(path);
  for (Material& material : scene.materials)
    material.*map.slot = {.texture = static_cast<int>(scene.textures.size()) - 1};
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
  for (Material& material : scene.materials) MIRRORBALL_TRY_VOID(setParameter(material, assignment));
  return {};
}

}  // namespace mirrorball
