#include "mirrorball/codec/hdr/hdr_rows.h"

#include <algorithm>
#include <vector>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/hdr/hdr_lines.h"

namespace mirrorball {
namespace {

/// Room for any real header.
constexpr std::uint64_t kMaxHeaderBytes = std::uint64_t{1} << 16;

/// Where the scan lines of a file begin, and how many of them are new RLE.
struct FileLines {
  std::vector<std::uint64_t> offsets;  ///< of those that are whole, and behind the last of them
  std::size_t new_rle_count = 0;

  std::size_t count() const { return offsets.size() - 1; }
};

/// Walks through the file once, so that what is missing of it is known before any line is decoded.
///
/// errors   io; bad_file; too_large: there are too many lines
Result<FileLines> findLines(const FileReader& file, const HdrHeader& header) {
  constexpr std::uint64_t kUsualBlock = std::uint64_t{1} << 22;
  MIRRORBALL_TRY_VOID(checkMemory(sizeof(std::uint64_t) * header.lineCount()));
  FileLines lines{{header.size}};
  lines.offsets.reserve(header.lineCount() + 1);
  Bytes bytes;
  for (std::uint64_t block = kUsualBlock; lines.count() < header.lineCount();) {
    const std::uint64_t at = lines.offsets.back();
    const std::uint64_t left = file.size() - at;
    bytes.resize(static_cast<std::size_t>(std::min(left, block)));
    MIRRORBALL_TRY_VOID(file.readAt(at, bytes));
    MIRRORBALL_TRY(index, indexLines(bytes, 0, header, lines.count(), header.lineCount() - lines.count(), at));
    if (index.starts.empty()) {
      if (block >= left) break;
      block *= 2;  // the line is longer
      continue;
    }
    for (std::size_t i = 1; i < index.starts.size(); ++i) lines.offsets.push_back(at + index.starts[i]);
    lines.offsets.push_back(at + index.end);
    lines.new_rle_count += index.new_rle_count;
    block = kUsualBlock;
  }
  return lines;
}

class HdrRows : public RowReader {
 public:
  HdrRows(FileReader file, HdrHeader header)
      : RowReader({.name = file.name(),
                   .width = header.width,
                   .height = header.height,
                   .metadata = header.metadata,
                   .oddities = header.oddities}),
        file_(std::move(file)),
        header_(std::move(header)) {}

 private:
  Result<void> surveyFile(std::vector<std::string>& oddities) override;
  Result<Image> readRows(int first, int count) override;

  FileReader file_;
  HdrHeader header_;
  std::vector<std::uint64_t> offsets_ = {};  ///< FileLines::offsets, once it is surveyed
};

Result<void> HdrRows::surveyFile(std::vector<std::string>& oddities) {
  MIRRORBALL_TRY(lines, findLines(file_, header_));
  MIRRORBALL_TRY(remark, missingLinesRemark(header_, lines.count(), lines.new_rle_count, file_.size()));
  if (!remark.empty()) oddities.push_back(std::move(remark));
  offsets_ = std::move(lines.offsets);
  return {};
}

Result<Image> HdrRows::readRows(int first, int count) {
  const std::size_t there = offsets_.size() - 1;
  const std::size_t begin = std::min(static_cast<std::size_t>(first), there);
  const std::size_t end = std::min(begin + static_cast<std::size_t>(count), there);
  Bytes bytes(static_cast<std::size_t>(offsets_[end] - offsets_[begin]));
  MIRRORBALL_TRY_VOID(file_.readAt(offsets_[begin], bytes));
  // Of a file that has changed since, fewer lines may be whole.
  MIRRORBALL_TRY(index, indexLines(bytes, 0, header_, begin, end - begin, offsets_[begin]));
  Image rows = Image::withoutValues(header_.width, count, 3);
  decodeLines(bytes, index, header_, rows);
  convertToRec709(rows, header_);
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
