#pragma once

#include <optional>
#include <string_view>

namespace mirrorball {

/// The text of a file of this folder, "page.css", "plot.css" or "page.js".
std::optional<std::string_view> pageFile(std::string_view name);

}  // namespace mirrorball
