// Small pictures of all that libjxl 0.7 writes.

#include <cmath>
#include <memory>

#include <jxl/encode.h>

#include "chance.h"
#include "jxl_mutation.h"
#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/ldr/jpeg.h"

namespace mirrorball::fuzz {
namespace {

using JxlEncoderPtr = std::unique_ptr<JxlEncoder, decltype(&JxlEncoderDestroy)>;

/// A setting of a frame, and the numbers that it may have; which number means what stands in jxl/encode.h.
struct JxlSetting {
  JxlEncoderFrameSettingId id;
  int least, most;
};

// libjxl 0.7's encoder ends the program where settings for the one go with the other, and now and then where a lossy
// picture is made progressive by its DC or by bits, which are not among these: the corpus has three such pictures.
constexpr JxlSetting kLosslessSettings[] = {{JXL_ENC_FRAME_SETTING_DECODING_SPEED, 0, 4},
                                            {JXL_ENC_FRAME_SETTING_KEEP_INVISIBLE, 0, 1},
                                            {JXL_ENC_FRAME_SETTING_GROUP_ORDER, 0, 1},
                                            {JXL_ENC_FRAME_SETTING_RESPONSIVE, 0, 1},
                                            {JXL_ENC_FRAME_SETTING_PALETTE_COLORS, 0, 300},
                                            {JXL_ENC_FRAME_SETTING_MODULAR_COLOR_SPACE, 0, 41},
                                            {JXL_ENC_FRAME_SETTING_MODULAR_GROUP_SIZE, 0, 3},
                                            {JXL_ENC_FRAME_SETTING_MODULAR_PREDICTOR, 0, 15},
                                            {JXL_ENC_FRAME_SETTING_MODULAR_NB_PREV_CHANNELS, 0, 3}};
constexpr JxlSetting kLossySettings[] = {{JXL_ENC_FRAME_SETTING_DECODING_SPEED, 0, 4},
                                         {JXL_ENC_FRAME_SETTING_RESAMPLING, 1, 2},
                                         {JXL_ENC_FRAME_SETTING_NOISE, 0, 1},
                                         {JXL_ENC_FRAME_SETTING_DOTS, 0, 1},
                                         {JXL_ENC_FRAME_SETTING_EPF, 0, 3},
                                         {JXL_ENC_FRAME_SETTING_GABORISH, 0, 1},
                                         {JXL_ENC_FRAME_SETTING_MODULAR, 0, 1},
                                         {JXL_ENC_FRAME_SETTING_GROUP_ORDER, 0, 1},
                                         {JXL_ENC_FRAME_SETTING_PROGRESSIVE_AC, 0, 1}};

/// What all frames of a file have in common.
struct JxlSamples {
  JxlPixelFormat format = {};
  std::uint32_t width = 0, height = 0;
};

/// Samples that rise over the picture, with some noise among them or none.
Bytes anyJxlSamples(const JxlSamples& samples, std::mt19937& random) {
  const std::size_t count = std::size_t{samples.width} * samples.height * samples.format.num_channels;
  const std::size_t noise = pick<std::size_t>({1, 1, 3, 20, 256}, random);
  const std::size_t step = below(9, random);
  Bytes bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t level = (i * step / 4 + below(noise, random)) & 255u;
    if (samples.format.data_type == JXL_TYPE_FLOAT) {
      const float value = static_cast<float>(level) / 128.0f - 0.25f;
      const auto* start = reinterpret_cast<const std::uint8_t*>(&value);
      bytes.insert(bytes.end(), start, start + sizeof(value));
    } else {
      bytes.push_back(static_cast<std::uint8_t>(level));
      if (samples.format.data_type == JXL_TYPE_UINT16) bytes.push_back(static_cast<std::uint8_t>(level));
    }
  }
  return bytes;
}

JxlColorEncoding anyJxlColor(bool is_grey, std::mt19937& random) {
  JxlColorEncoding color{};
  JxlColorEncodingSetToSRGB(&color, is_grey ? JXL_TRUE : JXL_FALSE);
  if (onceIn(2, random)) return color;
  color.white_point =
      pick({JXL_WHITE_POINT_D65, JXL_WHITE_POINT_CUSTOM, JXL_WHITE_POINT_E, JXL_WHITE_POINT_DCI}, random);
  color.primaries = pick({JXL_PRIMARIES_SRGB, JXL_PRIMARIES_CUSTOM, JXL_PRIMARIES_2100, JXL_PRIMARIES_P3}, random);
  color.transfer_function = pick(
      {JXL_TRANSFER_FUNCTION_709, JXL_TRANSFER_FUNCTION_LINEAR, JXL_TRANSFER_FUNCTION_SRGB, JXL_TRANSFER_FUNCTION_PQ,
       JXL_TRANSFER_FUNCTION_DCI, JXL_TRANSFER_FUNCTION_HLG, JXL_TRANSFER_FUNCTION_GAMMA},
      random);
  color.rendering_intent = static_cast<JxlRenderingIntent>(below(4, random));
  const auto place = [&](double* xy, double x, double y) {
    xy[0] = x + 0.01 * static_cast<double>(below(5, random));
    xy[1] = y + 0.01 * static_cast<double>(below(5, random));
  };
  place(color.white_point_xy, 0.3, 0.31);
  place(color.primaries_red_xy, 0.62, 0.3);
  place(color.primaries_green_xy, 0.2, 0.68);
  place(color.primaries_blue_xy, 0.13, 0.05);
  color.gamma = pick({1.0, 0.45, 0.3, 0.1}, random);
  return color;
}

JxlBasicInfo anyJxlInfo(bool is_lossless, std::mt19937& random) {
  JxlBasicInfo info;
  JxlEncoderInitBasicInfo(&info);
  const std::size_t longest = onceIn(32, random) ? 300 : 24;
  info.xsize = static_cast<std::uint32_t>(1 + below(longest, random));
  info.ysize = static_cast<std::uint32_t>(1 + below(longest, random));
  info.bits_per_sample = pick({1u, 4u, 8u, 8u, 8u, 10u, 12u, 16u, 16u, 32u}, random);
  info.exponent_bits_per_sample = info.bits_per_sample == 32 ? 8 : 0;
  if (info.bits_per_sample == 16 && is_lossless && onceIn(2, random)) info.exponent_bits_per_sample = 5;
  info.num_color_channels = onceIn(4, random) ? 1 : 3;
  info.orientation = static_cast<JxlOrientation>(onceIn(2, random) ? 1 : 1 + below(8, random));
  info.uses_original_profile = is_lossless || onceIn(3, random) ? JXL_TRUE : JXL_FALSE;
  info.intensity_target = pick({0.0f, 0.0f, 255.0f, 10000.0f}, random);
  info.num_extra_channels = onceIn(3, random) ? static_cast<std::uint32_t>(below(4, random)) : 0;
  if (onceIn(3, random)) {
    info.num_extra_channels += 1;
    info.alpha_bits = info.bits_per_sample;
    info.alpha_exponent_bits = info.exponent_bits_per_sample;
    info.alpha_premultiplied = onceIn(4, random) ? JXL_TRUE : JXL_FALSE;
  }
  if (onceIn(16, random)) {
    info.have_animation = JXL_TRUE;
    info.animation = {10, 1, 0, JXL_FALSE};
  }
  return info;
}

/// Describes the channels behind alpha. Those that libjxl does not take, it goes without.
void describeExtraChannels(JxlEncoder* encoder, const JxlBasicInfo& info, std::mt19937& random) {
  constexpr JxlExtraChannelType kTypes[] = {JXL_CHANNEL_DEPTH, JXL_CHANNEL_SPOT_COLOR, JXL_CHANNEL_SELECTION_MASK,
                                            JXL_CHANNEL_BLACK, JXL_CHANNEL_CFA,        JXL_CHANNEL_THERMAL,
                                            JXL_CHANNEL_ALPHA, JXL_CHANNEL_OPTIONAL};
  for (std::uint32_t i = info.alpha_bits > 0 ? 1 : 0; i < info.num_extra_channels; ++i) {
    JxlExtraChannelInfo extra;
    JxlEncoderInitExtraChannelInfo(pick(kTypes, random), &extra);
    extra.bits_per_sample = pick({1u, 8u, 16u}, random);
    for (float& share : extra.spot_color) share = 0.25f * static_cast<float>(below(5, random));
    JxlEncoderSetExtraChannelInfo(encoder, i, &extra);
  }
}

/// Adds a frame over all of the picture or, where there are several, over some of it.
bool addJxlFrame(JxlEncoder* encoder, const JxlBasicInfo& info, bool is_lossless, bool is_layer, std::mt19937& random) {
  JxlEncoderFrameSettings* settings = JxlEncoderFrameSettingsCreate(encoder, nullptr);
  JxlEncoderFrameSettingsSetOption(settings, JXL_ENC_FRAME_SETTING_EFFORT,
                                   static_cast<std::int64_t>(1 + below(onceIn(8, random) ? 7 : 4, random)));
  for (std::size_t i = below(5, random); i > 0; --i) {
    const JxlSetting& setting = is_lossless ? pick(kLosslessSettings, random) : pick(kLossySettings, random);
    const int number = setting.least + static_cast<int>(below(std::size_t(setting.most - setting.least) + 1, random));
    JxlEncoderFrameSettingsSetOption(settings, setting.id, number);
  }
  if (is_lossless)
    JxlEncoderSetFrameLossless(settings, JXL_TRUE);
  else
    JxlEncoderSetFrameDistance(settings, pick({0.01f, 0.5f, 1.0f, 3.0f, 15.0f}, random));

  JxlSamples samples{.width = info.xsize, .height = info.ysize};
  if (is_layer) {
    JxlFrameHeader header;
    JxlEncoderInitFrameHeader(&header);
    samples.width = static_cast<std::uint32_t>(1 + below(info.xsize, random));
    samples.height = static_cast<std::uint32_t>(1 + below(info.ysize, random));
    header.duration = info.have_animation != 0 ? 3 : 0;
    header.layer_info.have_crop = JXL_TRUE;
    header.layer_info.crop_x0 = static_cast<std::int32_t>(below(24, random)) - 12;
    header.layer_info.crop_y0 = static_cast<std::int32_t>(below(24, random)) - 12;
    header.layer_info.xsize = samples.width;
    header.layer_info.ysize = samples.height;
    header.layer_info.blend_info.blendmode = static_cast<JxlBlendMode>(below(5, random));
    header.layer_info.save_as_reference = static_cast<std::uint32_t>(below(3, random));
    JxlEncoderSetFrameHeader(settings, &header);
  }
  const bool is_float = info.exponent_bits_per_sample > 0;
  samples.format = {info.num_color_channels + (info.alpha_bits > 0 ? 1 : 0),
                    is_float                    ? JXL_TYPE_FLOAT
                    : info.bits_per_sample <= 8 ? JXL_TYPE_UINT8
                                                : JXL_TYPE_UINT16,
                    JXL_NATIVE_ENDIAN, 0};
  const Bytes pixels = anyJxlSamples(samples, random);
  if (JxlEncoderAddImageFrame(settings, &samples.format, pixels.data(), pixels.size()) != JXL_ENC_SUCCESS) return false;
  samples.format = {1, JXL_TYPE_UINT8, JXL_NATIVE_ENDIAN, 0};
  for (std::uint32_t i = info.alpha_bits > 0 ? 1 : 0; i < info.num_extra_channels; ++i) {
    const Bytes extra = anyJxlSamples(samples, random);
    if (JxlEncoderSetExtraChannelBuffer(settings, &samples.format, extra.data(), extra.size(), i) != JXL_ENC_SUCCESS)
      return false;
  }
  return true;
}

bool addFramesOfSamples(JxlEncoder* encoder, std::mt19937& random) {
  const bool is_lossless = onceIn(2, random);
  const JxlBasicInfo info = anyJxlInfo(is_lossless, random);
  if (JxlEncoderSetBasicInfo(encoder, &info) != JXL_ENC_SUCCESS) return false;
  describeExtraChannels(encoder, info, random);
  if (info.num_color_channels == 3 && onceIn(8, random)) {
    const Bytes profile = testing::iccDisplayP3();
    if (JxlEncoderSetICCProfile(encoder, profile.data(), profile.size()) != JXL_ENC_SUCCESS) return false;
  } else {
    const JxlColorEncoding color = anyJxlColor(info.num_color_channels == 1, random);
    if (JxlEncoderSetColorEncoding(encoder, &color) != JXL_ENC_SUCCESS) return false;
  }
  if (!addJxlFrame(encoder, info, is_lossless, false, random)) return false;
  for (std::size_t layers = onceIn(4, random) ? 1 + below(2, random) : 0; layers > 0; --layers)
    if (!addJxlFrame(encoder, info, is_lossless, true, random)) return false;
  return true;
}

/// A JPEG with what it takes to restore its bytes.
bool addFrameOfJpeg(JxlEncoder* encoder, std::mt19937& random) {
  Image8 picture(1 + int(below(20, random)), 1 + int(below(20, random)), onceIn(2, random) ? 1 : 3);
  for (std::uint8_t& sample : picture.samples()) sample = static_cast<std::uint8_t>(random() & 63u);
  const auto jpeg = encodeJpeg(picture, {});
  JxlEncoderStoreJPEGMetadata(encoder, JXL_TRUE);
  JxlEncoderFrameSettings* settings = JxlEncoderFrameSettingsCreate(encoder, nullptr);
  return JxlEncoderAddJPEGFrame(settings, jpeg->data(), jpeg->size()) == JXL_ENC_SUCCESS;
}

std::optional<Bytes> encodedJxl(std::mt19937& random) {
  const JxlEncoderPtr encoder(JxlEncoderCreate(nullptr), JxlEncoderDestroy);
  JxlEncoderSetCodestreamLevel(encoder.get(), 10);
  const bool has_boxes = onceIn(4, random);
  if (has_boxes) JxlEncoderUseBoxes(encoder.get());
  const bool has_frames =
      onceIn(12, random) ? addFrameOfJpeg(encoder.get(), random) : addFramesOfSamples(encoder.get(), random);
  if (!has_frames) return std::nullopt;
  if (has_boxes) {
    const Bytes content(8 + below(40, random), static_cast<std::uint8_t>(random() & 1u));
    JxlEncoderAddBox(encoder.get(), onceIn(2, random) ? "Exif" : "xml ", content.data(), content.size(),
                     onceIn(2, random) ? JXL_TRUE : JXL_FALSE);
  }
  JxlEncoderCloseInput(encoder.get());
  Bytes bytes(1 << 20);
  std::uint8_t* next = bytes.data();
  std::size_t left = bytes.size();
  if (JxlEncoderProcessOutput(encoder.get(), &next, &left) != JXL_ENC_SUCCESS) return std::nullopt;
  bytes.resize(bytes.size() - left);
  return bytes;
}

}  // namespace

Bytes anyJxl(std::uint32_t number) {
  std::mt19937 random(number % kAnyJxls);
  for (;;)
    if (auto bytes = encodedJxl(random)) return *std::move(bytes);
}

}  // namespace mirrorball::fuzz
