#include <cmath>
#include <cstddef>
#include <string>

#include "cli/formatted.h"
#include "cli/map_info.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/cube/cube_layout.h"

namespace mirrorball::cli {
namespace {

/// Of a unit direction, in which what is next to nothing is rounding.
std::string directionText(glm::vec3 d) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(d[axis]) < 1e-6f) d[axis] = 0.0f;
  return shortText(d);
}

/// "  format       KTX2": a fact with its name.
std::string line(const char* name, const std::string& fact) { return formatted("  %-12s ", name) + fact + "\n"; }

/// " at (16, 8) of 64x32 (its display window)"
std::string windowPlaceText(const PictureWindow& window) {
  return " at (" + std::to_string(window.corner.x) + ", " + std::to_string(window.corner.y) + ") of " +
         sizeText(window.whole) + " (" + window.source + ")";
}

/// Which directions a map covers that does not cover all.
std::string coveredText(const LoadedEnvironment& loaded) {
  const Projection projection = loaded.recognition->form.projection;
  if (projection == Projection::ball) return "none of the cone that the ball hides behind it, around -Z";
  if (projection != Projection::equirect) return "none of the half with z < 0";
  const PictureWindow& window = *loaded.window;
  const glm::dvec2 degrees = glm::dvec2(window.size) / glm::dvec2(window.whole) * glm::dvec2(360.0, 180.0);
  return shortText(degrees.x) + " x " + shortText(degrees.y) + " degrees," + windowPlaceText(window);
}

/// "AO (R G B), rgba (R G B): read"
std::string layersText(const LoadedEnvironment& loaded) {
  std::vector<std::string> texts;
  for (const PictureLayer& layer : loaded.layers)
    texts.push_back(printable(layer.name) + " (" + printable(layer.channels) + ")" +
                    (layer.name == loaded.layer ? ": read" : ""));
  return join(texts);
}

std::string fileText(const MapInfo& map) {
  const LoadedEnvironment& loaded = map.loaded;
  std::string text = line("format", loaded.format) + line("colour", loaded.color);
  if (!loaded.layers.empty()) text += line("layers", layersText(loaded));
  if (loaded.recognition) {
    text += line("size", sizeText(loaded.file_size));
    text +=
        line("projection", textOf(loaded.recognition->form) + " (recognised by " + loaded.recognition->told_by + ")");
    if (loaded.recognition->is_guess)
      text += line("mirroring", "OpenGL's table or as seen from inside: mirrored writing in a picture tells which");
    if (map.covered < 1.0f)
      text += line("covers", formatted("%.5g %% of the sphere: ", 100.0 * double(map.covered)) + coveredText(loaded));
    else if (loaded.window)
      text += line("window", sizeText(loaded.window->size) + windowPlaceText(*loaded.window));
  } else {
    text += line("projection", "none: a function of the direction");
  }
  return text + line("bad texels", loaded.bad_texels.count > 0 ? textOf(loaded.bad_texels) : "none");
}

std::string statisticsText(const RadianceStatistics& statistics) {
  return line("range", shortText(statistics.min) + " to " + shortText(statistics.max)) +
         line("mean", shortText(statistics.mean) + " over the sphere") +
         line("brightest",
              shortText(statistics.brightest) + " from direction " + directionText(statistics.brightest_direction));
}

/// What the two numbers are, after the image that they lie in: "face -X, (s, t)", "front, (u, v)", "(u, v)".
std::string coordinateText(Projection projection, int face) {
  switch (faceCount(projection)) {
    case 6:
      return "face " + std::string(cubeFaceName(face)) + ", (s, t)";
    case 2:
      return face == 0 ? "front, (u, v)" : "back, (u, v)";
    default:
      return projection == Projection::sphere ? "(s, t)" : "(u, v)";
  }
}

std::string placeText(const DirectionPlace& place) {
  if (!place.place) return "not in the map";
  // OpenGL's t of a sphere map grows upwards, a cube's and an image's v downwards.
  const glm::vec2 uv = place.place->uv;
  const float second = place.projection == Projection::sphere ? 1.0f - uv.y : uv.y;
  return coordinateText(place.projection, place.place->face) +
         formatted(" = (%.4f, %.4f), texel (%d, %d) of ", double(uv.x), double(second), place.texel.x, place.texel.y) +
         sizeText(place.size);
}

std::string directionText(const DirectionInfo& direction) {
  std::string text = "direction " + shortText(direction.given) + ", unit " + directionText(direction.unit) + "\n";
  for (const DirectionPlace& place : direction.places)
    text += line(std::string(nameOf(place.projection)).c_str(), placeText(place));
  return text + line("radiance", shortText(direction.radiance));
}

/// "-0.5 0 0.86603, column 1195 of 2048 (GPano:PoseHeadingDegrees 330)"
std::string northText(const NorthInfo& north) {
  const CompassHeading& heading = north.heading;
  std::string text = directionText(north.axes.north) + ", column " + formatted("%.0f", double(north.column)) + " of " +
                     std::to_string(north.columns) + " (" + heading.source + " " + shortText(heading.heading_deg);
  if (heading.is_magnetic) text += ", magnetic";
  if (heading.pitch_deg != 0.0) text += ", pitch " + shortText(heading.pitch_deg);
  if (heading.roll_deg != 0.0) text += ", roll " + shortText(heading.roll_deg);
  return text + ")";
}

