#include "cli/help.h"

#include <algorithm>
#include <cstdlib>

#include <CLI/CLI.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/reference_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball::cli {
namespace {

/// Of the names of options, before what they mean.
constexpr std::size_t kNameColumns = 30;
/// A command of more options shows a part of them.
constexpr std::size_t kManyOptions = 30;

/// A name, and behind it, or where that is long below it, what it means.
std::string row(const std::string& name, const std::string& meaning) {
  std::string line = name;
  if (columnsOf(name) >= kNameColumns) line += "\n" + std::string(kNameColumns, ' ');
  if (columnsOf(name) < kNameColumns) line.append(kNameColumns - columnsOf(name), ' ');
  return line + wrapped(meaning, helpColumns(), kNameColumns) + "\n";
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    return row("  " + make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option));
  }
  std::string make_subcommand(const CLI::App* command) const override {
    return row("  " + command->get_name(), command->get_description());
  }
};

}  // namespace

std::size_t helpColumns() {
  constexpr std::size_t kLeast = 40, kMost = 120, kUsual = 100;
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return std::clamp<std::size_t>(size.ws_col, kLeast, kMost);
  const char* columns = std::getenv("COLUMNS");
  const auto number = columns == nullptr ? std::nullopt : parseNumber(columns);
  return number && *number >= 1.0 ? std::size_t(std::clamp(*number, double(kLeast), double(kMost))) : kUsual;
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent) {
  std::string made;
  std::size_t at = indent;
  bool is_first_of_line = true;
  for (const std::string& line : split(std::string(text), '\n')) {
    if (!made.empty()) {
      made += "\n" + std::string(indent, ' ');
      at = indent;
      is_first_of_line = true;
    }
    for (const std::string& word : split(line, ' ')) {
      const std::size_t width = columnsOf(word);
      if (!is_first_of_line && at + 1 + width > columns) {
        made += "\n" + std::string(indent, ' ');
        at = indent;
      } else if (!is_first_of_line) {
        made += ' ';
        ++at;
      }
      made += word;
      at += width;
      is_first_of_line = false;
    }
  }
  return made;
}

std::shared_ptr<CLI::FormatterBase> helpFormatter() { return std::make_shared<HelpFormatter>(); }

bool isInShortHelp(const Command& command, const CommandOption& option) {
  return command.options.size() <= kManyOptions || option.text.is_daily;
}

std::string endOfHelp(const Command& command, bool shows_all) {
  const auto left_out =
      std::ranges::count_if(command.options, [&](const auto& option) { return !isInShortHelp(command, option); });
  std::string text;
  if (left_out > 0 && !shows_all)
    text += wrapped(counted(std::size_t(left_out), "more option") + ": mirrorball help " + std::string(command.name) +
                        " all",
                    helpColumns(), 0) +
            "\n\n";
  text += "Examples:";
  for (const Example& example : command.examples)
    text += "\n  mirrorball " + std::string(example.line) + "\n      " + wrapped(example.what, helpColumns(), 6);
  return text;
}

std::string helpOnMaterials() {
  std::string text = wrapped("Materials, for --material: " + join(materialNames(), " "), helpColumns(), 2) +
                     "\n\nParameters, for --set KEY=VALUE:\n";
  for (const CommandOption& parameter : rowsOfMaterials())
    text += row("  " + std::string(parameter.text.name) + " " + valueOf(parameter),
                describe(parameter.text, parameter.default_value));
  return text;
}

}  // namespace mirrorball::cli
