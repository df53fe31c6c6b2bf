#include "mirrorball/output/baked/babylon_environment.h"

#include <span>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::uint8_t, 8> kEnvMagic{0x86, 0x16, 0x87, 0x96, 0xf6, 0xd6, 0x96, 0x36};
constexpr std::array<std::string_view, 9> kTermNames{"x", "y", "z", "xx", "yy", "zz", "yz", "zx", "xy"};

/// Where each of some pictures is, that lie one behind the other.
///
/// position  of the first; becomes that behind the last
Json placesOf(std::span<const Bytes> pictures, std::size_t& position) {
  Json places = Json::array();
  for (const Bytes& picture : pictures) {
    places.push_back({{"length", picture.size()}, {"position", position}});
    position += picture.size();
  }
  return places;
}

}  // namespace

CubeArrangement babylonArrangement() { return flipped(*presetNamed("babylon")->cube, Flip::vertical); }

std::array<glm::vec3, 9> babylonPolynomial(const Harmonics& radiance) {
  const FilamentHarmonics c = filamentHarmonics(radiance);
  constexpr float kOfBand1 = 2.0f / 3.0f;
  constexpr float kOfBand2 = 1.0f / 4.0f;
  // Babylon's x is our −x.
  return {-kOfBand1 * c[3],
          kOfBand1 * c[1],
          kOfBand1 * c[2],
          c[0] + kOfBand2 * (c[8] - c[6]),
          c[0] - kOfBand2 * (c[8] + c[6]),
          c[0] + kOfBand2 * 2.0f * c[6],
          kOfBand2 * c[5],
          -kOfBand2 * c[7],
          -kOfBand2 * c[4]};
}

Result<PackedLight> babylonEnvironment(const BakedMaps& maps, const ProgressFunction& progress) {
  Json json{{"version", 2}, {"width", maps.levels.front().size}, {"imageType", "image/png"}};
  const std::array<glm::vec3, 9> polynomial = babylonPolynomial(maps.radiance);
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    json["irradiance"][kTermNames[i]] = {polynomial[i].x, polynomial[i].y, polynomial[i].z};
  const std::size_t count = maps.levels.size() * 6;
  MIRRORBALL_TRY(specular,
                 encodedCube(maps.specular, babylonArrangement(), rgbd(), partOf(progress, 0, count, count + 6)));
  MIRRORBALL_TRY(irradiance, encodedCube(maps.irradiance.images(), babylonArrangement(), rgbd(),
                                         partOf(progress, count, 6, count + 6)));
  std::size_t position = 0;
  json["specular"] = {{"mipmaps", placesOf(specular, position)}, {"lodGenerationScale", 0.8}};
  json["irradiance"]["irradianceTexture"] = {{"size", maps.irradiance.size()},
                                             {"faces", placesOf(irradiance, position)}};
  LittleEndianWriter file;
  file.append(kEnvMagic);
  file.text(json.dump());
  for (const std::vector<Bytes>* const pictures : {&specular, &irradiance})
    for (const Bytes& picture : *pictures) file.append(picture);
  return PackedLight{file.takeBytes(), lostLight(maps.specular, rgbd()), rgbd().brightest};
}

}  // namespace mirrorball
