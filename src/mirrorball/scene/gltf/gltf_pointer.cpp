#include "mirrorball/scene/gltf/gltf_pointer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/gltf/gltf_file.h"

// KHR_animation_pointer; its pointers are those of RFC 6901.

namespace mirrorball::gltf {
namespace {

bool isNumber(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char each) { return each >= '0' && each <= '9'; });
}

/// A word of a list that stands for one of an enumeration, and how many numbers it has.
template <typename Of>
struct Word {
  std::string_view word;
  Of of;
  std::size_t components = 1;
};

template <typename Words>
auto wordNamed(const Words& words, std::string_view name) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& each) { return each.word == name; });
  return found == words.end() ? nullptr : &*found;
}

constexpr std::array kOfNodes{
    Word<NodeTarget::Of>{"translation", NodeTarget::Of::translation, 3},
    Word<NodeTarget::Of>{"rotation", NodeTarget::Of::rotation, 4},
    Word<NodeTarget::Of>{"scale", NodeTarget::Of::scale, 3},
    Word<NodeTarget::Of>{"weights", NodeTarget::Of::weights, 0},
};

Pointed ofNode(const SceneOfFile& all, const ArrayStep& step) {
  const auto* word = wordNamed(kOfNodes, step.rest);
  if (word == nullptr) return {};
  Pointed pointed{.is_read = true, .targets = {}, .components = word->components};
  const int node = all.place_of_node[std::size_t(step.index)];
  if (node < 0) return pointed;
  if (word->of == NodeTarget::Of::weights) {
    pointed.components = all.scene.rig.nodes[std::size_t(node)].weights.size();
    if (pointed.components == 0) return pointed;  // its mesh has no targets, or is not read
  }
  pointed.targets.push_back(NodeTarget{node, word->of});
  return pointed;
}

constexpr std::array kOfTextures{
    Word<TextureTarget::Of>{"offset", TextureTarget::Of::offset, 2},
    Word<TextureTarget::Of>{"scale", TextureTarget::Of::scale, 2},
    Word<TextureTarget::Of>{"rotation", TextureTarget::Of::rotation, 1},
};

/// The place of a texture: "normalTexture.extensions.KHR_texture_transform.offset".
Pointed ofTexture(int material, std::string_view path) {
  constexpr std::string_view kTransform = ".extensions.KHR_texture_transform.";
  const std::size_t at = path.find(kTransform);
  if (at == std::string_view::npos) return {};
  const auto* word = wordNamed(kOfTextures, path.substr(at + kTransform.size()));
  if (word == nullptr) return {};
  Pointed pointed{.is_read = false, .targets = {}, .components = word->components};
  for (const MaterialMap& map : materialMaps()) {
    if (map.gltf != path.substr(0, at)) continue;
    pointed.is_read = true;
    if (material >= 0) pointed.targets.push_back(TextureTarget{material, map.slot, word->of});
  }
  return pointed;
}

constexpr std::string_view kEmissiveStrength = "extensions.KHR_materials_emissive_strength.emissiveStrength";

Pointed ofMaterial(const SceneOfFile& all, const ArrayStep& step) {
  const int material = all.materials[std::size_t(step.index)];
  const FileMaterial& source = all.document.materials[std::size_t(step.index)];
  const auto emission = [&](bool is_strength) {
    Pointed pointed{.is_read = true, .targets = {}, .components = is_strength ? 1u : 3u};
    if (material >= 0)
      pointed.targets.push_back(LightTarget{LightTarget::Of::emission, material, is_strength, source.emissive_factor,
                                            source.emissive_strength});
    return pointed;
  };
  if (step.rest == kEmissiveStrength) return emission(true);
  for (const MaterialParameter& parameter : materialParameters()) {
    if (parameter.gltf.empty() || parameter.gltf != step.rest) continue;
    if (parameter.text.name == "emission") return emission(false);
    Pointed pointed{.is_read = true, .targets = {}, .components = gltfNumbers(parameter)};
    if (material < 0) return pointed;
    // What begins to transmit is a sheet where it has no thickness.
    if (parameter.text.name == "transmission" && source.is_sheet)
      all.scene.materials[std::size_t(material)].thin_walled = true;
    pointed.targets.push_back(ParameterTarget{material, &parameter});
    return pointed;
  }
  return ofTexture(material, step.rest);
}

