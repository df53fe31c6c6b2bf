#include "mirrorball/codec/ldr/jpeg_reader.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/format_signature.h"
#include "mirrorball/codec/ldr/jpeg_damage.h"
#include "mirrorball/codec/ldr/jpeg_library.h"
#include "mirrorball/codec/ldr/jpeg_segments.h"
#include "mirrorball/codec/metadata.h"
// Behind jpeglib.h, which it needs.
#include <jerror.h>

namespace mirrorball {
namespace {

/// An 8×8 block costs at least one bit, and a block of a component may cover 16 of them at the
/// largest sampling ratio: at most 64 · 16 · 8 texels a byte.
constexpr std::size_t kMaxTexelsPerByte = 64 * 16 * 8;

/// A progressive file may have any number of scans, and one of 350 bytes can cover 16000 × 16000 texels: 3 MB of them
/// take a quarter of an hour. Writers make about ten; libjpeg-turbo's own fuzz targets set this limit.
constexpr int kMaxScans = 500;

/// Called now and then while a file is decoded.
void onProgress(j_common_ptr codec) {
  if (reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number <= kMaxScans) return;
  auto* errors = reinterpret_cast<JpegErrors*>(codec->err);
  std::snprintf(errors->message, sizeof errors->message, "it has more than %d scans", kMaxScans);
  std::longjmp(errors->jump, 1);
}

struct Decompressor {
  Decompressor() {
    codec.err = installJpegErrors(errors);
    errors.damage = &damage;
    progress.progress_monitor = onProgress;
  }
  ~Decompressor() { jpeg_destroy_decompress(&codec); }
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  JpegErrors errors{};
  JpegDamage damage;
  jpeg_progress_mgr progress{};
  jpeg_decompress_struct codec{};
};

/// How many bytes libjpeg has taken.
std::size_t takenBytes(const Decompressor& decoder, std::size_t size) {
  const std::size_t left = decoder.codec.src ? decoder.codec.src->bytes_in_buffer : size;
  return size - std::min(left, size);
}

tl::unexpected<Error> damagedAt(const Decompressor& decoder, std::size_t size, const std::string& text) {
  return fail(ErrorCode::bad_file,
              "is a damaged JPEG, at byte " + std::to_string(takenBytes(decoder, size)) + ": " + text);
}

tl::unexpected<Error> jpegFailure(const Decompressor& decoder, std::size_t size) {
  const std::string text = decoder.errors.message;
  const int number = decoder.errors.base.msg_parm.i[0];
  switch (decoder.errors.code) {
    case JERR_BAD_PRECISION:
      return fail(ErrorCode::unsupported, "is a JPEG of " + std::to_string(number) +
                                              " bits a sample, and those of 8 are read; save it as one, or as a PNG "
                                              "or TIFF of 16 bits");
    case JERR_SOF_UNSUPPORTED: {
      const bool is_lossless = (number & 3) == 3;  // SOF3, SOF7, SOF11 and SOF15
      return fail(ErrorCode::unsupported, "is a " + std::string(is_lossless ? "lossless" : "hierarchical") +
                                              " JPEG; save it as baseline or progressive JPEG, or as PNG");
    }
    case JERR_OUT_OF_MEMORY:
      return fail(ErrorCode::too_large, "not enough memory to decode it");
    default:
      return damagedAt(decoder, size, text);
  }
}

Metadata readComments(const jpeg_decompress_struct& codec) {
  Metadata metadata;
  for (jpeg_saved_marker_ptr marker = codec.marker_list; marker; marker = marker->next)
    if (marker->marker == JPEG_COM)
      readMetadataLine({reinterpret_cast<const char*>(marker->data), marker->data_length}, metadata);
  return metadata;
}

/// Reads up to the first scan and refuses what cannot be decoded.
Result<void> readJpegHeader(Decompressor& decoder, std::span<const std::uint8_t> bytes) {
  jpeg_decompress_struct& codec = decoder.codec;
  const bool read = guardedFromJpeg(decoder.errors, [&] {
    jpeg_create_decompress(&codec);
    codec.progress = &decoder.progress;
    jpeg_mem_src(&codec, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_save_markers(&codec, JPEG_COM, 0xffff);
    jpeg_save_markers(&codec, JPEG_APP0 + 2, 0xffff);  // parts of an ICC profile
    jpeg_read_header(&codec, TRUE);
  });
  if (!read) return jpegFailure(decoder, bytes.size());
  MIRRORBALL_TRY_VOID(checkDimensions(codec.image_width, codec.image_height));
  MIRRORBALL_TRY_VOID(checkImageMemory(static_cast<int>(codec.image_width), static_cast<int>(codec.image_height), 3));
  const std::size_t texels = std::size_t(codec.image_width) * codec.image_height;
  if (texels / kMaxTexelsPerByte > bytes.size()) return cannotHold(codec.image_width, codec.image_height, bytes.size());
  return {};
}

bool isInInks(const jpeg_decompress_struct& codec) {
  return codec.jpeg_color_space == JCS_CMYK || codec.jpeg_color_space == JCS_YCCK;
}

/// Cyan, magenta, yellow and black as the colours that are left of white. A code of 255 means no ink: Adobe's programs
/// store what the inks let through. Files without Adobe's marker are read likewise, as by all of Chromium, Firefox,
/// WebKit, ImageMagick, Pillow and gdk-pixbuf; libjpeg leaves it open, and libvips and Wine count 0 as no ink there.
///
/// ink   of as many texels as the row has
void mixInks(const JSAMPLE* ink, std::span<std::uint8_t> row, std::size_t channels) {
  for (std::size_t at = 0; at + channels <= row.size(); at += channels, ink += 4) {
    for (std::size_t c = 0; c < 3; ++c) row[at + c] = static_cast<std::uint8_t>((ink[c] * ink[3] + 127) / 255);
    if (channels == 4) row[at + 3] = 255;
  }
}

std::string inkRemark(const jpeg_decompress_struct& codec, const IccProfile& profile) {
  std::string remark = "is in inks (CMYK): mixed to RGB by their product, without ";
  remark += profile.description.empty() ? "a profile of them" : "their profile (" + profile.description + ")";
  return codec.saw_Adobe_marker ? remark : remark + "; 255 is taken as no ink, though Adobe's marker is missing";
}

/// The ICC profile in the file's markers, if there is one.
IccProfile jpegProfile(Decompressor& decoder) {
  JOCTET* profile = nullptr;
  unsigned size = 0;
  boolean found = FALSE;
  const bool read =
      guardedFromJpeg(decoder.errors, [&] { found = jpeg_read_icc_profile(&decoder.codec, &profile, &size); });
  const std::unique_ptr<JOCTET, decltype(&std::free)> owner(profile, &std::free);
  return read && found ? readIccProfile({profile, size}) : IccProfile{};
}

/// Decodes the rows that are there.
///
/// errors   bad_file: libjpeg gives up before the first of them, which with several scans it may do although some are
///          whole; too_large
Result<void> readRows(Decompressor& decoder, Image8& picture, std::size_t size) {
  jpeg_decompress_struct& codec = decoder.codec;
  Bytes inks(isInInks(codec) ? std::size_t{4} * codec.image_width : 0);  // of a row
  const auto channels = static_cast<std::size_t>(picture.channels());
  const bool ended_well = guardedFromJpeg(decoder.errors, [&] {
    jpeg_start_decompress(&codec);
    while (codec.output_scanline < decoder.damage.end()) {
      const auto shown = picture.row(static_cast<int>(codec.output_scanline));
      JSAMPROW row = inks.empty() ? shown.data() : inks.data();
      jpeg_read_scanlines(&codec, &row, 1);
      if (!inks.empty()) mixInks(inks.data(), shown, channels);
    }
    decoder.damage.checkScans(codec);
    if (codec.output_scanline == codec.output_height) jpeg_finish_decompress(&codec);
  });
  if (!ended_well) {
    if (codec.output_scanline == 0 || decoder.errors.code == JERR_OUT_OF_MEMORY) return jpegFailure(decoder, size);
    decoder.damage.endAt(codec.output_scanline, decoder.errors.message);
  }
  return {};
}

/// errors   as readJpegPicture's; then `end` becomes where the segment begins, behind a scan, that libjpeg gave up in
Result<JpegPicture> readUpTo(std::span<const std::uint8_t> bytes, CodeForm form, std::optional<std::size_t>& end) {
  Decompressor decoder;
  MIRRORBALL_TRY_VOID(readJpegHeader(decoder, bytes));
  jpeg_decompress_struct& codec = decoder.codec;
  const Exif exif = readJpegExif(bytes);
  const IccProfile profile = jpegProfile(decoder);
  const bool is_in_inks = isInInks(codec);
  CodedFile file{.codes = {},
                 .color = is_in_inks ? CodedColor{} : codedColor(profile),
                 .orientation = exif.orientation,
                 .exif = exif,
                 .metadata = readComments(codec),  // which finishing the decoding forgets, as it does the profile
                 .format = is_in_inks ? "JPEG, 8 bit, CMYK" : "JPEG, 8 bit"};
  if (is_in_inks) file.oddities.push_back(inkRemark(codec, profile));
  const bool grey = codec.num_components == 1;
  const int channels = form == CodeForm::rgba ? 4 : grey ? 1 : 3;
  codec.out_color_space = is_in_inks ? JCS_CMYK : channels == 4 ? JCS_EXT_RGBA : grey ? JCS_GRAYSCALE : JCS_RGB;
  const auto width = static_cast<int>(codec.image_width), height = static_cast<int>(codec.image_height);

  // Without values, so that a size that lies costs no memory: only rows that are decoded are touched.
  Image8 picture = Image8::withoutValues(width, height, channels);
  decoder.damage.expectRows(std::size_t(height));
  if (Result<void> read = readRows(decoder, picture, bytes.size()); !read) {
    constexpr std::size_t kEndMarker = 2;  // which libjpeg supplies itself where the bytes end
    const bool is_by_libjpeg = decoder.errors.code != 0;
    if (is_by_libjpeg) end = segmentBetweenScans(bytes, takenBytes(decoder, bytes.size()) + kEndMarker);
    return tl::unexpected<Error>(std::move(read).error());
  }
  const std::size_t missing_rows = decoder.damage.missingRows();
  if (missing_rows == std::size_t(height)) return damagedAt(decoder, bytes.size(), decoder.damage.cause());
  decoder.damage.blacken(picture);
  if (std::string remark = decoder.damage.remark(); !remark.empty()) file.oddities.push_back(std::move(remark));
  file.codes = std::move(picture);
  return JpegPicture{std::move(file), missing_rows};
}

}  // namespace

Result<JpegPicture> readJpegPicture(std::span<const std::uint8_t> bytes, CodeForm form) {
  const std::size_t begin = beginOfJpeg(bytes).value_or(0);
  std::span<const std::uint8_t> jpeg = bytes.subspan(begin);
  MIRRORBALL_TRY(with_height, withHeightInHeader(jpeg));
  if (with_height) jpeg = *with_height;
  std::optional<std::size_t> end;
  auto picture = readUpTo(jpeg, form, end);
  if (!picture && end && picture.error().code == ErrorCode::bad_file) picture = readUpTo(jpeg.first(*end), form, end);
  if (picture && begin > 0)
    picture->file.oddities.push_back(counted(begin, "byte") +
                                     " before its beginning belong to nothing, and are passed over");
  return picture;
}

}  // namespace mirrorball
