#include "mirrorball/render/light/prefilter_cache.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include <xxhash.h>

#include "mirrorball/base/memory.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

constexpr int kKeyDigits = 32;
constexpr const char* kExtension = ".ktx2";

fs::path chainPath(const fs::path& folder, const std::string& key) { return folder / (key + "-chain" + kExtension); }
fs::path irradiancePath(const fs::path& folder, const std::string& key) {
  return folder / (key + "-irradiance" + kExtension);
}

/// Whether it is one of the two files above, or what is left of one that was never finished: whatever else lies in the
/// folder is not touched.
bool isOurs(fs::path path) {
  if (path.extension().string().starts_with(".part")) path.replace_extension();
  const std::string name = path.filename().string();
  const auto isDigit = [](unsigned char letter) { return std::isxdigit(letter) != 0; };
  if (name.size() <= kKeyDigits || !std::all_of(name.begin(), name.begin() + kKeyDigits, isDigit)) return false;
  const std::string key = name.substr(0, kKeyDigits);
  return path == chainPath(path.parent_path(), key) || path == irradiancePath(path.parent_path(), key);
}

bool hasShape(const ImageSet& images, const std::vector<int>& sides) {
  if (images.faces() != 6 || images.layers() != 1 || images.levels() != static_cast<int>(sides.size())) return false;
  for (int level = 0; level < images.levels(); ++level) {
    const Image& image = images.at(level, 0);  // a file's faces are alike
    if (image.width() != sides[std::size_t(level)] || image.height() != image.width()) return false;
  }
  return true;
}

/// A cube that was kept, now the most recently used.
std::optional<ImageSet> read(const fs::path& path, const std::vector<int>& sides) {
  std::error_code status;
  if (!fs::exists(path, status)) return {};
  auto decoded = readImageSet(path);
  if (!decoded || !hasShape(decoded->images, sides)) return {};
  fs::last_write_time(path, fs::file_time_type::clock::now(), status);
  return std::move(decoded->images);
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

Result<std::optional<PrefilterCache>> PrefilterCache::ofUser() {
  const std::optional<fs::path> folder = folderOfUser();
  if (!folder) return std::nullopt;
  const auto written = variable("MIRRORBALL_CACHE_SIZE");
  if (!written || written->empty()) return PrefilterCache(*folder);
  if (*written == "0") return PrefilterCache(*folder, 0);
  const auto bytes = parseBytes(*written);
  if (!bytes) return fail(ErrorCode::usage, "MIRRORBALL_CACHE_SIZE: " + bytes.error().message);
  return PrefilterCache(*folder, *bytes);
}

std::string PrefilterCache::keyOf(const ImageSet& cube) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  XXH3_128bits_reset_withSeed(state.get(), kVersion);
  const int side = cube.at(0, 0).width();
  XXH3_128bits_update(state.get(), &side, sizeof side);
  for (int face = 0; face < cube.faces(); ++face) {
    const std::span<const float> samples = cube.at(0, face).samples();
    XXH3_128bits_update(state.get(), samples.data(), samples.size_bytes());
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  char digits[kKeyDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits;
}

std::optional<Prefiltered> PrefilterCache::find(const std::string& key, const PrefilteredShape& shape) const {
  std::optional<ImageSet> chain = read(chainPath(folder_, key), shape.chain);
  if (!chain) return {};
  std::optional<ImageSet> irradiance = read(irradiancePath(folder_, key), shape.irradiance);
  if (!irradiance) return {};
  return Prefiltered{std::move(*chain), std::move(*irradiance)};
}

void PrefilterCache::keep(const std::string& key, const Prefiltered& prefiltered, TexelFormat format) const {
  if (max_bytes_ == 0) return;
  std::error_code status;
  fs::create_directories(folder_, status);
  if (status) return;
  // What cannot be written is not kept.
  static_cast<void>(writeImageSet(irradiancePath(folder_, key), prefiltered.irradiance, {.format = format}));
  static_cast<void>(writeImageSet(chainPath(folder_, key), prefiltered.chain, {.format = format}));
  dropOldest();
}

std::vector<PrefilterCache::Kept> PrefilterCache::kept() const {
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

PrefilterCache::Contents PrefilterCache::contents() const {
  Contents contents;
  for (const Kept& file : kept()) contents = {contents.files + 1, contents.bytes + file.bytes};
  return contents;
}

Result<PrefilterCache::Contents> PrefilterCache::clear() const {
  Contents removed;
  for (const Kept& file : kept()) {
    std::error_code status;
    fs::remove(file.path, status);
    if (status) return fail(ErrorCode::io, file.path.string() + ": cannot be removed: " + status.message());
    removed = {removed.files + 1, removed.bytes + file.bytes};
  }
  return removed;
}

void PrefilterCache::dropOldest() const {
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
