#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mirrorball::gltf {

/// JSON whose members keep the order in which they were added, and whose numbers are floats: "0.3", not
/// "0.30000001192092896". Only declared here: most files that pass it on do not look into it, and nlohmann's header
/// takes longer to compile than they do.
using OutputJson =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

}  // namespace mirrorball::gltf
