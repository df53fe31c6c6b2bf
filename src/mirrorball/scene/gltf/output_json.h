#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace mirrorball::gltf {

/// JSON whose members keep the order in which they were added, and whose numbers are floats: "0.3", not
/// "0.30000001192092896". It is only declared here, since few of those who read and write parts of a file look into it,
/// and to compile it takes longer than to compile them.
using OutputJson =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t, std::uint64_t, float>;

}  // namespace mirrorball::gltf
