#include "mirrorball/scene/load_model.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/builtin_shapes.h"
#include "mirrorball/scene/gltf.h"
#include "mirrorball/scene/obj.h"
#include "mirrorball/scene/ply.h"
#include "mirrorball/scene/showcase.h"
#include "mirrorball/scene/stl.h"
#include "mirrorball/scene/teapot.h"

namespace mirrorball {
namespace {

constexpr std::string_view kExtensions = ".glb .gltf .obj .ply .stl";
// Beyond it squares of distances overflow in a shader's floats.
constexpr float kLargestRadius = 1e15f;

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
    BuiltinModel{"sphere", [] { return sceneOf(sphereMesh()); }},
    BuiltinModel{"torus", [] { return sceneOf(torusMesh()); }},
    BuiltinModel{"knot", [] { return sceneOf(knotMesh()); }},
    // The spout is open: one sees its inside.
    BuiltinModel{"teapot", [] { return sceneOf(teapotMesh(), doubleSided()); }},
    BuiltinModel{"plane", [] { return sceneOf(planeMesh(), doubleSided()); }},
    BuiltinModel{"cube", [] { return sceneOf(cubeMesh()); }},
    BuiltinModel{"showcase", showcaseScene},
};

constexpr auto kBuiltinNames = [] {
  std::array<std::string_view, kBuiltins.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kBuiltins[i].name;
  return names;
}();

/// The loader for a file name's extension.
Result<Scene> (*loaderFor(const std::filesystem::path& path))(const std::filesystem::path&) {
  const std::string extension = extensionOf(path);
  if (extension == "glb" || extension == "gltf") return loadGltf;
  if (extension == "obj") return loadObj;
  if (extension == "ply") return loadPly;
  if (extension == "stl") return loadStl;
  return nullptr;
}

/// Finite coordinates and transforms may still multiply to what no renderer can hold.
Result<void> checkExtent(const Scene& scene, const std::string& name) {
  const BoundingSphere bounds = boundingSphere(scene);
  const float reach = glm::length(bounds.center) + bounds.radius;
  if (reach <= kLargestRadius) return {};
  return fail(ErrorCode::bad_file, name + ": reaches " + formatNumber(reach) +
                                       " units from the origin, more than can be drawn; scale the model down");
}

}  // namespace

std::span<const std::string_view> builtinModelNames() { return kBuiltinNames; }

Result<Scene> loadModel(const std::string& name_or_path) {
  for (const BuiltinModel& builtin : kBuiltins)
    if (name_or_path == builtin.name) return builtin.make();

  if (const auto load = loaderFor(name_or_path)) {
    MIRRORBALL_TRY(scene, load(name_or_path));
    MIRRORBALL_TRY_VOID(checkExtent(scene, name_or_path));
    return scene;
  }
  std::error_code status;
  if (std::filesystem::exists(name_or_path, status))
    return fail(ErrorCode::unsupported,
                name_or_path + ": is no model that can be read (" + std::string(kExtensions) + ")");
  std::string message = unknownName("model", name_or_path, builtinModelNames()).message;
  return fail(ErrorCode::not_found, message + ", nor is there such a file (" + std::string(kExtensions) + ")");
}

}  // namespace mirrorball
