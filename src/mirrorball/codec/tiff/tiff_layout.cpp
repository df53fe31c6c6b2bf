#include "mirrorball/codec/tiff/tiff_layout.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/ldr/coded_picture.h"
#include "mirrorball/codec/missing_rows.h"

namespace mirrorball {
namespace {

struct Compression {
  std::uint16_t number;
  const char* name;
  /// How many bytes one of the file's can become at most.
  std::uint64_t max_bytes_per_byte;
};

/// Few on purpose: each is code that meets untrusted bytes. Two bytes of PackBits are at most 128, a code of 12 bits of
/// LZW at most 4094; deflate and JPEG are as in png.cpp and jpeg.cpp; a block of Zstandard is at most 128 KiB and at
/// least 4 bytes; two bytes of LogLuv are at most 129 of one of a texel's four bytes, which become 12.
constexpr Compression kCompressions[] = {
    {COMPRESSION_NONE, "", 1},
    {COMPRESSION_LZW, "LZW", 4094},
    {COMPRESSION_ADOBE_DEFLATE, "deflate", 1032},
    {COMPRESSION_DEFLATE, "deflate", 1032},
    {COMPRESSION_PACKBITS, "PackBits", 64},
    {COMPRESSION_ZSTD, "Zstandard", 32768},
    {COMPRESSION_JPEG, "JPEG", 64 * 16 * 8 * 3},
    {COMPRESSION_SGILOG, "RLE", 200},
    {COMPRESSION_SGILOG24, "24 bit", 4},
};

const Compression* compressionOf(std::uint16_t number) {
  return std::find_if(std::begin(kCompressions), std::end(kCompressions),
                      [&](const Compression& known) { return known.number == number; });
}

template <typename Value>
Value field(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 1 ? value : otherwise;
}

/// What is there instead of light, for messages; nothing where it is read.
const char* unreadable(std::uint16_t photometric) {
  switch (photometric) {
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_MINISBLACK:
    case PHOTOMETRIC_RGB:
    case PHOTOMETRIC_PALETTE:
    case PHOTOMETRIC_YCBCR:
    case PHOTOMETRIC_LOGL:
    case PHOTOMETRIC_LOGLUV:
      return nullptr;
    case PHOTOMETRIC_SEPARATED:
      return "is a CMYK TIFF; save it as RGB";
    case PHOTOMETRIC_CIELAB:
    case PHOTOMETRIC_ICCLAB:
    case PHOTOMETRIC_ITULAB:
      return "is a TIFF in L*a*b*; save it as RGB";
    case PHOTOMETRIC_MASK:
      return "is a TIFF that holds a mask only; save it as RGB";
    default:
      return "is a camera's raw picture; develop it to a TIFF of 16 bits first";
  }
}

/// Goes to the first page that is no preview: raw pictures of cameras begin with one,
/// and have nothing else at this level.
Result<void> findPage(const TiffFile& file) {
  constexpr int kMaxPages = 16;
  for (int i = 0; i < TIFFGetTagListCount(file.get()); ++i)
    if (TIFFGetTagListEntry(file.get(), i) == TIFFTAG_DNGVERSION)
      return fail(ErrorCode::unsupported, unreadable(PHOTOMETRIC_CFA));
  for (int page = 0; page < kMaxPages; ++page) {
    if ((field<std::uint32_t>(file.get(), TIFFTAG_SUBFILETYPE, 0) & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0)
      return {};
    if (TIFFReadDirectory(file.get()) == 0) break;
  }
  return fail(ErrorCode::unsupported, std::string("has nothing but a preview; ") + unreadable(PHOTOMETRIC_CFA));
}

Result<void> checkCompression(TIFF* tiff, TiffLayout& layout) {
  const auto number = field<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const auto* const known = compressionOf(number);
  if (known == std::end(kCompressions) || TIFFIsCODECConfigured(number) == 0)
    return fail(ErrorCode::unsupported, "has the compression " + std::to_string(number) +
                                            ", which is not read; save it with LZW, deflate or none");
  layout.compression = known->name;
  layout.is_jpeg = number == COMPRESSION_JPEG;
  layout.is_log = number == COMPRESSION_SGILOG || number == COMPRESSION_SGILOG24;
  if (layout.is_jpeg) TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  if (layout.is_log) TIFFSetField(tiff, TIFFTAG_SGILOGDATAFMT, SGILOGDATAFMT_FLOAT);
  return {};
}

/// The bits of a sample and how they stand for a number.
Result<void> readSamples(TIFF* tiff, TiffLayout& layout) {
  layout.bits = field<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const auto format = field<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  layout.is_float = format == SAMPLEFORMAT_IEEEFP;
  const bool is_read = layout.is_float ? layout.bits == 16 || layout.bits == 32 || layout.bits == 64
                                       : (format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID) &&
                                             layout.bits >= 1 && (layout.bits <= 16 || layout.bits == 32);
  if (is_read) return {};
  return fail(ErrorCode::unsupported, "has samples of " + counted(std::size_t(layout.bits), "bit") +
                                          " and TIFF's kind " + std::to_string(format) +
                                          ", which are not read; save it with 8 or 16 bits, or with floats of 32");
}

Result<void> readPaletteLayout(const TiffFile& file, TiffLayout& layout) {
  std::uint16_t* columns[3]{};
  if (layout.is_float || layout.bits > 16 ||
      TIFFGetField(file.get(), TIFFTAG_COLORMAP, &columns[0], &columns[1], &columns[2]) == 0)
    return file.damaged();
  const std::size_t count = std::size_t{1} << layout.bits;
  std::uint16_t max = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    layout.palette[c].assign(columns[c], columns[c] + count);
    max = std::max(max, *std::max_element(layout.palette[c].begin(), layout.palette[c].end()));
  }
  // Some writers fill the 16 bits of a palette with 8.
  if (max <= 255)
    for (std::vector<std::uint16_t>& column : layout.palette)
      for (std::uint16_t& code : column) code = static_cast<std::uint16_t>(code * 257);
  return {};
}

/// Which samples are colours, and which is alpha.
Result<void> readChannels(const TiffFile& file, TiffLayout& layout) {
  TIFF* tiff = file.get();
  layout.samples = field<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.is_by_planes = field<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
  std::uint16_t photometric = layout.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
  TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
  if (const char* what = unreadable(photometric)) return fail(ErrorCode::unsupported, what);
  const bool is_of_log = photometric == PHOTOMETRIC_LOGL || photometric == PHOTOMETRIC_LOGLUV;
  if (is_of_log != layout.is_log) return file.damaged();
  if (photometric == PHOTOMETRIC_YCBCR && (!layout.is_jpeg || layout.is_by_planes))
    return fail(ErrorCode::unsupported, "is a TIFF in YCbCr without JPEG compression; save it as RGB");
  const bool has_three =
      photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_YCBCR || photometric == PHOTOMETRIC_LOGLUV;
  layout.colors = has_three ? 3 : 1;
  layout.is_white_zero = photometric == PHOTOMETRIC_MINISWHITE;
  if (layout.samples < layout.colors) return file.damaged();
  if (layout.is_white_zero && layout.is_float)
    return fail(ErrorCode::unsupported, "is a TIFF of floats whose 0 is white; save it with 0 as black");
  if (photometric == PHOTOMETRIC_PALETTE) MIRRORBALL_TRY_VOID(readPaletteLayout(file, layout));

  std::uint16_t count = 0;
  std::uint16_t* kinds = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds) == 0) return {};
  for (int i = 0; i < count && layout.colors + i < layout.samples && layout.alpha < 0; ++i) {
    if (kinds[i] != EXTRASAMPLE_ASSOCALPHA && kinds[i] != EXTRASAMPLE_UNASSALPHA) continue;
    layout.alpha = layout.colors + i;
    layout.is_premultiplied = kinds[i] == EXTRASAMPLE_ASSOCALPHA;
  }
  return {};
}

