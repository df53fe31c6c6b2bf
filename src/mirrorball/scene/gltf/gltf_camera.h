#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "mirrorball/base/json_reader.h"
#include "mirrorball/scene/camera/model_camera.h"
#include "mirrorball/scene/gltf/output_json.h"

namespace mirrorball::gltf {

/// A camera of a file, still without a place; its name may be empty.
///
/// returns  nothing where its numbers show nothing, such as a field of view of 0
std::optional<ModelCamera> parseCamera(const JsonReader& json);

/// A camera's JSON, without its place.
///
/// farthest   depth up to which it sees; without it a perspective one has no end
OutputJson jsonOf(const ModelCamera& camera, std::optional<float> farthest);

}  // namespace mirrorball::gltf
