#include "mirrorball/scene/model_files.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

bool isLetter(char letter) { return std::isalpha(static_cast<unsigned char>(letter)) != 0; }

/// Whether a name begins at a root: of Unix, of Windows ("C:\…", "\\server\…"), or as an address of this machine.
bool beginsAtRoot(std::string_view name) {
  constexpr std::string_view kScheme = "file:";
  const bool is_address =
      std::equal(kScheme.begin(), kScheme.end(), name.begin(), name.begin() + std::min(name.size(), kScheme.size()),
                 [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
  const bool has_drive = name.size() > 2 && isLetter(name[0]) && name[1] == ':' && (name[2] == '/' || name[2] == '\\');
  return is_address || has_drive || name.starts_with('/') || name.starts_with('\\');
}

/// Why a name is none of a file that may be read, wherever it lies.
Result<void> checkName(std::string_view name) {
  if (name.empty()) return fail(ErrorCode::bad_file, "names no file");
  if (name.find('\0') != std::string_view::npos) return fail(ErrorCode::bad_file, "has a NUL in it, as no file's name");
  if (beginsAtRoot(name))
    return fail(ErrorCode::unsupported, "is no path from the model's folder; put the file beside the model");
  if (name.find("://") != std::string_view::npos)
    return fail(ErrorCode::unsupported, "lies in a network; fetch it and put it beside the model");
  return {};
}

}  // namespace

ModelFiles::ModelFiles(const fs::path& model, const ModelLoadOptions& options)
    : model_(model.string()), folder_(model.parent_path()), options_(options) {
  std::error_code status;
  true_folder_ = fs::weakly_canonical(fs::absolute(model, status).parent_path(), status);
}

bool ModelFiles::isOutside(const fs::path& file) const {
  const auto [folder, rest] = std::mismatch(true_folder_.begin(), true_folder_.end(), file.begin(), file.end());
  return folder != true_folder_.end();
}

Result<fs::path> ModelFiles::find(const std::string& name) {
  MIRRORBALL_TRY_VOID(checkName(name));
  std::error_code status;
  const fs::path file = fs::weakly_canonical(fs::absolute(folder_ / name, status), status);
  // Before it is asked whether there is such a file, which would be to learn something.
  if (options_.inside_only && (status || isOutside(file)))
    return fail(ErrorCode::unsupported,
                "lies outside of the model's folder, where nothing is to be read; put the file into the folder");
  if (status || !fs::exists(file, status)) return fail(ErrorCode::bad_file, "is missing; put it beside the model");
  if (!fs::is_regular_file(file, status))
    return fail(ErrorCode::bad_file, "is no regular file; put a file beside the model");
  return file;
}

Result<std::span<const std::uint8_t>> ModelFiles::read(const fs::path& file) {
  if (const auto found = contents_.find(file); found != contents_.end())
    return std::span<const std::uint8_t>(found->second);
  MemoryShare share(budget_);
  MIRRORBALL_TRY(bytes, readFile(file));
  MIRRORBALL_TRY_VOID(share.keep(bytes.size()));
  return std::span<const std::uint8_t>(contents_[file] = std::move(bytes));
}

std::vector<std::string> ModelFiles::files() const {
  std::vector<std::string> names;
  for (const auto& [file, bytes] : contents_) names.push_back(file.string());
  return names;
}

std::string ModelFiles::remarkOnOutside() const {
  std::vector<std::string> outside;
  for (const auto& [file, bytes] : contents_)
    if (isOutside(file)) outside.push_back(file.string());
  if (outside.empty()) return {};
  return model_ + ": " + countedAre(outside.size(), "file") + " read that it names outside of its folder" +
         (outside.size() > 1 ? ", the first " : ": ") + excerpt(outside.front());
}

void tellOfFiles(const ModelFiles& files, Scene& scene) {
  scene.files = files.files();
  if (std::string remark = files.remarkOnOutside(); !remark.empty()) scene.warnings.push_back(std::move(remark));
}

}  // namespace mirrorball