void readColor(TIFF* tiff, TiffLayout& layout) {
  std::uint32_t size = 0;
  std::uint8_t* profile = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_ICCPROFILE, &size, &profile) == 1) {
    layout.profile = readIccProfile({profile, size});
    layout.primaries = layout.profile.primaries;
    return;
  }
  float* white = nullptr;
  float* xy = nullptr;
  if (layout.is_log || TIFFGetField(tiff, TIFFTAG_WHITEPOINT, &white) == 0 ||
      TIFFGetField(tiff, TIFFTAG_PRIMARYCHROMATICITIES, &xy) == 0)
    return;
  layout.primaries = Primaries{{xy[0], xy[1]}, {xy[2], xy[3]}, {xy[4], xy[5]}, {white[0], white[1]}};
}

Result<void> readStriles(const TiffFile& file, TiffLayout& layout) {
  TIFF* tiff = file.get();
  layout.is_tiled = TIFFIsTiled(tiff) != 0;
  const auto width = layout.is_tiled ? field<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) : std::uint32_t(layout.width);
  auto height = field<std::uint32_t>(tiff, layout.is_tiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP, 0);
  if (!layout.is_tiled) height = std::min(height, std::uint32_t(layout.height));
  constexpr std::uint32_t kMax = std::numeric_limits<std::int32_t>::max();
  if (width == 0 || height == 0 || width > kMax || height > kMax) return file.damaged();
  layout.strile_width = static_cast<int>(width);
  layout.strile_height = static_cast<int>(height);
  const tmsize_t size = layout.is_tiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  if (size <= 0 || std::uint64_t(size) != layout.strileBytes()) return file.damaged();
  return {};
}

