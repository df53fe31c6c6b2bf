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

Error ofMap(const std::string& input, Error error) {
  const auto format = modelFormatOf(input);
  if (!format) return error;
  return {error.code, input + ": is " + std::string(*format) + " model, no map; try `mirrorball render " + input + "`"};
}

Result<LoadedEnvironment> loadMap(const std::string& name_or_path, const EnvironmentLoadOptions& options,
                                  const ProgressFunction& progress) {
  auto loaded = loadEnvironment(name_or_path, options, progress);
  if (!loaded) return tl::unexpected<Error>(ofMap(name_or_path, std::move(loaded).error()));
  tellAbout(*loaded, terminalObserver());
  return loaded;
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
