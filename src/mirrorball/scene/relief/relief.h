#pragma once

#include <functional>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// How the heights of a surface are shown: from not at all to the surface itself.
enum class ReliefKind {
  none,           ///< not at all
  bump,           ///< by normals alone (Blinn 1978)
  parallax,       ///< and by the texture's place, by a guess (Kaneko et al. 2001)
  steep,          ///< found in equal steps (McGuire & McGuire 2005)
  occlusion,      ///< and between the last two as on a straight surface (Tatarchuk 2006)
  linear_binary,  ///< and between them by halves (Policarpo et al. 2005)
  cone,           ///< found in steps as wide as the empty space (Dummer 2006)
  exact,          ///< where the ray meets it, with silhouettes and depth (Tevs et al. 2008)
  geometry,       ///< the mesh is cut into triangles that stand where the surface is
};

/// Whether a kind moves the place of the surface, within the triangles that there are.
constexpr bool movesSurface(ReliefKind kind) { return kind >= ReliefKind::parallax && kind < ReliefKind::geometry; }

/// Whether heights bend the normals of a material: what its map of slopes gives way to.
inline bool showsHeights(const Material& material, ReliefKind kind) {
  const bool has_shape = material.height == HeightKind::orange || material.height_texture >= 0;
  return has_shape && material.height != HeightKind::none && material.height_scale != 0.0f && kind != ReliefKind::none;
}

/// Whether they are those of a texture, in a scene that is prepared for that kind: what lies below the material's
/// triangles where movesSurface(kind).
inline bool showsHeightTexture(const Material& material, ReliefKind kind) {
  return showsHeights(material, kind) && material.height_texture >= 0;
}

/// Gives a scene what that kind needs of it: the textures of built-in heights, and for `geometry` the triangles. A
/// material with a texture and a height_scale below 0 gets 1 − h as its heights, and the scale above 0: so all else can
/// take the scale as a depth.
///
/// scene            with `geometry`, is warned as by displaceMeshes. Height textures of no material are left out
/// largest_texture  how many texels a side the driver takes that will draw it; asked for, before any work, only where
///                  heights are searched that not every driver takes; none: no driver draws it
/// errors           too_large
/// cost             for each built-in surface 20 ms to 60 ms; `geometry` as displacedMesh's
Result<void> prepareRelief(Scene& scene, ReliefKind kind, const std::function<int()>& largest_texture = {});

}  // namespace mirrorball