constexpr std::array kOfCameras{
    Word<LensTarget::Of>{"perspective.yfov", LensTarget::Of::fov},
    Word<LensTarget::Of>{"perspective.aspectRatio", LensTarget::Of::aspect},
    Word<LensTarget::Of>{"perspective.znear", LensTarget::Of::nearest},
    Word<LensTarget::Of>{"orthographic.xmag", LensTarget::Of::half_width},
    Word<LensTarget::Of>{"orthographic.ymag", LensTarget::Of::half_height},
    Word<LensTarget::Of>{"orthographic.znear", LensTarget::Of::nearest},
};

Pointed ofCamera(const SceneOfFile& all, const ArrayStep& step) {
  const auto* word = wordNamed(kOfCameras, step.rest);
  if (word == nullptr) return {};
  Pointed pointed{.is_read = true, .targets = {}, .components = 1};
  const bool is_orthographic = word->word.starts_with("orthographic");
  for (const int camera : all.cameras[std::size_t(step.index)])
    if (all.scene.cameras[std::size_t(camera)].orthographic == is_orthographic)
      pointed.targets.push_back(LensTarget{camera, word->of});
  return pointed;
}

constexpr std::array kOfLamps{
    Word<LampTarget::Of>{"range", LampTarget::Of::range},
    Word<LampTarget::Of>{"spot.innerConeAngle", LampTarget::Of::inner_angle},
    Word<LampTarget::Of>{"spot.outerConeAngle", LampTarget::Of::outer_angle},
};

Pointed ofLamp(const SceneOfFile& all, const ArrayStep& step) {
  const bool is_strength = step.rest == "intensity";
  const auto* word = wordNamed(kOfLamps, step.rest);
  if (word == nullptr && !is_strength && step.rest != "color") return {};
  Pointed pointed{.is_read = true, .targets = {}, .components = word == nullptr && !is_strength ? 3u : 1u};
  for (const int light : all.lights[std::size_t(step.index)]) {
    const FileLight& source = *all.document.lights[std::size_t(step.index)];
    if (word != nullptr)
      pointed.targets.push_back(LampTarget{light, word->of});
    else
      pointed.targets.push_back(LightTarget{LightTarget::Of::lamp, light, is_strength, source.tint, source.intensity});
  }
  return pointed;
}

}  // namespace

std::optional<ArrayStep> stepInto(std::string_view array, std::string_view pointer) {
  if (!pointer.starts_with(array)) return std::nullopt;
  pointer.remove_prefix(array.size());
  const std::size_t end = std::min(pointer.find('/'), pointer.size());
  if (!isNumber(pointer.substr(0, end)) || end == pointer.size()) return std::nullopt;
  const double index = parseNumber(pointer.substr(0, end)).value_or(1e300);
  ArrayStep step{static_cast<int>(std::min(index, double(std::numeric_limits<int>::max()))),
                 std::string(pointer.substr(end + 1))};
  std::replace(step.rest.begin(), step.rest.end(), '/', '.');
  return step;
}

Result<Pointed> pointedAt(const SceneOfFile& all, const std::string& pointer, const std::string& key) {
  struct Kind {
    const char* array;
    const char* thing;
    std::size_t count;
    Pointed (*find)(const SceneOfFile&, const ArrayStep&);
  };
  const std::array kinds{
      Kind{"/nodes/", "node", all.document.nodes.size(), ofNode},
      Kind{"/materials/", "material", all.document.materials.size(), ofMaterial},
      Kind{"/cameras/", "camera", all.document.cameras.size(), ofCamera},
      Kind{"/extensions/KHR_lights_punctual/lights/", "light", all.document.lights.size(), ofLamp},
  };
  for (const Kind& kind : kinds) {
    const std::optional<ArrayStep> step = stepInto(kind.array, pointer);
    if (!step) continue;
    if (std::size_t(step->index) < kind.count) return kind.find(all, *step);
    return fail(ErrorCode::bad_file, key + " leads to " + kind.thing + " " + std::to_string(step->index) + ", but " +
                                         thereAre(kind.count, kind.thing));
  }
  return Pointed{};
}

std::string kindOfPointer(const std::string& pointer) {
  std::vector<std::string> parts = split(pointer, '/');
  for (std::string& part : parts)
    if (isNumber(part)) part = "N";
  return excerpt(join(std::span<const std::string>(parts), "/"));
}

}  // namespace mirrorball::gltf
