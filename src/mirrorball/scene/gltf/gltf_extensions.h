#pragma once

#include <string>
#include <vector>

#include "mirrorball/base/json_reader.h"
#include "mirrorball/base/result.h"

namespace mirrorball::gltf {

/// The extensions that a file uses and this program does not read, each once, in the alphabet's order: those that it
/// declares, and those of its materials, which some programs forget to declare.
///
/// root     of the file's JSON
/// returns  at most 8, and then "…"; fit for a message
/// errors   unsupported: one that it requires
Result<std::vector<std::string>> unreadExtensions(const JsonReader& root);

}  // namespace mirrorball::gltf