std::string textOf(const MapInfo& map) {
  const std::string north = map.north ? line("north", northText(*map.north)) : "";
  if (map.direction) return directionText(*map.direction) + (map.is_north_alone ? north : "");
  if (map.is_north_alone) return north;
  std::string text = fileText(map) + statisticsText(map.statistics) + north;
  if (map.harmonics)
    text += line("harmonics", "Filament's, of irradiance / pi: " + shortText((*map.harmonics)[0]) + " in the mean");
  return text;
}

std::string nameOf(const Material& material) { return material.name.empty() ? "(unnamed)" : printable(material.name); }

/// "Key (point, 54 cd)" for each.
template <typename Thing>
std::vector<std::string> described(const std::vector<Thing>& things, std::string (*what)(const Thing&)) {
  std::vector<std::string> texts;
  for (const Thing& thing : things)
    texts.push_back((thing.name.empty() ? "unnamed" : thing.name) + " (" + what(thing) + ")");
  return texts;
}

std::string cameraText(const ModelCamera& camera) {
  return camera.orthographic ? "orthographic, height " + shortText(double(camera.height))
                             : "perspective, " + shortText(glm::degrees(double(camera.fov_rad))) + " degrees";
}

std::string lightText(const ModelLight& light) {
  if (light.kind == formula::kLampDirectional) return "directional, " + shortText(light.color) + " lx";
  return (light.kind == formula::kLampSpot ? "spot, " : "point, ") + shortText(light.color) + " cd";
}

std::string animationText(const Animation& animation) { return shortText(double(animation.length_s)) + " s"; }

/// "metallic 0.25; base_color_map 1024x1024, normal_map 512x512 (floats)"
std::string materialText(const MaterialFacts& facts) {
  std::vector<std::string> parameters, maps;
  for (const auto& [name, value] : facts.parameters) parameters.push_back(std::string(name) + " " + value);
  for (const MaterialMapFact& map : facts.maps)
    maps.push_back(std::string(map.name) + " " + sizeText(map.size) + (map.has_floats ? " (floats)" : ""));
  return join(parameters) + (parameters.empty() || maps.empty() ? "" : "; ") + join(maps);
}

/// A line for each material that has something to say, of the first ones.
std::string materialsText(const std::vector<MaterialFacts>& materials) {
  constexpr std::size_t kMostLines = 20;
  std::string text;
  std::size_t lines = 0;
  for (const MaterialFacts& facts : materials) {
    if (facts.parameters.empty() && facts.maps.empty()) continue;
    if (lines++ < kMostLines)
      text += line("material", (facts.name.empty() ? "(unnamed)" : printable(facts.name)) + ": " + materialText(facts));
  }
  if (lines > kMostLines) text += line("material", "and " + std::to_string(lines - kMostLines) + " more (--json)");
  return text;
}

/// In the file's coordinates: far from their origin, with the digits that it takes there.
std::string centerText(const BoundingSphere& bounds) {
  if (bounds.origin == glm::dvec3(0.0)) return shortText(bounds.center);
  const glm::dvec3 center = bounds.inFile(bounds.center);
  return formatted("%.12g %.12g %.12g", center.x, center.y, center.z);
}

std::string textOf(const ModelInfo& model) {
  const Scene& scene = model.scene;
  const BoundingSphere bounds = boundingSphere(scene);
  std::vector<std::string> materials;
  for (const Material& material : scene.materials) materials.push_back(nameOf(material));
  std::string text =
      line("format", model.format) + line("triangles", std::to_string(triangleCount(scene))) +
      line("extent", "a ball about " + centerText(bounds) + " of radius " + shortText(double(bounds.radius))) +
      line("size", shortText(boundingBox(scene).high - boundingBox(scene).low) + " along x, y and z");
  const auto list = [&](const char* name, const std::vector<std::string>& things) {
    if (!things.empty()) text += line(name, join(things));
  };
  list("materials", materials);
  text += materialsText(model.materials);
  list("variants", scene.variants);
  list("cameras", described(scene.cameras, cameraText));
  list("lights", described(scene.lights, lightText));
  list("animations", described(scene.rig.animations, animationText));
  for (const std::string& warning : scene.warnings) text += line("note", warning);
  for (const std::string& mistake : likelyMistakes(scene)) text += line("note", mistake);
  return text;
}

std::string textOf(const FoundBrdfTable& table) {
  return line("format", table.format) + line("size", sizeText({table.table.width(), table.table.height()})) +
         line("what", std::string("BRDF table of bake, no map of light: scale and bias of f0") +
                          (table.facts.channels == 3 ? ", and the mean for multiple scattering" : "")) +
         line("microfacets", table.facts.distribution) +
         line("axes", table.facts.axes + ": n.v to the right, perceptual roughness downwards");
}

std::string textOf(const FoundLobeRows& rows) {
  return line("format", rows.format) + line("size", sizeText(rows.size)) +
         line("what", "rows of " + std::to_string(rows.lobes) +
                          " lobes of bake, no map of light: where to look a rough reflection up at any angle") +
         line("axes", "lobes beside each other, in each sqrt(n.v) to the right, perceptual roughness downwards");
}

std::string textOf(const Error& error) { return line("error", error.message); }

}  // namespace

std::string textOf(const InputInfo& info) {
  const auto* const map = std::get_if<MapInfo>(&info.what);
  const std::string heading = map && (map->direction || map->is_north_alone) ? "" : printable(info.name) + "\n";
  return heading + std::visit([](const auto& what) { return textOf(what); }, info.what);
}

}  // namespace mirrorball::cli
