#include "mirrorball/codec/texture/ktx1.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/ktx1_layout.h"
#include "mirrorball/codec/texture/ktx_key_values.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {
namespace {

using namespace ktx1;
using Span = std::span<const std::uint8_t>;

/// glFormat, and what it says about channels. Luminance is one channel of light.
struct GlFormat {
  std::uint32_t number;
  int channels;
  bool blue_first;
};
constexpr GlFormat kGlFormats[] = {
    {0x1903, 1, false},         // GL_RED
    {0x1909, 1, false},         // GL_LUMINANCE
    {kRg, 2, false},            // GL_RG
    {kRgb, 3, false},           // GL_RGB
    {kRgba, 4, false},          // GL_RGBA
    {kR11FG11FB10F, 3, false},  // of Filament's older files
    {0x80e0, 3, true},          // GL_BGR
    {0x80e1, 4, true},          // GL_BGRA
};

/// glInternalFormat, where it says that 8-bit samples are encoded.
constexpr std::uint32_t kSrgbInternalFormats[] = {
    0x8c40,  // GL_SRGB
    0x8c41,  // GL_SRGB8
    0x8c42,  // GL_SRGB_ALPHA
    0x8c43,  // GL_SRGB8_ALPHA8
    0x8fbd,  // GL_SR8_EXT
    0x8fbe,  // GL_SRG8_EXT
    0x8c46,  // GL_SLUMINANCE
    0x8c47,  // GL_SLUMINANCE8
};

constexpr const char* kKtx1Instead = "GL_RGBA16F";

std::string hex(std::uint32_t number) {
  std::string digits;
  for (; number > 0; number /= 16) digits.insert(digits.begin(), "0123456789abcdef"[number % 16]);
  return "0x" + (digits.empty() ? "0" : digits);
}

std::optional<SampleType> sampleType(std::uint32_t gl_type, std::uint32_t gl_internal_format) {
  const bool srgb =
      std::count(std::begin(kSrgbInternalFormats), std::end(kSrgbInternalFormats), gl_internal_format) > 0;
  switch (gl_type) {
    case kUnsignedByte:
      return srgb ? SampleType::srgb8 : SampleType::unorm8;
    case kUnsignedShort:
      return SampleType::unorm16;
    case kFloat:
      return SampleType::float32;
    case kHalfFloat:
    case kHalfFloatOes:
      return SampleType::half;
    case kUnsignedInt10F11F11FRev:
    case kR11FG11FB10F:
      return SampleType::b10g11r11;
    case kUnsignedInt5999Rev:
      return SampleType::e5b9g9r9;
    default:
      return {};
  }
}

/// The format that glType and glFormat describe; glInternalFormat tells sRGB and names block compression.
Result<StoredFormat> ktx1TexelFormat(std::uint32_t gl_type, std::uint32_t gl_format, std::uint32_t gl_internal_format) {
  if (gl_internal_format == kRgbBptcSignedFloat) return StoredFormat{SampleType::bc6h_signed, 3};
  if (gl_internal_format == kRgbBptcUnsignedFloat) return StoredFormat{SampleType::bc6h_unsigned, 3};
  if (const auto blocks = blockCompressionOfGl(gl_internal_format)) return unsupportedTexture(*blocks, kKtx1Instead);
  const auto* row = std::find_if(std::begin(kGlFormats), std::end(kGlFormats),
                                 [&](const GlFormat& known) { return known.number == gl_format; });
  const auto type = sampleType(gl_type, gl_internal_format);
  const bool packed = type == SampleType::b10g11r11 || type == SampleType::e5b9g9r9;
  if (!type || row == std::end(kGlFormats) || (packed && row->channels != 3))
    return unsupportedTexture("texels of glType " + hex(gl_type) + ", glFormat " + hex(gl_format) +
                                  ", glInternalFormat " + hex(gl_internal_format),
                              kKtx1Instead);
  return StoredFormat{*type, row->channels, row->blue_first};
}

/// Walks over the levels: a size, then images, all at multiples of 4.
class Reader {
 public:
  Reader(Span bytes, ReadAs as) : bytes_(bytes), as_(as) {}

  Result<DecodedImageSet> read() {
    if (bytes_.size() < kKtx1HeaderSize) return truncated("the header");
    big_endian_ = bytes_[12] == 4;
    if (u32(12) != kByteOrder)
      return fail(ErrorCode::bad_file, "has no byte order mark at byte 12; the file is damaged");
    // gli states no face where there is one (g-truc/gli#98).
    TextureShape shape{u32(36), u32(40), std::max(u32(56), 1u), std::max(u32(48), 1u), std::max(u32(52), 1u)};
    if (u32(44) > 1) return unsupportedTexture("a three-dimensional texture", kKtx1Instead);
    if (shape.height == 0 && shape.width > 0) return unsupportedTexture("a one-dimensional texture", kKtx1Instead);
    MIRRORBALL_TRY_VOID(checkTextureShape(shape));
    MIRRORBALL_TRY(stored, ktx1TexelFormat(u32(16), u32(24), u32(28)));
    const StoredFormat format = as_ == ReadAs::light ? stored : withoutCurve(stored);

    const std::uint32_t key_value_size = u32(60);
    if (key_value_size > bytes_.size() - kKtx1HeaderSize) return truncated("the key/value data");
    MIRRORBALL_TRY(values, readKtxKeyValues(bytes_, kKtx1HeaderSize, key_value_size, big_endian_));
    at_ = kKtx1HeaderSize + key_value_size;
    const bool is_array = u32(48) > 0;
    MIRRORBALL_TRY_VOID(settleLevels(format, shape));
    MIRRORBALL_TRY_VOID(checkTextureMemory(shape, format));
    MIRRORBALL_TRY(images, readLevels(shape, format, is_array));
    if (images.faces() == 1) forEachImage(images, [&](Image& image) { turnUpright(image, values); });
    if (!values.swizzle.empty()) oddities_.push_back(swizzleRemark(values));
    if (format != stored) tellUnapplied("sRGB", oddities_);
    const std::string color = describeColor(transferCurve(format), {}, imageChannels(format));
    return DecodedImageSet{.images = std::move(images),
                           .metadata = std::move(values.metadata),
                           .format = "KTX1, " + formatName(stored) + (big_endian_ ? ", big-endian" : ""),
                           .color = as_ == ReadAs::light ? color : std::string(kAsStored),
                           .oddities = std::move(oddities_),
                           .is_converted = hasSrgbCurve(format)};
  }

