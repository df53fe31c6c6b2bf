#include "mirrorball/codec/image_file.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/ldr/bmp.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/codec/ldr/pnm.h"
#include "mirrorball/codec/ldr/tga.h"
#include "mirrorball/codec/ldr/webp.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/ktx1.h"
#include "mirrorball/codec/texture/ktx2.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/codec/tiff/tiff.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::initializer_list<Holds> kPicturesAndLight{Holds::light, Holds::picture};

/// The error for bytes that no codec takes.
tl::unexpected<Error> unknownFormat(Span bytes, std::string_view known) {
  if (bytes.empty()) return fail(ErrorCode::bad_file, "is empty");
  constexpr char kDigits[] = "0123456789abcdef";
  std::string begins;
  for (const std::uint8_t byte : bytes.first(std::min<std::size_t>(bytes.size(), 4))) {
    begins += ' ';
    begins += kDigits[byte >> 4];
    begins += kDigits[byte & 15];
  }
  return fail(ErrorCode::bad_file,
              "is not an image that can be read (it begins with the bytes" + begins + "); use " + std::string(known));
}

/// The largest level of a texture of one face: its first picture, if it is an array.
Result<DecodedImage> decodeTexturePicture(Span bytes) {
  MIRRORBALL_TRY(texture, decodeImageSet(bytes));
  if (texture.images.faces() != 1)
    return fail(ErrorCode::bad_shape, "is the texture of a cube, where one picture is wanted");
  return DecodedImage{std::move(texture.images.at(0, 0)), std::move(texture.metadata), std::move(texture.format),
                      std::move(texture.color)};
}

/// How a format is told by a file's first bytes, and read.
struct Decoder {
  bool (*begins)(Span bytes);
  Result<DecodedImage> (*decode)(Span bytes, const ProgressFunction& progress);
  /// To 8-bit RGBA as stored; nothing where the format has no integers, or is none of pictures.
  Result<Image8> (*decode_texture)(Span bytes);
  /// To the codes as stored; nothing where a format has no more than 8 bits.
  Result<CodedPicture> (*decode_codes)(Span bytes) = nullptr;
};

template <Result<DecodedImage> (*decode)(Span)>
Result<DecodedImage> withoutProgress(Span bytes, const ProgressFunction&) {
  return decode(bytes);
}

/// In the order of kImageFormats. TGA has no first bytes of its own, and is asked for last.
constexpr std::array<Decoder, kImageFormats.size()> kDecoders{{
    {isHdr, withoutProgress<decodeHdr>, nullptr},
    {isExr, decodeExr, nullptr},
    {isPng, withoutProgress<decodePng>, decodePngTexture, decodePngCodes},
    {isJpeg, withoutProgress<decodeJpeg>, decodeJpegTexture},
    {isKtx2, withoutProgress<decodeTexturePicture>, nullptr},
    {isKtx1, withoutProgress<decodeTexturePicture>, nullptr},
    {isDds, withoutProgress<decodeTexturePicture>, nullptr},
    {isTiff, decodeTiff, decodeTiffTexture, decodeTiffCodes},
    {isWebp, withoutProgress<decodeWebp>, decodeWebpTexture},
    {isTga, withoutProgress<decodeTga>, decodeTgaTexture},
    {isBmp, withoutProgress<decodeBmp>, decodeBmpTexture},
    {isPnm, withoutProgress<decodePnm>, decodePnmTexture, decodePnmCodes},
    {isPfm, withoutProgress<decodePfm>, nullptr},
}};

/// The decoder for these bytes; nullptr where there is none.
const Decoder* decoderFor(Span bytes) {
  const Decoder& tga = kDecoders[static_cast<std::size_t>(ImageFormatId::tga)];
  for (const Decoder& decoder : kDecoders)
    if (&decoder != &tga && decoder.begins(bytes)) return &decoder;
  return tga.begins(bytes) ? &tga : nullptr;
}

Result<DecodedImage> decodeByMagic(Span bytes, const ProgressFunction& progress) {
  if (const Decoder* decoder = decoderFor(bytes)) return decoder->decode(bytes, progress);
  return unknownFormat(bytes, readFormatNames());
}

