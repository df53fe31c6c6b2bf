#include "mirrorball/codec/texture/data_format_descriptor.h"

#include <array>
#include <span>
#include <vector>

#include "mirrorball/base/bit_cast.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/little_endian_writer.h"

namespace mirrorball {
namespace {

constexpr std::size_t kBlockSize = 24;  // the basic block without its samples
constexpr std::size_t kSampleSize = 16;
constexpr std::uint16_t kVersion = 2;  // KHR_DF_VERSIONNUMBER_1_3, which 1.4 keeps
constexpr std::uint8_t kModelRgbsda = 1;
constexpr std::uint8_t kModelBc6h = 133;
// KHR_DF_PRIMARIES_*
constexpr std::uint8_t kPrimariesBt709 = 1;
constexpr std::uint8_t kPrimariesBt2020 = 4;
constexpr std::uint8_t kPrimariesAcesCc = 7;  // AP1, which ACEScg shares; the curve is stated beside it
constexpr std::uint8_t kPrimariesDisplayP3 = 10;
constexpr std::uint8_t kTransferLinear = 1;
constexpr std::uint8_t kTransferSrgb = 2;

// A sample's channel type: which colour in the lower four bits, then qualifiers.
constexpr std::uint8_t kAlpha = 15;
constexpr std::uint8_t kExponent = 0x20;
constexpr std::uint8_t kSigned = 0x40;
constexpr std::uint8_t kFloatSamples = 0x80;

/// One row of the descriptor's list of samples.
struct Sample {
  std::uint16_t bit_offset;
  std::uint8_t bits;
  std::uint8_t channel_type;
  std::uint32_t lower;  ///< what stands for −1 or 0; a float's bits where the sample is one
  std::uint32_t upper;  ///< what stands for 1
};

constexpr std::array<std::uint8_t, 4> kFloatChannels{0, 1, 2, kAlpha};

const std::uint32_t kOne = bitCast<std::uint32_t>(1.0f);
const std::uint32_t kMinusOne = bitCast<std::uint32_t>(-1.0f);

/// Floats one behind the other: red, green, blue and alpha, or the first few of them.
std::vector<Sample> floatSamples(std::uint8_t bits, int channels) {
  std::vector<Sample> samples;
  for (const std::uint8_t channel : std::span(kFloatChannels).first(std::size_t(channels)))
    samples.push_back({static_cast<std::uint16_t>(bits * samples.size()), bits,
                       static_cast<std::uint8_t>(channel | kFloatSamples | kSigned), kMinusOne, kOne});
  return samples;
}

std::vector<Sample> samplesOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::half:
      return floatSamples(16, 4);
    case TexelFormat::float32:
      return floatSamples(32, 4);
    case TexelFormat::rg_half:
      return floatSamples(16, 2);
    case TexelFormat::rg_float32:
      return floatSamples(32, 2);
    case TexelFormat::bc6h:
    case TexelFormat::uastc_hdr:  // one sample, the colour, of all the block's bits
      return {{0, 128, kFloatSamples | 0, 0, kOne}};
    case TexelFormat::b10g11r11:
      return {{0, 11, kFloatSamples | 0, 0, kOne},
              {11, 11, kFloatSamples | 1, 0, kOne},
              {22, 10, kFloatSamples | 2, 0, kOne}};
    default: {
      // Each channel is a mantissa and the common exponent, whose bias is 15 and largest value 31. The upper value of
      // the mantissa is what the specification's example of this format has.
      constexpr std::uint32_t kUpperMantissa = 8448;
      std::vector<Sample> samples;
      for (std::uint8_t channel = 0; channel < 3; ++channel) {
        samples.push_back({static_cast<std::uint16_t>(9 * channel), 9, channel, 0, kUpperMantissa});
        samples.push_back({27, 5, static_cast<std::uint8_t>(channel | kExponent), 15, 31});
      }
      return samples;
    }
  }
}

std::uint8_t modelOf(TexelFormat format) {
  if (format == TexelFormat::bc6h) return kModelBc6h;
  return format == TexelFormat::uastc_hdr ? kModelUastcHdr : kModelRgbsda;
}

