#pragma once

#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/light_edit/map_lamp.h"

namespace mirrorball {

/// The endings of the names of files that lamps can be written to: ".glb .json .three.js .babylon.js .gd .py".
std::string lampFileEndings(const std::string& before_last = " or ");

/// Refuses a name that ends otherwise.
///
/// errors   usage
Result<void> checkLampFile(const std::string& path);

/// Writes lamps as the file's name says: glTF, JSON or a snippet of a program's code.
///
/// errors   usage, as checkLampFile's; io
Result<void> writeLamps(const std::string& path, std::span<const MapLamp> lamps);

/// The lamps' files beside a map of a name: as glTF and JSON, and as the snippet of a program, if one is known.
///
/// stem     what the names begin with: "rest_lamps"
/// program  a preset's name, may be empty
std::vector<std::string> lampFilesFor(const std::string& stem, const std::string& program);

}  // namespace mirrorball
