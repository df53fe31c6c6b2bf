#pragma once

#include <span>

#include "mirrorball/scene/mesh_file/mtl.h"
#include "mirrorball/scene/mesh_file/named_file.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Turns materials of a .mtl into those of a scene, in their order, and loads their pictures. What cannot be read, and
/// what is read otherwise than it is written, becomes a warning.
///
/// - Kd is the base colour, linear, Ke the emission, Ni the index of refraction, d or 1 − Tr the opacity; where Tr
///   alone would hide the whole material, it is read as the opacity, as which some programs write it (three.js issue
///   12861). A d of 0 hides a material, unless nothing of the model would be seen.
/// - Ns is turned into the Beckmann roughness α = √(2/(Ns + 2)), which highlights of that exponent have; Pr, Pm, Ps,
///   Pc, Pcr, aniso and anisor are what glTF calls roughness, metallic, sheen, clear coat with its roughness, and
///   anisotropy.
/// - Pictures multiply these as in glTF. One of base colours beside a Kd of 0, or none, is shown as it is.
///
/// scene   without textures so far, and with the material of what names none
void addObjMaterials(std::span<const MtlMaterial> materials, NamedFiles& named, Scene& scene);

}  // namespace mirrorball
