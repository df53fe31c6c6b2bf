#include "cli/files.h"

#include <filesystem>

namespace mirrorball::cli {

Result<void> refuseOverwriting(const std::string& input, const std::string& output) {
  std::error_code missing;
  if (std::filesystem::equivalent(input, output, missing))
    return fail(ErrorCode::usage, output + ": is the input itself; give -o another name");
  return {};
}

std::string suffixed(const std::string& path, const std::string& suffix) {
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + suffix + whole.extension().string())).string();
}

}  // namespace mirrorball::cli