 private:
  std::uint32_t u32(std::size_t at) const {
    return big_endian_ ? bigU32(bytes_.data() + at) : littleU32(bytes_.data() + at);
  }

  tl::unexpected<Error> truncated(const std::string& what) const {
    return fail(ErrorCode::bad_file,
                what + " ends early, at byte " + std::to_string(bytes_.size()) + "; the file is truncated or damaged");
  }

  /// Before memory is taken: the levels are those that the file is long enough for. The largest stands first.
  Result<void> settleLevels(const StoredFormat& format, TextureShape& shape) {
    const auto level_bytes = [&](std::uint32_t level) {
      return 4 + imageSize(shape, format, static_cast<int>(level), kAlignment) * shape.imagesPerLevel();
    };
    const std::uint32_t stated = shape.levels;
    std::uint64_t total = 0;
    for (std::uint32_t level = 0; level < stated; ++level) total += level_bytes(level);
    const std::uint64_t all = total;
    while (shape.levels > 0 && total > bytes_.size() - at_) total -= level_bytes(--shape.levels);
    if (shape.levels == 0)
      return fail(ErrorCode::bad_file, "its levels have " + std::to_string(all) + " bytes from byte " +
                                           std::to_string(at_) + " on, but the file has " +
                                           std::to_string(bytes_.size()) + "; it is truncated or damaged");
    if (shape.levels != stated) oddities_.push_back(levelsRemark(stated, shape.levels));
    return {};
  }

  /// Whether the sizes that stand before the levels are those of all images of a level, as they are but for a cube that
  /// is no array, where they are those of one face. Older versions of gli and bimg took the one for the other
  /// (kopaka1822/ImageViewer#16, bkaradzic/bimg#64, #82).
  bool statesWholeLevels(bool is_array, std::uint32_t stated, std::uint64_t of_image, std::uint64_t of_level) {
    const bool is_other = of_image != of_level && stated == (is_array ? of_image : of_level);
    if (is_other)
      oddities_.push_back(is_array ? "states the size of one image where that of its level should stand: read as such"
                                   : "states the size of six faces where that of one should stand: read as such");
    return is_array != is_other;
  }

  Result<ImageSet> readLevels(const TextureShape& shape, const StoredFormat& format, bool is_array) {
    ImageSet images(static_cast<int>(shape.levels), static_cast<int>(shape.faces), static_cast<int>(shape.layers));
    bool states_levels = is_array;
    for (int level = 0; level < images.levels(); ++level) {
      const std::uint64_t size = imageSize(shape, format, level, kAlignment);
      const std::uint64_t of_level = size * shape.imagesPerLevel();
      const std::uint32_t stated = u32(at_);
      if (level == 0) states_levels = statesWholeLevels(is_array, stated, size, of_level);
      const std::uint64_t expected = states_levels ? of_level : size;
      if (stated != expected)
        return fail(ErrorCode::bad_file, "level " + std::to_string(level) + " at byte " + std::to_string(at_) +
                                             " says it has " + counted(stated, "byte") + "; as " + formatName(format) +
                                             " it has " + std::to_string(expected));
      at_ += 4;
      for (int layer = 0; layer < images.layers(); ++layer)
        for (int face = 0; face < images.faces(); ++face, at_ += size) {
          MIRRORBALL_TRY(image, readImage(shape, format, level));
          images.at(level, face, layer) = std::move(image);
        }
    }
    return images;
  }

  Result<Image> readImage(const TextureShape& shape, const StoredFormat& format, int level) const {
    const Span stored = bytes_.subspan(at_, static_cast<std::size_t>(imageSize(shape, format, level, kAlignment)));
    const int width = shape.widthAt(level);
    const int height = shape.heightAt(level);
    const std::size_t pitch = stored.size() / blocksAlong(format, std::uint64_t(height));
    const std::size_t word = wordSize(format);
    if (!big_endian_ || word == 1) return unpackTexels(format, stored.data(), pitch, width, height);
    std::vector<std::uint8_t> swapped(stored.begin(), stored.end());
    for (std::size_t i = 0; i + word <= swapped.size(); i += word)
      std::reverse(swapped.begin() + static_cast<std::ptrdiff_t>(i),
                   swapped.begin() + static_cast<std::ptrdiff_t>(i + word));
    return unpackTexels(format, swapped.data(), pitch, width, height);
  }

  Span bytes_;
  ReadAs as_;
  bool big_endian_ = false;
  std::size_t at_ = 0;
  std::vector<std::string> oddities_ = {};
};

}  // namespace

bool isKtx1(Span bytes) {
  return bytes.size() >= kIdentifier.size() && std::equal(kIdentifier.begin(), kIdentifier.end(), bytes.begin());
}

Result<DecodedImageSet> decodeKtx1(Span bytes, ReadAs as) { return Reader(bytes, as).read(); }

}  // namespace mirrorball
