#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/codec/hdr/hdr_header.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// New RLE exists for scan lines of these lengths only (Radiance's MINELEN and MAXELEN).
inline constexpr std::size_t kShortestRle = 8;
inline constexpr std::size_t kLongestRle = 0x7fff;

/// A code byte up to 128 counts literal bytes, one above it repeats the next byte code − 128 times.
inline constexpr std::size_t kLongestLiteral = 128;
inline constexpr std::size_t kLongestRun = 127;

/// How many scan lines one piece of parallel work has.
std::size_t linesPerPiece(std::size_t line_length);

/// What a scan line turned out to be.
enum class LineForm { flat, old_rle, new_rle };

/// What the file is, in words: "Radiance HDR, XYZE, old RLE".
std::string describe(const HdrHeader& header, LineForm form);

/// What `info` says of its colour (primaries.h).
std::string describeColor(const HdrHeader& header);

/// Where each of some scan lines begins, and what form the lines have.
struct LineIndex {
  std::vector<std::size_t> starts;  ///< of those that are whole, which are fewer where the bytes end early
  std::size_t end = 0;              ///< behind the last of them
  LineForm form = LineForm::flat;
  std::size_t new_rle_count = 0;  ///< of the lines
};

/// Refuses a size that so many bytes cannot hold.
///
/// left     bytes behind the header
/// errors   bad_file
Result<void> checkLineBytes(const HdrHeader& header, std::uint64_t left);

/// Finds scan lines: cheap, and proof that decoding them, in parallel, will not fail.
///
/// bytes      of the file
/// at         where the first of the lines begins
/// first      its number, and
/// origin     the place of `bytes` in the file: for messages
/// errors     bad_file (the line and byte are named), but not where the bytes end
Result<LineIndex> indexLines(std::span<const std::uint8_t> bytes, std::size_t at, const HdrHeader& header,
                             std::size_t first, std::size_t count, std::uint64_t origin);

/// The remark on a file that ends before its last scan line; empty where it does not.
///
/// there          how many lines are whole
/// new_rle_count  how many of these are new RLE
/// size           of the file, in bytes
/// errors         bad_file: no line is whole; or some are new RLE and others not, which those behind a damaged one seem
///                to be
Result<std::string> missingLinesRemark(const HdrHeader& header, std::size_t there, std::size_t new_rle_count,
                                       std::uint64_t size);

/// Decodes lines to the components that they hold, on all cores; those that the index lacks become black.
///
/// image    where they belong: as wide as the header says and as high as there are lines, or the other way round where
///          scan lines are columns
void decodeLines(std::span<const std::uint8_t> bytes, const LineIndex& index, const HdrHeader& header, Image& image);

/// Brings the components to linear light in Rec.709.
///
/// returns  whether that changed them
bool convertToRec709(Image& components, const HdrHeader& header);

}  // namespace mirrorball
