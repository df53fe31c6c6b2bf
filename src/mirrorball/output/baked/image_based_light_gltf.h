#pragma once

#include <array>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/output/baked/packed_light.h"

namespace mirrorball {

/// A .glb file with nothing but a light of EXT_lights_image_based, as Babylon.js reads it: the faces as in its .env
/// files, PNGs in RGBD, and three bands of irradiance.
///
/// maps     as PackLight's, but for the irradiance cube; sides are powers of two
/// errors   as PackLight's
/// from     EXT_lights_image_based of the glTF registry; EXT_lights_image_based.ts of Babylon.js 9.28, the only reader
///          that is known, where the specification leaves orientations, signs and the levels' roughness open
Result<PackedLight> imageBasedLightGltf(const BakedMaps& maps, const ProgressFunction& progress = {});

/// The extension's irradianceCoefficients: irradiance in harmonics whose x is our −x, by bands.
///
/// radiance at least three bands of it
std::array<glm::vec3, 9> irradianceCoefficients(const Harmonics& radiance);

}  // namespace mirrorball
