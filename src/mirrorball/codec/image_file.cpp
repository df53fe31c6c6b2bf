#include "mirrorball/codec/image_file.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/foreign_file.h"
#include "mirrorball/codec/format_registry.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::initializer_list<Holds> kPicturesAndLight{Holds::light, Holds::picture};

/// The error for bytes that no codec takes.
tl::unexpected<Error> unknownFormat(Span bytes, std::string_view known) {
  if (bytes.empty()) return fail(ErrorCode::bad_file, "is empty");
  if (std::optional<Error> foreign = foreignFileError(FileUse::picture, bytes))
    return tl::unexpected<Error>(std::move(*foreign));
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

/// The codec for these bytes; nullptr where there is none.
Result<const FormatCodec*> codecFor(Span bytes) { return FormatRegistry::ofThisBuild().codecFor(bytes); }

/// errors   not_found: a layer was asked for of a file of one picture
Result<void> checkLayer(const ImageReadOptions& options, bool has_layers) {
  if (options.layer.empty() || has_layers) return {};
  return fail(ErrorCode::not_found, "has no layers, and none that is named '" + excerpt(options.layer) + "'");
}

/// Whether a file of a codec's format holds integers.
bool holdsIntegers(const FormatCodec& codec, Span bytes) {
  return codec.decode_codes && (!codec.holds_integers || codec.holds_integers(bytes));
}

/// The codec of a file that holds integers; nullptr of any other.
const FormatCodec* codecOfIntegers(Span bytes) {
  const Result<const FormatCodec*> codec = codecFor(bytes);
  return codec && *codec && holdsIntegers(**codec, bytes) ? *codec : nullptr;
}

Result<DecodedImage> decodeByMagic(Span bytes, const ImageReadOptions& options) {
  MIRRORBALL_TRY(codec, codecFor(bytes));
  if (!codec) return unknownFormat(bytes, readFormatNames());
  const bool are_numbers_of_codes = options.as == ReadAs::numbers && holdsIntegers(*codec, bytes);
  if (codec->decode && !are_numbers_of_codes) {
    MIRRORBALL_TRY(decoded, codec->decode(bytes, options));
    MIRRORBALL_TRY_VOID(checkLayer(options, !decoded.layer.empty()));
    return decoded;
  }
  MIRRORBALL_TRY_VOID(checkLayer(options, false));
  MIRRORBALL_TRY(file, codec->decode_codes(bytes, CodeForm::stored));
  return asImage(std::move(file), options.as);
}

Result<CodedFile> decodeCodedFile(Span bytes, CodeForm form) {
  MIRRORBALL_TRY(codec, codecFor(bytes));
  const std::string right = readFormatNames(Holds::picture) + " for textures";
  if (!codec) return unknownFormat(bytes, right);
  if (!codec->decode_codes)
    return fail(ErrorCode::unsupported, "is " + std::string(formatOf(*formatBegunBy(bytes)).name) +
                                            ", which no texture of a model is; use " + right);
  return codec->decode_codes(bytes, form);
}

/// What an image takes while alpha is put to it [bytes].
std::uint64_t bytesWithAlpha(const Image& image) {
  const std::uint64_t own = image.samples().size_bytes();
  return image.channels() == 4 ? own : own + std::uint64_t{4} * sizeof(float) * image.texelCount();
}

Result<Decoded<Texels>> decodeTexels(Span bytes, const ImageReadOptions& options) {
  if (const FormatCodec* codec = codecOfIntegers(bytes)) {
    MIRRORBALL_TRY_VOID(checkLayer(options, false));
    MIRRORBALL_TRY(file, codec->decode_codes(bytes, CodeForm::rgba));
    return asTexels(std::move(file), options.as);
  }
  MIRRORBALL_TRY(decoded, decodeByMagic(bytes, options));
  MIRRORBALL_TRY_VOID(checkMemory(bytesWithAlpha(decoded.image)));
  return Decoded<Texels>{withAlpha(std::move(decoded.image)), std::move(decoded.oddities),
                         std::move(decoded.layer_guess), decoded.is_converted};
}

ImageReadOptions asNumbers(ImageReadOptions options) {
  options.as = ReadAs::numbers;
  return options;
}

Result<Bytes> encodeImage(ImageFormatId format, const Image& image, const ImageWriteOptions& options) {
  const FormatCodec& codec = FormatRegistry::ofThisBuild()[format];
  if (codec.encode) return codec.encode(image, options);
  const int channels = std::min(image.channels(), codec.picture_channels);
  return codec.encode_picture(pictureFromLinear(image, channels, options.dither), options.metadata, options.primaries);
}

template <typename Sample>
Result<void> checkShape(const ImageOf<Sample>& image) {
  if (image.empty()) return fail(ErrorCode::bad_shape, "an image of no texels cannot be written");
  if (image.channels() == 2)
    return fail(ErrorCode::bad_shape, "an image of 2 channels cannot be written; give it 1, 3 or 4");
  return {};
}

}  // namespace

Result<Bytes> readImageFile(const std::filesystem::path& path) {
  constexpr std::size_t kTelling = std::size_t{1} << 16;  // bytes at each end; TGA is recognised by its last ones
  constexpr std::uint64_t kLarge = std::uint64_t{1} << 24;
  MIRRORBALL_TRY(file, FileReader::open(path));
  if (file.size() > kLarge) {
    Bytes ends(2 * kTelling);
    const std::span<std::uint8_t> all(ends);
    MIRRORBALL_TRY_VOID(withName(file.name(), file.readAt(0, all.first(kTelling))));
    MIRRORBALL_TRY_VOID(withName(file.name(), file.readAt(file.size() - kTelling, all.last(kTelling))));
    MIRRORBALL_TRY(codec, withName(file.name(), codecFor(ends)));
    if (!codec) return withName(file.name(), Result<Bytes>(unknownFormat(ends, readFormatNames())));
  }
  return readFile(path);
}

