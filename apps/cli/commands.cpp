#include "cli/commands.h"

#include <memory>
#include <utility>

#include "cli/common_options.h"

namespace mirrorball::cli {

std::vector<Command> allCommands() {
  std::vector<Command> commands{renderCommand(),  convertCommand(),  bakeCommand(),    captureCommand(),
                                exportCommand(),  infoCommand(),     lightsCommand(),  compareCommand(),
                                contactCommand(), studyCommand(),    fresnelCommand(), photoCommand(),
                                surfaceCommand(), transferCommand(), cacheCommand(),   referenceCommand()};
  for (Command& command : commands) {
    auto common = std::make_shared<CommonOptions>();
    addOptions(command, commonOptions(), *common);
    command.action = [common, work = std::move(command.action)] {
      use(*common);
      return work();
    };
  }
  return commands;
}

}  // namespace mirrorball::cli