/// The chromaticities of KHR_DF_PRIMARIES_*, by number; those not listed are Rec.709's or
/// unspecified, or too rare to convert.
std::optional<Primaries> primariesOf(int number) {
  switch (number) {
    case 2:
      return kRec601Of625Lines;
    case 3:  // as SMPTE 170M
      return kRec601Of525Lines;
    case kPrimariesBt2020:
      return kRec2020;
    case 6:  // ACES 2065-1
      return kAcesAp0;
    case kPrimariesAcesCc:
      return kAcesAp1;
    case kPrimariesDisplayP3:
      return kDisplayP3;
    case 11:
      return kAdobeRgb;
    default:
      return {};
  }
}

std::uint8_t primariesNumber(OutputPrimaries primaries) {
  constexpr std::array<std::uint8_t, 4> kNumbers{kPrimariesBt709, kPrimariesDisplayP3, kPrimariesBt2020,
                                                 kPrimariesAcesCc};
  return kNumbers[static_cast<std::size_t>(primaries)];
}

}  // namespace

Result<DescribedColor> readDataFormatDescriptor(std::span<const std::uint8_t> bytes, std::size_t begin,
                                                std::size_t size, ReadAs as) {
  const std::string place = "the data format descriptor at byte " + std::to_string(begin);
  const std::uint8_t* descriptor = bytes.data() + begin;
  // SlimKTX2 made the environments of the glTF Sample Viewer so (KhronosGroup/glTF-Sample-Environments#6).
  if (size == 0 || (size >= 4 && littleU32(descriptor) == 0)) return DescribedColor{.is_missing = true};
  if (size < 4 + kBlockSize || littleU32(descriptor) != size)
    return fail(ErrorCode::bad_file,
                place + " is not as long as the header says (" + std::to_string(size) + " bytes); the file is damaged");
  DescribedColor color;
  // Vendor and type of a block: 0 and 0 is Khronos's basic one. Others say nothing that is needed here.
  if (littleU32(descriptor + 4) != 0) return color;
  color.model = descriptor[12];
  color.primaries = primariesOf(descriptor[13]);
  const int transfer = descriptor[14];
  color.srgb = transfer == kTransferSrgb;
  color.has_other_curve = transfer > kTransferSrgb;
  if (color.has_other_curve && as == ReadAs::light)
    return fail(ErrorCode::unsupported, place + " names the transfer function " + std::to_string(transfer) +
                                            "; only linear (1) and sRGB (2) are read: convert the texture");
  return color;
}

Bytes dataFormatDescriptor(TexelFormat format, OutputPrimaries primaries) {
  const std::vector<Sample> samples = samplesOf(format);
  const std::size_t block_size = kBlockSize + samples.size() * kSampleSize;
  LittleEndianWriter writer;
  writer.u32(static_cast<std::uint32_t>(4 + block_size));
  writer.u32(0);  // Khronos, basic format
  writer.u16(kVersion);
  writer.u16(static_cast<std::uint16_t>(block_size));
  const StoredFormat stored = storedFormat(format);
  const auto side = static_cast<std::uint8_t>(blockSide(stored) - 1);
  writer.u8(modelOf(format));
  writer.u8(primariesNumber(primaries));
  writer.u8(kTransferLinear);
  writer.u8(0);     // straight alpha
  writer.u8(side);  // of a block, less one: across, down, and in two more dimensions
  writer.u8(side);
  writer.zeros(2);
  writer.u8(static_cast<std::uint8_t>(blockSize(stored)));
  writer.zeros(7);  // one plane only
  for (const Sample& sample : samples) {
    writer.u16(sample.bit_offset);
    writer.u8(static_cast<std::uint8_t>(sample.bits - 1));
    writer.u8(sample.channel_type);
    writer.zeros(4);  // at the block's corner
    writer.u32(sample.lower);
    writer.u32(sample.upper);
  }
  return writer.takeBytes();
}

}  // namespace mirrorball
