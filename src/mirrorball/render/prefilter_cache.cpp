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

#include "mirrorball/codec/texture_file.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;

/// Goes up whenever prefiltering gives other values.
constexpr std::uint32_t kVersion = 3;
constexpr int kKeyDigits = 32;
constexpr const char* kExtension = ".ktx2";

/// kKeyDigits hexadecimal digits of the cube's texels and size.
std::string keyOf(const ImageSet& cube) {
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

/// A cube that was written by `write`, now the most recently used.
std::optional<ImageSet> read(const fs::path& path) {
  std::error_code status;
  if (!fs::exists(path, status)) return {};
  auto decoded = readImageSet(path);
  if (!decoded || decoded->images.faces() != 6) return {};
  fs::last_write_time(path, fs::file_time_type::clock::now(), status);
  return std::move(decoded->images);
}

void write(const fs::path& path, const ImageSet& images) {
  if (!writeImageSet(path, images, {.format = TexelFormat::half}))
    static_cast<void>(writeImageSet(path, images, {.format = TexelFormat::float32}));
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

std::optional<Prefiltered> PrefilterCache::find(const ImageSet& cube) const {
  const std::string key = keyOf(cube);
  std::optional<ImageSet> chain = read(chainPath(folder_, key));
  if (!chain) return {};
  std::optional<ImageSet> irradiance = read(irradiancePath(folder_, key));
  if (!irradiance) return {};
  return Prefiltered{std::move(*chain), std::move(*irradiance)};
}

void PrefilterCache::keep(const ImageSet& cube, const Prefiltered& prefiltered) const {
  std::error_code status;
  fs::create_directories(folder_, status);
  if (status) return;
  const std::string key = keyOf(cube);
  write(irradiancePath(folder_, key), prefiltered.irradiance);
  write(chainPath(folder_, key), prefiltered.chain);
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
