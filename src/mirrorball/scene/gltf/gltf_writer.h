#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// A scene as a .glb file.
struct EncodedScene {
  Bytes bytes;
  /// What glTF cannot say, or only nearly, one line each: "materials[4] (orange): height is left out".
  std::vector<std::string> left_out;
};

/// Encodes a scene as glTF 2.0 in one binary file: what decodeGltf reads back is the same scene, but for left_out.
///
/// Each mesh becomes a mesh of one primitive, with positions and indices bit by bit; each instance a node and matrix.
/// Of a material, every row of materialParameters() and materialMaps() with a key in glTF is written where it is not
/// glTF's default. A complex index of refraction becomes its reflectance at normal incidence, an opacity the base
/// colour's alpha. Textures become PNG. The scene's own cameras, lights and variants are written as they are, and what
/// skins and morph targets bend as it is bent; animations are not.
///
/// camera   as the last node, so that other programs show the same picture
/// errors   bad_shape (a scene without triangles); too_large (4 GiB, which the format ends at, or memory)
/// cost     the showcase, 11 MB: less than 70 ms, which its making and the program's start take too
/// source   Khronos, "glTF 2.0 Specification" (ISO/IEC 12113:2022)
Result<EncodedScene> encodeGlb(const Scene& scene, const std::optional<Camera>& camera = {});

}  // namespace mirrorball
