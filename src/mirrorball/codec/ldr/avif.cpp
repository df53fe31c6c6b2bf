#include "mirrorball/codec/ldr/avif.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <avif/avif.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/size_text.h"
#include "mirrorball/codec/color/icc_profile.h"
#include "mirrorball/codec/ldr/av1_size.h"
#include "mirrorball/codec/ldr/coded_file.h"
#include "mirrorball/codec/picture_window.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;
using AvifDecoder = std::unique_ptr<avifDecoder, decltype(&avifDecoderDestroy)>;

tl::unexpected<Error> avifFailure(avifResult result, std::size_t size) {
  switch (result) {
    case AVIF_RESULT_OUT_OF_MEMORY:
      return fail(ErrorCode::too_large, "not enough memory to decode it");
    case AVIF_RESULT_TRUNCATED_DATA:
      return fail(ErrorCode::bad_file,
                  "ends at byte " + std::to_string(size) + ", before its last texel; the file is truncated or damaged");
    case AVIF_RESULT_NO_CODEC_AVAILABLE:
      return fail(ErrorCode::unsupported, "is an AVIF, and libavif here has nothing that decodes AV1");
    default:
      return fail(ErrorCode::bad_file, "is a damaged AVIF: " + std::string(avifResultToString(result)));
  }
}

/// The size that the file's AV1 data says it has; nothing where that is not known.
std::optional<glm::uvec2> codedSize(const avifDecoder& decoder, Span bytes) {
  avifExtent extent{};
  if (avifDecoderNthImageMaxExtent(&decoder, 0, &extent) != AVIF_RESULT_OK) return std::nullopt;
  if (extent.offset > bytes.size() || extent.size > bytes.size() - extent.offset) return std::nullopt;
  return sizeInAv1(bytes.subspan(extent.offset, extent.size));
}

/// A decoder that has read what the file says of its picture.
///
/// codec    that is to decode it
Result<AvifDecoder> parsedAvif(Span bytes, avifCodecChoice codec = AVIF_CODEC_CHOICE_AUTO) {
  AvifDecoder decoder(avifDecoderCreate(), avifDecoderDestroy);
  if (!decoder) return fail(ErrorCode::too_large, "not enough memory to decode it");
  decoder->codecChoice = codec;
  decoder->maxThreads = threadLimit();
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  decoder->strictFlags = AVIF_STRICT_DISABLED;  // writers leave out what decoding does not need
  avifResult result = avifDecoderSetIOMemory(decoder.get(), bytes.data(), bytes.size());
  if (result == AVIF_RESULT_OK) result = avifDecoderParse(decoder.get());
  if (result != AVIF_RESULT_OK) return avifFailure(result, bytes.size());
  if (decoder->imageCount > 1)
    return fail(ErrorCode::unsupported, "is an animated AVIF; save one of its pictures by itself");
  const avifImage& image = *decoder->image;
  MIRRORBALL_TRY_VOID(checkDimensions(image.width, image.height));
  // libavif's own picture, and ours.
  const int sample_bytes = image.depth > 8 ? 4 : 2;
  MIRRORBALL_TRY_VOID(checkPictureMemory(int(image.width), int(image.height), 4, sample_bytes));
  // The data may be larger than the file says, and takes memory before libavif compares them.
  if (const auto coded = codedSize(*decoder, bytes)) {
    MIRRORBALL_TRY_VOID(checkDimensions(coded->x, coded->y));
    MIRRORBALL_TRY_VOID(checkPictureMemory(int(coded->x), int(coded->y), 4, sample_bytes));
  }
  const std::uint64_t texels = memoryLimit() / (4 * (sizeof(float) + std::uint64_t(sample_bytes)));
  decoder->imageSizeLimit = static_cast<std::uint32_t>(std::min<std::uint64_t>(texels, AVIF_DEFAULT_IMAGE_SIZE_LIMIT));
  return decoder;
}

/// Whether libaom is to try what dav1d did not decode: dav1d 1.0 fails at more than 35,651,584 texels, which is where
/// the levels of AV1 end. libaom takes whatever memory the data asks for, which must be no more than was checked.
bool canBeTriedByAom(const avifDecoder& decoder, Span bytes) {
  constexpr std::uint64_t kMostOfLevels = 35'651'584;
  const avifImage& image = *decoder.image;
  const bool is_large = std::uint64_t{image.width} * image.height > kMostOfLevels;
  return is_large && !decoder.alphaPresent && codedSize(decoder, bytes) == glm::uvec2(image.width, image.height) &&
         avifCodecName(AVIF_CODEC_CHOICE_AOM, AVIF_CODEC_FLAG_CAN_DECODE) != nullptr;
}

/// For an aperture that cannot be meant.
std::optional<PictureWindow> withoutAperture(std::vector<std::string>& oddities) {
  oddities.emplace_back("states a clean aperture (clap) that does not lie in the picture: read without it");
  return std::nullopt;
}

/// As cameras number it. HEIF turns a picture first, against the clock, and then mirrors it: its upper half to the
/// lower, or its left to the right.
int cameraOrientation(const avifImage& image) {
  constexpr int kTurned[]{1, 8, 3, 6};
  constexpr int kTurnedAndMirrored[2][4]{{4, 5, 2, 7}, {2, 7, 4, 5}};
  const int quarters = (image.transformFlags & AVIF_TRANSFORM_IROT) != 0 ? image.irot.angle & 3 : 0;
  if ((image.transformFlags & AVIF_TRANSFORM_IMIR) == 0) return kTurned[quarters];
  return kTurnedAndMirrored[image.imir.mode == 0 ? 0 : 1][quarters];
}

