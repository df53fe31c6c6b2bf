#pragma once

#include <string>
#include <vector>

namespace mirrorball::testing {

/// Drags files onto a window and lets them go there, as a file manager does: the source's half of X's protocol for that
/// (XDND, version 5), with names as the addresses of a text/uri-list.
///
/// display   ":1"
/// window    its number
/// paths     absolute
/// returns   "": the window has taken them; else what it did not do within some seconds
std::string dropFiles(const std::string& display, unsigned long window, const std::vector<std::string>& paths);

}  // namespace mirrorball::testing
