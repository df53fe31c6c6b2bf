#include "cli/commands.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "cli/common_options.h"
#include "cli/terminal.h"

namespace mirrorball::cli {

std::vector<Command> allCommands() {
  std::vector<Command> commands{renderCommand(),  convertCommand(),  bakeCommand(),    captureCommand(),
                                exportCommand(),  infoCommand(),     lightsCommand(),  compareCommand(),
                                contactCommand(), studyCommand(),    fresnelCommand(), photoCommand(),
                                surfaceCommand(), transferCommand(), cacheCommand(),   referenceCommand()};
  for (Command& command : commands) {
    auto common = std::make_shared<CommonOptions>();
    addOptions(command, commonOptions(), *common);
    const bool has_size = std::any_of(command.options.begin(), command.options.end(),
                                      [](const CommandOption& option) { return option.text.name == "size"; });
    command.action = [common, has_size, work = std::move(command.action)] {
      use(*common);
      if (!has_size) suggestNoSize();
      return work();
    };
  }
  return commands;
}

}  // namespace mirrorball::cli
