#include "mirrorball/output/lamps/lamp_json.h"

#include <nlohmann/json.hpp>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

/// By its shortest text.
Json numberOf(float value) { return parseNumber(formatNumber(double(value))).value_or(0.0); }

Json arrayOf(glm::vec3 v) { return {numberOf(v.x), numberOf(v.y), numberOf(v.z)}; }

Json jsonOf(const MapLamp& lamp) {
  Json json;
  json["direction"] = arrayOf(lamp.direction);
  json["irradiance"] = arrayOf(lamp.irradiance);
  json["illuminance"] = numberOf(lamp.illuminance());
  json["is_lower_bound"] = lamp.is_clipped;
  json["angular_size"] = numberOf(glm::degrees(lamp.angular_size_rad));
  json["share"] = numberOf(lamp.share);
  json["outline"] = Json::array();
  for (const glm::vec3& corner : lamp.outline) json["outline"].push_back(arrayOf(corner));
  return json;
}

}  // namespace

Json lampJson(std::span<const MapLamp> lamps) {
  Json json;
  json["conventions"] = {
      {"axes", "right-handed, +Y up, +Z in the middle of a panorama"},
      {"direction", "from the viewer towards the light"},
      {"irradiance", "red, green, blue (linear, Rec.709) of a surface that faces the lamp: radiance times sr"},
      {"illuminance", "luminance of the irradiance (Rec.709): lx where the map's radiance is in cd/m2"},
      {"angular_size", "degrees, the diameter of a disc"},
      {"share", "of the luminance of all light, 0 to 1"}};
  json["lights"] = Json::array();
  for (const MapLamp& lamp : lamps) json["lights"].push_back(jsonOf(lamp));
  return json;
}

}  // namespace mirrorball
