#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/map_output.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball::cli {

/// One conversion of `convert`, for any input.
struct ConvertRequest {
  std::optional<Projection> to;  ///< nothing: the input's own, and a cube's layout too where no other is asked for
  int size = 0;                  ///< 0: what keeps the input's detail
  Resampling resampling;
  EnvironmentLoadOptions load;
  MapOutputOptions output;
};

/// Converts one map, shows its progress, and writes it. Large panoramas are read by rows.
///
/// errors   as loadEnvironment's, convert's and writeImage's
Result<void> convertFile(const std::string& input, const ConvertRequest& request);

/// Converts maps, several at a time, into the folder that the request's output names, which is made if it is not there.
/// A map that cannot be converted is told of, and the others go on; what is wrong with the options is told once, before
/// anything is made.
///
/// extension  of the files; empty: each input's own
/// errors     usage (the folder is a file's name, two outputs of one name, an output that overwrites its input or cannot
///            be written as asked); io (the folder); interrupted; one input's own error; of several the summary
Result<void> convertMany(const std::vector<std::string>& inputs, const std::string& extension,
                         const ConvertRequest& request);

}  // namespace mirrorball::cli
