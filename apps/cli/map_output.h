#pragma once

#include <string>
#include <string_view>

#include "cli/command.h"
#include "mirrorball/output/map_file.h"

namespace mirrorball::cli {

/// What a command that writes a map is told about its files.
struct MapOutputOptions {
  std::string output;
  MapFileOptions file = {};
  GivenOptions given = {};  ///< which options were given, as far as it matters
};

/// Adds --output and the options of a map's file.
///
/// help     of --output, where there is more to say than of one map; must outlive the command
void addMapOutput(Command& command, MapOutputOptions& output, std::string_view help = {});
/// The help of --output of one map.
std::string_view mapOutputHelp();

/// A projection that --to names.
///
/// errors   usage: there is none such; a cube's layout is no projection
Result<Projection> projectionToWrite(const std::string& name);

/// Refuses what can be refused before the map's projection is known.
///
/// errors   usage
Result<void> checkMapOutput(const MapOutputOptions& options, const std::string& output);

/// Where a map goes, told of at the terminal.
///
/// errors   as MapFile::resolve's and checkMapOutput's
Result<MapFile> mapFileFor(const MapOutputOptions& options, const std::string& output, Projection projection);

}  // namespace mirrorball::cli
