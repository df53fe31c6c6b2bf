#include "mirrorball/environment/file/header_size.h"

#include "mirrorball/codec/header_size.h"
#include "mirrorball/codec/row_reader.h"
#include "mirrorball/environment/file/photo_sphere.h"

namespace mirrorball {

std::optional<glm::ivec2> sizeInHeader(const std::filesystem::path& path) {
  const auto bytes = readEnds(path);
  if (!bytes) return std::nullopt;
  if (const auto size = sizeInHeader(std::span<const std::uint8_t>(*bytes))) return size;
  const auto rows = openRows(path);
  if (!rows || !*rows) return std::nullopt;
  return glm::ivec2((*rows)->description().width, (*rows)->description().height);
}

}  // namespace mirrorball
