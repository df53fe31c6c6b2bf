#include <string>

#include "cli/json_values.h"
#include "cli/map_info.h"

namespace mirrorball::cli {
namespace {

Json jsonOfDirection(const DirectionInfo& direction) {
  Json json;
  json["given"] = arrayOf(direction.given);
  json["unit"] = arrayOf(direction.unit);
  json["radiance"] = arrayOf(direction.radiance);
  for (const DirectionPlace& place : direction.places) {
    Json& projection = json["places"][std::string(nameOf(place.projection))];
    projection["size"] = arrayOf(place.size);
    projection["covered"] = place.place.has_value();
    if (!place.place) continue;
    projection["image"] = place.place->face;
    projection["uv"] = {numberOf(double(place.place->uv.x)), numberOf(double(place.place->uv.y))};
    projection["texel"] = arrayOf(place.texel);
  }
  return json;
}

void add(const MapInfo& map, Json& json) {
  const LoadedEnvironment& loaded = map.loaded;
  json["kind"] = "map";
  json["format"] = loaded.format;
  json["colour"] = loaded.color;
  json["projection"] = nullptr;
  if (loaded.recognition) {
    const MapForm& form = loaded.recognition->form;
    json["projection"] = std::string(nameOf(form.projection));
    json["form"] = textOf(form);
    json["told_by"] = loaded.recognition->told_by;
    json["size"] = arrayOf(loaded.file_size);
  }
  json["covered"] = numberOf(double(map.covered));
  json["bad_texels"]["count"] = loaded.bad_texels.count;
  if (loaded.bad_texels.count > 0) json["bad_texels"]["first"] = arrayOf(loaded.bad_texels.first);
  json["min"] = arrayOf(map.statistics.min);
  json["max"] = arrayOf(map.statistics.max);
  json["mean"] = arrayOf(map.statistics.mean);
  json["brightest"] = {{"radiance", arrayOf(map.statistics.brightest)},
                       {"direction", arrayOf(map.statistics.brightest_direction)}};
  if (map.harmonics)
    for (const glm::vec3& row : *map.harmonics) json["filament_harmonics"].push_back(arrayOf(row));
  if (map.direction) json["direction"] = jsonOfDirection(*map.direction);
}

void add(const FoundBrdfTable& table, Json& json) {
  json["kind"] = "brdf_table";
  json["format"] = table.format;
  json["size"] = {table.table.width(), table.table.height()};
  json["distribution"] = table.facts.distribution;
  json["axes"] = table.facts.axes;
  json["channels"] = table.facts.channels;
}

void add(const Error& error, Json& json) { json["error"] = error.message; }

}  // namespace

std::string jsonOf(std::span<const InputInfo> inputs) {
  Json all = Json::array();
  for (const InputInfo& input : inputs) {
    Json json;
    json["file"] = input.name;
    std::visit([&](const auto& what) { add(what, json); }, input.what);
    all.push_back(std::move(json));
  }
  return printedJson(inputs.size() == 1 ? all.front() : all);
}

}  // namespace mirrorball::cli
