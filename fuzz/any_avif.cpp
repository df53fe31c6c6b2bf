// Small pictures of all that libavif writes.

#include <map>
#include <memory>

#include <avif/avif.h>

#include "avif_mutation.h"
#include "chance.h"
#include "mirrorball/codec/color/icc_testing.h"

namespace mirrorball::fuzz {
namespace {

using AvifImage = std::unique_ptr<avifImage, decltype(&avifImageDestroy)>;
using AvifEncoder = std::unique_ptr<avifEncoder, decltype(&avifEncoderDestroy)>;

/// Codes that rise over the plane, with some noise among them or none.
void fillPlane(std::uint8_t* plane, std::size_t row_bytes, std::size_t height, std::uint32_t depth,
               std::mt19937& random) {
  const std::size_t noise = pick<std::size_t>({1, 1, 3, 3, 20, 256}, random);
  for (std::size_t i = 0; i < row_bytes * height; ++i) {
    const std::size_t code = (i + below(noise, random)) & 255u;
    // Of more than 8 bits every second byte is the higher one.
    const bool is_high = depth > 8 && i % 2 == 1;
    plane[i] = static_cast<std::uint8_t>(is_high ? code & ((1u << (depth - 8)) - 1) : code);
  }
}

/// The colours and whatever else all cells of a grid share.
struct AvifKind {
  std::uint32_t depth = 8;
  avifPixelFormat format = AVIF_PIXEL_FORMAT_YUV444;
  bool has_alpha = false;
  std::uint32_t look = 0;  ///< which colours
};

AvifKind anyKind(std::mt19937& random) {
  return {.depth = pick({8u, 8u, 10u, 12u}, random),
          .format = pick(
              {AVIF_PIXEL_FORMAT_YUV444, AVIF_PIXEL_FORMAT_YUV422, AVIF_PIXEL_FORMAT_YUV420, AVIF_PIXEL_FORMAT_YUV400},
              random),
          .has_alpha = onceIn(2, random),
          .look = static_cast<std::uint32_t>(random())};
}

AvifImage anyAvifImage(std::uint32_t width, std::uint32_t height, const AvifKind& kind, std::mt19937& random) {
  std::mt19937 look(kind.look);
  AvifImage image(avifImageCreate(width, height, kind.depth, kind.format), avifImageDestroy);
  image->yuvRange = onceIn(2, look) ? AVIF_RANGE_LIMITED : AVIF_RANGE_FULL;
  image->colorPrimaries = static_cast<avifColorPrimaries>(pick({1, 2, 9, 12}, look));
  image->transferCharacteristics = static_cast<avifTransferCharacteristics>(pick({1, 2, 4, 8, 13, 16, 18}, look));
  image->matrixCoefficients = static_cast<avifMatrixCoefficients>(pick({1, 2, 5, 6, 9, 12}, look));
  if (kind.format == AVIF_PIXEL_FORMAT_YUV444 && onceIn(2, look)) {
    image->matrixCoefficients = AVIF_MATRIX_COEFFICIENTS_IDENTITY;
    image->yuvRange = AVIF_RANGE_FULL;
  }
  if (onceIn(4, look)) {
    const Bytes profile = testing::iccDisplayP3();
    avifImageSetProfileICC(image.get(), profile.data(), profile.size());
  }
  avifImageAllocatePlanes(image.get(), kind.has_alpha ? AVIF_PLANES_ALL : AVIF_PLANES_YUV);
  const bool has_small_chroma = kind.format == AVIF_PIXEL_FORMAT_YUV420;
  for (int channel = 0; channel < AVIF_PLANE_COUNT_YUV; ++channel) {
    if (image->yuvPlanes[channel] == nullptr) continue;
    const std::size_t rows = channel > 0 && has_small_chroma ? (height + 1) / 2 : height;
    fillPlane(image->yuvPlanes[channel], image->yuvRowBytes[channel], rows, kind.depth, random);
  }
  if (kind.has_alpha) fillPlane(image->alphaPlane, image->alphaRowBytes, height, kind.depth, random);
  image->alphaPremultiplied = kind.has_alpha && onceIn(4, look) ? AVIF_TRUE : AVIF_FALSE;
  return image;
}

/// Turns, mirrors, cuts or stretches the picture that is shown.
void transformAvif(avifImage& image, std::mt19937& random) {
  if (onceIn(4, random)) {
    image.transformFlags |= AVIF_TRANSFORM_IROT;
    image.irot.angle = static_cast<std::uint8_t>(below(4, random));
  }
  if (onceIn(4, random)) {
    image.transformFlags |= AVIF_TRANSFORM_IMIR;
    image.imir.mode = static_cast<std::uint8_t>(below(2, random));
  }
  if (onceIn(4, random)) {
    image.transformFlags |= AVIF_TRANSFORM_PASP;
    image.pasp = {1, 2};
  }
  if (onceIn(4, random)) {
    image.transformFlags |= AVIF_TRANSFORM_CLAP;
    image.clap = {image.width, 1, image.height, 1, 0, 1, 0, 1};
  }
}

bool addImages(avifEncoder* encoder, std::mt19937& random) {
  const AvifKind kind = anyKind(random);
  if (onceIn(8, random)) {
    constexpr std::uint32_t kCell = 64;  // the smallest that a grid may have
    const AvifImage first = anyAvifImage(kCell, kCell, kind, random), second = anyAvifImage(kCell, kCell, kind, random);
    const avifImage* cells[] = {first.get(), second.get()};
    return avifEncoderAddImageGrid(encoder, 2, 1, cells, AVIF_ADD_IMAGE_FLAG_SINGLE) == AVIF_RESULT_OK;
  }
  const std::size_t longest = onceIn(16, random) ? 140 : 24;
  const auto width = static_cast<std::uint32_t>(1 + below(longest, random));
  const auto height = static_cast<std::uint32_t>(1 + below(longest, random));
  const AvifImage image = anyAvifImage(width, height, kind, random);
  transformAvif(*image, random);
  const bool is_animated = onceIn(64, random);
  const avifAddImageFlags flags = is_animated ? AVIF_ADD_IMAGE_FLAG_NONE : AVIF_ADD_IMAGE_FLAG_SINGLE;
  for (int frames = is_animated ? 2 : 1; frames > 0; --frames)
    if (avifEncoderAddImage(encoder, image.get(), 1, flags) != AVIF_RESULT_OK) return false;
  return true;
}

std::optional<Bytes> encodedAvif(std::mt19937& random) {
  const AvifEncoder encoder(avifEncoderCreate(), avifEncoderDestroy);
  encoder->speed = AVIF_SPEED_FASTEST;
  encoder->minQuantizer = encoder->maxQuantizer = pick({0, 20, 40, 63}, random);
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = pick({0, 63}, random);
  encoder->tileRowsLog2 = static_cast<int>(below(2, random));
  encoder->tileColsLog2 = static_cast<int>(below(2, random));
  if (!addImages(encoder.get(), random)) return std::nullopt;
  avifRWData output = AVIF_DATA_EMPTY;
  const bool is_written = avifEncoderFinish(encoder.get(), &output) == AVIF_RESULT_OK;
  Bytes bytes(output.data, output.data + output.size);
  avifRWDataFree(&output);
  return is_written ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace

const Bytes& anyAvif(std::uint32_t number) {
  static std::map<std::uint32_t, Bytes> known;
  Bytes& bytes = known[number % kAnyAvifs];
  std::mt19937 random(number % kAnyAvifs);
  while (bytes.empty())
    if (auto encoded = encodedAvif(random)) bytes = *std::move(encoded);
  return bytes;
}

}  // namespace mirrorball::fuzz
