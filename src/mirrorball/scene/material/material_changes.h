#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

enum class FresnelOverride { material, exact, schlick, empirical, f82 };

/// Changes to the materials of a scene.
struct MaterialChanges {
  std::string variant = {};   ///< first gives every mesh its material in this one of Scene::variants; empty: none
  std::string material = {};  ///< then gives every surface this material of materialNames(); empty: each keeps its own
  std::vector<std::string> set = {};  ///< then sets these parameters of all: "key=value" (set_parameter.h)
  FresnelOverride fresnel = FresnelOverride::material;
};

/// The table of these options.
std::span<const Option<MaterialChanges>> materialOptions();

/// Changes the materials of a scene.
///
/// errors   usage; as setParameter's
Result<void> changeMaterials(Scene& scene, const MaterialChanges& changes);

/// What changeMaterials would say of any scene, without reading a picture; a variant only the scene knows.
///
/// errors   usage; as checkParameter's
Result<void> checkChanges(const MaterialChanges& changes);

}  // namespace mirrorball
