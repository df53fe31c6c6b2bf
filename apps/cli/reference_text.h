#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"

namespace mirrorball::cli {

/// A table of options that is no command's: --set's, the sky's, and what every command has.
struct ReferenceTable {
  std::string_view title;
  std::string_view about;
  std::string_view prefix;  ///< "--", or nothing
  std::vector<CommandOption> rows;
};

/// All that there is to tell of the program's words.
struct Reference {
  std::vector<Command> commands;  ///< without the options that every one has
  std::vector<ReferenceTable> tables;
};

Reference makeReference();

/// --set's parameters, and the maps of materials.
std::vector<CommandOption> rowsOfMaterials();

/// docs/options.md.
std::string markdownOf(const Reference& reference);

/// A page for `man`, in section 1 (groff's man macros).
std::string manualOf(const Reference& reference);

/// What completes a command line.
///
/// commands   with all their options
std::string bashCompletionOf(std::span<const Command> commands);
std::string zshCompletionOf(std::span<const Command> commands);
std::string fishCompletionOf(std::span<const Command> commands);

}  // namespace mirrorball::cli
