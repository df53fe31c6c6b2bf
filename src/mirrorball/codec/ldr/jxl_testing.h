#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <jxl/encode.h>

#include "mirrorball/base/file.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// How libjxl is to write a picture.
struct JxlForm {
  JxlTransferFunction transfer = JXL_TRANSFER_FUNCTION_SRGB;
  JxlPrimaries primaries = JXL_PRIMARIES_SRGB;
  bool is_lossy = false;
  int orientation = 1;               ///< as cameras number them
  std::uint32_t extra_channels = 0;  ///< beside alpha, all black
  std::string other_xml = {};        ///< in a box that Brotli compresses; empty: none
  std::string xmp = {};              ///< in another behind it
};

/// A picture of 3 or 4 channels.
///
/// Sample   std::uint8_t, std::uint16_t, or float
template <typename Sample>
Bytes jxlFile(const ImageOf<Sample>& picture, const JxlForm& form = {}) {
  constexpr bool kIsFloat = std::is_same_v<Sample, float>;
  const std::unique_ptr<JxlEncoder, decltype(&JxlEncoderDestroy)> encoder(JxlEncoderCreate(nullptr), JxlEncoderDestroy);
  const auto channels = static_cast<std::uint32_t>(picture.channels());
  JxlBasicInfo info;
  JxlEncoderInitBasicInfo(&info);
  info.xsize = static_cast<std::uint32_t>(picture.width());
  info.ysize = static_cast<std::uint32_t>(picture.height());
  info.bits_per_sample = 8 * sizeof(Sample);
  info.exponent_bits_per_sample = kIsFloat ? 8 : 0;
  info.uses_original_profile = form.is_lossy ? JXL_FALSE : JXL_TRUE;
  info.orientation = static_cast<JxlOrientation>(form.orientation);
  if (channels == 4) {
    info.num_extra_channels = 1;
    info.alpha_bits = info.bits_per_sample;
    info.alpha_exponent_bits = info.exponent_bits_per_sample;
  }
  const std::uint32_t first_extra = info.num_extra_channels;
  info.num_extra_channels += form.extra_channels;
  EXPECT_EQ(JxlEncoderSetBasicInfo(encoder.get(), &info), JXL_ENC_SUCCESS);
  JxlColorEncoding color;
  JxlColorEncodingSetToSRGB(&color, JXL_FALSE);
  color.transfer_function = form.transfer;
  color.primaries = form.primaries;
  EXPECT_EQ(JxlEncoderSetColorEncoding(encoder.get(), &color), JXL_ENC_SUCCESS);
  for (std::uint32_t i = first_extra; i < info.num_extra_channels; ++i) {
    JxlExtraChannelInfo extra;
    JxlEncoderInitExtraChannelInfo(JXL_CHANNEL_OPTIONAL, &extra);
    EXPECT_EQ(JxlEncoderSetExtraChannelInfo(encoder.get(), i, &extra), JXL_ENC_SUCCESS);
  }
  if (!form.other_xml.empty() || !form.xmp.empty()) EXPECT_EQ(JxlEncoderUseBoxes(encoder.get()), JXL_ENC_SUCCESS);
  for (const std::string& text : {form.other_xml, form.xmp}) {
    if (text.empty()) continue;
    const auto* xml = reinterpret_cast<const std::uint8_t*>(text.data());
    EXPECT_EQ(JxlEncoderAddBox(encoder.get(), "xml ", xml, text.size(), JXL_TRUE), JXL_ENC_SUCCESS);
  }
  JxlEncoderFrameSettings* settings = JxlEncoderFrameSettingsCreate(encoder.get(), nullptr);
  if (form.is_lossy)
    JxlEncoderSetFrameDistance(settings, 0.5f);
  else
    JxlEncoderSetFrameLossless(settings, JXL_TRUE);
  const JxlDataType type = kIsFloat ? JXL_TYPE_FLOAT : sizeof(Sample) == 1 ? JXL_TYPE_UINT8 : JXL_TYPE_UINT16;
  const JxlPixelFormat format{channels, type, JXL_NATIVE_ENDIAN, 0};
  EXPECT_EQ(JxlEncoderAddImageFrame(settings, &format, picture.samples().data(), picture.samples().size_bytes()),
            JXL_ENC_SUCCESS);
  const Image8 black(picture.width(), picture.height(), 1);
  const JxlPixelFormat grey{1, JXL_TYPE_UINT8, JXL_NATIVE_ENDIAN, 0};
  for (std::uint32_t i = first_extra; i < info.num_extra_channels; ++i)
    EXPECT_EQ(JxlEncoderSetExtraChannelBuffer(settings, &grey, black.samples().data(), black.samples().size(), i),
              JXL_ENC_SUCCESS);
  JxlEncoderCloseInput(encoder.get());
  Bytes bytes(1 << 20);
  std::uint8_t* next = bytes.data();
  std::size_t left = bytes.size();
  EXPECT_EQ(JxlEncoderProcessOutput(encoder.get(), &next, &left), JXL_ENC_SUCCESS);
  bytes.resize(bytes.size() - left);
  return bytes;
}

}  // namespace mirrorball::testing
