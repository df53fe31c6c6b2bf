#include "program_size/program_size.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "program_size/spirv_module.h"

namespace mirrorball::testing {
namespace {

namespace fs = std::filesystem;

/// A folder for the files between the tools, which ends with it.
class Folder {
 public:
  Folder() : path_(fs::path(::testing::TempDir()) / (std::to_string(::getpid()) + "_program_size")) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code status;
    fs::remove_all(path_, status);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path operator/(std::string_view name) const { return path_ / name; }

  /// Runs a command there.
  ///
  /// errors   unsupported: it failed; with its own words
  Result<void> run(const std::string& command) const {
    const std::string line = "cd '" + path_.string() + "' && " + command + " > log 2>&1";
    if (std::system(line.c_str()) == 0) return {};
    const auto log = readFile(path_ / "log");
    return fail(ErrorCode::unsupported, command + ": " + (log ? std::string(log->begin(), log->end()) : "no output"));
  }

 private:
  fs::path path_;
};

/// The version that a tool prints in one line; empty: it is not installed.
///
/// name   with which that line begins
std::string findVersion(const std::string& tool, std::string_view name) {
  std::array<char, 256> line{};
  FILE* output = ::popen((tool + " --version 2>&1").c_str(), "r");  // spirv-opt prints it to stderr
  if (!output) return "";
  const bool has_line = std::fgets(line.data(), static_cast<int>(line.size()), output) != nullptr;
  ::pclose(output);
  const std::string_view printed = has_line ? trimmed(line.data()) : "";
  return printed.starts_with(name) ? std::string(trimmed(printed.substr(name.size()))) : "";
}

Result<SpirvModule> readModule(const fs::path& path) {
  MIRRORBALL_TRY(bytes, readFile(path));
  constexpr std::size_t kWordBytes = 4;
  std::vector<std::uint32_t> words(bytes.size() / kWordBytes);
  std::memcpy(words.data(), bytes.data(), words.size() * kWordBytes);
  return parseSpirv(words);
}

/// The module that spirv-opt makes of all.spv.
Result<SpirvModule> runPasses(const Folder& folder, const std::string& passes) {
  MIRRORBALL_TRY_VOID(folder.run("spirv-opt " + passes + " all.spv -o changed.spv"));
  return readModule(folder / "changed.spv");
}

}  // namespace

Result<std::string> findSizeTools() {
  const std::string glslang = findVersion("glslangValidator", "Glslang Version:");  // 11:12.0.0
  const std::string tools = findVersion("spirv-opt", "SPIRV-Tools");                // v2023.1 unknown hash, …
  if (glslang.empty() || tools.empty())
    return fail(ErrorCode::not_found, std::string(glslang.empty() ? "glslangValidator" : "spirv-opt") +
                                          " is not installed (Debian's packages glslang-tools and spirv-tools)");
  return "glslang " + glslang + ", SPIRV-Tools " + tools.substr(0, tools.find(' '));
}

Result<ProgramSize> measureSize(const std::string& fragment) {
  const Folder folder;
  MIRRORBALL_TRY_VOID(writeFile(folder / "all.frag", std::vector<std::uint8_t>(fragment.begin(), fragment.end())));
  MIRRORBALL_TRY_VOID(folder.run("glslangValidator -G100 --aml --amb -S frag all.frag -o all.spv"));
  MIRRORBALL_TRY(inlined,
                 runPasses(folder, "--merge-return --inline-entry-points-exhaustive --eliminate-dead-functions"));
  MIRRORBALL_TRY(optimised, runPasses(folder, "-O"));
  MIRRORBALL_TRY(called, runPasses(folder,
                                   "--ccp --eliminate-dead-branches --eliminate-dead-code-aggressive "
                                   "--eliminate-dead-functions"));
  return ProgramSize{.instructions = optimised.instructions,
                     .inlined = inlined.instructions,
                     .samplings = optimised.samplings,
                     .arriving_light = countCopies(called, "arrivingLight"),
                     .sight_from = countCopies(called, "sightFrom"),
                     .ray_walks = countCopies(called, "nearestTriangleBeside")};
}

}  // namespace mirrorball::testing
