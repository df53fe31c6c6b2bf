#include "mirrorball/codec/exr/exr_missing_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <Iex.h>
#include <ImfCompression.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>

#include "mirrorball/codec/byte_order.h"

namespace mirrorball {
namespace {

/// Where a chunk lies in its part.
struct ExrChunk {
  int part = 0;
  std::int64_t row = 0;    ///< of scan lines the first, in the display's coordinates; of tiles, which row of them
  bool is_largest = true;  ///< not of a smaller level
};

/// Reads what chunks begin with, each number of it little-endian.
class ChunkWalker {
 public:
  ChunkWalker(Imf::IStream& stream, const Imf::MultiPartInputFile& file, std::uint64_t first_chunk,
              std::uint64_t file_size)
      : stream_(stream),
        file_(file),
        is_multi_part_(Imf::isMultiPart(file.version())),
        at_(first_chunk),
        file_size_(file_size) {}

  /// The next chunk; nothing where it is not whole.
  std::optional<ExrChunk> next() {
    try {
      stream_.seekg(at_);
      ExrChunk chunk;
      if (is_multi_part_) chunk.part = number();
      if (chunk.part < 0 || chunk.part >= file_.parts()) return std::nullopt;
      const Imf::Header& header = file_.header(chunk.part);
      if (isTiledPart(file_, chunk.part)) {
        number();  // which of its row
        chunk.row = number();
        const int level_x = number();
        const int level_y = number();
        chunk.is_largest = level_x == 0 && level_y == 0;
      } else {
        chunk.row = number();
      }
      return skipData(header.hasType() && Imf::isDeepData(header.type())) ? std::optional(chunk) : std::nullopt;
    } catch (const Iex::InputExc&) {
      return std::nullopt;  // the file ends
    }
  }

 private:
  int number() {
    std::array<char, 4> bytes{};
    stream_.read(bytes.data(), static_cast<int>(bytes.size()));
    return static_cast<std::int32_t>(littleU32(reinterpret_cast<const std::uint8_t*>(bytes.data())));
  }

  std::uint64_t largeNumber() {
    const auto low = static_cast<std::uint32_t>(number());
    return std::uint64_t{static_cast<std::uint32_t>(number())} << 32 | low;
  }

  /// Passes over the samples.
  ///
  /// returns  whether the file has all of them
  bool skipData(bool is_deep) {
    std::uint64_t size = 0;
    if (is_deep) {
      size = largeNumber();  // of the table of samples in each texel
      const std::uint64_t samples = largeNumber();
      largeNumber();  // as they are unpacked
      if (size > file_size_ || samples > file_size_) return false;
      size += samples;
    } else {
      size = static_cast<std::uint32_t>(number());
    }
    const std::uint64_t begin = stream_.tellg();
    if (begin > file_size_ || size > file_size_ - begin) return false;
    at_ = begin + size;
    return true;
  }

  Imf::IStream& stream_;
  const Imf::MultiPartInputFile& file_;
  bool is_multi_part_;
  std::uint64_t at_;
  std::uint64_t file_size_;
};

}  // namespace

bool isTiledPart(const Imf::MultiPartInputFile& file, int part) {
  const Imf::Header& header = file.header(part);
  return header.hasType() ? Imf::isTiled(header.type()) : Imf::isTiled(file.version());
}

int rowsInExrChunk(const Imf::MultiPartInputFile& file, int part) {
  const Imf::Header& header = file.header(part);
  const Imath::Box2i& window = header.dataWindow();
  const int height = window.max.y - window.min.y + 1;
  if (isTiledPart(file, part))
    return static_cast<int>(std::min(header.tileDescription().ySize, static_cast<unsigned>(height)));
  constexpr std::array<int, 10> kLines{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // of each compression
  const auto compression = static_cast<std::size_t>(header.compression());
  return compression < kLines.size() ? kLines[compression] : 1;
}

std::vector<std::uint8_t> missingExrRows(Imf::IStream& stream, const Imf::MultiPartInputFile& file, int part,
                                         std::uint64_t first_chunk, std::uint64_t file_size) {
  const Imf::Header& header = file.header(part);
  const Imath::Box2i& window = header.dataWindow();
  const auto height = std::int64_t{window.max.y} - window.min.y + 1;
  const std::int64_t rows = rowsInExrChunk(file, part);
  const bool is_tiled = isTiledPart(file, part);
  const std::int64_t across =
      is_tiled ? (std::int64_t{window.max.x} - window.min.x) / header.tileDescription().xSize + 1 : 1;
  std::vector<std::int64_t> there(static_cast<std::size_t>((height - 1) / rows + 1), 0);  // chunks beside each other
  ChunkWalker walker(stream, file, first_chunk, file_size);
  while (const auto chunk = walker.next()) {
    const std::int64_t row = is_tiled ? chunk->row * rows : chunk->row - window.min.y;
    if (chunk->part == part && chunk->is_largest && row >= 0 && row < height) ++there[std::size_t(row / rows)];
  }
  std::vector<std::uint8_t> is_missing(static_cast<std::size_t>(height));
  for (std::size_t row = 0; row < is_missing.size(); ++row)
    is_missing[row] = there[row / std::size_t(rows)] < across ? 1 : 0;
  return is_missing;
}

}  // namespace mirrorball
