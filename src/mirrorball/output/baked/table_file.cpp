#include "mirrorball/output/baked/table_file.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball {
namespace {

/// Whether a file says near its beginning, where formats have their words, that it is a table.
bool saysThatItIsATable(const std::string& path) {
  constexpr std::size_t kBeginning = std::size_t{1} << 16;
  const auto file = FileReader::open(path);
  if (!file) return false;
  std::vector<std::uint8_t> bytes(std::min<std::uint64_t>(file->size(), kBeginning));
  if (!file->readAt(0, bytes)) return false;
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find(kTableKey) !=
         std::string_view::npos;
}

}  // namespace

Result<std::optional<TableFile>> tableFileIn(const std::string& path) {
  if (!saysThatItIsATable(path)) return std::nullopt;
  std::vector<std::uint8_t> begin(16);
  MIRRORBALL_TRY(file, FileReader::open(path));
  MIRRORBALL_TRY_VOID(file.readAt(0, begin));
  if (isImageSet(begin)) {
    MIRRORBALL_TRY(texture, readImageSet(path));
    return TableFile{std::move(texture.metadata), std::move(texture.format), std::move(texture.images.at(0, 0))};
  }
  MIRRORBALL_TRY(picture, readImage(path));
  return TableFile{std::move(picture.metadata), std::move(picture.format), std::move(picture.image)};
}

}  // namespace mirrorball
