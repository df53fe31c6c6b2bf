#include "mirrorball/output/baked/image_based_light_gltf.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "formula/constants.h"
#include "mirrorball/bake/harmonics/filament_harmonics.h"
#include "mirrorball/codec/glb_container.h"
#include "mirrorball/output/baked/babylon_environment.h"

namespace mirrorball {
namespace {

using GltfJson = nlohmann::ordered_json;

constexpr const char* kImageBasedLights = "EXT_lights_image_based";

/// The factor of each harmonic in Babylon.js (SH3ylmBasisConstants).
///
/// from     Babylon.js, sphericalPolynomial.ts
std::array<float, 9> signedFactors() {
  const float band1 = std::sqrt(3.0f / (4.0f * formula::kPi));
  const float band2 = std::sqrt(15.0f / (4.0f * formula::kPi));
  return {std::sqrt(1.0f / (4.0f * formula::kPi)),  -band1, band1,       -band1, band2, -band2,
          std::sqrt(5.0f / (16.0f * formula::kPi)), -band2, band2 / 2.0f};
}

/// Appends all faces of the chain to a document and to its buffer.
///
/// faces    as encodedCube returns them
/// returns  the images' numbers, six for each level
GltfJson appendFaces(std::span<const Bytes> faces, GltfJson& document, Bytes& buffer) {
  GltfJson numbers = GltfJson::array();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    numbers[i / 6].push_back(document["images"].size());
    document["images"].push_back({{"bufferView", document["bufferViews"].size()}, {"mimeType", "image/png"}});
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", faces[i].size()}});
    buffer.insert(buffer.end(), faces[i].begin(), faces[i].end());
  }
  return numbers;
}

}  // namespace

std::array<glm::vec3, 9> irradianceCoefficients(const Harmonics& radiance) {
  // Terms of the polynomial, in the order of the harmonics: 1, y, z, x, xy, yz, 3z² − 1, zx, x² − y².
  constexpr std::array<float, 9> kMirrored{1, 1, 1, -1, -1, 1, 1, -1, 1};
  const FilamentHarmonics over_pi = filamentHarmonics(radiance);
  const std::array<float, 9> factors = signedFactors();
  std::array<glm::vec3, 9> coefficients;
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    coefficients[i] = over_pi[i] * (formula::kPi * kMirrored[i] / factors[i]);
  return coefficients;
}

Result<PackedLight> imageBasedLightGltf(const BakedMaps& maps, const ProgressFunction& progress) {
  MIRRORBALL_TRY(faces, encodedCube(maps.specular, babylonArrangement(), rgbd(), progress));
  GltfJson document;
  document["asset"] = {{"version", "2.0"}, {"generator", "mirrorball"}};
  document["extensionsUsed"] = {kImageBasedLights};
  document["images"] = GltfJson::array();
  document["bufferViews"] = GltfJson::array();
  Bytes buffer;
  GltfJson light{{"intensity", 1.0}, {"specularImageSize", maps.levels.front().size}};
  for (const glm::vec3 coefficient : irradianceCoefficients(maps.radiance))
    light["irradianceCoefficients"].push_back({coefficient.x, coefficient.y, coefficient.z});
  light["specularImages"] = appendFaces(faces, document, buffer);
  document["buffers"].push_back({{"byteLength", buffer.size()}});
  document["extensions"][kImageBasedLights]["lights"].push_back(light);
  document["scene"] = 0;
  document["scenes"].push_back({{"extensions", {{kImageBasedLights, {{"light", 0}}}}}});
  MIRRORBALL_TRY(file, glbFile(document.dump(), buffer));
  return PackedLight{std::move(file), lostLight(maps.specular, rgbd()), rgbd().brightest};
}

}  // namespace mirrorball
