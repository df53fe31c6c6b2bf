#include "mirrorball/codec/texture/dds.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/texture/dds_layout.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"

namespace mirrorball {
namespace {

using namespace dds;
using Span = std::span<const std::uint8_t>;

/// What the headers say.
struct DdsHeader {
  TextureShape shape;
  StoredFormat format;
  bool encoding_assumed = false;    ///< the file does not say whether it is sRGB
  std::size_t size = 0;             ///< bytes: the texels begin here
  std::size_t row_alignment = 1;    ///< bytes: rows of texels are multiples of them
  std::uint32_t stored_levels = 1;  ///< of each image, of which `shape` may have fewer, the largest
  std::vector<std::string> oddities = {};
  std::string channel_guess = {};  ///< DecodedImageSet's

  std::uint64_t texelBytes() const { return chainSize(shape, format, row_alignment) * shape.imagesPerLevel(); }
};

constexpr const char* kDdsInstead = "R16G16B16A16_FLOAT";

/// Formats from before DX10 that have a code instead of masks: D3DFORMAT's numbers.
std::optional<StoredFormat> formatOfCode(std::uint32_t code) {
  switch (code) {
    case 36:  // D3DFMT_A16B16G16R16
      return StoredFormat{SampleType::unorm16, 4};
    case 111:  // D3DFMT_R16F
      return StoredFormat{SampleType::half, 1};
    case 112:  // D3DFMT_G16R16F
      return StoredFormat{SampleType::half, 2};
    case 113:  // D3DFMT_A16B16G16R16F
      return StoredFormat{SampleType::half, 4};
    case 114:  // D3DFMT_R32F
      return StoredFormat{SampleType::float32, 1};
    case 115:  // D3DFMT_G32R32F
      return StoredFormat{SampleType::float32, 2};
    case 116:  // D3DFMT_A32B32G32R32F
      return StoredFormat{SampleType::float32, 4};
    default:
      return {};
  }
}

/// "DXT5", or a number where the code has no letters.
std::string nameOfCode(std::uint32_t code) {
  std::string letters;
  for (int i = 0; i < 4; ++i) letters += static_cast<char>(code >> (8 * i));
  if (std::all_of(letters.begin(), letters.end(), [](unsigned char c) { return std::isalnum(c) != 0; }))
    return letters + " (block compression or another code)";
  return "the pixel format " + std::to_string(code);
}

/// Bytes one behind the other, as bit masks of red, green, blue and alpha name them.
struct MaskRow {
  std::uint32_t bits;
  std::uint32_t red, green, blue, alpha;
  StoredFormat format;
};
constexpr MaskRow kMaskRows[] = {
    {32, 0xff0000, 0xff00, 0xff, 0xff000000, {SampleType::srgb8, 4, true}},
    {32, 0xff0000, 0xff00, 0xff, 0, {SampleType::srgb8, 4, true, true}},
    {32, 0xff, 0xff00, 0xff0000, 0xff000000, {SampleType::srgb8, 4}},
    {32, 0xff, 0xff00, 0xff0000, 0, {SampleType::srgb8, 4, false, true}},
    {24, 0xff0000, 0xff00, 0xff, 0, {SampleType::srgb8, 3, true}},
    {24, 0xff, 0xff00, 0xff0000, 0, {SampleType::srgb8, 3}},
    {8, 0xff, 0, 0, 0, {SampleType::srgb8, 1}},
};

/// Whether a mask's bits stand side by side, at most 16 of them, within a word.
bool isMask(std::uint32_t mask, std::uint32_t bits) {
  constexpr int kMostBits = 16;
  if (mask == 0) return true;
  const std::uint32_t codes = mask >> std::countr_zero(mask);
  return (codes & (codes + 1)) == 0 && std::popcount(mask) <= kMostBits && (bits == 32 || mask >> bits == 0);
}

/// Integers of any bits under masks: 5:6:5, 5:5:5:1, 4:4:4:4, 10:10:10:2, luminance with alpha.
///
/// masks    red, green, blue, alpha; of luminance the first alone, and perhaps alpha
/// returns  nothing where the masks are none of such
std::optional<StoredFormat> formatOfMasks(std::uint32_t bits, std::array<std::uint32_t, 4> masks) {
  const bool is_word = bits == 8 || bits == 16 || bits == 24 || bits == 32;
  if (!is_word || masks[0] == 0) return {};
  for (const std::uint32_t mask : masks)
    if (!isMask(mask, bits)) return {};
  const bool is_luminance = masks[1] == 0 && masks[2] == 0;
  if (is_luminance) masks[1] = masks[2] = masks[0];
  const int most_bits = std::max({std::popcount(masks[0]), std::popcount(masks[1]), std::popcount(masks[2])});
  // As D3DFMT_A16B16G16R16, more bits than a display's are not encoded.
  constexpr int kMostEncoded = 10;
  return StoredFormat{.type = most_bits <= kMostEncoded ? SampleType::srgb_bits : SampleType::unorm_bits,
                      .channels = masks[3] != 0  ? 4
                                  : is_luminance ? 1
                                                 : 3,
                      .word_bytes = bits / 8,
                      .masks = masks};
}

/// The format from the 32 bytes of DDS_PIXELFORMAT, for files without the DX10 header.
///
/// channel_guess   receives the remark on masks that are exchanged
Result<StoredFormat> formatBeforeDx10(const std::uint8_t* pixel_format, std::string& channel_guess) {
  const std::uint32_t flags = littleU32(pixel_format + 4);
  const std::uint32_t code = littleU32(pixel_format + 8);
  if (flags & kPixelFourLetters) {
    const auto format = formatOfCode(code);
    if (!format) return unsupportedTexture(nameOfCode(code), kDdsInstead);
    return *format;
  }
  const std::uint32_t bits = littleU32(pixel_format + 12);
  const auto mask = [&](int channel) { return littleU32(pixel_format + 16 + 4 * channel); };
  // The alpha mask of a format without alpha may hold anything: its flag is the lowest bit.
  const std::uint32_t alpha = flags & 1u ? mask(3) : 0;
  if (flags & (kPixelRgb | kPixelLuminance))
    for (const MaskRow& row : kMaskRows)
      if (row.bits == bits && row.red == mask(0) && row.green == mask(1) && row.blue == mask(2) && row.alpha == alpha)
        return row.format;
  const std::array<std::uint32_t, 4> masks{mask(0), mask(1), mask(2), alpha};
  auto format = flags & (kPixelRgb | kPixelLuminance) ? formatOfMasks(bits, masks) : std::nullopt;
  if (!format)
    return unsupportedTexture("a pixel format of " + counted(bits, "bit") + " with masks of its own", kDdsInstead);
  constexpr std::uint32_t kLowTen = 0x3ff, kMiddleTen = 0xffc00, kHighTen = 0x3ff00000;
  const bool is_ten = masks[1] == kMiddleTen && masks[0] + masks[2] == kLowTen + kHighTen &&
                      (masks[0] == kLowTen || masks[0] == kHighTen);
  if (is_ten) {
    // D3DX, of every version, and texconv before DirectXTex exchange the two when they write and when they read
    // (C. Walbourn, "DDS Update and 10:10:10:2 Problems"); DirectXTex reads all such files so.
    std::swap(format->masks[0], format->masks[2]);
    channel_guess =
        "has 10 bits a colour under masks from before DX10, where D3DX exchanged red and blue: read "
        "so; if its colours are exchanged now, save it with a DX10 header, which leaves no doubt";
  }
  return *format;
}

Result<void> readDx10Header(const std::uint8_t* dx10, DdsHeader& header) {
  const std::uint32_t stated = littleU32(dx10);
  const std::uint32_t typed = typedDxgi(stated);
  const auto format = formatOfDxgi(typed);
  if (!format) return unsupportedTexture(nameOfDxgi(stated), kDdsInstead);
  header.format = *format;
  if (typed != stated)
    header.oddities.push_back("leaves open what its samples are (DXGI_FORMAT " + std::to_string(stated) +
                              ", typeless): read as " + formatName(*format));
  // World of Tanks Blitz has 0, D3D10_RESOURCE_DIMENSION_UNKNOWN (microsoft/DirectXTex#667).
  const std::uint32_t dimension = littleU32(dx10 + 4);
  if (dimension == 0) header.oddities.emplace_back("does not say its dimension: read as two-dimensional");
  if (dimension != 0 && dimension != kTexture2d)
    return unsupportedTexture("a texture that is not two-dimensional", kDdsInstead);
  if (littleU32(dx10 + 8) & kMiscCube) header.shape.faces = 6;
  // Writers that hold one image for no array (microsoft/DirectXTex#490).
  header.shape.layers = littleU32(dx10 + 12);
  if (header.shape.layers == 0) {
    header.oddities.emplace_back("says it is an array of no layers: read as one");
    header.shape.layers = 1;
  }
  return {};
}

/// The sizes of DDS_HEADER and DDS_PIXELFORMAT, which state themselves. Some programs of Direct3D 9 write 24 for
/// either, or 0 for the latter (microsoft/DirectXTex#399, #392, #371); the rest of their headers is right.
Result<void> checkHeaderSizes(std::uint32_t header_size, std::uint32_t pixel_format_size, DdsHeader& header) {
  constexpr std::uint32_t kHeader = 124;
  constexpr std::uint32_t kPixelFormat = 32;
  constexpr std::uint32_t kWrong = 24;
  const bool is_known = (header_size == kHeader || header_size == kWrong) &&
                        (pixel_format_size == kPixelFormat || pixel_format_size == kWrong || pixel_format_size == 0);
  if (!is_known)
    return fail(ErrorCode::bad_file, "the header's sizes at bytes 4 and 76 are not 124 and 32; it is damaged");
  if (header_size != kHeader || pixel_format_size != kPixelFormat)
    header.oddities.push_back("states " + std::to_string(header_size) + " and " + std::to_string(pixel_format_size) +
                              " for the sizes of its header's parts: read as 124 and 32");
  return {};
}

/// "+X, -X and +Y" of dwCaps2.
std::string facesListed(std::uint32_t caps2) {
  constexpr std::uint32_t kFirstFace = 0x400;
  constexpr std::array<std::string_view, 6> kFaces{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  std::vector<std::string_view> listed;
  for (std::size_t face = 0; face < kFaces.size(); ++face)
    if (caps2 & kFirstFace << face) listed.push_back(kFaces[face]);
  return listed.empty() ? "none" : join(listed, ", ", " and ");
}

/// The texels of a file decide where what it says of a cube can be read in two ways. A cube is declared in dwCaps2, the
/// only place before DX10, or by a flag of DX10; writers set one or both (g-truc/gli#148, #158, #171).
///
/// available  bytes of texels
Result<void> settleCube(std::uint32_t caps2, bool is_dx10, std::uint64_t available, DdsHeader& header) {
  TextureShape& shape = header.shape;
  const bool is_square = shape.width == shape.height;
  const auto fits = [&](std::uint32_t faces, std::uint32_t layers) {
    const TextureShape tried{shape.width, shape.height, shape.levels, layers, faces};
    return chainSize(tried, header.format) * tried.imagesPerLevel() <= available;
  };
  // Microsoft's own example of a cube had arraySize 6, as its images are counted in memory, where a file counts cubes
  // (MicrosoftDocs/win32#1970, microsoft/DirectXTex#585).
  const bool counts_faces = is_dx10 && shape.layers % 6 == 0 && !fits(6, shape.layers) && fits(6, shape.layers / 6);
  const bool lists_all = (caps2 & kCaps2AllFaces) == kCaps2AllFaces;
  const bool is_listed = (caps2 & kCaps2Cube) || (lists_all && is_square && fits(6, shape.layers));
  if (is_dx10 && shape.faces == 1 && is_listed && is_square && (fits(6, shape.layers) || counts_faces)) {
    header.oddities.emplace_back("says only in its old header that it is a cube: read as one");
    shape.faces = 6;
  }
  if (shape.faces == 6 && counts_faces) {
    header.oddities.push_back("counts " + std::to_string(shape.layers) + " layers, and has texels for " +
                              counted(shape.layers / 6, "cube") + ": its faces are counted");
    shape.layers /= 6;
  }
  if (is_dx10 || !is_listed) return {};
  if (!lists_all && !(is_square && fits(6, 1)))
    return fail(ErrorCode::unsupported, "holds a cube with fewer than six faces (" + facesListed(caps2) +
                                            "), whose light from the others is not known; store all six");
  if (!lists_all)
    header.oddities.push_back("lists the faces " + facesListed(caps2) + " of a cube, and has texels for six: read so");
  shape.faces = 6;
  return {};
}

std::uint32_t mostLevels(const TextureShape& shape) {
  return static_cast<std::uint32_t>(std::bit_width(std::max(shape.width, shape.height)));
}

/// Whether a file behind whose texels some bytes are left was filled up with them: few, and all 0.
bool isFilledUp(Span left) {
  constexpr std::size_t kMostFilling = 64;
  return left.size() < kMostFilling &&
         std::all_of(left.begin(), left.end(), [](std::uint8_t byte) { return byte == 0; });
}

/// Levels of several images, of which the file has not all: fewer of each, or it ends within the smallest ones of the
/// last image. Where its length alone would allow both, what is left behind the fewer levels decides.
void settleCutLevels(std::uint64_t stated_bytes, Span texels, DdsHeader& header) {
  const std::uint64_t available = texels.size();
  TextureShape& shape = header.shape;
  const std::uint32_t stated = shape.levels;
  const std::uint64_t of_image = stated_bytes / shape.imagesPerLevel();
  while (shape.levels > 1 && header.texelBytes() > available) --shape.levels;
  const std::uint64_t fewer_bytes = header.texelBytes();
  if (fewer_bytes <= available && isFilledUp(texels.subspan(static_cast<std::size_t>(fewer_bytes)))) {
    header.stored_levels = shape.levels;
    return;
  }
  const auto last_fits = [&] {
    return stated_bytes - of_image + chainSize(shape, header.format, header.row_alignment) <= available;
  };
  shape.levels = stated;
  while (shape.levels > 1 && !last_fits()) --shape.levels;
  if (!last_fits()) shape.levels = stated;
}

/// Levels that a header counts and the file does not have (microsoft/DirectXTex#394, #484), or the other way round. The
/// second of several images begins behind the levels of the first: there nothing but the file's length can tell.
void settleLevels(Span texels, DdsHeader& header) {
  const std::uint64_t available = texels.size();
  TextureShape& shape = header.shape;
  const std::uint32_t stated = header.stored_levels = shape.levels;
  const std::uint64_t stated_bytes = header.texelBytes();
  if (shape.imagesPerLevel() == 1) {
    while (shape.levels > 1 && header.texelBytes() > available) --shape.levels;
  } else if (stated_bytes < available) {
    shape.levels = mostLevels(shape);
    if (header.texelBytes() != available) shape.levels = stated;
    header.stored_levels = shape.levels;
  } else if (stated_bytes > available) {
    settleCutLevels(stated_bytes, texels, header);
  }
  if (shape.levels != stated) header.oddities.push_back(levelsRemark(stated, shape.levels));
}

/// Rows that begin at multiples of 4 bytes, as Direct3D had them in memory: where the pitch says so and the file is as
/// long as that makes it (DirectXTex's DDS_FLAGS_LEGACY_DWORD).
void settleRows(std::uint32_t pitch, std::uint64_t available, DdsHeader& header) {
  constexpr std::size_t kDirect3dAlignment = 4;
  const std::uint64_t row = rowSize(header.shape, header.format, 0);
  if (row % kDirect3dAlignment == 0 || row + kDirect3dAlignment - row % kDirect3dAlignment != pitch) return;
  header.row_alignment = kDirect3dAlignment;
  if (header.texelBytes() == available)
    header.oddities.push_back("has rows of " + std::to_string(pitch) + " bytes for " + std::to_string(row) +
                              " of texels: the rest of each is left out");
  else
    header.row_alignment = 1;
}

Result<DdsHeader> readDdsHeader(Span bytes) {
  if (bytes.size() < kDdsHeaderSize)
    return fail(ErrorCode::bad_file, "the header ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                         std::to_string(kDdsHeaderSize) + "; the file is truncated");
  const auto u32 = [&](std::size_t at) { return littleU32(bytes.data() + at); };
  DdsHeader header;
  MIRRORBALL_TRY_VOID(checkHeaderSizes(u32(4), u32(76), header));
  header.size = kDdsHeaderSize;
  header.shape.height = u32(12);
  header.shape.width = u32(16);
  const std::uint32_t caps2 = u32(112);
  if (caps2 & kCaps2Volume) return unsupportedTexture("a three-dimensional texture", kDdsInstead);
  const bool is_dx10 = (u32(80) & kPixelFourLetters) && u32(84) == kDx10;
  if (is_dx10) {
    header.size += kDx10HeaderSize;
    if (bytes.size() < header.size)
      return fail(ErrorCode::bad_file, "the DX10 header ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                           std::to_string(header.size) + "; the file is truncated");
    MIRRORBALL_TRY_VOID(readDx10Header(bytes.data() + kDdsHeaderSize, header));
  } else {
    MIRRORBALL_TRY(format, formatBeforeDx10(bytes.data() + 76, header.channel_guess));
    header.format = format;
    header.encoding_assumed = hasSrgbCurve(format);
  }
  // Of a shape that no texture has, no sizes are computed.
  MIRRORBALL_TRY_VOID(checkTextureShape(header.shape));
  const std::uint32_t stated_levels = std::max(u32(28), 1u);
  header.shape.levels = std::min(stated_levels, mostLevels(header.shape));
  if (header.shape.levels != stated_levels)
    header.oddities.push_back("counts " + std::to_string(stated_levels) + " mip levels, of which its size has " +
                              std::to_string(header.shape.levels) + ": read so");
  const std::uint64_t available = bytes.size() - header.size;
  MIRRORBALL_TRY_VOID(settleCube(caps2, is_dx10, available, header));
  MIRRORBALL_TRY_VOID(checkTextureShape(header.shape));
  settleRows(u32(20), available, header);
  settleLevels(bytes.subspan(header.size), header);
  return header;
}

/// texels   the largest levels of each image at least
/// format   of the texels, in its reading
Result<ImageSet> readImages(Span texels, const DdsHeader& header, const StoredFormat& format) {
  const TextureShape& shape = header.shape;
  ImageSet images(static_cast<int>(shape.levels), static_cast<int>(shape.faces), static_cast<int>(shape.layers));
  std::uint64_t begin = 0;  // of the next image; behind the last that is read, perhaps not in the file
  for (int layer = 0; layer < images.layers(); ++layer)
    for (int face = 0; face < images.faces(); ++face)
      for (int level = 0; level < static_cast<int>(header.stored_levels); ++level) {
        const std::uint64_t size = imageSize(shape, header.format, level, header.row_alignment);
        const std::uint64_t at = std::exchange(begin, begin + size);
        if (level >= images.levels()) continue;
        const auto row =
            static_cast<std::size_t>(size / blocksAlong(header.format, std::uint64_t(shape.heightAt(level))));
        const std::uint8_t* const first = texels.data() + static_cast<std::size_t>(at);
        MIRRORBALL_TRY(image, unpackTexels(format, first, row, shape.widthAt(level), shape.heightAt(level)));
        images.at(level, face, layer) = std::move(image);
      }
  return images;
}

}  // namespace

bool isDds(Span bytes) { return bytes.size() >= 4 && littleU32(bytes.data()) == kMagic; }

Result<DecodedImageSet> decodeDds(Span bytes, ReadAs as) {
  MIRRORBALL_TRY(header, readDdsHeader(bytes));
  const std::uint64_t expected = header.texelBytes();
  if (expected > bytes.size() - header.size)
    return fail(ErrorCode::bad_file, "its texels have " + std::to_string(expected) + " bytes from byte " +
                                         std::to_string(header.size) + " on, but the file has " +
                                         std::to_string(bytes.size()) + "; it is truncated or damaged");
  MIRRORBALL_TRY_VOID(checkTextureMemory(header.shape, header.format));
  const char* assumed = header.encoding_assumed ? " (assumed)" : "";
  const StoredFormat format = as == ReadAs::light ? header.format : withoutCurve(header.format);
  MIRRORBALL_TRY(images, readImages(bytes.subspan(header.size), header, format));
  if (!header.channel_guess.empty()) header.oddities.push_back(header.channel_guess);
  if (format != header.format && !header.encoding_assumed) tellUnapplied("sRGB", header.oddities);
  const std::string color = describeColor(transferCurve(format), {}, imageChannels(format)) + assumed;
  return DecodedImageSet{.images = std::move(images),
                         .metadata = {},
                         .format = "DDS, " + formatName(header.format) + assumed,
                         .color = as == ReadAs::light ? color : std::string(kAsStored),
                         .oddities = std::move(header.oddities),
                         .is_converted = hasSrgbCurve(format),
                         .channel_guess = std::move(header.channel_guess)};
}

}  // namespace mirrorball