Result<DecodedImage> readImage(const std::filesystem::path& path, const ImageReadOptions& options) {
  MIRRORBALL_TRY(bytes, readImageFile(path));
  return withName(path.string(), decodeImage(bytes, options));
}

Result<DecodedImage> decodeImage(Span bytes, const ImageReadOptions& options) {
  return withinMemory<DecodedImage>([&] { return decodeByMagic(bytes, options); });
}

bool isImage(Span bytes) { return formatBegunBy(bytes).has_value(); }

Result<void> writeImage(const std::filesystem::path& path, const Image& image, const ImageWriteOptions& options) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatToWrite(path, kPicturesAndLight));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(image)));
  MIRRORBALL_TRY_VOID(checkMetadata(options.metadata));
  if (!options.layers.empty() && format != ImageFormatId::exr)
    return fail(ErrorCode::usage, name + ": only OpenEXR files have layers; name it .exr");
  MIRRORBALL_TRY_VOID(checkStatesPrimaries(path, options.primaries, kPicturesAndLight));
  MIRRORBALL_TRY(bytes, withName(name, withinMemory<Bytes>([&] { return encodeImage(format, image, options); })));
  return writeFile(path, bytes);
}

Result<PictureCodes> decodeCodes(Span bytes) {
  return withinMemory<PictureCodes>([&]() -> Result<PictureCodes> {
    MIRRORBALL_TRY(file, decodeCodedFile(bytes, CodeForm::rgba));
    return asCodes(std::move(file));
  });
}

Result<std::variant<PictureCodes, PictureFractions>> decodeCodesOrFractions(Span bytes) {
  using Picture = std::variant<PictureCodes, PictureFractions>;
  return withinMemory<Picture>([&]() -> Result<Picture> {
    {
      MIRRORBALL_TRY(file, decodeCodedFile(bytes, CodeForm::rgba));
      if (file.color.transfer != Transfer::linear) return asCodes(std::move(file));
      const bool may_have_more_channels =
          std::visit([](const auto& codes) { return codes.channels() == 4; }, file.codes);
      if (!may_have_more_channels) return asFractions(std::move(file));
    }
    MIRRORBALL_TRY(file, decodeCodedFile(bytes, CodeForm::stored));
    return asFractions(std::move(file));
  });
}

Result<Image8> decodeTexture(Span bytes) {
  MIRRORBALL_TRY(picture, decodeCodes(bytes));
  return std::move(picture.codes);
}

Result<Decoded<Texels>> decodeColorTexture(Span bytes) {
  return withinMemory<Decoded<Texels>>([&] { return decodeTexels(bytes, {}); });
}

Result<Decoded<Texels>> decodeDataTexture(Span bytes, const ImageReadOptions& options) {
  return withinMemory<Decoded<Texels>>([&] { return decodeTexels(bytes, asNumbers(options)); });
}

Result<Decoded<Image>> decodeNumbers(Span bytes, const ImageReadOptions& options) {
  MIRRORBALL_TRY(decoded, decodeImage(bytes, asNumbers(options)));
  return Decoded<Image>{std::move(decoded.image), std::move(decoded.oddities), std::move(decoded.layer_guess)};
}

Result<void> savePicture(const std::filesystem::path& path, const Image8& picture, const Metadata& metadata) {
  const std::string name = path.string();
  MIRRORBALL_TRY(format, formatToWrite(path, {Holds::picture}));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(picture)));
  MIRRORBALL_TRY_VOID(checkMetadata(metadata));
  MIRRORBALL_TRY(bytes, withName(name, withinMemory<Bytes>([&] { return encodePicture(format, picture, metadata); })));
  return writeFile(path, bytes);
}

Result<void> savePictureWithGainMap(const std::filesystem::path& path, const Image8& picture, const Image& light,
                                    const Metadata& metadata) {
  const std::string name = path.string();
  MIRRORBALL_TRY_VOID(checkHoldsGainMap(path));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(picture)));
  MIRRORBALL_TRY_VOID(withName(name, checkShape(light)));
  MIRRORBALL_TRY_VOID(checkMetadata(metadata));
  MIRRORBALL_TRY(format, formatToWrite(path, {Holds::picture}));
  const FormatCodec& codec = FormatRegistry::ofThisBuild()[format];
  MIRRORBALL_TRY(
      bytes, withName(name, withinMemory<Bytes>([&] { return codec.encode_with_gain_map(picture, light, metadata); })));
  return writeFile(path, bytes);
}

Result<void> checkHoldsGainMap(const std::filesystem::path& path) {
  const auto format = formatToWrite(path, kPicturesAndLight);
  if (format && FormatRegistry::ofThisBuild()[*format].encode_with_gain_map) return {};
  return fail(ErrorCode::usage, path.string() + ": has no gain map beside its picture; write .jpg");
}

bool holdsCodes(Span bytes) { return codecOfIntegers(bytes) != nullptr; }

Result<void> checkWritable(const std::filesystem::path& path) {
  MIRRORBALL_TRY_VOID(formatToWrite(path, kPicturesAndLight));
  return {};
}

bool storesLinearLight(const std::filesystem::path& path) { return formatToWrite(path, {Holds::light}).has_value(); }

}  // namespace mirrorball