Result<Image8> decodeTextureByMagic(Span bytes) {
  const Decoder* decoder = decoderFor(bytes);
  const std::string right = readFormatNames(Holds::picture) + " for textures";
  if (!decoder) return unknownFormat(bytes, right);
  if (decoder->decode_texture) return decoder->decode_texture(bytes);
  const ImageFormat& format = kImageFormats[static_cast<std::size_t>(decoder - kDecoders.data())];
  return fail(ErrorCode::unsupported,
              "is " + std::string(format.name) + ", which no texture of a model is; use " + right);
}

Result<Image> decodeNumbersByMagic(Span bytes, const ProgressFunction& progress) {
  if (!holdsCodes(bytes)) {
    MIRRORBALL_TRY(decoded, decodeByMagic(bytes, progress));
    return std::move(decoded.image);
  }
  const Decoder* decoder = decoderFor(bytes);
  if (decoder->decode_codes) {
    MIRRORBALL_TRY(codes, decoder->decode_codes(bytes));
    return sharesOf(codes);
  }
  MIRRORBALL_TRY(codes, decoder->decode_texture(bytes));
  return sharesOf(CodedPicture(std::move(codes)));
}

Result<Bytes> encodePicture(ImageFormatId format, const Image8& picture, const Metadata& metadata) {
  if (format == ImageFormatId::png) return encodePng(picture, metadata);
  return encodeJpeg(picture, metadata);
}

Result<Bytes> encodeImage(ImageFormatId format, const Image& image, const ImageWriteOptions& options) {
  if (format == ImageFormatId::exr) return encodeExr(image, options);
  if (format == ImageFormatId::hdr) return encodeHdr(image, options.metadata);
  const int channels = format == ImageFormatId::jpeg ? std::min(image.channels(), 3) : image.channels();
  return encodePicture(format, pictureFromLinear(image, channels), options.metadata);
}

template <typename Sample>
Result<void> checkShape(const ImageOf<Sample>& image) {
  if (image.empty()) return fail(ErrorCode::bad_shape, "an image of no texels cannot be written");
  if (image.channels() == 2)
    return fail(ErrorCode::bad_shape, "an image of 2 channels cannot be written; give it 1, 3 or 4");
  return {};
}

}  // namespace

Result<DecodedImage> readImage(const std::filesystem::path& path) {
  MIRRORBALL_TRY(bytes, readFile(path));
  return withName(path.string(), decodeImage(bytes));
}

Result<DecodedImage> decodeImage(Span bytes, const ProgressFunction& progress) {
  return withinMemory<DecodedImage>([&] { return decodeByMagic(bytes, progress); });
}

bool isImage(Span bytes) { return decoderFor(bytes) != nullptr; }

Result<void> writeImage(const std::filesystem::path& path, const Image& image, const ImageWriteOptions& options) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatToWrite(path, kPicturesAndLight));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(image)));
  MIRRORBALL_TRY_VOID(checkMetadata(options.metadata));
  if (!options.layers.empty() && format != ImageFormatId::exr)
    return fail(ErrorCode::usage, name + ": only OpenEXR files have layers; name it .exr");
  MIRRORBALL_TRY(bytes, withName(name, withinMemory<Bytes>([&] { return encodeImage(format, image, options); })));
  return writeFile(path, bytes);
}

Result<Image8> decodeTexture(Span bytes) {
  return withinMemory<Image8>([&] { return decodeTextureByMagic(bytes); });
}

Result<Image> decodeNumbers(Span bytes, const ProgressFunction& progress) {
  return withinMemory<Image>([&] { return decodeNumbersByMagic(bytes, progress); });
}

Result<void> savePicture(const std::filesystem::path& path, const Image8& picture, const Metadata& metadata) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatToWrite(path, {Holds::picture}));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(picture)));
  MIRRORBALL_TRY_VOID(checkMetadata(metadata));
  MIRRORBALL_TRY(bytes, withName(name, withinMemory<Bytes>([&] { return encodePicture(format, picture, metadata); })));
  return writeFile(path, bytes);
}

bool holdsCodes(Span bytes) {
  const Decoder* decoder = decoderFor(bytes);
  return decoder && decoder->decode_texture && (!isTiff(bytes) || isTiffOfIntegers(bytes));
}

Result<void> checkWritable(const std::filesystem::path& path) {
  MIRRORBALL_TRY_VOID(formatToWrite(path, kPicturesAndLight));
  return {};
}

bool storesLinearLight(const std::filesystem::path& path) { return formatToWrite(path, {Holds::light}).has_value(); }

}  // namespace mirrorball
