#include "mirrorball/base/cache_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Behind the key, in the order of CachedKind.
constexpr std::array<std::string_view, 3> kEndings{"-chain.ktx2", "-irradiance.ktx2", "-occlusion.bin"};

/// Whether it is a key with one of these endings, or what is left of such a file that was never finished: whatever else
/// lies in the folder is not touched.
bool isOurs(fs::path path) {
  if (path.extension().string().starts_with(".part")) path.replace_extension();
  const std::string name = path.filename().string();
  const auto isDigit = [](unsigned char letter) { return std::isxdigit(letter) != 0; };
  if (name.size() <= ContentHash::kDigits ||
      !std::all_of(name.begin(), name.begin() + std::ptrdiff_t{ContentHash::kDigits}, isDigit))
    return false;
  return contains(kEndings, std::string_view(name).substr(ContentHash::kDigits));
}

std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::optional<std::string>() : std::string(value);
}

std::optional<fs::path> folderOfUser() {
  if (const auto folder = variable("MIRRORBALL_CACHE"))
    return folder->empty() ? std::nullopt : std::optional<fs::path>(*folder);
  if (const auto folder = variable("XDG_CACHE_HOME"); folder && fs::path(*folder).is_absolute())
    return fs::path(*folder) / "mirrorball";
  if (const auto home = variable("HOME"); home && !home->empty()) return fs::path(*home) / ".cache" / "mirrorball";
  return {};
}

}  // namespace

Result<std::optional<CacheFolder>> CacheFolder::ofUser() {
  const std::optional<fs::path> folder = folderOfUser();
  if (!folder) return std::nullopt;
  const auto written = variable("MIRRORBALL_CACHE_SIZE");
  if (!written || written->empty()) return CacheFolder(*folder);
  if (*written == "0") return CacheFolder(*folder, 0);
  const auto bytes = parseBytes(*written);
  if (!bytes) return fail(ErrorCode::usage, "MIRRORBALL_CACHE_SIZE: " + bytes.error().message);
  return CacheFolder(*folder, *bytes);
}

fs::path CacheFolder::pathOf(const std::string& key, CachedKind kind) const {
  return folder_ / (key + std::string(kEndings[static_cast<std::size_t>(kind)]));
}

void CacheFolder::keep(const std::string& key, CachedKind kind,
                       const std::function<Result<void>(const fs::path&)>& write) const {
  if (max_bytes_ == 0) return;
  std::error_code status;
  fs::create_directories(folder_, status);
  if (status) return;
  static_cast<void>(write(pathOf(key, kind)));  // what cannot be written is not kept
  dropOldest();
}

std::vector<CacheFolder::Kept> CacheFolder::kept() const {
  std::vector<Kept> all;
  std::error_code status;
  for (fs::directory_iterator entry(folder_, status), end; !status && entry != end; entry.increment(status)) {
    if (!isOurs(entry->path())) continue;
    std::error_code gone;
    const std::uintmax_t bytes = entry->file_size(gone);
    if (!gone) all.push_back({entry->last_write_time(gone), entry->path(), bytes});
  }
  return all;
}

CacheFolder::Contents CacheFolder::contents() const {
  Contents contents;
  for (const Kept& file : kept()) contents = {contents.files + 1, contents.bytes + file.bytes};
  return contents;
}

Result<CacheFolder::Contents> CacheFolder::clear() const {
  Contents removed;
  for (const Kept& file : kept()) {
    std::error_code status;
    fs::remove(file.path, status);
    if (status) return fail(ErrorCode::io, file.path.string() + ": cannot be removed: " + status.message());
    removed = {removed.files + 1, removed.bytes + file.bytes};
  }
  return removed;
}

void CacheFolder::dropOldest() const {
  std::vector<Kept> all = kept();
  std::uintmax_t bytes = 0;
  for (const Kept& file : all) bytes += file.bytes;
  std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& oldest : all) {
    if (bytes <= max_bytes_) return;
    std::error_code status;
    fs::remove(oldest.path, status);
    bytes -= oldest.bytes;
  }
}

}  // namespace mirrorball
