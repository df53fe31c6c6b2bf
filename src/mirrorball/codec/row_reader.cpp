#include "mirrorball/codec/row_reader.h"

#include <algorithm>
#include <array>

#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_rows.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/hdr/hdr_rows.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

Result<std::unique_ptr<RowReader>> rowsOf(FileReader file) {
  std::array<std::uint8_t, 16> magic{};
  MIRRORBALL_TRY(count, file.readAt(0, magic));
  const auto begin = std::span<const std::uint8_t>(magic).first(count);
  if (isExr(begin)) return openExrRows(std::move(file));
  if (isHdr(begin)) return openHdrRows(std::move(file));
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<RowReader>> openRows(const std::filesystem::path& path) {
  MIRRORBALL_TRY(file, FileReader::open(path));
  return withName(path.string(), withinMemory<std::unique_ptr<RowReader>>([&] { return rowsOf(std::move(file)); }));
}

}  // namespace mirrorball
