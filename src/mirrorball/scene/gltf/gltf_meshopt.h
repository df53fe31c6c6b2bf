#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {

/// Decodes every buffer view that EXT_meshopt_compression holds compressed, and has it point to the bytes: a buffer of
/// its own. One that is damaged (a wrong size, mode or filter) is an error of whoever asks for it.
///
/// errors   too_large
Result<void> decodeMeshopt(File& file);

}  // namespace mirrorball::gltf
