#include "mirrorball/codec/hdr/hdr_rows.h"

#include <algorithm>

#include "mirrorball/codec/hdr/hdr_lines.h"

namespace mirrorball {
namespace {

/// Room for any real header.
constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 16;

class HdrRows : public RowReader {
 public:
  HdrRows(FileReader file, HdrHeader header)
      : RowReader({.name = file.name(),
                   .width = header.width,
                   .height = header.height,
                   .metadata = header.metadata,
                   .oddities = header.oddities}),
        file_(std::move(file)),
        header_(std::move(header)),
        next_byte_(header_.size) {}

 private:
  Result<Image> readRows(int count) override;

  FileReader file_;
  HdrHeader header_;
  std::uint64_t next_byte_;  // of the file, where line `next_` begins
  std::size_t next_ = 0;
};

Result<Image> HdrRows::readRows(int count) {
  const auto lines = static_cast<std::size_t>(count);
  const std::uint64_t left = file_.size() - next_byte_;
  // Lines are rarely longer than flat ones: only where they are, more bytes are read and looked through once more.
  const auto at_most = [&](std::uint64_t size) { return static_cast<std::size_t>(std::min(left, size)); };
  Bytes bytes(at_most((4 * header_.lineLength() + 4 * header_.lineLength() / 128 + 64) * lines));
  MIRRORBALL_TRY_VOID(file_.readAt(next_byte_, bytes));
  auto index = indexLines(bytes, 0, header_, next_, lines, next_byte_);
  if (!index && bytes.size() < left) {
    bytes.resize(at_most(longestLine(header_.lineLength()) * lines));
    MIRRORBALL_TRY_VOID(file_.readAt(next_byte_, bytes));
    index = indexLines(bytes, 0, header_, next_, lines, next_byte_);
  }
  if (!index) return tl::unexpected<Error>(index.error());
  Image rows = Image::withoutValues(header_.width, count, 3);
  decodeLines(bytes, *index, header_, rows);
  convertToRec709(rows, header_);
  next_byte_ += index->end;
  next_ += lines;
  return rows;
}

}  // namespace

Result<std::unique_ptr<RowReader>> openHdrRows(FileReader file) {
  Bytes begin(static_cast<std::size_t>(std::min<std::uint64_t>(file.size(), kMaxHeaderBytes)));
  MIRRORBALL_TRY_VOID(file.readAt(0, begin));
  MIRRORBALL_TRY(header, parseHdrHeader(begin));
  if (header.columns || header.x_descends || header.y_ascends) return nullptr;
  MIRRORBALL_TRY_VOID(checkLineBytes(header, file.size() - header.size));
  return std::make_unique<HdrRows>(std::move(file), std::move(header));
}

}  // namespace mirrorball
