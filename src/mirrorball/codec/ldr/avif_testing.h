#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <avif/avif.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// How libavif is to write a picture.
struct AvifForm {
  int depth = 8;      ///< 8, 10 or 12 bits
  int primaries = 1;  ///< numbers of ITU-T H.273
  int transfer = 13;
  int quarters = 0;      ///< turned so often against the clock when it is shown
  bool mirrors = false;  ///< then its left is on the right
  std::optional<avifCleanApertureBox> clap = {};
};

/// A picture of 3 or 4 channels without loss, as red, green and blue.
///
/// Sample   std::uint8_t, or std::uint16_t with codes of the depth
template <typename Sample>
Bytes avifFile(const ImageOf<Sample>& picture, const AvifForm& form = {}) {
  const std::unique_ptr<avifImage, decltype(&avifImageDestroy)> image(
      avifImageCreate(picture.width(), picture.height(), form.depth, AVIF_PIXEL_FORMAT_YUV444), avifImageDestroy);
  image->matrixCoefficients = AVIF_MATRIX_COEFFICIENTS_IDENTITY;
  image->colorPrimaries = static_cast<avifColorPrimaries>(form.primaries);
  image->transferCharacteristics = static_cast<avifTransferCharacteristics>(form.transfer);
  if (form.quarters > 0) {
    image->transformFlags |= AVIF_TRANSFORM_IROT;
    image->irot.angle = static_cast<std::uint8_t>(form.quarters);
  }
  if (form.mirrors) {
    image->transformFlags |= AVIF_TRANSFORM_IMIR;
    image->imir.mode = 1;
  }
  if (form.clap) {
    image->transformFlags |= AVIF_TRANSFORM_CLAP;
    image->clap = *form.clap;
  }
  avifRGBImage rgb;
  avifRGBImageSetDefaults(&rgb, image.get());
  rgb.depth = static_cast<std::uint32_t>(form.depth);
  rgb.format = picture.channels() == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.pixels = reinterpret_cast<std::uint8_t*>(const_cast<Sample*>(picture.samples().data()));
  rgb.rowBytes = static_cast<std::uint32_t>(std::size_t(picture.width() * picture.channels()) * sizeof(Sample));
  EXPECT_EQ(avifImageRGBToYUV(image.get(), &rgb), AVIF_RESULT_OK);
  const std::unique_ptr<avifEncoder, decltype(&avifEncoderDestroy)> encoder(avifEncoderCreate(), avifEncoderDestroy);
  encoder->speed = AVIF_SPEED_FASTEST;
  encoder->minQuantizer = encoder->maxQuantizer = AVIF_QUANTIZER_LOSSLESS;
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = AVIF_QUANTIZER_LOSSLESS;
  avifRWData output = AVIF_DATA_EMPTY;
  EXPECT_EQ(avifEncoderWrite(encoder.get(), image.get(), &output), AVIF_RESULT_OK);
  Bytes bytes(output.data, output.data + output.size);
  avifRWDataFree(&output);
  return bytes;
}

}  // namespace mirrorball::testing
