#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/command.h"

namespace mirrorball::cli {

/// What is said of an option that a command does not have and that means one that it has: "did you mean --size?". It is
/// a word that other programs have for it, a material's parameter, or a slip of the finger; nothing where none is
/// close.
///
/// written  as it was typed, with its dashes
std::optional<std::string> hintForOption(const Command& command, std::string_view written);

/// What is said of a word where no word is expected: "to write it say -o a.png"; nothing where nothing is known of it.
std::optional<std::string> hintForWord(const Command& command, const std::string& word);

/// The command that is meant by a word that is none; nothing where none is close.
std::optional<std::string_view> commandMeantBy(std::string_view word, std::span<const Command> commands);

}  // namespace mirrorball::cli
