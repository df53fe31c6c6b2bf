#pragma once

#include <array>

#include <glm/glm.hpp>

#include "mirrorball/bake/harmonics/spherical_harmonics.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/output/baked/packed_light.h"

namespace mirrorball {

/// How Babylon.js has the faces in its .env files and in glTF: its cubes, each image upside down.
CubeArrangement babylonArrangement();

/// A .env file of Babylon.js: the chain and the irradiance as PNGs in RGBD, and three bands of irradiance.
///
/// maps     as PackLight's, with MipMapping::babylon down to one texel a face; sides are powers of two
/// errors   as PackLight's
/// from     Babylon.js 9.35, environmentTextureTools.ts
Result<PackedLight> babylonEnvironment(const BakedMaps& maps, const ProgressFunction& progress = {});

/// The coefficients of a SphericalPolynomial of Babylon.js, in its axes: x, y, z, xx, yy, zz, yz, zx, xy. They are
/// those of irradiance / π but for a factor of 2/3 in the first band and 1/4 in the second, which its materials take
/// out again (FromHarmonics and FromPolynomial in sphericalPolynomial.ts).
///
/// radiance at least three bands of it
std::array<glm::vec3, 9> babylonPolynomial(const Harmonics& radiance);

}  // namespace mirrorball