/// TiffLayout::rows_there of a strip or tile.
int rowsThere(const TiffFile& file, const TiffLayout& layout, std::uint32_t index) {
  const std::uint64_t begin = TIFFGetStrileOffset(file.get(), index);
  const std::uint64_t stored = TIFFGetStrileByteCount(file.get(), index);
  if (stored == 0 || begin >= file.size()) return 0;
  const int rows = layout.rowsInStrile(index);
  if (stored <= file.size() - begin) return rows;
  const bool is_plain = layout.compression.empty() &&
                        field<std::uint16_t>(file.get(), TIFFTAG_FILLORDER, FILLORDER_MSB2LSB) == FILLORDER_MSB2LSB;
  return is_plain ? static_cast<int>(std::min<std::uint64_t>((file.size() - begin) / layout.rowBytes(), rows)) : 0;
}

/// Before memory is taken: whether the bytes of each strip or tile can become all of it, but for those that are
/// missing.
Result<void> checkSizes(const TiffFile& file, TiffLayout& layout) {
  TIFF* tiff = file.get();
  const auto* const compression = compressionOf(field<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE));
  const std::uint32_t count = layout.is_tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  if (count == 0) return file.damaged();
  std::uint64_t whole = 0, there = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint64_t stored = std::min<std::uint64_t>(TIFFGetStrileByteCount(tiff, i), file.size());
    const std::uint64_t bytes = layout.rowBytes() * std::uint64_t(layout.rowsInStrile(i));
    const int rows = layout.rows_there.emplace_back(rowsThere(file, layout, i));
    whole += bytes;
    there += layout.rowBytes() * std::uint64_t(rows);
    if (rows < layout.rowsInStrile(i)) continue;
    if (stored == 0 || bytes / compression->max_bytes_per_byte > stored)
      return cannotHold(layout.width, layout.height, file.size());
  }
  if (!mayBeLeftOf(whole, there)) return cannotHold(layout.width, layout.height, file.size());
  if (const auto missing = layout.missingRows(); !missing.empty() && !contains(missing, std::uint8_t{0}))
    return endsInFirstRow(file.size());
  return {};
}

}  // namespace

std::vector<std::uint8_t> TiffLayout::missingRows() const {
  const auto down = std::size_t(strilesDown()), across = std::size_t(strilesAcross());
  std::vector<int> fewest(down, strile_height);  // of the strips or tiles beside each other, in all planes
  for (std::size_t i = 0; i < rows_there.size(); ++i)
    if (const std::size_t row = i / across % down; rows_there[i] < rowsInStrile(std::uint32_t(i)))
      fewest[row] = std::min(fewest[row], rows_there[i]);
  std::vector<std::uint8_t> is_missing(static_cast<std::size_t>(height), 0);
  bool is_any = false;
  for (std::size_t y = 0; y < is_missing.size(); ++y) {
    const bool is_there = static_cast<int>(y % std::size_t(strile_height)) < fewest[y / std::size_t(strile_height)];
    is_missing[y] = is_there ? 0 : 1;
    is_any |= !is_there;
  }
  return is_any ? is_missing : std::vector<std::uint8_t>();
}

Result<TiffLayout> readTiffLayout(const TiffFile& file) {
  if (!file.get()) return file.damaged();
  MIRRORBALL_TRY_VOID(findPage(file));
  TIFF* tiff = file.get();
  const auto width = field<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  const auto height = field<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  MIRRORBALL_TRY_VOID(checkDimensions(width, height));
  TiffLayout layout;
  layout.width = static_cast<int>(width);
  layout.height = static_cast<int>(height);
  MIRRORBALL_TRY_VOID(checkCompression(tiff, layout));
  MIRRORBALL_TRY_VOID(readSamples(tiff, layout));
  MIRRORBALL_TRY_VOID(readChannels(file, layout));
  layout.orientation = field<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, 1);
  MIRRORBALL_TRY(window, readTiffWindow(file, {layout.width, layout.height}));
  layout.window = std::move(window);
  readColor(tiff, layout);
  MIRRORBALL_TRY_VOID(readStriles(file, layout));
  MIRRORBALL_TRY_VOID(checkSizes(file, layout));
  return layout;
}

}  // namespace mirrorball
