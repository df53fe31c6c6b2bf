#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/json_reader.h"
#include "mirrorball/scene/gltf/output_json.h"
#include "mirrorball/scene/model_light.h"

namespace mirrorball::gltf {

/// A light as a file has it, of whose factors its colour is the product.
struct FileLight : ModelLight {
  glm::vec3 tint{1.0f};
  float intensity = 1.0f;
};

/// A light of KHR_lights_punctual, still at the origin and along −Z; its name may be empty.
///
/// returns  nothing for a type that the extension has not
std::optional<FileLight> parseLight(const JsonReader& json);

/// A light's JSON, without its place.
OutputJson jsonOf(const ModelLight& light);

/// A node's matrix that brings −Z to the way a light goes, and the origin to its place.
glm::mat4 worldFromNode(const ModelLight& light);

}  // namespace mirrorball::gltf
