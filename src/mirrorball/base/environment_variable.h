#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace mirrorball {

/// What an environment variable says; nothing where it is not set.
inline std::optional<std::string> environmentVariable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::optional<std::string>() : std::string(value);
}

}  // namespace mirrorball
