#include "mirrorball/render/light/prefilter_cache.h"

#include <utility>

#include "mirrorball/base/content_hash.h"
#include "mirrorball/base/memory.h"

namespace mirrorball {
namespace {

/// Reads what was kept.
Result<ImageSet> imagesOf(const CachedContent& content) {
  MIRRORBALL_TRY_VOID(checkMemory(content.size));
  Bytes bytes(static_cast<std::size_t>(content.size));
  MIRRORBALL_TRY_VOID(content.file.readAt(0, bytes));
  MIRRORBALL_TRY(decoded, decodeImageSet(bytes));
  return std::move(decoded.images);
}

bool hasShape(const ImageSet& images, const std::vector<int>& sides) {
  if (images.faces() != 6 || images.layers() != 1 || images.levels() != static_cast<int>(sides.size())) return false;
  for (int level = 0; level < images.levels(); ++level) {
    const Image& image = images.at(level, 0);  // a file's faces are alike
    if (image.width() != sides[std::size_t(level)] || image.height() != image.width()) return false;
  }
  return true;
}

}  // namespace

std::string PrefilterCache::keyOf(const ImageSet& cube) {
  ContentHash hash(kVersion);
  hash.add(cube.at(0, 0).width());
  for (int face = 0; face < cube.faces(); ++face) hash.addAll(cube.at(0, face).samples());
  return hash.digits();
}

std::optional<Prefiltered> PrefilterCache::find(const std::string& key, const PrefilteredShape& shape) const {
  const auto read = [&](CachedKind kind, const std::vector<int>& sides) {
    return folder_.find(key, kind, [&](const CachedContent& content) -> std::optional<ImageSet> {
      Result<ImageSet> images = imagesOf(content);
      if (!images || !hasShape(*images, sides)) return {};
      return std::move(*images);
    });
  };
  std::optional<ImageSet> chain = read(CachedKind::prefiltered_chain, shape.chain);
  if (!chain) return {};
  std::optional<ImageSet> irradiance = read(CachedKind::irradiance, shape.irradiance);
  if (!irradiance) return {};
  return Prefiltered{std::move(*chain), std::move(*irradiance)};
}

void PrefilterCache::keep(const std::string& key, const Prefiltered& prefiltered, TexelFormat format) const {
  const auto write = [&](CachedKind kind, const ImageSet& images) {
    folder_.keep(key, kind, [&](const FileWriter& file) { return writeImageSet(file, images, {.format = format}); });
  };
  write(CachedKind::irradiance, prefiltered.irradiance);
  write(CachedKind::prefiltered_chain, prefiltered.chain);
}

}  // namespace mirrorball
