#include "cli/map_inputs.h"

#include "cli/terminal.h"
#include "mirrorball/base/text.h"
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

}  // namespace mirrorball::cli
