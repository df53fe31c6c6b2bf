#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/bake/bake.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/file/light_limits.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// A file of a program's own kind with all that it needs of an environment, in pictures of four bytes a texel.
struct PackedLight {
  Bytes bytes;
  LostLight lost = {};     ///< what the four bytes do not hold, of the environment itself
  float brightest = 0.0f;  ///< that they hold
};

/// Makes such a file.
///
/// maps     with the chain, an irradiance cube, and three bands of harmonics
/// progress asked for each picture that goes into it
/// errors   too_large; interrupted
using PackLight = Result<PackedLight> (*)(const BakedMaps& maps, const ProgressFunction& progress);

/// A way of keeping light in four bytes a texel, of which the fourth is a factor of the others.
struct LightCode {
  float brightest;  ///< that it holds; what is brighter is lowered to that, keeping its hue
  void (*encode)(glm::vec3 light, std::uint8_t* code);  ///< light no brighter than that
};

/// Red, green and blue times d, encoded with 1 / 2.2, and d: 255 at least 1, and as near to the brightest channel as
/// whole numbers come. Holds up to 255, in steps of about one percent.
///
/// from     Babylon.js, helperFunctions.fx, toRGBD and fromRGBD
LightCode rgbd();

/// The square roots of red, green and blue over 8 − 7 a, and a. Holds up to 64.
///
/// from     PlayCanvas, encode.js, encodeRGBP, and decode.js, decodeRGBP
LightCode rgbp();

/// An image of light as bytes.
Image8 encoded(const Image& light, const LightCode& code);

/// An image of light as a PNG of bytes.
///
/// errors   too_large
Result<Bytes> encodedPng(const Image& light, const LightCode& code);

/// All images of a cube as such PNGs: level by level, the slots of an arrangement one after the other.
///
/// cube     three channels, by OpenGL's table
/// errors   too_large; interrupted
/// cost     some 100 ns a texel, on as many threads as there are images; codes and PNGs take 8 bytes a texel, of the
///          images in work, beside those that are finished; the same bytes for any number of threads
Result<std::vector<Bytes>> encodedCube(const ImageSet& cube, const CubeArrangement& arrangement, const LightCode& code,
                                       const ProgressFunction& progress = {});

/// What a code does not hold of a cube.
LostLight lostLight(const ImageSet& chain, const LightCode& code);

}  // namespace mirrorball
