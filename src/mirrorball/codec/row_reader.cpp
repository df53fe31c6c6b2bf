#include "mirrorball/codec/row_reader.h"

#include <algorithm>
#include <array>

#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_rows.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/hdr/hdr_rows.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {

Result<std::unique_ptr<RowReader>> openRows(const std::filesystem::path& path) {
  const std::string name = path.string();
  MIRRORBALL_TRY(file, FileReader::open(path));
  std::array<std::uint8_t, 16> magic{};
  MIRRORBALL_TRY(count, file.readAt(0, magic));
  const auto begin = std::span<const std::uint8_t>(magic).first(count);
  return withinMemory<std::unique_ptr<RowReader>>(name, [&]() -> Result<std::unique_ptr<RowReader>> {
    if (isExr(begin)) return openExrRows(std::move(file), name);
    if (isHdr(begin)) return openHdrRows(std::move(file), name);
    return nullptr;
  });
}

}  // namespace mirrorball
