#include "cli/files.h"

#include <filesystem>

namespace mirrorball::cli {

Result<void> refuseOverwriting(std::span<const std::string> inputs, std::span<const std::string> outputs) {
  std::error_code missing;
  for (const std::string& output : outputs)
    for (const std::string& input : inputs)
      if (std::filesystem::equivalent(input, output, missing))
        return fail(ErrorCode::usage, output + ": is the input itself; give -o another name");
  return {};
}

Result<void> checkFolder(const std::string& output) {
  if (output.empty()) return fail(ErrorCode::usage, "the output has no name: -o FILE");
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  std::error_code status;
  if (folder.empty() || std::filesystem::is_directory(folder, status)) return {};
  return fail(ErrorCode::io, output + ": cannot be written; check that the folder exists");
}

bool isFolder(const std::string& output) {
  std::error_code status;
  return output.ends_with('/') || std::filesystem::is_directory(output, status);
}

Result<void> makeFolder(const std::string& folder) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  if (status) return fail(ErrorCode::io, folder + ": cannot be made: " + status.message());
  return {};
}

Result<OutputFolder> OutputFolder::make(const std::string& folder) {
  std::error_code status;
  std::string made;
  for (std::filesystem::path above = folder; !above.empty() && !std::filesystem::exists(above, status);
       above = above.parent_path())
    made = above.string();
  OutputFolder output(std::move(made));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  return output;
}

OutputFolder::~OutputFolder() {
  std::error_code status;
  if (isNew()) std::filesystem::remove_all(made_, status);
}

std::string suffixed(const std::string& path, const std::string& suffix) {
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + suffix + whole.extension().string())).string();
}

}  // namespace mirrorball::cli
