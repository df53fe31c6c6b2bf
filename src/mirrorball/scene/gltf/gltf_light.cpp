#include "mirrorball/scene/gltf/gltf_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "formula/constants.h"
#include "formula/tangent.h"
#include "mirrorball/base/text.h"

namespace mirrorball::gltf {
namespace {

/// By their kinds in formula/lamp.glsl; Phong's lights are not glTF's.
constexpr std::array<std::string_view, 4> kTypes{"", "point", "spot", "directional"};

}  // namespace

std::optional<FileLight> parseLight(const JsonReader& json) {
  FileLight light;
  const std::string type = json["type"].required().text("");
  const auto kind = std::find(kTypes.begin() + 1, kTypes.end(), type);
  if (kind == kTypes.end()) return std::nullopt;
  light.kind = static_cast<int>(kind - kTypes.begin());
  light.name = printable(json["name"].text(""));
  const double intensity = json["intensity"].number(1.0);
  const std::vector<double> color = json["color"].numbers({1.0, 1.0, 1.0});
  light.intensity = static_cast<float>(intensity);
  for (int channel = 0; channel < 3; ++channel) {
    light.tint[channel] = static_cast<float>(color[std::size_t(channel)]);
    light.color[channel] =
        static_cast<float>(std::clamp(intensity * color[std::size_t(channel)], 0.0, double(ModelLight::kBrightest)));
  }
  light.range = static_cast<float>(std::clamp(json["range"].number(0.0), 0.0, 1e15));
  if (light.kind != formula::kLampSpot) return light;
  const JsonReader spot = json["spot"];
  const double outer = std::clamp(spot["outerConeAngle"].number(double(formula::kPi) / 4.0), 0.0, double(formula::kPi));
  const double inner = std::clamp(spot["innerConeAngle"].number(0.0), 0.0, outer);
  light.cosine_outer = static_cast<float>(std::cos(outer));
  light.cosine_inner = static_cast<float>(std::cos(inner));
  return light;
}

OutputJson jsonOf(const ModelLight& light) {
  const float brightest = std::max({light.color.x, light.color.y, light.color.z});
  const glm::vec3 color = brightest > 0.0f ? light.color / brightest : glm::vec3(0.0f);
  OutputJson json{{"type", kTypes[static_cast<std::size_t>(light.kind)]},
                  {"intensity", brightest},
                  {"color", std::vector<float>{color.x, color.y, color.z}}};
  if (!light.name.empty()) json["name"] = light.name;
  if (light.range > 0.0f) json["range"] = light.range;
  if (light.kind == formula::kLampSpot)
    json["spot"] = {{"innerConeAngle", std::acos(light.cosine_inner)},
                    {"outerConeAngle", std::acos(light.cosine_outer)}};
  return json;
}

glm::mat4 worldFromNode(const ModelLight& light) {
  const glm::vec3 back = -light.direction;
  const glm::vec3 right = formula::anyTangent(back);
  return {glm::vec4(right, 0.0f), glm::vec4(glm::cross(back, right), 0.0f), glm::vec4(back, 0.0f),
          glm::vec4(light.position, 1.0f)};
}

}  // namespace mirrorball::gltf
