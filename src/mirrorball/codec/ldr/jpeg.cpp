#include "mirrorball/codec/ldr/jpeg.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

// jpeglib.h needs size_t and FILE from <cstdio>, jerror.h needs jpeglib.h: this order stays.
#include <jpeglib.h>
//
#include <jerror.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/ldr/coded_picture.h"
#include "mirrorball/codec/ldr/ultra_hdr.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

/// An 8×8 block costs at least one bit, and a block of a component may cover 16 of them at the
/// largest sampling ratio: at most 64 · 16 · 8 texels a byte.
constexpr std::size_t kMaxTexelsPerByte = 64 * 16 * 8;

/// A progressive file may have any number of scans, and one of 350 bytes can cover 16000 × 16000 texels: 3 MB of them
/// take a quarter of an hour. Writers make about ten; libjpeg-turbo's own fuzz targets set this limit.
constexpr int kMaxScans = 500;

/// libjpeg's error manager with where to jump, the error's text and its number.
struct ErrorManager {
  jpeg_error_mgr base;  // first: libjpeg hands out a pointer to it
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
  int code;
};

void onJpegError(j_common_ptr codec) {
  auto* manager = reinterpret_cast<ErrorManager*>(codec->err);
  manager->code = codec->err->msg_code;
  codec->err->format_message(codec, manager->message);
  std::longjmp(manager->jump, 1);
}

/// libjpeg warns of damaged data (level −1) and goes on with grey; here that is an error. What is
/// left is harmless: stray bytes between segments, and odd numbers in Adobe's and JFIF's markers.
void onMessage(j_common_ptr codec, int level) {
  if (level >= 0) return;
  switch (codec->err->msg_code) {
    case JWRN_EXTRANEOUS_DATA:
    case JWRN_ADOBE_XFORM:
    case JWRN_JFIF_MAJOR:
    case JWRN_BOGUS_ICC:
      return;
    default:
      onJpegError(codec);
  }
}

/// Called now and then while a file is decoded.
void onProgress(j_common_ptr codec) {
  if (reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number <= kMaxScans) return;
  auto* manager = reinterpret_cast<ErrorManager*>(codec->err);
  std::snprintf(manager->message, sizeof manager->message, "it has more than %d scans", kMaxScans);
  std::longjmp(manager->jump, 1);
}

/// The library prints nothing.
void onOutput(j_common_ptr) {}

jpeg_error_mgr* install(ErrorManager& manager) {
  jpeg_std_error(&manager.base);
  manager.base.error_exit = onJpegError;
  manager.base.emit_message = onMessage;
  manager.base.output_message = onOutput;
  manager.message[0] = '\0';
  manager.code = 0;
  return &manager.base;
}

/// Runs calls of libjpeg, which reports an error by a jump back to here. `body` must own nothing
/// that has a destructor, for the jump passes over its frame.
///
/// returns  false after an error; it stands in the manager
template <typename Body>
bool guardedFromJpeg(ErrorManager& manager, const Body& body) {
  if (setjmp(manager.jump)) return false;
  body();
  return true;
}

struct Decompressor {
  Decompressor() {
    codec.err = install(errors);
    progress.progress_monitor = onProgress;
  }
  ~Decompressor() { jpeg_destroy_decompress(&codec); }
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  ErrorManager errors{};
  jpeg_progress_mgr progress{};
  jpeg_decompress_struct codec{};
};

struct Compressor {
  Compressor() { codec.err = install(errors); }
  ~Compressor() {
    jpeg_destroy_compress(&codec);
    std::free(bytes);
  }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  ErrorManager errors{};
  jpeg_compress_struct codec{};
  unsigned char* bytes = nullptr;  // libjpeg's memory
  unsigned long size = 0;
};

