#include "mirrorball/output/lamps/lamp_gltf.h"

#include <string>

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "mirrorball/codec/glb_container.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/output/lamps/directional_light.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExtension = "KHR_lights_punctual";

Json lightJson(const DirectionalLight& light) {
  return {{"name", light.name},
          {"type", "directional"},
          {"color", {light.color.x, light.color.y, light.color.z}},
          {"intensity", light.intensity}};
}

/// A node whose +Z leads towards the lamp.
Json nodeJson(const DirectionalLight& light, std::size_t index) {
  const glm::quat turn = glm::quat_cast(centredOn(light.towards));
  return {{"name", light.name},
          {"rotation", {turn.x, turn.y, turn.z, turn.w}},
          {"extensions", {{kExtension, {{"light", index}}}}}};
}

Json documentOf(std::span<const MapLamp> lamps) {
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "mirrorball"}};
  json["extensionsUsed"] = {kExtension};
  json["scene"] = 0;
  json["scenes"] = Json::array({Json::object()});
  std::size_t index = 0;
  for (const DirectionalLight& light : directionalLights(lamps)) {
    json["extensions"][kExtension]["lights"].push_back(lightJson(light));
    json["nodes"].push_back(nodeJson(light, index));
    json["scenes"][0]["nodes"].push_back(index++);
  }
  if (index == 0) json.erase("extensionsUsed");
  return json;
}

}  // namespace

Result<Bytes> lampGlb(std::span<const MapLamp> lamps) { return glbFile(documentOf(lamps).dump(), {}); }

}  // namespace mirrorball
