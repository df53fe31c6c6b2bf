#include <string>
#include <string_view>
#include <vector>

#include "cli/reference_text.h"
#include "mirrorball/base/text.h"

namespace mirrorball::cli {
namespace {

/// "--output", "-o": how an option may be written.
std::vector<std::string> flagsOf(const OptionText& text) {
  std::vector<std::string> flags{"--" + std::string(text.name)};
  if (!text.also.empty()) flags.push_back("--" + std::string(text.also));
  if (!text.letter.empty()) flags.push_back("-" + std::string(text.letter));
  return flags;
}

/// All flags of a command.
std::string flagsOf(const Command& command) {
  std::string flags = "--help --version";
  for (const CommandOption& option : command.options) flags += " " + join(flagsOf(option.text), " ");
  return flags;
}

std::string wordsText(const OptionText& text) {
  const std::vector<std::string_view> words = wordsOf(text);
  return join(words, " ");
}

std::string namesText(std::span<const Command> commands) {
  std::string names = "help";
  for (const Command& command : commands) names += " " + std::string(command.name);
  return names;
}

/// Whether the first argument is one of some words, and the others are something else: what is to be done with those.
bool beginsWithWord(const Command& command) {
  const auto& arguments = command.arguments;
  return arguments.size() > 1 && arguments.front().names != nullptr && !arguments.front().takes_path;
}

std::string joinedNames(std::span<const Argument> arguments) {
  std::string words;
  for (const Argument& argument : arguments)
    if (argument.names != nullptr) words += (words.empty() ? "" : " ") + join(argument.names(), " ");
  return words;
}

/// The words that a command's first argument may be, where the others are something else.
std::string firstWords(const Command& command) {
  return beginsWithWord(command) ? joinedNames(std::span(command.arguments).first(1)) : std::string();
}

/// The words that its arguments may be, or those behind such a one.
std::string argumentWords(const Command& command) {
  return joinedNames(std::span(command.arguments).subspan(beginsWithWord(command) ? 1 : 0));
}

bool takesPaths(const Command& command) {
  for (const Argument& argument : command.arguments)
    if (argument.takes_path) return true;
  return false;
}

/// In single quotes, for zsh and fish. Colons and brackets have a meaning in zsh's _arguments, and are left out there.
std::string inQuotes(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

/// One line of a help text, short enough for a menu: up to its first stop.
std::string brief(std::string_view help) {
  constexpr std::string_view kRequired = "required: ";
  if (help.starts_with(kRequired)) help.remove_prefix(kRequired.size());
  std::string text(help.substr(0, help.find_first_of(":;[(")));
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

/// What bash offers after an option: "choices FILES".
std::string bashCase(const CommandOption& option) {
  const std::string words = wordsText(option.text);
  std::string reply = "words=" + inQuotes(words);
  if (option.text.takes_path) reply += "; paths=1";
  return "      " + join(flagsOf(option.text), "|") + ") " + reply + "; value=1 ;;\n";
}

std::string zshSpec(const CommandOption& option) {
  const std::vector<std::string> flags = flagsOf(option.text);
  const std::string words = wordsText(option.text);
  std::string action;
  if (!option.is_flag) {
    action = ":" + brief(option.text.value.empty() ? "value" : option.text.value) + ":";
    if (option.text.takes_path)
      action += words.empty() ? "_files" : "{_alternative \"names:name:(" + words + ")\" \"files:file:_files\"}";
    else
      action += words.empty() ? " " : "(" + words + ")";
  }
  std::string specs;
  for (const std::string& flag : flags) {
    // "--to=" takes --to=cube and --to cube.
    const std::string name = flag + (flag.starts_with("--") && !option.is_flag ? "=" : "");
    specs += "      " + inQuotes((option.may_repeat ? "*" : "") + name + "[" + brief(option.text.help) + "]" + action) +
             " \\\n";
  }
  return specs;
}

std::string fishLine(const Command& command, const CommandOption& option) {
  const OptionText& text = option.text;
  std::string line = "complete -c mirrorball -n '__fish_seen_subcommand_from " + std::string(command.name) + "' -l " +
                     std::string(text.name);
  if (!text.letter.empty()) line += " -s " + std::string(text.letter);
  if (!option.is_flag) line += text.takes_path ? " -r -F" : " -x";
  if (const std::string words = wordsText(text); !words.empty()) line += " -a " + inQuotes(words);
  line += " -d " + inQuotes(brief(text.help)) + "\n";
  if (text.also.empty()) return line;
  CommandOption other = option;
  other.text.name = text.also;
  other.text.also = {};
  return line + fishLine(command, other);
}

}  // namespace

std::string bashCompletionOf(std::span<const Command> commands) {
  std::string text =
      "# Completion of mirrorball's command line for bash, made by `mirrorball reference --format bash`.\n"
      "_mirrorball() {\n"
      "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} words= paths= value= flags=\n"
      "  # --to=cube is three words to bash.\n"
      "  if [[ $cur == = ]]; then cur=; elif [[ $prev == = ]]; then prev=${COMP_WORDS[COMP_CWORD - 2]}; fi\n"
      "  if ((COMP_CWORD == 1)) || [[ ${COMP_WORDS[1]} == help ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W " +
      inQuotes(namesText(commands) + " --help --version") +
      " -- \"$cur\")\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const Command& command : commands) {
    text +=
        "    " + std::string(command.name) + ")\n      flags=" + inQuotes(flagsOf(command)) + "\n      case $prev in\n";
    for (const CommandOption& option : command.options)
      if (!option.is_flag) text += "  " + bashCase(option);
    text += "        *) words=" + inQuotes(argumentWords(command)) + (takesPaths(command) ? "; paths=1" : "");
    if (const std::string first = firstWords(command); !first.empty())
      text += "; ((COMP_CWORD == 2)) && words=" + inQuotes(first) + " paths=";
    text += " ;;\n      esac\n      ;;\n";
  }
  return text +
         "  esac\n"
         "  [[ -z $value && $cur == -* ]] && words=$flags paths=\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\"; [[ -n $paths ]] && compgen -f -- \"$cur\")\n"
         "  [[ -n $paths ]] && compopt -o filenames\n"
         "}\n"
         "complete -F _mirrorball mirrorball\n";
}

std::string zshCompletionOf(std::span<const Command> commands) {
  std::string text =
      "#compdef mirrorball\n"
      "# Completion of mirrorball's command line for zsh, made by `mirrorball reference --format zsh`.\n"
      "_mirrorball() {\n  local -a commands\n  commands=(\n";
  for (const Command& command : commands)
    text += "    " + inQuotes(std::string(command.name) + ":" + brief(command.help)) + "\n";
  text +=
      "    'help:Tells what a command takes'\n  )\n"
      "  if ((CURRENT == 2)) || [[ ${words[2]} == help ]]; then\n    _describe command commands\n    return\n  fi\n"
      "  local command=${words[2]}\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const Command& command : commands) {
    text += "    " + std::string(command.name) + ")\n      _arguments \\\n";
    for (const CommandOption& option : command.options) text += zshSpec(option);
    const std::string words = argumentWords(command);
    std::string action = takesPaths(command) ? "_files" : "(" + words + ")";
    if (takesPaths(command) && !words.empty())
      action = "{_alternative \"names:name:(" + words + ")\" \"files:file:_files\"}";
    if (const std::string first = firstWords(command); !first.empty())
      text += "      " + inQuotes("1:" + std::string(command.arguments.front().name) + ":(" + first + ")") + " \\\n";
    if (!command.arguments.empty())
      text += "      " + inQuotes("*:" + std::string(command.arguments.back().name) + ":" + action) + " \\\n";
    text += "      '--help[Print this help]'\n      ;;\n";
  }
  return text + "  esac\n}\n_mirrorball \"$@\"\n";
}

std::string fishCompletionOf(std::span<const Command> commands) {
  std::string text =
      "# Completion of mirrorball's command line for fish, made by `mirrorball reference --format fish`.\n";
  const std::string names = namesText(commands);
  for (const Command& command : commands)
    text += "complete -c mirrorball -f -n 'not __fish_seen_subcommand_from " + names + "' -a " +
            std::string(command.name) + " -d " + inQuotes(brief(command.help)) + "\n";
  text += "complete -c mirrorball -f -n 'not __fish_seen_subcommand_from " + names +
          "' -a help -d 'Tells what a command takes'\n";
  for (const Command& command : commands) {
    text += "complete -c mirrorball -f -n '__fish_seen_subcommand_from help' -a " + std::string(command.name) + "\n";
    if (const std::string words = joinedNames(command.arguments); !words.empty())
      text += "complete -c mirrorball -n '__fish_seen_subcommand_from " + std::string(command.name) + "' -a " +
              inQuotes(words) + "\n";
    if (!takesPaths(command))
      text += "complete -c mirrorball -f -n '__fish_seen_subcommand_from " + std::string(command.name) + "'\n";
    for (const CommandOption& option : command.options) text += fishLine(command, option);
  }
  return text;
}

}  // namespace mirrorball::cli
