#include "mirrorball/render/prefilter_cache.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include <xxhash.h>

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

constexpr int kKeyDigits = 32;
constexpr const char* kExtension = ".ktx2";

fs::path chainPath(const fs::path& folder, const std::string& key) { return folder / (key + "-chain" + kExtension); }
fs::path irradiancePath(const fs::path& folder, const std::string& key) {
  return folder / (key + "-irradiance" + kExtension);
}

/// Whether it is one of the two files above: whatever else lies in the folder is not touched.
bool isOurs(const fs::path& path) {
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

}  // namespace

std::optional<PrefilterCache> PrefilterCache::ofUser() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::optional<std::string>() : std::string(value);
  };
  if (const auto folder = variable("MIRRORBALL_CACHE"))
    return folder->empty() ? std::nullopt : std::optional(PrefilterCache(*folder));
  if (const auto folder = variable("XDG_CACHE_HOME"); folder && fs::path(*folder).is_absolute())
    return PrefilterCache(fs::path(*folder) / "mirrorball");
  if (const auto home = variable("HOME"); home && !home->empty())
    return PrefilterCache(fs::path(*home) / ".cache" / "mirrorball");
  return {};
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
  std::error_code status;
  fs::create_directories(folder_, status);
  if (status) return;
  // What cannot be written is not kept.
  static_cast<void>(writeImageSet(irradiancePath(folder_, key), prefiltered.irradiance, {.format = format}));
  static_cast<void>(writeImageSet(chainPath(folder_, key), prefiltered.chain, {.format = format}));
  dropOldest();
}

void PrefilterCache::dropOldest() const {
  struct Kept {
    fs::file_time_type used;
    fs::path path;
    std::uintmax_t bytes;
  };
  std::vector<Kept> all;
  std::uintmax_t bytes = 0;
  std::error_code status;
  for (fs::directory_iterator entry(folder_, status), end; !status && entry != end; entry.increment(status)) {
    if (!isOurs(entry->path())) continue;
    all.push_back({entry->last_write_time(status), entry->path(), entry->file_size(status)});
    bytes += all.back().bytes;
  }
  std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
  for (const Kept& kept : all) {
    if (bytes <= most_bytes_) return;
    fs::remove(kept.path, status);
    bytes -= kept.bytes;
  }
}

}  // namespace mirrorball
