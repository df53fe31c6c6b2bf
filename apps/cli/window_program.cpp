#include "cli/window_program.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace mirrorball::cli {

Result<void> becomeWindow(char* const* words) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed = self.parent_path() / "mirrorball-view";
  const std::filesystem::path built = self.parent_path().parent_path() / "window" / "mirrorball-view";
  for (const std::filesystem::path& program : {installed, built}) {
    if (!std::filesystem::exists(program, error)) continue;
    std::string name = program.string();
    std::vector<char*> arguments{name.data()};
    for (char* const* word = words; *word != nullptr; ++word) arguments.push_back(*word);
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
  }
  return fail(ErrorCode::not_found,
              "view: the window's program, mirrorball-view, is not beside this one; ./mirrorball view in the sources "
              "builds it");
}

}  // namespace mirrorball::cli
