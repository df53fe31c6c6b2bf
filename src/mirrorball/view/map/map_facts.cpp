#include "mirrorball/view/map/map_facts.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include "formula/color.h"
#include "formula/projection.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/image/small_float.h"
#include "mirrorball/view/map/false_colors.h"

namespace mirrorball {
namespace {

/// Numbers by one printf format, with blanks between them.
std::string numbersText(const char* format, std::initializer_list<float> numbers) {
  std::string text;
  for (const float number : numbers) {
    std::array<char, 48> written{};
    std::snprintf(written.data(), written.size(), format, double(number));
    text += (text.empty() ? "" : " ") + std::string(written.data());
  }
  return text;
}

/// Five digits, which is what a reader of light wants.
std::string lightText(glm::vec3 light) { return numbersText("%.5g", {light.x, light.y, light.z}); }
std::string numberText(float number) { return numbersText("%.5g", {number}); }
std::string placeText(glm::vec2 place) { return numbersText("%.4f", {place.x, place.y}); }

std::string texelText(glm::ivec2 texel, glm::ivec2 size) {
  return std::to_string(texel.x) + ", " + std::to_string(texel.y) + " of " + sizeText(size);
}

glm::ivec2 texelAt(glm::vec2 uv, glm::ivec2 size) { return glm::min(glm::ivec2(uv * glm::vec2(size)), size - 1); }

/// Which of the images of a map it is: "face -X", "front"; nothing where there is one.
std::string imageText(Projection projection, int face) {
  if (faceCount(projection) == 6) return "face " + std::string(cubeFaceName(face));
  if (faceCount(projection) == 2) return face == 0 ? "front" : "back";
  return "";
}

void addDirection(glm::vec3 d, std::vector<MapFact>& facts) {
  facts.push_back({"direction", numbersText("%.4f", {d.x, d.y, d.z})});
  facts.push_back({"longitude", numbersText("%.2f", {glm::degrees(std::atan2(d.x, d.z))}), "degrees"});
  facts.push_back(
      {"latitude", numbersText("%.2f", {glm::degrees(std::asin(glm::clamp(d.y, -1.0f, 1.0f)))}), "degrees"});
}

/// The lecture's steps.
void addCubeSteps(const Environment& light, glm::vec3 d, std::vector<MapFact>& facts) {
  const MapPosition position = positionOf(Projection::cube, d);
  const glm::vec3 projected = formula::cubeProjected(position.face, d);
  const glm::ivec2 size(light.naturalSize(Projection::cube));
  constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  const auto axis = static_cast<std::size_t>(position.face / 2);
  facts.push_back(
      {"longest component", std::string(kAxes[axis]) + " = " + numbersText("%.4f", {d[position.face / 2]})});
  facts.push_back({"face", std::string(cubeFaceName(position.face))});
  facts.push_back({"sc, tc, ma", numbersText("%.4f", {projected.x, projected.y, projected.z})});
  facts.push_back({"s, t", placeText(position.uv)});
  facts.push_back({"cube's texel", texelText(texelAt(position.uv, size), size)});
}

void addHalves(glm::vec3 light, std::vector<MapFact>& facts) {
  std::string bits;
  glm::vec3 values;
  for (int channel = 0; channel < 3; ++channel) {
    const std::uint16_t half = halfFromFloat(light[channel]);
    std::array<char, 8> written{};
    std::snprintf(written.data(), written.size(), "0x%04x", unsigned(half));
    bits += (channel == 0 ? "" : " ") + std::string(written.data());
    values[channel] = floatFromHalf(half);
  }
  facts.push_back({"16-bit", bits});
  facts.push_back({"16-bit value", lightText(values)});
}

void addLight(glm::vec3 light, std::vector<MapFact>& facts) {
  facts.push_back({"radiance", lightText(light)});
  addHalves(light, facts);
  facts.push_back({"luminance", numberText(formula::luminance(light))});
  facts.push_back({"stops above 1", numberText(stopsOf(light, 0.0f))});
  facts.push_back({"bad", std::string(nameOf(faultOf(light)))});
}

/// The map's own texel, or what a function has there.
void addOwnTexel(const Environment& light, glm::vec3 d, std::vector<MapFact>& facts) {
  const EnvironmentMap* map = light.map();
  if (!map) return addLight(light.radiance(d), facts);
  if (!covers(map->projection(), d)) return facts.push_back({"map's texel", "not in the map"});
  const MapPosition position = positionOf(map->projection(), d);
  const glm::ivec2 texel = texelAt(position.uv, map->extent());
  const std::string image = imageText(map->projection(), position.face);
  facts.push_back({"map's texel", (image.empty() ? "" : image + ", ") + texelText(texel, map->extent())});
  facts.push_back({"texel's solid angle", numberText(texelSolidAngle(map->projection(), map->extent(), texel)), "sr"});
  addLight(rgbAt(map->face(position.face), texel.x, texel.y), facts);
}

std::string lampText(const MapLamp& lamp) {
  return "towards " + numbersText("%.3f", {lamp.direction.x, lamp.direction.y, lamp.direction.z}) + ", " +
         numberText(lamp.solidAngle_sr()) + " sr, radiance " + lightText(lamp.radiance()) + ", " +
         numbersText("%.2g", {100.0f * lamp.share}) + " % of the light";
}

}  // namespace

std::vector<MapFact> mapFactsAt(const PreparedMap& map, const MapViewSettings& settings, const MapCanvas& canvas,
                                glm::vec2 pixel) {
  const MapLayout layout = mapLayout(settings, canvas);
  const auto direction = directionAtPixel(layout, settings, pixel);
  if (!direction) return {};
  std::vector<MapFact> facts{{"pixel", numbersText("%.0f", {std::floor(pixel.x), std::floor(pixel.y)})}};
  if (const MapPane* pane = paneAt(layout, pixel)) {
    const std::string image = imageText(pane->projection, pane->face);
    facts.push_back({"projection", textOf(pane->projection) + (image.empty() ? "" : ", " + image)});
    const glm::vec2 uv = (pixel - glm::vec2(pane->place.corner)) / glm::vec2(pane->place.extent);
    facts.push_back({"u, v", placeText(uv)});
  }
  addDirection(*direction, facts);
  addCubeSteps(*map.given, *direction, facts);
  addOwnTexel(*map.given, *direction, facts);
  if (settings.light != MapLight::map) {
    const glm::vec3 shown = shownRadiance(map, settings, *direction);
    facts.push_back({"shown radiance", lightText(shown)});
    facts.push_back({"shown stops above 1", numberText(stopsOf(shown, 0.0f))});
  }
  return facts;
}

std::vector<MapFact> mapFacts(const PreparedMap& map, const MapViewSettings& settings) {
  std::vector<MapFact> facts;
  if (const EnvironmentMap* images = map.given->map()) {
    const glm::ivec2 size = images->extent();
    facts.push_back({"map", textOf(images->projection()) + ", " + sizeText(size)});
  } else {
    facts.push_back({"map", "a function of the direction"});
  }
  const FaultyTexels& faulty = map.faulty;
  facts.push_back({"bad texels", std::to_string(faulty.count())});
  const auto addFaults = [&](TexelFault fault, std::size_t count) {
    if (count > 0) facts.push_back({nameOf(fault), std::to_string(count), count == 1 ? "texel" : "texels"});
  };
  addFaults(TexelFault::not_finite, faulty.not_finite);
  addFaults(TexelFault::negative, faulty.negative);
  addFaults(TexelFault::too_bright, faulty.too_bright);
  for (const MapLamp& lamp : map.lamps) facts.push_back({"lamp", lampText(lamp)});
  for (int band = 0; band <= settings.degree; ++band)
    for (int order = -band; order <= band; ++order) {
      const auto index = static_cast<std::size_t>(band * (band + 1) + order);
      facts.push_back(
          {"harmonic", std::to_string(band) + ", " + std::to_string(order) + ": " + lightText(map.harmonics[index])});
    }
  return facts;
}

}  // namespace mirrorball
