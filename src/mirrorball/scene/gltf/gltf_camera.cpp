#include "mirrorball/scene/gltf/gltf_camera.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "formula/constants.h"
#include "mirrorball/base/text.h"

// glTF 2.0, section 3.10.

namespace mirrorball::gltf {

std::optional<ModelCamera> parseCamera(const JsonReader& json) {
  ModelCamera camera;
  camera.name = printable(json["name"].text(""));
  const std::string type = json["type"].required().text("");
  camera.orthographic = type == "orthographic";
  if (type != "orthographic" && type != "perspective") return std::nullopt;
  const JsonReader lens = json[type.c_str()].required();
  const auto number = [&](const char* key, double otherwise) {
    return static_cast<float>(lens[key].number(otherwise));
  };
  camera.nearest = std::max(number("znear", 0.0), 0.0f);
  if (camera.orthographic) {
    const float width = 2.0f * std::abs(number("xmag", 0.0));
    camera.height = 2.0f * std::abs(number("ymag", 0.0));
    camera.aspect = width / camera.height;
    const bool shows_something = width > 0.0f && camera.height > 0.0f && camera.aspect > 0.0f;
    return shows_something && std::isfinite(camera.aspect) ? std::optional(camera) : std::nullopt;
  }
  camera.fov_rad = number("yfov", 0.0);
  camera.aspect = std::max(number("aspectRatio", 0.0), 0.0f);
  // Within what floats of a projection can hold.
  const bool shows_something = camera.fov_rad > 1e-4f && camera.fov_rad < formula::kPi - 1e-4f;
  return shows_something ? std::optional(camera) : std::nullopt;
}

OutputJson jsonOf(const ModelCamera& camera, std::optional<float> farthest) {
  OutputJson lens;
  if (camera.orthographic) {
    lens["xmag"] = camera.height * camera.aspect / 2.0f;
    lens["ymag"] = camera.height / 2.0f;
  } else {
    if (camera.aspect > 0.0f) lens["aspectRatio"] = camera.aspect;
    lens["yfov"] = camera.fov_rad;
  }
  lens["znear"] = camera.nearest;
  if (farthest || camera.orthographic)
    lens["zfar"] = std::max(farthest.value_or(0.0f), camera.nearest * 1.001f + 1e-6f);
  const char* const type = camera.orthographic ? "orthographic" : "perspective";
  return {{"type", type}, {type, std::move(lens)}};
}

}  // namespace mirrorball::gltf
