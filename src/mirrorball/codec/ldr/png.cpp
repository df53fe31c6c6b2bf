#include "mirrorball/codec/ldr/png.h"

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

#include <png.h>
#include <zlib.h>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/ldr/png_chunks.h"
#include "mirrorball/codec/ldr/png_color.h"
#include "mirrorball/codec/ldr/png_xmp.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/missing_rows.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

/// Deflate makes at most 1032 bytes of one (258 bytes from two bits; zlib's technical notes).
constexpr std::size_t kMaxBytesPerByte = 1032;

/// What libpng's callbacks need: where they read or write, and the text of the error.
struct PngContext {
  std::span<const std::uint8_t> in;
  std::size_t at = 0;
  // How far decoding has come: libpng's jump out of it leaves no other trace.
  int passes = 1;  ///< 7 of an interlaced file
  int pass = 0;
  int row = 0;
  Bytes out;
  char message[160] = "unknown error";
};

void onPngError(png_structp png, png_const_charp message) {
  auto* context = static_cast<PngContext*>(png_get_error_ptr(png));
  std::snprintf(context->message, sizeof context->message, "%s", message);
  png_longjmp(png, 1);
}

/// The library prints nothing: what libpng can live with, so can we.
void onWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep to, std::size_t count) {
  auto* context = static_cast<PngContext*>(png_get_io_ptr(png));
  if (count > context->in.size() - context->at) png_error(png, "the file is truncated");
  std::memcpy(to, context->in.data() + context->at, count);
  context->at += count;
}

