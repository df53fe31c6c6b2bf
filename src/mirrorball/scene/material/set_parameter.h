#pragma once

#include <string_view>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

/// Sets a parameter of all materials of a scene from "key=value": a row of materialParameters(), or of materialMaps()
/// with a picture's file or the name of a built-in one, as in "base_color_map=orange.jpg". A picture is repeated beyond
/// its edges. Meshes without texture coordinates show one texel of it, of which the scene's warnings tell.
///
/// errors   usage: a wrong key lists the right ones, a wrong value its range; bad_shape and non_finite: slopes of a
///          derivative map that are none; as readImageFile's and decodeColorTexture's
Result<void> setParameter(Scene& scene, std::string_view assignment);

/// What setParameter would say of an assignment, but for what is in a picture: without reading that.
///
/// errors   usage; as FileReader::open's
Result<void> checkParameter(std::string_view assignment);

}  // namespace mirrorball
