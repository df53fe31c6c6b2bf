#include "mirrorball/output/baked/babylon_environment.h"

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::uint8_t, 8> kEnvMagic{0x86, 0x16, 0x87, 0x96, 0xf6, 0xd6, 0x96, 0x36};
constexpr std::array<std::string_view, 9> kTermNames{"x", "y", "z", "xx", "yy", "zz", "yz", "zx", "xy"};

/// The pictures of a file, one behind the other, and where each of them is.
struct Pictures {
  Bytes bytes;

  /// Appends all levels of a cube.
  ///
  /// returns  length and position of each face of each level
  /// errors   too_large
  Result<Json> append(const ImageSet& cube) {
    Json places = Json::array();
    const ImageSet faces = arranged(cube, babylonArrangement());
    for (int level = 0; level < faces.levels(); ++level)
      for (int face = 0; face < 6; ++face) {
        MIRRORBALL_TRY(png, encodedPng(faces.at(level, face), rgbd()));
        places.push_back({{"length", png.size()}, {"position", bytes.size()}});
        bytes.insert(bytes.end(), png.begin(), png.end());
      }
    return places;
  }
};

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

Result<PackedLight> babylonEnvironment(const BakedMaps& maps) {
  Json json{{"version", 2}, {"width", maps.levels.front().size}, {"imageType", "image/png"}};
  const std::array<glm::vec3, 9> polynomial = babylonPolynomial(maps.radiance);
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    json["irradiance"][kTermNames[i]] = {polynomial[i].x, polynomial[i].y, polynomial[i].z};
  Pictures pictures;
  MIRRORBALL_TRY(specular, pictures.append(maps.specular));
  json["specular"] = {{"mipmaps", specular}, {"lodGenerationScale", 0.8}};
  MIRRORBALL_TRY(irradiance, pictures.append(maps.irradiance.images()));
  json["irradiance"]["irradianceTexture"] = {{"size", maps.irradiance.size()}, {"faces", irradiance}};
  LittleEndianWriter file;
  file.append(kEnvMagic);
  file.text(json.dump());
  file.append(pictures.bytes);
  return PackedLight{file.takeBytes(), lostLight(maps.specular, rgbd()), rgbd().brightest};
}

}  // namespace mirrorball
