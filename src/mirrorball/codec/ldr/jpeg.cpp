#include "mirrorball/codec/ldr/jpeg.h"

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/codec/ldr/jpeg_library.h"
#include "mirrorball/codec/ldr/jpeg_reader.h"
#include "mirrorball/codec/ldr/ultra_hdr.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/image/upright.h"

namespace mirrorball {
namespace {

struct Compressor {
  Compressor() { codec.err = installJpegErrors(errors); }
  ~Compressor() {
    jpeg_destroy_compress(&codec);
    std::free(bytes);
  }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  JpegErrors errors{};
  jpeg_compress_struct codec{};
  unsigned char* bytes = nullptr;  // libjpeg's memory
  unsigned long size = 0;
};

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

/// A gain map's codes, turned as the picture is.
///
/// errors   whatever is wrong with it: "has a gain map that …"
Result<Image8> gainMapCodes(const GainMapPart& part, int orientation) {
  const auto inGainMap = [](Error error) {
    error.message = "has a gain map that " + error.message;
    return tl::unexpected<Error>(std::move(error));
  };
  auto picture = readJpegPicture(part.jpeg, CodeForm::stored);
  if (!picture) return inGainMap(std::move(picture).error());
  if (picture->missing_rows > 0) return inGainMap({ErrorCode::bad_file, picture->file.oddities.back()});
  return upright(std::get<Image8>(std::move(picture->file.codes)), orientation);
}

/// Lifts a decoded picture to the light that its gain map holds, where it has one; a damaged one leaves it as it is,
/// with a remark.
///
/// errors   too_large
Result<void> applyGainMap(std::span<const std::uint8_t> bytes, int orientation, DecodedImage& decoded) {
  const auto leave = [&](const Error& error) -> Result<void> {
    if (error.code == ErrorCode::too_large) return tl::unexpected<Error>(error);
    decoded.oddities.push_back("is read without its gain map: it " + error.message);
    decoded.format += ", its gain map damaged";
    return {};
  };
  const auto part = findGainMap(bytes);
  if (!part) return leave(part.error());
  if (!*part) return {};
  if ((*part)->jpeg.empty()) {
    decoded.gain_map = GainMapUse::lost;
    decoded.format += ", its gain map lost";
    return {};
  }
  const auto map = gainMapCodes(**part, orientation);
  if (!map) return leave(map.error());
  // The picture and the light stand side by side.
  const std::uint64_t texels = std::uint64_t(decoded.image.width()) * std::uint64_t(decoded.image.height());
  MIRRORBALL_TRY_VOID(checkMemory(texels * 2 * 3 * sizeof(float) + map->samples().size()));
  decoded.image = lightByGainMap(decoded.image, *map, (*part)->map);
  decoded.gain_map = GainMapUse::applied;
  decoded.format += ", gain map of " + sizeText({map->width(), map->height()});
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

Result<CodedFile> decodeJpegCodes(std::span<const std::uint8_t> bytes, CodeForm form) {
  MIRRORBALL_TRY(picture, readJpegPicture(bytes, form));
  return std::move(picture.file);
}

Result<DecodedImage> decodeJpeg(std::span<const std::uint8_t> bytes) {
  MIRRORBALL_TRY(file, decodeJpegCodes(bytes, CodeForm::stored));
  const int orientation = file.orientation;
  // Gains are of the picture's own channels.
  const std::optional<Primaries> primaries = std::exchange(file.color.primaries, std::nullopt);
  CodedColor color = file.color;
  color.primaries = primaries;
  DecodedImage image = asImage(std::move(file));
  image.color = describeColor(color, image.image.channels());
  MIRRORBALL_TRY_VOID(applyGainMap(bytes, orientation, image));
  convertToRec709(image.image, primaries);
  return image;
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
          .decode_codes = decodeJpegCodes,
          .encode_picture = [](const Image8& picture, const Metadata& metadata,
                               OutputPrimaries) { return encodeJpeg(picture, metadata); },
          .encode_with_gain_map = encodeJpegWithGainMap,
          .picture_channels = 3};
}

}  // namespace mirrorball
