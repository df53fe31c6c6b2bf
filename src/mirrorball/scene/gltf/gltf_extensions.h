#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "mirrorball/scene/gltf/gltf_remarks.h"

namespace mirrorball::gltf {

/// The extensions that a file uses and this program does not read, each once, in the alphabet's order: those that it
/// declares, and those of its materials, which some programs forget to declare.
///
/// file     its JSON
/// remarks  has a suspicion of those that the file requires: without them there may be nothing to show
/// returns  at most 8, and then "…"; fit for a message
std::vector<std::string> unreadExtensions(const nlohmann::json& file, Remarks& remarks);

}  // namespace mirrorball::gltf
