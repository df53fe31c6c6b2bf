#pragma once

#include "mirrorball/base/json_reader.h"
#include "mirrorball/scene/gltf/gltf_document.h"

namespace mirrorball::gltf {

/// An animation of a file. What a channel moves is told as a JSON pointer in any case.
FileAnimation parseAnimation(const JsonReader& json);

}  // namespace mirrorball::gltf
