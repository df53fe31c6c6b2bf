#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/image/image.h"

namespace mirrorball {

/// How a sample, or a texel where samples share a word, or a block of texels, stands in a texture file. All but the
/// first two keep light.
enum class SampleType {
  srgb8,
  unorm8,
  unorm16,
  half,
  float32,
  b10g11r11,
  e5b9g9r9,
  bc6h_unsigned,
  bc6h_signed,
  uastc_hdr,
  srgb_bits,   ///< integers of 1 to 16 bits in one word, under masks
  unorm_bits,  ///< the same, not encoded
};

/// How a texel stands in a texture file: little-endian samples in the order of their names.
struct StoredFormat {
  SampleType type = SampleType::half;
  int channels = 4;                         ///< 1 to 4; 3 for the packed and the compressed types
  bool blue_first = false;                  ///< b g r a instead of r g b a
  bool ignores_fourth = false;              ///< b8g8r8x8: what the fourth channel holds means nothing
  std::uint32_t word_bytes = 0;             ///< of srgb_bits and unorm_bits: 1 to 4
  std::array<std::uint32_t, 4> masks = {};  ///< the bits of each channel in the word, side by side; 0: it is 0

  friend bool operator==(const StoredFormat&, const StoredFormat&) = default;
};

/// The format that one of the writer's options stands for.
StoredFormat storedFormat(TexelFormat format);

/// "r16g16b16a16 sfloat": Vulkan's name in lower case.
std::string formatName(const StoredFormat& format);

/// Texels along a side of the blocks in which texels are stored: 4 where they are compressed, else 1.
int blockSide(const StoredFormat& format);

/// Bytes of such a block: of one texel, where they are not compressed.
std::size_t blockSize(const StoredFormat& format);

/// How many blocks so many texels in a row or column take.
std::uint64_t blocksAlong(const StoredFormat& format, std::uint64_t texels);

/// Bytes of one number whose byte order matters: 1 (where there is none), 2 or 4.
std::size_t wordSize(const StoredFormat& format);

/// How many channels the decoded image has: two become three with no blue, for two would be grey and alpha.
int imageChannels(const StoredFormat& format);

/// Whether the samples are encoded by sRGB's curve.
bool hasSrgbCurve(const StoredFormat& format);

/// The same samples without sRGB's curve, of formats that state it: what they hold where they are numbers.
StoredFormat withoutCurve(StoredFormat format);

/// The curve from the stored samples to light.
TransferCurve transferCurve(const StoredFormat& format);

/// Decodes texels to linear light.
///
/// bytes    width · height texels, rows of blocks of `row_pitch` bytes, little-endian
/// returns  imageChannels(format) channels
/// errors   unsupported (the first block of ASTC that is none of UASTC HDR)
/// cost     on all cores, at the speed of memory for half and float; bc6h some 40 million texels a second and core
Result<Image> unpackTexels(const StoredFormat& format, const std::uint8_t* bytes, std::size_t row_pitch, int width,
                           int height);

/// Encodes rows of texels. What does not fit the format leaves unspecified bytes.
///
/// samples  1 (grey), 3 or 4 channels a texel, or 2 for the formats that have two; alpha is 1 where the format has it
///          and the samples do not, and what the format has no place for is dropped
/// width    texels of a row; only compressed formats ask
/// bytes    blockSize bytes a block
/// returns  whether every value fits: finite ones within the format's range, infinity and NaN only where it has them
bool packTexels(TexelFormat format, std::span<const float> samples, int channels, int width,
                std::span<std::uint8_t> bytes);

/// The first of some texels that does not fit the format, of which there must be one.
std::size_t firstMisfit(TexelFormat format, std::span<const float> samples, int channels);

/// Whether the format has no place for light below 0.
bool refusesNegativeLight(TexelFormat format);

/// The greatest value that every channel of the format holds.
float maxOf(TexelFormat format);

/// "half floats hold −65504 to 65504": for the message where a value does not fit.
std::string rangeOf(TexelFormat format);

}  // namespace mirrorball
