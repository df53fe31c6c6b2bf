#include "mirrorball/codec/texel_stream.h"

#include <algorithm>
#include <mutex>
#include <optional>

#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/stored_format.h"
#include "mirrorball/codec/texture_shape.h"

namespace mirrorball {
namespace {

/// Texels are converted in pieces that stay in a core's cache until they are written.
constexpr std::size_t kBytesPerPiece = std::size_t{1} << 16;

/// So many pieces share one buffer.
constexpr std::size_t kPiecesPerBuffer = 16;

/// Consecutive texels of one image.
struct Piece {
  const PlacedImage* placed;
  std::size_t begin;
  std::size_t end;
};

std::vector<Piece> cutIntoPieces(const ImageSet& images, std::span<const PlacedImage> placed, std::size_t texel_size) {
  const std::size_t step = kBytesPerPiece / texel_size;
  std::vector<Piece> pieces;
  for (const PlacedImage& image : placed) {
    const std::size_t texels = images.at(image.level, image.face, image.layer).texelCount();
    for (std::size_t begin = 0; begin < texels; begin += step)
      pieces.push_back({&image, begin, std::min(texels, begin + step)});
  }
  return pieces;
}

/// The error for the first texel of a piece that does not fit.
Error misfitOf(const ImageSet& images, const Piece& piece, TexelFormat format, const std::string& name) {
  const PlacedImage& placed = *piece.placed;
  const Image& image = images.at(placed.level, placed.face, placed.layer);
  const std::size_t channels = std::size_t(image.channels());
  const std::size_t texel =
      piece.begin + firstMisfit(format, image.samples().subspan(piece.begin * channels), image.channels());
  const auto width = static_cast<std::size_t>(image.width());
  return misfit(name, format, placeName(shapeOf(images), placed.level, placed.layer, placed.face),
                glm::ivec2(texel % width, texel / width), image.samples().subspan(texel * channels, channels));
}

}  // namespace

std::size_t firstMisfit(TexelFormat format, std::span<const float> samples, int channels) {
  const auto step = static_cast<std::size_t>(channels);
  std::vector<std::uint8_t> bytes(texelSize(storedFormat(format)));
  std::size_t texel = 0;
  while (packTexels(format, samples.subspan(texel * step, step), channels, bytes)) ++texel;
  return texel;
}

Error misfit(const std::string& name, TexelFormat format, const std::string& place, glm::ivec2 texel,
             std::span<const float> samples) {
  std::string value;
  for (const float sample : samples) value += (value.empty() ? "" : " ") + formatNumber(sample);
  return {ErrorCode::out_of_range, name + ": texel (" + std::to_string(texel.x) + ", " + std::to_string(texel.y) +
                                       ") of " + place + " is " + value + ", but " + rangeOf(format) +
                                       "; scale the light, or use --format float32"};
}

Result<void> streamTexels(const ImageSet& images, std::span<const PlacedImage> placed, TexelFormat format,
                          const std::string& name, const WriteAt& write) {
  const std::size_t texel_size = texelSize(storedFormat(format));
  const std::vector<Piece> pieces = cutIntoPieces(images, placed, texel_size);

  std::mutex mutex;  // guards the two below
  std::size_t first_misfit = pieces.size();
  std::optional<Error> failure;
  parallelFor(pieces.size(), kPiecesPerBuffer, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> buffer(kBytesPerPiece);
    for (std::size_t i = begin; i < end; ++i) {
      const Piece& piece = pieces[i];
      const Image& image = images.at(piece.placed->level, piece.placed->face, piece.placed->layer);
      const std::size_t channels = std::size_t(image.channels());
      const std::span<std::uint8_t> bytes = std::span(buffer).first((piece.end - piece.begin) * texel_size);
      const bool fits =
          packTexels(format, image.samples().subspan(piece.begin * channels, (piece.end - piece.begin) * channels),
                     image.channels(), bytes);
      const Result<void> written = write(piece.placed->offset + piece.begin * texel_size, bytes);
      if (fits && written) continue;
      const std::lock_guard lock(mutex);
      if (!fits) first_misfit = std::min(first_misfit, i);
      if (!written) failure = written.error();
      return;
    }
  });
  if (failure) return tl::unexpected<Error>(std::move(*failure));
  if (first_misfit < pieces.size()) return tl::unexpected<Error>(misfitOf(images, pieces[first_misfit], format, name));
  return {};
}

}  // namespace mirrorball
