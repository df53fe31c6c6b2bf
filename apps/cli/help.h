#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "cli/command.h"

namespace CLI {
class FormatterBase;
}

namespace mirrorball::cli {

/// How wide help is written: as the terminal of standard output, else as COLUMNS says, else 100 columns; from 40 to
/// 120.
std::size_t helpColumns();

/// A text in lines of at most so many columns; a longer word has a line of its own, and lines stay apart.
///
/// indent   columns before each line but the first, which begins behind as many
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent);

/// Help in that width, whose columns are as straight as code points make them: CLI11 counts bytes.
std::shared_ptr<CLI::FormatterBase> helpFormatter();

/// Whether a command's help shows an option before all of them are asked for: commands with many of them show those
/// that most people use.
bool isInShortHelp(const Command& command, const CommandOption& option);

/// What the help of a command ends with: how many options it has left out, and examples.
std::string endOfHelp(const Command& command, bool shows_all);

/// `mirrorball help materials`: the materials' names, and the parameters of --set.
std::string helpOnMaterials();

}  // namespace mirrorball::cli
