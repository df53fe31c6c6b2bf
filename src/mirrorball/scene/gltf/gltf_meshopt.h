#pragma once

#include "mirrorball/base/result.h"
#include "mirrorball/scene/gltf/gltf_file.h"

namespace mirrorball::gltf {

/// Decodes every buffer view that EXT_meshopt_compression holds compressed, and has it point to the bytes: a buffer of
/// its own.
///
/// errors   bad_file (a view's key is named: a wrong size, mode or filter, damaged bytes); too_large
Result<void> decodeMeshopt(File& file);

}  // namespace mirrorball::gltf
