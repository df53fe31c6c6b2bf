#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "cli/command.h"

namespace mirrorball::cli {

/// Reads the command line of a program with these subcommands. Prints help or the version where they are asked for.
///
/// returns  what is to be done
/// errors   usage
Result<Action> readCommandLine(int argc, const char* const* argv, std::span<const Command> commands);

/// The unit vector along the three numbers of an option, which may be as small or as large as floats are.
///
/// errors   usage: all three are 0
Result<glm::vec3> unitVector(const std::string& option, const std::vector<float>& numbers);

/// errors   usage: no number of bytes (base/memory.h: parseBytes)
Result<void> useMemoryLimit(const OptionText& text, std::string_view written);

/// --max-memory, of every command that reads maps.
inline constexpr OptionText kMaxMemoryText{
    .name = "max-memory",
    .value = "BYTES",
    .help = "maximum memory for images, as in 1.5G or 800M; without it, 3/4 of the machine's memory"};

/// Sets memoryLimit() as soon as the option is read, before any input is.
///
/// errors   usage
template <typename Target>
inline constexpr ParsedField<Target> kMemoryLimitField{
    [](const Target&) { return std::string(); },
    [](const OptionText& text, std::string_view written, Target&) { return useMemoryLimit(text, written); }};

/// --inside-only, of every command that reads models (ModelLoadOptions).
inline constexpr OptionText kInsideOnlyText{
    .name = "inside-only",
    .help = "read nothing that a model names outside of its own folder, be it by .. or through a symbolic link"};

/// --rotate, of commands that can turn the light.
inline constexpr OptionText kRotateText{
    .name = "rotate",
    .value = "YAW[,PITCH[,ROLL]]",
    .unit = "degrees",
    .max_count = 3,
    .help = "turn the light about +Z by ROLL, then about +X by PITCH, then about +Y by YAW, from +Z towards +X",
    .also = "env-rotation"};

}  // namespace mirrorball::cli
