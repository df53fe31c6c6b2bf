#include "mirrorball/scene/animation/target_values.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "formula/constants.h"

namespace mirrorball {
namespace {

template <typename Part>
Part* partAt(std::vector<Part>& parts, int index) {
  return index >= 0 && std::size_t(index) < parts.size() ? &parts[std::size_t(index)] : nullptr;
}

glm::dvec3 vectorOf(std::span<const double> value) { return {value[0], value[1], value[2]}; }

float bounded(double number, double minimum, double maximum) {
  return static_cast<float>(std::clamp(number, minimum, maximum));
}

/// Splines go beyond their keys, and may go beyond floats.
float floatOf(double number) { return bounded(number, -1e30, 1e30); }

}  // namespace

void TargetValues::set(const AnimationTarget& target, std::span<const double> value) {
  std::visit([&](const auto& kind) { set(kind, value); }, target);
}

void TargetValues::set(const NodeTarget& target, std::span<const double> value) {
  RigNode* const node = partAt(nodes_, target.node);
  if (node == nullptr) return;
  switch (target.of) {
    case NodeTarget::Of::translation:
      node->place.translation = vectorOf(value);
      break;
    case NodeTarget::Of::rotation:
      node->place.rotation = glm::dquat(value[3], value[0], value[1], value[2]);
      break;
    case NodeTarget::Of::scale:
      node->place.scale = vectorOf(value);
      break;
    case NodeTarget::Of::weights:
      for (std::size_t i = 0; i < std::min(node->weights.size(), value.size()); ++i)
        node->weights[i] = floatOf(value[i]);
      break;
  }
}

void TargetValues::set(const ParameterTarget& target, std::span<const double> value) {
  if (Material* material = partAt(scene_.materials, target.material))
    setGltfNumbers(*target.parameter, value, *material);
}

void TargetValues::set(const TextureTarget& target, std::span<const double> value) {
  Material* const material = partAt(scene_.materials, target.material);
  if (material == nullptr) return;
  TextureSlot& slot = material->*target.slot;
  if (target.of == TextureTarget::Of::rotation)
    slot.rotation_rad = floatOf(value[0]);
  else
    (target.of == TextureTarget::Of::offset ? slot.offset : slot.scale) = {floatOf(value[0]), floatOf(value[1])};
}

void TargetValues::set(const LightTarget& target, std::span<const double> value) {
  Light& light = lights_.try_emplace({target.of, target.index}, Light{target.color, target.strength}).first->second;
  if (target.is_strength)
    light.strength = floatOf(value[0]);
  else
    light.color = {floatOf(value[0]), floatOf(value[1]), floatOf(value[2])};
}

void TargetValues::set(const LampTarget& target, std::span<const double> value) {
  ModelLight* const light = partAt(scene_.lights, target.light);
  if (light == nullptr) return;
  const float cosine = static_cast<float>(std::cos(std::clamp(value[0], 0.0, double(formula::kPi))));
  switch (target.of) {
    case LampTarget::Of::range:
      light->range = bounded(value[0], 0.0, 1e15);
      break;
    case LampTarget::Of::inner_angle:
      light->cosine_inner = cosine;
      break;
    case LampTarget::Of::outer_angle:
      light->cosine_outer = cosine;
      break;
  }
}

void TargetValues::set(const LensTarget& target, std::span<const double> value) {
  ModelCamera* const camera = partAt(scene_.cameras, target.camera);
  if (camera == nullptr) return;
  // Sizes of which another one is divided.
  const auto size = [&] { return 2.0f * bounded(std::abs(value[0]), 1e-15, 1e15); };
  switch (target.of) {
    case LensTarget::Of::fov:
      camera->fov_rad = bounded(value[0], 1e-3, double(formula::kPi) - 1e-3);
      break;
    case LensTarget::Of::aspect:
      camera->aspect = bounded(value[0], 0.0, 1e6);
      break;
    case LensTarget::Of::half_width:
      camera->aspect = size() / camera->height;
      break;
    case LensTarget::Of::half_height:
      camera->aspect *= camera->height / size();
      camera->height = size();
      break;
    case LensTarget::Of::nearest:
      camera->nearest = bounded(value[0], 0.0, 1e15);
      break;
  }
}

void TargetValues::finish() {
  for (const auto& [of, light] : lights_) {
    const glm::vec3 color = light.color * light.strength;
    if (of.first == LightTarget::Of::emission) {
      if (Material* material = partAt(scene_.materials, of.second))
        material->emission = glm::clamp(color, 0.0f, kBrightestEmission);
    } else if (ModelLight* lamp = partAt(scene_.lights, of.second)) {
      lamp->color = glm::clamp(color, 0.0f, ModelLight::kBrightest);
    }
  }
  for (ModelLight& light : scene_.lights) light.cosine_inner = std::max(light.cosine_inner, light.cosine_outer);
}

}  // namespace mirrorball
