#include "mirrorball/base/cache_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string_view>

#include <sys/stat.h>
#include <unistd.h>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/environment_variable.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/range.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Behind the key, in the order of CachedKind.
constexpr std::array<std::string_view, 3> kEndings{"-chain.ktx2", "-irradiance.ktx2", "-occlusion.bin"};

/// Whether it is a key with one of these endings, or a file that is not finished: whatever else lies in the folder is
/// not touched.
bool isOurs(const fs::path& path) {
  if (isPartName(path.filename())) return true;
  const std::string name = path.filename().string();
  const auto isDigit = [](unsigned char letter) { return std::isxdigit(letter) != 0; };
  if (name.size() <= ContentHash::kDigits ||
      !std::all_of(name.begin(), name.begin() + std::ptrdiff_t{ContentHash::kDigits}, isDigit))
    return false;
  return contains(kEndings, std::string_view(name).substr(ContentHash::kDigits));
}

std::optional<fs::path> folderOfUser() {
  if (const auto folder = environmentVariable("MIRRORBALL_CACHE"))
    return folder->empty() ? std::nullopt : std::optional<fs::path>(*folder);
  if (const auto folder = environmentVariable("XDG_CACHE_HOME"); folder && fs::path(*folder).is_absolute())
    return fs::path(*folder) / "mirrorball";
  if (const auto home = environmentVariable("HOME"); home && !home->empty())
    return fs::path(*home) / ".cache" / "mirrorball";
  return {};
}

using Digits = std::array<char, ContentHash::kDigits>;

Digits digitsOf(const std::string& written) {
  Digits digits{};
  std::copy_n(written.begin(), std::min(written.size(), digits.size()), digits.begin());
  return digits;
}

/// What a file ends with. Its numbers are as this machine has them: on another one they are not those that are
/// expected, and the file is made again.
struct Seal {
  std::array<char, 8> magic{'M', 'B', 's', 'e', 'a', 'l', '\r', '\n'};
  std::uint32_t version = 1;
  CachedKind kind = {};
  Digits key{};
  Digits checksum{};  ///< of all that stands before

  bool operator==(const Seal&) const = default;
};
static_assert(sizeof(Seal) == 16 + 2 * ContentHash::kDigits, "nothing lies between its members");

/// What the bytes that a file begins with are sealed by; nothing: they cannot be read.
template <typename File>
std::optional<Seal> sealOf(const File& file, std::uint64_t size, const std::string& key, CachedKind kind) {
  ContentHash content;
  Bytes piece(std::size_t(std::min<std::uint64_t>(size, 1u << 20u)));
  for (std::uint64_t at = 0; at < size; at += piece.size()) {
    piece.resize(std::size_t(std::min<std::uint64_t>(piece.size(), size - at)));
    const auto count = file.readAt(at, piece);
    if (!count || *count != piece.size()) return {};
    content.addAll(std::span<const std::uint8_t>(piece));
  }
  return Seal{.kind = kind, .key = digitsOf(key), .checksum = digitsOf(content.digits())};
}

Result<void> writeSealed(const fs::path& path, const std::string& key, CachedKind kind,
                         const std::function<Result<void>(const FileWriter&)>& write) {
  MIRRORBALL_TRY(writer, FileWriter::create(path, Links::refuse));
  MIRRORBALL_TRY_VOID(write(writer));
  MIRRORBALL_TRY(size, writer.size());
  const std::optional<Seal> seal = sealOf(writer, size, key, kind);
  if (!seal) return fail(ErrorCode::io, path.string() + ": cannot be read again");
  MIRRORBALL_TRY_VOID(writer.writeAt(size, bytesOf(std::span<const Seal>(&*seal, 1))));
  return writer.commit();
}

}  // namespace

Result<std::optional<CacheFolder>> CacheFolder::ofUser() {
  const std::optional<fs::path> folder = folderOfUser();
  if (!folder) return std::nullopt;
  const auto written = environmentVariable("MIRRORBALL_CACHE_SIZE");
  if (!written || written->empty()) return CacheFolder(*folder);
  if (*written == "0") return CacheFolder(*folder, 0);
  const auto bytes = parseBytes(*written);
  if (!bytes) return fail(ErrorCode::usage, "MIRRORBALL_CACHE_SIZE: " + bytes.error().message);
  return CacheFolder(*folder, *bytes);
}

fs::path CacheFolder::pathOf(const std::string& key, CachedKind kind) const {
  return folder_ / (key + std::string(kEndings[static_cast<std::size_t>(kind)]));
}

Result<void> CacheFolder::check() const {
  struct stat status {};
  if (::stat(folder_.c_str(), &status) != 0) return {};  // it will be ours
  constexpr mode_t kWritableByOthers = S_IWGRP | S_IWOTH;
  if (status.st_uid != ::geteuid())
    return fail(ErrorCode::io, folder_.string() + ": is another user's, so nothing is cached there; name one of your " +
                                   "own in MIRRORBALL_CACHE");
  if ((status.st_mode & kWritableByOthers) != 0)
    return fail(ErrorCode::io, folder_.string() + ": others may write there, so nothing is cached; chmod 700 it");
  return {};
}

/// Makes the folder, if there is none.
///
/// returns  whether it can be used
bool CacheFolder::make() const {
  std::error_code status;
  if (const fs::path parent = folder_.parent_path(); !parent.empty()) fs::create_directories(parent, status);
  static_cast<void>(::mkdir(folder_.c_str(), S_IRWXU));  // which fails where it is
  return fs::is_directory(folder_, status) && check();
}

void CacheFolder::keep(const std::string& key, CachedKind kind,
                       const std::function<Result<void>(const FileWriter&)>& write) const {
  if (max_bytes_ == 0 || !make()) return;
  static_cast<void>(writeSealed(pathOf(key, kind), key, kind, write));  // what cannot be written is not kept
  dropOldest();
}

std::optional<CachedContent> CacheFolder::open(const std::string& key, CachedKind kind) const {
  if (!check()) return {};
  auto file = FileReader::open(pathOf(key, kind), Links::refuse);
  if (!file || file->size() < sizeof(Seal)) return {};
  const std::uint64_t size = file->size() - sizeof(Seal);
  Seal seal;
  const auto count = file->readAt(size, {reinterpret_cast<std::uint8_t*>(&seal), sizeof(Seal)});
  if (!count || *count != sizeof(Seal) || seal != sealOf(*file, size, key, kind)) return {};
  return CachedContent{std::move(*file), size};
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
