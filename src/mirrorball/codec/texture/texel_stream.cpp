#include "mirrorball/codec/texture/texel_stream.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {
namespace {

/// Texels are converted in pieces that stay in a core's cache until they are written.
constexpr std::size_t kBytesPerPiece = std::size_t{1} << 16;

/// So many pieces share one buffer.
constexpr std::size_t kPiecesPerBuffer = 16;

/// Compressing takes so long that a buffer for each piece does not count; and these are a few rows of blocks.
constexpr std::size_t kCompressedTexelsPerPiece = std::size_t{1} << 14;

/// Consecutive texels of one image, and whole rows of blocks where texels are compressed.
struct Piece {
  const PlacedImage* placed;
  std::size_t begin;
  std::size_t end;
};

std::vector<Piece> cutIntoPieces(const ImageSet& images, std::span<const PlacedImage> placed,
                                 const StoredFormat& format) {
  const auto side = static_cast<std::size_t>(blockSide(format));
  std::vector<Piece> pieces;
  for (const PlacedImage& image : placed) {
    const Image& source = images.at(image.level, image.face, image.layer);
    const std::size_t texels = source.texelCount();
    const std::size_t row_of_blocks = side * std::size_t(source.width());
    const std::size_t step = side == 1
                                 ? kBytesPerPiece / blockSize(format)
                                 : std::max<std::size_t>(kCompressedTexelsPerPiece / row_of_blocks, 1) * row_of_blocks;
    for (std::size_t begin = 0; begin < texels; begin += step)
      pieces.push_back({&image, begin, std::min(texels, begin + step)});
  }
  return pieces;
}

/// Bytes of an image's texels before one of them, which where they are compressed is the first of a row of blocks, or
/// the image's end.
std::size_t bytesBefore(const StoredFormat& format, const Image& image, std::size_t texel) {
  if (blockSide(format) == 1) return texel * blockSize(format);
  const std::size_t row = texel / std::size_t(image.width());
  return std::size_t(blocksAlong(format, row) * blocksAlong(format, std::uint64_t(image.width()))) * blockSize(format);
}

/// The error for the first texel of a piece that does not fit.
Error misfitOf(const ImageSet& images, const Piece& piece, TexelFormat format) {
  const PlacedImage& placed = *piece.placed;
  const Image& image = images.at(placed.level, placed.face, placed.layer);
  const std::size_t channels = std::size_t(image.channels());
  const std::size_t texel =
      piece.begin + firstMisfit(format, image.samples().subspan(piece.begin * channels), image.channels());
  const auto width = static_cast<std::size_t>(image.width());
  return misfit(format, placeName(shapeOf(images), placed.level, placed.layer, placed.face),
                glm::ivec2(texel % width, texel / width), image.samples().subspan(texel * channels, channels));
}

}  // namespace

Error misfit(TexelFormat format, const std::string& place, glm::ivec2 texel, std::span<const float> samples) {
  std::string value;
  for (const float sample : samples) value += (value.empty() ? "" : " ") + formatNumber(sample);
  return {ErrorCode::out_of_range,
          "texel (" + std::to_string(texel.x) + ", " + std::to_string(texel.y) + ") of " + place + " is " + value +
              ", but " + rangeOf(format) + "; scale the light",
          FixHint::store_floats};
}

Result<void> streamTexels(const ImageSet& images, std::span<const PlacedImage> placed, TexelFormat format,
                          const WriteAt& write, const ProgressFunction& progress) {
  const StoredFormat stored = storedFormat(format);
  const bool is_compressed = blockSide(stored) > 1;
  const std::vector<Piece> pieces = cutIntoPieces(images, placed, stored);

  std::mutex mutex;  // guards the two below
  std::size_t first_misfit = pieces.size();
  std::optional<Error> failure;
  ProgressCounter steps(progress, pieces.size());
  parallelFor(pieces.size(), is_compressed ? 1 : kPiecesPerBuffer, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> buffer;
    for (std::size_t i = begin; i < end && !steps.stopped(); ++i) {
      const Piece& piece = pieces[i];
      const Image& image = images.at(piece.placed->level, piece.placed->face, piece.placed->layer);
      const std::size_t channels = std::size_t(image.channels());
      buffer.resize(bytesBefore(stored, image, piece.end) - bytesBefore(stored, image, piece.begin));
      const bool fits =
          packTexels(format, image.samples().subspan(piece.begin * channels, (piece.end - piece.begin) * channels),
                     image.channels(), image.width(), buffer);
      const Result<void> written = write(piece.placed->offset + bytesBefore(stored, image, piece.begin), buffer);
      steps.advance();
      if (fits && written) continue;
      const std::lock_guard lock(mutex);
      if (!fits) first_misfit = std::min(first_misfit, i);
      if (!written) failure = written.error();
      return;
    }
  });
  MIRRORBALL_TRY_VOID(steps.result());
  if (failure) return tl::unexpected<Error>(std::move(*failure));
  if (first_misfit < pieces.size()) return tl::unexpected<Error>(misfitOf(images, pieces[first_misfit], format));
  return {};
}

}  // namespace mirrorball