/// No exception may pass through libpng's frames, so running out of memory becomes its error.
bool append(Bytes& out, const std::uint8_t* bytes, std::size_t count) {
  try {
    out.insert(out.end(), bytes, bytes + count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void writeBytes(png_structp png, png_bytep from, std::size_t count) {
  if (!append(static_cast<PngContext*>(png_get_io_ptr(png))->out, from, count)) png_error(png, "out of memory");
}

void flushBytes(png_structp) {}

/// Runs calls of libpng, which reports an error by a jump back to here. `body` must own nothing
/// that has a destructor, for the jump passes over its frame; whatever outlives the calls lives in
/// the caller's.
///
/// returns  false after an error; its text is in the PngContext
template <typename Body>
bool guardedFromPng(png_structp png, const Body& body) {
  if (setjmp(png_jmpbuf(png))) return false;
  body();
  return true;
}

struct PngReader {
  explicit PngReader(std::span<const std::uint8_t> bytes) {
    context.in = bytes;
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &context, onPngError, onWarning);
    if (png) info = png_create_info_struct(png);
    if (info) png_set_read_fn(png, &context, readBytes);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  PngContext context;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

struct Writer {
  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &context, onPngError, onWarning);
    if (png) info = png_create_info_struct(png);
    if (info) png_set_write_fn(png, &context, writeBytes, flushBytes);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  PngContext context;
  png_structp png = nullptr;
  png_infop info = nullptr;
};

/// Samples of 8 or 16 bits in the machine's byte order; grey, RGB or RGBA.
void setTransforms(png_structp png, png_infop info, CodeForm form) {
  png_set_expand(png);  // palettes, 1, 2 and 4 bits, and tRNS to whole samples with alpha
  const bool grey = (png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR) == 0;
  const bool alpha =
      (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  constexpr png_uint_32 kOpaque = 0xffff;  // of 8 bits its lower half
  if (form == CodeForm::rgba) png_set_add_alpha(png, kOpaque, PNG_FILLER_AFTER);
  if (grey && (alpha || form == CodeForm::rgba)) png_set_gray_to_rgb(png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
}

/// What a PNG holds: interleaved samples without padding.
struct Pixels {
  int width = 0;
  int height = 0;
  int channels = 0;
  int bits = 0;         ///< of a sample as it is decoded
  int stored_bits = 0;  ///< of a sample in the file
  int rows = 0;         ///< those that the file holds; the others have no values
  Metadata metadata;
  CodedColor color;
  Exif exif;
  std::vector<std::string> oddities;
};

/// Metadata stands in tEXt alone. Of the other texts libpng would unpack all that are compressed, up to a thousand
/// times as many bytes as the file has.
void passOverOtherTexts(png_structp png) {
  constexpr std::array<png_byte, 10> kTexts{'z', 'T', 'X', 't', 0, 'i', 'T', 'X', 't', 0};
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, kTexts.data(), 2);
}

Metadata readTexts(png_structp png, png_infop info) {
  Metadata metadata;
  png_textp texts = nullptr;
  const int count = png_get_text(png, info, &texts, nullptr);
  for (int i = 0; i < count; ++i)
    if (texts[i].key && texts[i].text && isMetadataKey(texts[i].key)) metadata[texts[i].key] = texts[i].text;
  return metadata;
}

Exif readExifChunk(png_structp png, png_infop info) {
  png_uint_32 size = 0;
  png_bytep bytes = nullptr;
  return png_get_eXIf_1(png, info, &size, &bytes) != 0 ? readExif({bytes, size}) : Exif{};
}

tl::unexpected<Error> damaged(const PngReader& reader) {
  return fail(ErrorCode::bad_file, "is a damaged PNG, at byte " + std::to_string(reader.context.at) + ": " +
                                       excerpt(reader.context.message));
}

Result<void> readPngHeader(PngReader& reader, Pixels& pixels) {
  const bool read = guardedFromPng(reader.png, [&] {
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // checkDimensions decides
    keepPngColor(reader.png);
    passOverOtherTexts(reader.png);
    png_read_info(reader.png, reader.info);
  });
  if (!read) return damaged(reader);
  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  MIRRORBALL_TRY_VOID(checkDimensions(width, height));
  MIRRORBALL_TRY_VOID(checkImageMemory(static_cast<int>(width), static_cast<int>(height), 4));
  const std::size_t stored = png_get_rowbytes(reader.png, reader.info) * std::size_t(height);
  if (stored / kMaxBytesPerByte > reader.context.in.size()) return cannotHold(width, height, reader.context.in.size());
  pixels.width = static_cast<int>(width);
  pixels.height = pixels.rows = static_cast<int>(height);
  pixels.stored_bits = png_get_bit_depth(reader.png, reader.info);
  pixels.color = readPngColor(reader.png, reader.info);
  return {};
}

/// Decodes the rows into their places. In a file that ends early a texel of an interlaced picture fills its block until
/// others come.
bool readRows(PngReader& reader, std::vector<png_bytep>& rows, bool ends_early) {
  PngContext& at = reader.context;
  return guardedFromPng(reader.png, [&] {
    for (at.pass = 0; at.pass < at.passes; ++at.pass)
      for (at.row = 0; at.row < int(rows.size()); ++at.row) {
        png_bytep row = rows[std::size_t(at.row)];
        png_read_row(reader.png, ends_early ? nullptr : row, ends_early ? row : nullptr);
      }
    png_read_end(reader.png, reader.info);
  });
}

/// Takes up what is there of a file that ends early.
///
/// errors   bad_file: not one row is, or what is there is damaged
Result<void> takeRowsOfEarlyEnd(const PngReader& reader, bool decoded, Pixels& pixels) {
  const PngContext& at = reader.context;
  constexpr std::size_t kEndChunk = 12;  // which libpng has come to
  if (!decoded && (at.at <= at.in.size() - kEndChunk || (at.pass == 0 && at.row == 0))) return damaged(reader);
  if (decoded) {
    pixels.oddities.emplace_back("lacks its end chunk; all of its rows are there");
  } else if (at.pass > 0) {
    pixels.oddities.emplace_back("ends before its last pass: it is coarser than it was meant to be");
  } else {
    pixels.rows = at.row;
  }
  return {};
}

/// memory   gives the place for all samples, when all is known of them but the texts. They need no values, so that a
///          size that lies costs nothing: only rows that are decoded are touched
Result<Pixels> readPixels(std::span<const std::uint8_t> bytes, CodeForm form,
                          const std::function<std::uint8_t*(const Pixels&)>& memory) {
  MIRRORBALL_TRY(completed, completedPng(bytes));
  PngReader reader(completed ? std::span<const std::uint8_t>(*completed) : bytes);
  if (!reader.info) return fail(ErrorCode::too_large, "not enough memory to decode it");
  Pixels pixels;
  MIRRORBALL_TRY_VOID(readPngHeader(reader, pixels));

  const bool prepared = guardedFromPng(reader.png, [&] {
    setTransforms(reader.png, reader.info, form);
    reader.context.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
  });
  if (!prepared) return damaged(reader);
  const std::size_t row_size = png_get_rowbytes(reader.png, reader.info);
  pixels.channels = png_get_channels(reader.png, reader.info);
  pixels.bits = png_get_bit_depth(reader.png, reader.info);

  std::uint8_t* const first = memory(pixels);
  std::vector<png_bytep> rows(std::size_t(pixels.height));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = first + y * row_size;
  const bool decoded = readRows(reader, rows, completed.has_value());
  if (completed)
    MIRRORBALL_TRY_VOID(takeRowsOfEarlyEnd(reader, decoded, pixels));
  else if (!decoded)
    return damaged(reader);
  pixels.metadata = readTexts(reader.png, reader.info);
  pixels.exif = readExifChunk(reader.png, reader.info);
  return pixels;
}

/// A picture of that shape, for a decoder to fill.
template <typename Sample>
std::uint8_t* makePlace(ImageOf<Sample>& picture, const Pixels& pixels) {
  picture = ImageOf<Sample>::withoutValues(pixels.width, pixels.height, pixels.channels);
  return reinterpret_cast<std::uint8_t*>(picture.samples().data());
}

int colorType(int channels) {
  if (channels == 1) return PNG_COLOR_TYPE_GRAY;
  return channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
}

/// The better of two filters for each row, and of deflate only its runs of one byte. After the
/// filters a rendered or photographed picture has hardly anything else that repeats, and looking
/// for it is what takes the time. A noisy 1280 × 720 picture takes 21 ms and 1.20 MB this way on
/// one core; libpng's own choice (all filters, level 6, Z_FILTERED) takes 360 ms and 1.18 MB.
void setCompression(png_structp png) {
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
  png_set_compression_level(png, 1);
  png_set_compression_strategy(png, Z_RLE);
}

}  // namespace

Result<CodedFile> decodePng(std::span<const std::uint8_t> bytes, CodeForm form) {
  CodedPicture codes;
  const auto memory = [&codes](const Pixels& pixels) {
    return pixels.bits == 8 ? makePlace(codes.emplace<Image8>(), pixels)
                            : makePlace(codes.emplace<ImageOf<std::uint16_t>>(), pixels);
  };
  MIRRORBALL_TRY(pixels, readPixels(bytes, form, memory));
  std::visit([&](auto& picture) { blackenMissingRows(picture, pixels.rows, /*from_top=*/true, pixels.oddities); },
             codes);
  return CodedFile{.codes = std::move(codes),
                   .color = std::move(pixels.color),
                   .orientation = pixels.exif.orientation,
                   .exif = pixels.exif,
                   .metadata = std::move(pixels.metadata),
                   .format = "PNG, " + std::to_string(pixels.stored_bits) + " bit",
                   .oddities = std::move(pixels.oddities)};
}

Result<Bytes> encodePng(const Image8& picture, const Metadata& metadata, OutputPrimaries primaries) {
  Writer writer;
  if (!writer.info) return fail(ErrorCode::too_large, "not enough memory to encode it");
  std::vector<png_text> texts;
  for (const auto& [key, value] : metadata) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(key.c_str());  // libpng only reads them
    text.text = const_cast<char*>(value.c_str());
    text.text_length = value.size();
    texts.push_back(text);
  }
  writer.context.out.reserve(picture.samples().size() / 2);
  const bool written = guardedFromPng(writer.png, [&] {
    png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    setCompression(writer.png);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(picture.width()),
                 static_cast<png_uint_32>(picture.height()), 8, colorType(picture.channels()), PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    writePngColor(writer.png, writer.info, primaries);
    png_set_text(writer.png, writer.info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < picture.height(); ++y) png_write_row(writer.png, picture.row(y).data());
    png_write_end(writer.png, nullptr);
  });
  if (!written) return fail(ErrorCode::too_large, "cannot be encoded as PNG: " + std::string(writer.context.message));
  return std::move(writer.context.out);
}

FormatCodec pngCodec() {
  return {.decode_codes = decodePng, .encode_picture = encodePng, .compressed_xmp = compressedXmpInPng};
}

}  // namespace mirrorball
