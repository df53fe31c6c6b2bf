#include "cli/command.h"

#include <set>
#include <string>

namespace mirrorball::cli {

void addArgument(Command& command, Argument argument, std::string& target) {
  argument.set = [&target](const std::string& value) -> Result<void> {
    target = value;
    return {};
  };
  command.arguments.push_back(std::move(argument));
}

void addArgument(Command& command, Argument argument, std::vector<std::string>& target) {
  argument.may_repeat = true;
  argument.set = [&target](const std::string& value) -> Result<void> {
    target.push_back(value);
    return {};
  };
  command.arguments.push_back(std::move(argument));
}

std::string inCommandWords(std::string_view text) {
  return filledIn(text, [](std::string_view name) { return "--" + std::string(name); });
}

OptionText inCommandWords(OptionText text) {
  static std::set<std::string> helps;  // which live as long as the tables that they are of
  if (text.help.find('{') != std::string_view::npos) text.help = *helps.insert(inCommandWords(text.help)).first;
  return text;
}

std::string synopsisOf(const Command& command) {
  std::string synopsis(command.name);
  for (const Argument& argument : command.arguments) {
    const std::string name = std::string(argument.name) + (argument.may_repeat ? "…" : "");
    synopsis += argument.missing.empty() ? " [" + name + "]" : " " + name;
  }
  return synopsis;
}

std::string describe(const OptionText& text, const std::string& default_value) {
  std::string description(text.help);
  std::string facts;
  const auto add = [&](const std::string& fact) { facts += (facts.empty() ? "" : "; ") + fact; };
  if (!text.unit.empty()) add("in " + std::string(text.unit));
  if (const std::string range = rangeText(text); !range.empty()) add(range);
  if (!default_value.empty()) add("default " + default_value);
  if (!text.implied.empty()) add("without a value " + std::string(text.implied));
  return facts.empty() ? description : description + " (" + facts + ")";
}

std::string valueOf(const CommandOption& option) {
  if (option.is_flag) return "";
  const OptionText& text = option.text;
  return std::string(text.value.empty() ? (text.choices.empty() ? "NUMBER" : text.choices) : text.value);
}

std::vector<std::string_view> wordsOf(const OptionText& text) {
  if (text.names == nullptr) return choicesOf(text);
  const auto names = text.names();
  return {names.begin(), names.end()};
}

}  // namespace mirrorball::cli
