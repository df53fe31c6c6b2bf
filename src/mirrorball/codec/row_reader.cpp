#include "mirrorball/codec/row_reader.h"

#include <array>

#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

Result<std::unique_ptr<RowReader>> rowsOf(FileReader file, const ImageReadOptions& options) {
  std::array<std::uint8_t, 16> magic{};
  MIRRORBALL_TRY(count, file.readAt(0, magic));
  const auto begin = std::span<const std::uint8_t>(magic).first(count);
  MIRRORBALL_TRY(codec, FormatRegistry::ofThisBuild().codecFor(begin));
  return codec && codec->open_rows ? codec->open_rows(std::move(file), options) : nullptr;
}

}  // namespace

Result<void> RowReader::survey() {
  if (is_surveyed_) return {};
  MIRRORBALL_TRY_VOID(withName(description_.name, surveyFile(description_.oddities)));
  is_surveyed_ = true;
  return {};
}

Result<Image> RowReader::read(int count) {
  MIRRORBALL_TRY_VOID(survey());
  MIRRORBALL_TRY(rows, withName(description_.name, readRows(next_row_, count)));
  next_row_ += count;
  return std::move(rows);
}

Result<std::unique_ptr<RowReader>> openRows(const std::filesystem::path& path, const ImageReadOptions& options) {
  MIRRORBALL_TRY(file, FileReader::open(path));
  return withName(path.string(),
                  withinMemory<std::unique_ptr<RowReader>>([&] { return rowsOf(std::move(file), options); }));
}

}  // namespace mirrorball
