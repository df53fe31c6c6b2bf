#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mirrorball/base/cache_folder.h"

namespace mirrorball::gl {

/// Where a graphics driver keeps the shaders that it has compiled, for later processes. The folders are the driver's
/// own: it makes, limits and empties them.
struct DriverCache {
  std::vector<std::filesystem::path> folders;  ///< that are there; where none is, the one that it would make
  std::optional<bool> is_on;                   ///< nothing: it depends on the driver's version
  std::string switch_name;                     ///< the environment variable that turns it on or off

  /// The files in its folders and in all folders below them.
  CacheFolder::Contents contents() const;
};

/// What drivers say of it in their documentation: Mesa on its page "Environment Variables", NVIDIA in its driver's
/// README, "OpenGL Shader Disk Cache". By environment variables, as the driver reads them; what NVIDIA's profiles and
/// an X server's configuration say is not looked at.
///
/// version   of a context: Context::version()
/// returns   nothing: where this driver keeps its shaders is not known
std::optional<DriverCache> findDriverCache(const std::string& version);

}  // namespace mirrorball::gl
