#include "cli/lights_text.h"

#include <algorithm>

#include "cli/formatted.h"
#include "cli/json_values.h"
#include "mirrorball/base/text.h"
#include "mirrorball/output/lamps/lamp_json.h"

namespace mirrorball::cli {
namespace {

constexpr const char* kHeading =
    "     share  direction to it      size     illuminance     irradiance (red green blue)\n";

std::string lampRow(std::size_t number, const MapLamp& lamp) {
  const glm::vec3 d = lamp.direction;
  return formatted("%2zu  %5.1f %%  %6.3f %6.3f %6.3f  %5.2f deg  ", number, 100.0 * double(lamp.share), double(d.x),
                   double(d.y), double(d.z), double(glm::degrees(lamp.angular_size_rad))) +
         formatted("%s%-11s  ", lamp.is_clipped ? ">= " : "   ", shortText(double(lamp.illuminance())).c_str()) +
         shortText(lamp.irradiance) + "\n";
}

std::string lampTable(std::span<const MapLamp> lamps) {
  std::string text = kHeading;
  for (std::size_t i = 0; i < lamps.size(); ++i) text += lampRow(i + 1, lamps[i]);
  return text;
}

/// "3 lamps with 41 % of the light".
std::string summary(std::span<const MapLamp> lamps) {
  double share = 0.0;
  for (const MapLamp& lamp : lamps) share += double(lamp.share);
  return counted(lamps.size(), "lamp") + " with " + formatted("%.3g", 100.0 * share) + " % of the light";
}

std::string percentText(float share) { return formatted("%.2g %%", 100.0 * double(share)); }

/// What a lamp of one direction changes.
std::string errorLines(const std::vector<LampError>& errors) {
  std::string text;
  for (std::size_t i = 0; i < errors.size(); ++i)
    text += formatted("%2zu  lights no surface by more than ", i + 1) + percentText(errors[i].irradiance) +
            " otherwise as a disc of its size, " + percentText(errors[i].irradiance_of_point) +
            " from one direction; a sphere of roughness " + shortText(double(LampError::kRoughness)) + " by " +
            percentText(errors[i].rough_sphere) + " of its peak\n";
  return text;
}

bool isClippedAny(std::span<const MapLamp> lamps) {
  return std::any_of(lamps.begin(), lamps.end(), [](const MapLamp& lamp) { return lamp.is_clipped; });
}

}  // namespace

std::string textOf(const FoundLights& found) {
  std::string text = printable(found.name) + ": ";
  if (found.lamps.empty() && found.taken.empty())
    return text + "no lamp outshines the rest with " + shortText(100.0 * double(found.min_share)) +
           " % of the light or more\n";
  if (found.is_split && found.taken.empty()) text += "no lamp was taken out, as none is small; ";
  if (!found.taken.empty())
    text += "taken out: " + summary(found.taken) + "\n" + lampTable(found.taken) + errorLines(found.errors);
  if (found.scale) text += "scaled by " + shortText(double(*found.scale)) + ", before: ";
  if (!found.lamps.empty())
    text += (found.is_split ? "in the map: " : "") + summary(found.lamps) + "\n" + lampTable(found.lamps);
  if (isClippedAny(found.lamps) || isClippedAny(found.taken))
    text += ">= its brightest texels are all alike, as where a camera or a format clips: it is at least so much\n";
  return text;
}

std::string jsonOf(const FoundLights& found) {
  Json json{{"file", found.name}};
  json.update(lampJson(found.is_split ? found.taken : found.lamps));
  if (found.scale) json["scale"] = numberOf(double(*found.scale));
  if (found.is_split) {
    for (std::size_t i = 0; i < found.errors.size(); ++i)
      json["lights"][i]["error"] = {{"irradiance", numberOf(double(found.errors[i].irradiance))},
                                    {"irradiance_of_point", numberOf(double(found.errors[i].irradiance_of_point))},
                                    {"rough_sphere", numberOf(double(found.errors[i].rough_sphere))}};
    json["kept"] = lampJson(found.lamps)["lights"];
  }
  return printedJson(json);
}

}  // namespace mirrorball::cli
