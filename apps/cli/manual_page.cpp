#include <string>
#include <string_view>

#include "cli/reference_text.h"

namespace mirrorball::cli {
namespace {

/// Text that groff takes as it is: no escapes, no requests at the beginning of a line, and dashes that can be copied.
std::string roff(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\\') {
      result += "\\e";
    } else if (letter == '-') {
      result += "\\-";
    } else if (letter == '`') {
      result += "\\(aq";  // Markdown's quotation marks of code
    } else if ((letter == '.' || letter == '\'') && (result.empty() || result.back() == '\n')) {
      result += "\\&";
      result += letter;
    } else {
      result += letter;
    }
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

/// A term and what it means.
std::string entry(const std::string& term, const std::string& meaning) {
  return ".TP\n" + term + "\n" + meaning + "\n";
}

std::string entryOf(const CommandOption& option, std::string_view prefix) {
  const OptionText& text = option.text;
  std::string term = bold(std::string(prefix) + std::string(text.name));
  if (!text.letter.empty()) term = bold("-" + std::string(text.letter)) + ", " + term;
  if (!text.also.empty()) term += ", " + bold(std::string(prefix) + std::string(text.also));
  if (const std::string value = valueOf(option); !value.empty()) term += (prefix.empty() ? "=" : " ") + italic(value);
  return entry(term, roff(describe(text, option.is_flag ? "" : option.default_value)));
}

std::string commandText(const Command& command) {
  std::string page = ".SS " + bold("mirrorball " + std::string(command.name)) + "\n";
  page += roff(std::string(command.help) + ". " + std::string(command.about)) + "\n";
  for (const Argument& argument : command.arguments) page += entry(italic(argument.name), roff(argument.help));
  for (const CommandOption& option : command.options) page += entryOf(option, "--");
  return page;
}

constexpr std::string_view kEnvironment[][2] = {
    {"MIRRORBALL_CACHE",
     "the folder for prefiltered environments and the occlusion of models; empty: none are kept. If it is not set: "
     "$XDG_CACHE_HOME/mirrorball or ~/.cache/mirrorball."},
    {"MIRRORBALL_CACHE_SIZE",
     "maximum size of that folder, as in 500M or 2G; 0: nothing is kept. If it is not set: 1G. What was not used for "
     "longest is removed first."},
    {"TMPDIR", "the folder for a file that goes to standard output, until it is complete."}};

constexpr std::string_view kExits[][2] = {
    {"0", "done"},
    {"1", "failed; one line on standard error says why"},
    {"2", "the command line is wrong"},
    {"by a signal", "ended by Ctrl-C, SIGTERM or SIGHUP; no incomplete file stays"}};

}  // namespace

std::string manualOf(const Reference& reference) {
  std::string page = ".TH MIRRORBALL 1 \"\" \"mirrorball " MIRRORBALL_VERSION
                     "\"\n.SH NAME\nmirrorball \\- environment "
                     "mapping: panoramas, sphere maps and cube maps in, mirrors and glass out\n.SH SYNOPSIS\n";
  for (const Command& command : reference.commands)
    page += bold("mirrorball") + " " + roff(synopsisOf(command)) + " [" + italic("OPTION") + "\\&...]\n.br\n";
  page +=
      ".SH DESCRIPTION\nTakes the light that arrives at a place from every direction, as a panorama, a sphere map, a "
      "light "
      "probe or a cube map, and converts it, prefilters it for engines, and shows what mirrors, glass, rough metal and "
      "bumpy surfaces look like in it.\n.PP\nWhere a file is read, " +
      bold("-") + " is standard input; " + bold("-o -.exr") +
      " writes to standard output, in the format of that extension.\n.SH COMMANDS\n";
  for (const Command& command : reference.commands) page += commandText(command);
  for (const ReferenceTable& table : reference.tables) {
    page += ".SH \"" + roff(table.title) + "\"\n" + roff(table.about) + "\n";
    for (const CommandOption& row : table.rows) page += entryOf(row, table.prefix);
  }
  page += ".SH ENVIRONMENT\n";
  for (const auto& [name, meaning] : kEnvironment) page += entry(bold(name), roff(meaning));
  page += ".SH \"EXIT STATUS\"\n";
  for (const auto& [code, meaning] : kExits) page += entry(bold(code), roff(meaning));
  page += ".SH EXAMPLES\n";
  for (const Command& command : reference.commands)
    for (const Example& example : command.examples)
      page += entry(bold("mirrorball " + std::string(example.line)), roff(example.what));
  return page;
}

}  // namespace mirrorball::cli
