#include <array>
#include <string>
#include <vector>

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
  if (!loaded.layers.empty()) json["layer"] = loaded.layer;
  for (const PictureLayer& layer : loaded.layers)
    json["layers"].push_back({{"name", layer.name}, {"channels", layer.channels}});
  json["projection"] = nullptr;
  if (loaded.recognition) {
    const MapForm& form = loaded.recognition->form;
    json["projection"] = std::string(nameOf(form.projection));
    json["form"] = textOf(form);
    json["told_by"] = loaded.recognition->told_by;
    json["size"] = arrayOf(loaded.file_size);
  }
  json["covered"] = numberOf(double(map.covered));
  if (const auto& window = loaded.window)
    json["window"] = {{"corner", arrayOf(window->corner)},
                      {"size", arrayOf(window->size)},
                      {"whole", arrayOf(window->whole)},
                      {"source", window->source}};
  json["bad_texels"]["count"] = loaded.bad_texels.count;
  if (loaded.bad_texels.count > 0) json["bad_texels"]["first"] = arrayOf(loaded.bad_texels.first);
  json["min"] = arrayOf(map.statistics.min);
  json["max"] = arrayOf(map.statistics.max);
  json["mean"] = arrayOf(map.statistics.mean);
  json["brightest"] = {{"radiance", arrayOf(map.statistics.brightest)},
                       {"direction", arrayOf(map.statistics.brightest_direction)}};
  if (map.harmonics)
    for (const glm::vec3& row : *map.harmonics) json["filament_harmonics"].push_back(arrayOf(row));
  if (map.north) {
    const auto& [heading, axes, column, columns] = *map.north;
    json["north"] = {{"direction", arrayOf(axes.north)},
                     {"up", arrayOf(axes.up)},
                     {"column", numberOf(double(column))},
                     {"columns", columns},
                     {"heading", numberOf(heading.heading_deg)},
                     {"pitch", numberOf(heading.pitch_deg)},
                     {"roll", numberOf(heading.roll_deg)},
                     {"is_magnetic", heading.is_magnetic},
                     {"source", heading.source}};
  }
  if (map.direction) json["direction"] = jsonOfDirection(*map.direction);
}

/// An array of what is said of each; empty where there is none.
template <typename Thing>
Json arrayOfEach(const std::vector<Thing>& things, Json (*one)(const Thing&)) {
  Json array = Json::array();
  for (const Thing& thing : things) array.push_back(one(thing));
  return array;
}

Json jsonOfCamera(const ModelCamera& camera) {
  Json json{{"name", camera.name}, {"type", camera.orthographic ? "orthographic" : "perspective"}};
  if (camera.orthographic)
    json["height"] = numberOf(double(camera.height));
  else
    json["fov_deg"] = numberOf(double(glm::degrees(camera.fov_rad)));
  return json;
}

Json jsonOfLight(const ModelLight& light) {
  constexpr std::array<const char*, 4> kTypes{"phong", "point", "spot", "directional"};  // by formula::Lamp's kinds
  return {{"name", light.name},
          {"type", kTypes[static_cast<std::size_t>(light.kind)]},
          {light.kind == formula::kLampDirectional ? "lux" : "candela", arrayOf(light.color)}};
}

Json jsonOfAnimation(const Animation& animation) {
  return {{"name", animation.name}, {"seconds", numberOf(double(animation.length_s))}};
}

Json jsonOfMaterial(const MaterialFacts& facts) {
  Json json{{"name", facts.name}, {"parameters", Json::object()}, {"maps", Json::object()}};
  for (const auto& [name, value] : facts.parameters) json["parameters"][std::string(name)] = value;
  for (const MaterialMapFact& map : facts.maps)
    json["maps"][std::string(map.name)] = {{"size", {map.size.x, map.size.y}}, {"floats", map.has_floats}};
  return json;
}

void add(const ModelInfo& model, Json& json) {
  const Scene& scene = model.scene;
  const BoundingSphere bounds = boundingSphere(scene);
  json["kind"] = "model";
  json["format"] = model.format;
  json["triangles"] = triangleCount(scene);
  json["center"] = arrayOf(bounds.center);
  if (scene.origin != glm::dvec3(0.0)) {
    const glm::dvec3 center = bounds.inFile(bounds.center);
    json["center"] = {center.x, center.y, center.z};
  }
  json["origin"] = {scene.origin.x, scene.origin.y, scene.origin.z};
  json["radius"] = numberOf(double(bounds.radius));
  json["materials"] =
      arrayOfEach<Material>(scene.materials, [](const Material& material) -> Json { return material.name; });
  json["variants"] = scene.variants;
  json["cameras"] = arrayOfEach<ModelCamera>(scene.cameras, jsonOfCamera);
  json["lights"] = arrayOfEach<ModelLight>(scene.lights, jsonOfLight);
  json["animations"] = arrayOfEach<Animation>(scene.rig.animations, jsonOfAnimation);
  json["material_facts"] = Json::array();
  for (const MaterialFacts& facts : model.materials) json["material_facts"].push_back(jsonOfMaterial(facts));
  json["notes"] = scene.warnings;
  for (const std::string& mistake : likelyMistakes(scene)) json["notes"].push_back(mistake);
}

void add(const FoundBrdfTable& table, Json& json) {
  json["kind"] = "brdf_table";
  json["format"] = table.format;
  json["size"] = {table.table.width(), table.table.height()};
  json["distribution"] = table.facts.distribution;
  json["axes"] = table.facts.axes;
  json["channels"] = table.facts.channels;
}

void add(const FoundLobeRows& rows, Json& json) {
  json["kind"] = "lobe_rows";
  json["format"] = rows.format;
  json["size"] = {rows.size.x, rows.size.y};
  json["lobes"] = rows.lobes;
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
