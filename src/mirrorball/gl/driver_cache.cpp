#include "mirrorball/gl/driver_cache.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include <pwd.h>
#include <unistd.h>

#include "mirrorball/base/environment_variable.h"

namespace mirrorball::gl {
namespace {

namespace fs = std::filesystem;

/// One that is not set counts as empty.
std::string variable(const char* name) { return environmentVariable(name).value_or(""); }

bool isYes(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char letter) { return std::tolower(letter); });
  constexpr std::array<std::string_view, 5> kYes{"1", "t", "true", "y", "yes"};
  return std::find(kYes.begin(), kYes.end(), word) != kYes.end();
}

/// Those that are there, else the first.
std::vector<fs::path> thoseThere(const std::vector<fs::path>& candidates) {
  std::vector<fs::path> there;
  std::error_code status;
  for (const fs::path& folder : candidates)
    if (fs::is_directory(folder, status)) there.push_back(folder);
  if (there.empty() && !candidates.empty()) there.push_back(candidates.front());
  return there;
}

/// The home that the user database has, whatever HOME says; empty: it has none.
fs::path findUsersHome() {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  std::vector<char> texts(1024);
  for (;;) {
    passwd entry{};
    passwd* found = nullptr;
    const int error = ::getpwuid_r(::getuid(), &entry, texts.data(), texts.size(), &found);
    if (error != ERANGE || texts.size() >= kMostBytes) return found == nullptr ? fs::path() : fs::path(found->pw_dir);
    texts.resize(2 * texts.size());
  }
}

/// The folder that Mesa puts its own into.
fs::path folderAboveMesas() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "XDG_CACHE_HOME"})
    if (const std::string folder = variable(name); !folder.empty()) return folder;
  const fs::path home = findUsersHome();
  return home.empty() ? home : home / ".cache";
}

/// Mesa has three kinds of files, each in a folder of its own; which is the usual one depends on its version.
DriverCache ofMesa() {
  constexpr const char* kSwitch = "MESA_SHADER_CACHE_DISABLE";
  const std::string written = variable(kSwitch);
  const bool is_off = isYes(written.empty() ? variable("MESA_GLSL_CACHE_DISABLE") : written);  // its older name
  const fs::path above = folderAboveMesas();
  std::vector<fs::path> folders{above / "mesa_shader_cache", above / "mesa_shader_cache_db",
                                above / "mesa_shader_cache_sf"};
  if (isYes(variable("MESA_DISK_CACHE_DATABASE"))) std::swap(folders[0], folders[1]);
  if (isYes(variable("MESA_DISK_CACHE_SINGLE_FILE"))) std::swap(folders[0], folders[2]);
  return {thoseThere(folders), !is_off, kSwitch};
}

DriverCache ofNvidia() {
  constexpr const char* kSwitch = "__GL_SHADER_DISK_CACHE";
  std::vector<fs::path> folders;
  if (const std::string folder = variable("__GL_SHADER_DISK_CACHE_PATH"); !folder.empty()) {
    folders = {fs::path(folder) / "GLCache"};
  } else {
    const std::string of_caches = variable("XDG_CACHE_HOME");
    const fs::path home = variable("HOME");
    const fs::path caches = of_caches.empty() ? home / ".cache" : fs::path(of_caches);
    folders = {caches / "nvidia" / "GLCache", home / ".nv" / "GLCache"};
  }
  const std::string written = variable(kSwitch);
  std::optional<bool> is_on;  // for root, older drivers keep nothing unless it is on
  if (!written.empty() || ::geteuid() != 0) is_on = written != "0";
  return {thoseThere(folders), is_on, kSwitch};
}

}  // namespace

std::optional<DriverCache> findDriverCache(const std::string& version) {
  if (version.find("Mesa ") != std::string::npos) return ofMesa();
  if (version.find("NVIDIA ") != std::string::npos) return ofNvidia();
  return {};
}

CacheFolder::Contents DriverCache::contents() const {
  CacheFolder::Contents found;
  for (const fs::path& folder : folders) {
    std::error_code status;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, status);
    for (const fs::recursive_directory_iterator end; !status && entry != end; entry.increment(status)) {
      std::error_code gone;
      if (!entry->is_regular_file(gone) || gone) continue;
      const std::uintmax_t bytes = entry->file_size(gone);
      if (!gone) found = {found.files + 1, found.bytes + bytes};
    }
  }
  return found;
}

}  // namespace mirrorball::gl