tl::unexpected<Error> jpegFailure(const Decompressor& decoder, std::size_t size) {
  const std::string text = decoder.errors.message;
  switch (decoder.errors.code) {
    case JERR_BAD_PRECISION:
    case JERR_SOF_UNSUPPORTED:
      return fail(ErrorCode::unsupported, text + "; save it as baseline or progressive JPEG of 8 bits");
    case JERR_OUT_OF_MEMORY:
      return fail(ErrorCode::too_large, "not enough memory to decode it");
    default: {
      const std::size_t left = decoder.codec.src ? decoder.codec.src->bytes_in_buffer : size;
      // libjpeg supplies two bytes of its own when the data end early.
      const std::size_t at = decoder.errors.code == JWRN_JPEG_EOF ? size : size - std::min(left, size);
      return fail(ErrorCode::bad_file, "is a damaged JPEG, at byte " + std::to_string(at) + ": " + text);
    }
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
  if (codec.jpeg_color_space == JCS_CMYK || codec.jpeg_color_space == JCS_YCCK)
    return fail(ErrorCode::unsupported, "is a CMYK JPEG; save it as RGB");
  return {};
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

struct Decoded {
  Image8 picture;
  Metadata metadata;
  IccProfile profile;
};

/// texture  RGBA for everything; else grey or RGB as the file has it
Result<Decoded> readJpegPicture(std::span<const std::uint8_t> bytes, bool texture) {
  Decompressor decoder;
  MIRRORBALL_TRY_VOID(readJpegHeader(decoder, bytes));
  jpeg_decompress_struct& codec = decoder.codec;
  Metadata metadata = readComments(codec);  // which finishing the decoding forgets, as it does the profile
  IccProfile profile = jpegProfile(decoder);
  const bool grey = codec.num_components == 1;
  codec.out_color_space = texture ? JCS_EXT_RGBA : grey ? JCS_GRAYSCALE : JCS_RGB;

  // Without values, so that a size that lies costs no memory: only rows that are decoded are touched.
  Image8 picture = Image8::withoutValues(static_cast<int>(codec.image_width), static_cast<int>(codec.image_height),
                                         texture ? 4
                                         : grey  ? 1
                                                 : 3);
  const bool decoded = guardedFromJpeg(decoder.errors, [&] {
    jpeg_start_decompress(&codec);
    while (codec.output_scanline < codec.output_height) {
      JSAMPROW row = picture.row(static_cast<int>(codec.output_scanline)).data();
      jpeg_read_scanlines(&codec, &row, 1);
    }
    jpeg_finish_decompress(&codec);
  });
  if (!decoded) return jpegFailure(decoder, bytes.size());
  return Decoded{std::move(picture), std::move(metadata), std::move(profile)};
}

constexpr int kPictureQuality = 95;

/// A gain map's codes are powers: at 95 a sun of one texel is off by a fifth, at 100 by 3 %.
constexpr int kGainMapQuality = 100;

void writePixels(Compressor& encoder, const Image8& picture, const Metadata& metadata, int quality) {
  jpeg_compress_struct& codec = encoder.codec;
  jpeg_create_compress(&codec);
  jpeg_mem_dest(&codec, &encoder.bytes, &encoder.size);
  codec.image_width = static_cast<JDIMENSION>(picture.width());
  codec.image_height = static_cast<JDIMENSION>(picture.height());
  codec.input_components = picture.channels();
  codec.in_color_space = picture.channels() == 1 ? JCS_GRAYSCALE : picture.channels() == 3 ? JCS_RGB : JCS_EXT_RGBX;
  jpeg_set_defaults(&codec);
  jpeg_set_quality(&codec, quality, TRUE);
  for (int component = 0; component < codec.num_components; ++component)
    codec.comp_info[component].h_samp_factor = codec.comp_info[component].v_samp_factor = 1;
  jpeg_start_compress(&codec, TRUE);
  for (const auto& [key, value] : metadata) {
    // Written byte by byte: a std::string here would be lost by the jump of an error.
    jpeg_write_m_header(&codec, JPEG_COM, static_cast<unsigned>(key.size() + 1 + value.size()));
    for (const char letter : key) jpeg_write_m_byte(&codec, letter);
    jpeg_write_m_byte(&codec, '=');
    for (const char letter : value) jpeg_write_m_byte(&codec, letter);
  }
  while (codec.next_scanline < codec.image_height) {
    JSAMPROW row = const_cast<JSAMPLE*>(picture.row(static_cast<int>(codec.next_scanline)).data());
    jpeg_write_scanlines(&codec, &row, 1);
  }
  jpeg_finish_compress(&codec);
}

/// Lifts a decoded picture to the light that its gain map holds, where it has one.
Result<void> applyGainMap(std::span<const std::uint8_t> bytes, DecodedImage& decoded) {
  MIRRORBALL_TRY(part, findGainMap(bytes));
  if (!part) return {};
  if (part->jpeg.empty()) {
    decoded.gain_map = GainMapUse::lost;
    decoded.format += ", its gain map lost";
    return {};
  }
  const auto inGainMap = [](Error error) {
    error.message = "has a gain map that " + error.message;
    return tl::unexpected<Error>(std::move(error));
  };
  auto codes = readJpegPicture(part->jpeg, false);
  if (!codes) return inGainMap(std::move(codes).error());
  const Image8& map = codes->picture;
  // The picture and the light stand side by side.
  const std::uint64_t texels = std::uint64_t(decoded.image.width()) * std::uint64_t(decoded.image.height());
  MIRRORBALL_TRY_VOID(checkMemory(texels * 2 * 3 * sizeof(float) + map.samples().size()));
  decoded.image = lightByGainMap(decoded.image, map, part->map);
  decoded.gain_map = GainMapUse::applied;
  decoded.format += ", gain map of " + std::to_string(map.width()) + "x" + std::to_string(map.height());
  return {};
}

/// errors   as encodeJpeg's
Result<Bytes> encodedWith(int quality, const Image8& picture, const Metadata& metadata) {
  if (picture.width() > JPEG_MAX_DIMENSION || picture.height() > JPEG_MAX_DIMENSION)
    return fail(ErrorCode::bad_shape,
                "a JPEG has at most " + std::to_string(JPEG_MAX_DIMENSION) + " texels a side; use .png");
  Compressor encoder;
  if (!guardedFromJpeg(encoder.errors, [&] { writePixels(encoder, picture, metadata, quality); }))
    return fail(ErrorCode::too_large, "cannot be encoded as JPEG: " + std::string(encoder.errors.message));
  return Bytes(encoder.bytes, encoder.bytes + encoder.size);
}

}  // namespace

Result<DecodedImage> decodeJpeg(std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(decoded, readJpegPicture(bytes, false));
  const IccProfile& profile = decoded.profile;
  DecodedImage image{linearFromPicture(decoded.picture, profile.curve), std::move(decoded.metadata), "JPEG, 8 bit",
                     describeColor(profile, decoded.picture.channels())};
  // Gains are of the picture's own channels.
  MIRRORBALL_TRY_VOID(applyGainMap(bytes, image));
  convertToRec709(image.image, profile.primaries);
  return image;
}

Result<Image8> decodeJpegTexture(std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(decoded, readJpegPicture(bytes, true));
  return std::move(decoded.picture);
}

Result<Bytes> encodeJpeg(const Image8& picture, const Metadata& metadata) {
  return encodedWith(kPictureQuality, picture, metadata);
}

Result<Bytes> encodeJpegWithGainMap(const Image8& picture, const Image& light, const Metadata& metadata) {
  MIRRORBALL_TRY(first, encodeJpeg(picture, metadata));
  MIRRORBALL_TRY(shown, decodeJpeg(first));
  const MadeGainMap made = gainMapFor(shown.image, light);
  MIRRORBALL_TRY(second, encodedWith(kGainMapQuality, made.codes, {}));
  return joinedUltraHdr(first, second, made.numbers);
}

FormatCodec jpegCodec() {
  return {.decode = withoutOptions<decodeJpeg>,
          .decode_texture = decodeJpegTexture,
          .encode_picture = [](const Image8& picture, const Metadata& metadata,
                               OutputPrimaries) { return encodeJpeg(picture, metadata); },
          .encode_with_gain_map = encodeJpegWithGainMap,
          .picture_channels = 3};
}

}  // namespace mirrorball