/// A fraction rounded to the next whole number; a half upwards.
///
/// divisor   greater than 0
std::int64_t rounded(std::int64_t numerator, std::int64_t divisor) {
  const std::int64_t doubled = 2 * numerator + divisor;
  const std::int64_t whole = doubled / (2 * divisor);
  return doubled % (2 * divisor) < 0 ? whole - 1 : whole;
}

/// The part of the picture that is to be shown, before it is turned; nothing: all of it. Edges between texels, which
/// whoever crops about the middle easily writes, are rounded.
///
/// from     ISO/IEC 14496-12:2015, 12.1.4.3: the aperture's size, and how far its middle lies from the picture's
std::optional<PictureWindow> cleanAperture(const avifImage& image, std::vector<std::string>& oddities) {
  if ((image.transformFlags & AVIF_TRANSFORM_CLAP) == 0) return std::nullopt;
  const avifCleanApertureBox& clap = image.clap;
  PictureWindow window{.size = {int(image.width), int(image.height)}};
  struct Side {
    std::uint32_t size, size_divisor, offset, offset_divisor;
  };
  const Side sides[2]{{clap.widthN, clap.widthD, clap.horizOffN, clap.horizOffD},
                      {clap.heightN, clap.heightD, clap.vertOffN, clap.vertOffD}};
  bool is_rounded = false;
  for (int i = 0; i < 2; ++i) {
    const std::int64_t divisor = sides[i].size_divisor, offset_divisor = sides[i].offset_divisor;
    const std::int64_t size = divisor > 0 ? rounded(sides[i].size, divisor) : 0;
    if (size < 1 || size > window.size[i] || offset_divisor == 0) return withoutAperture(oddities);
    // Twice the distance of its edge from the picture's, times the divisor.
    const std::int64_t doubled =
        2 * std::int64_t{static_cast<std::int32_t>(sides[i].offset)} + offset_divisor * (window.size[i] - size);
    const std::int64_t edge = rounded(doubled, 2 * offset_divisor);
    is_rounded |= sides[i].size % divisor != 0 || doubled % (2 * offset_divisor) != 0;
    if (edge < 0 || edge + size > window.size[i]) return withoutAperture(oddities);
    window.whole[i] = int(size);
    window.corner[i] = -int(edge);
  }
  if (window.whole == window.size) return std::nullopt;
  oddities.push_back("is cut to " + sizeText(window.whole) + " of its " + sizeText(window.size) + " texels at (" +
                     std::to_string(-window.corner.x) + ", " + std::to_string(-window.corner.y) +
                     "), as its clean aperture (clap) says" + (is_rounded ? ", rounded to whole texels" : ""));
  return window;
}

template <typename Sample>
Result<ImageOf<Sample>> codesOfAvif(const avifImage& image, int channels, std::size_t size) {
  ImageOf<Sample> codes = ImageOf<Sample>::withoutValues(int(image.width), int(image.height), channels);
  avifRGBImage rgb;
  avifRGBImageSetDefaults(&rgb, &image);
  rgb.depth = 8 * sizeof(Sample);
  rgb.format = channels == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.pixels = reinterpret_cast<std::uint8_t*>(codes.samples().data());
  rgb.rowBytes = static_cast<std::uint32_t>(std::size_t(image.width) * std::size_t(channels) * sizeof(Sample));
  const avifResult result = avifImageYUVToRGB(&image, &rgb);
  if (result != AVIF_RESULT_OK) return avifFailure(result, size);
  return codes;
}

/// The picture of a decoder that has parsed the file; it may give way to another one. Alpha that is all opaque is
/// there, too.
Result<CodedPicture> pictureOf(AvifDecoder& decoder, CodeForm form, Span bytes) {
  avifResult result = avifDecoderNextImage(decoder.get());
  if (result == AVIF_RESULT_DECODE_COLOR_FAILED && canBeTriedByAom(*decoder, bytes)) {
    MIRRORBALL_TRY(other, parsedAvif(bytes, AVIF_CODEC_CHOICE_AOM));
    decoder = std::move(other);
    result = avifDecoderNextImage(decoder.get());
  }
  if (result != AVIF_RESULT_OK) return avifFailure(result, bytes.size());
  const std::size_t size = bytes.size();
  const avifImage& image = *decoder->image;
  const int channels = form == CodeForm::rgba || image.alphaPlane != nullptr ? 4 : 3;
  if (image.depth <= 8) {
    MIRRORBALL_TRY(codes, codesOfAvif<std::uint8_t>(image, channels, size));
    return CodedPicture(std::move(codes));
  }
  MIRRORBALL_TRY(codes, codesOfAvif<std::uint16_t>(image, channels, size));
  return CodedPicture(std::move(codes));
}

}  // namespace

Result<CodedFile> decodeAvif(Span bytes, CodeForm form) {
  MIRRORBALL_TRY(decoder, parsedAvif(bytes));
  MIRRORBALL_TRY(picture, pictureOf(decoder, form, bytes));
  const avifImage& image = *decoder->image;
  std::vector<std::string> oddities;
  const std::optional<PictureWindow> aperture = cleanAperture(image, oddities);
  if (aperture) std::visit([&](auto& codes) { codes = placedInWindow(codes, *aperture); }, picture);
  CodedColor color = image.icc.size > 0 ? codedColor(readIccProfile({image.icc.data, image.icc.size}))
                                        : codedColor(image.colorPrimaries, image.transferCharacteristics);
  return CodedFile{.codes = std::move(picture),
                   .color = std::move(color),
                   .orientation = cameraOrientation(image),
                   .orientation_source = "header",
                   .format = "AVIF, " + std::to_string(image.depth) + " bits",
                   .oddities = std::move(oddities)};
}

FormatCodec avifCodec() { return {.decode_codes = decodeAvif}; }

}  // namespace mirrorball
