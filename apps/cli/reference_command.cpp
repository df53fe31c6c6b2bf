#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/reference_text.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball::cli {
namespace {

enum class ReferenceFormat { markdown, man, bash, zsh, fish };

struct ReferenceRequest {
  ReferenceFormat format = ReferenceFormat::markdown;
};

const auto kReferenceOptions = std::to_array<Option<ReferenceRequest>>({
    {{.name = "format",
      .choices = "markdown|man|bash|zsh|fish",
      .help = "what to print: a page of documentation, a manual page, or completions for a shell"},
     choiceField<&ReferenceRequest::format>},
});

template <typename Target>
CommandOption rowOf(const Option<Target>& option, const Target& defaults) {
  return {.text = inCommandWords(option.text), .default_value = written(option, defaults), .is_flag = option.isFlag()};
}

template <typename Target>
std::vector<CommandOption> rowsOf(std::span<const Option<Target>> table) {
  std::vector<CommandOption> rows;
  for (const Option<Target>& option : table) rows.push_back(rowOf(option, Target{}));
  return rows;
}

/// "a|b" would end a cell of a Markdown table.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '|') result += '\\';
    result += letter;
  }
  return result;
}

std::string optionTable(std::span<const CommandOption> rows, std::string_view prefix) {
  std::string table = "| name | value | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const CommandOption& row : rows) {
    const OptionText& text = row.text;
    const std::string_view value = text.value.empty() ? text.choices : text.value;
    table += "| `" + std::string(prefix) + std::string(text.name) + "`";
    if (!text.letter.empty()) table += " -" + std::string(text.letter);
    if (!text.also.empty()) table += " `" + std::string(prefix) + std::string(text.also) + "`";
    table += " | " + escaped(value) + " | " + std::string(text.unit) + " | " + rangeText(text) + " | " +
             escaped(row.default_value) + " | " + escaped(text.help) + " |\n";
  }
  return table;
}

std::string_view contentsOf(Holds what) {
  switch (what) {
    case Holds::light:
      return "linear light";
    case Holds::picture:
      return "integers, sRGB";
    case Holds::either:
      return "integers, sRGB; or floats, linear light";
    case Holds::texture:
      return "textures: cubes, arrays, mip levels";
  }
  return {};
}

std::string formatsText() {
  std::string page =
      "\n## Formats of pictures\n\nA file that is read is recognised by its first bytes, and a file that is "
      "written has the format of its extension.\n\n| format | extensions | holds | written | read "
      "|\n|---|---|---|---|---|\n";
  for (const ImageFormat& format : kImageFormats) {
    if (!isInThisBuild(format)) continue;
    std::string extensions;
    for (const std::string& extension : split(format.extensions, ' '))
      extensions += (extensions.empty() ? "`." : " `.") + extension + "`";
    page += "| " + std::string(format.name) + " | " + extensions + " | " + std::string(contentsOf(format.holds)) +
            " | " + (format.is_written ? "yes" : "") + " | " + std::string(format.what) + " |\n";
  }
  return page;
}

Result<void> printReference(ReferenceFormat format) {
  const std::vector<Command> commands = allCommands();
  std::string text;
  if (format == ReferenceFormat::markdown) text = markdownOf(makeReference());
  if (format == ReferenceFormat::man) text = manualOf(makeReference());
  if (format == ReferenceFormat::bash) text = bashCompletionOf(commands);
  if (format == ReferenceFormat::zsh) text = zshCompletionOf(commands);
  if (format == ReferenceFormat::fish) text = fishCompletionOf(commands);
  std::fputs(text.c_str(), stdout);
  return {};
}

}  // namespace

std::vector<CommandOption> rowsOfMaterials() {
  std::vector<CommandOption> rows;
  for (const MaterialParameter& parameter : materialParameters())
    rows.push_back(rowOf<Material>(parameter, Material{}));
  for (const MaterialMap& map : materialMaps())
    rows.push_back(
        {.text = inCommandWords({.name = map.name, .value = "FILE", .help = map.help}), .default_value = ""});
  return rows;
}

Reference makeReference() {
  Reference reference{
      allCommands(),
      {{"Every command", "All commands also take these options, and `--help`.", "--", rowsOf(commonOptions())},
       {"Material parameters", "For `--set key=value`.", "", rowsOfMaterials()},
       {"Parameters of the sky", "For `sky:key=value,key=value`.", "", rowsOf(skyParameters())}}};
  const std::vector<CommandOption>& common = reference.tables.front().rows;
  for (Command& command : reference.commands)
    std::erase_if(command.options, [&](const CommandOption& option) {
      return std::ranges::any_of(common, [&](const CommandOption& row) { return row.text.name == option.text.name; });
    });
  return reference;
}

std::string markdownOf(const Reference& reference) {
  std::string page =
      "# Options\n\nMade by `mirrorball reference` from the tables that the command line itself is made from; "
      "a test holds this page to them.\n";
  for (const Command& command : reference.commands) {
    page += "\n## mirrorball " + synopsisOf(command) + "\n\n" + std::string(command.help) + ". " +
            std::string(command.about) + "\n";
    if (!command.options.empty()) page += "\n" + optionTable(command.options, "--");
  }
  page += formatsText();
  for (const ReferenceTable& table : reference.tables)
    page += "\n## " + std::string(table.title) + "\n\n" + std::string(table.about) + "\n\n" +
            optionTable(table.rows, table.prefix);
  return page;
}

Command referenceCommand() {
  auto request = std::make_shared<ReferenceRequest>();
  Command command{.name = "reference",
                  .help = "Prints all options and parameters",
                  .about = "The installed manual page and shell completions are made by this command.",
                  .examples = {{"reference | less", "all options as Markdown"},
                               {"reference --format bash >~/.local/share/bash-completion/completions/mirrorball",
                                "completion for a program that is not installed"}}};
  addOptions(command, std::span<const Option<ReferenceRequest>>(kReferenceOptions), *request);
  command.action = [request] { return printReference(request->format); };
  return command;
}

}  // namespace mirrorball::cli
