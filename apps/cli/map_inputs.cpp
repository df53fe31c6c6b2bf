#include "cli/map_inputs.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>

#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {

Result<LoadedEnvironment> loadMap(const std::string& name_or_path, const EnvironmentLoadOptions& options,
                                  const ProgressFunction& progress) {
  auto loaded = loadEnvironment(name_or_path, options, progress);
  if (loaded && !loaded->doubt.message.empty())
    remark(name_or_path + ": " + loaded->doubt.message + ", and --from " +
           join(loaded->doubt.other_forms, " or --from ") + " names another form");
  if (loaded) return loaded;
  const auto format = modelFormatOf(name_or_path);
  if (!format) return loaded;
  return fail(loaded.error().code, name_or_path + ": is " + std::string(*format) +
                                       " model, no map; try `mirrorball render " + name_or_path + "`");
}

void takeNegativeAsNone(const std::string& name, EnvironmentMap& map) {
  if (const std::size_t negative = raiseNegativeLight(map); negative > 0)
    remark(name + ": " + countedAre(negative, "value") + " negative, which light cannot be; taken as 0");
}

std::vector<std::string> withEachCubeOnce(const std::vector<std::string>& inputs, const FormHint& from) {
  std::vector<std::string> kept;
  std::map<std::filesystem::path, std::size_t> files_of_cube;  // by its first file
  for (const std::string& input : inputs) {
    const auto files = cubeFilesOf(input, from);
    if (!files || ++files_of_cube[files->paths[0]] == 1) kept.push_back(input);
  }
  for (const std::string& input : kept)
    if (const auto files = cubeFilesOf(input, from); files && files_of_cube[files->paths[0]] > 1)
      remark(input + ": is one of " + std::to_string(files_of_cube[files->paths[0]]) +
             " inputs that are the faces of one cube, which is taken once");
  return kept;
}

}  // namespace mirrorball::cli
