#include "mirrorball/codec/texture/ktx2.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/texture/data_format_descriptor.h"
#include "mirrorball/codec/texture/format_numbers.h"
#include "mirrorball/codec/texture/ktx2_layout.h"
#include "mirrorball/codec/texture/ktx_key_values.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/codec/texture/texture_shape.h"
#include "mirrorball/codec/texture/zstandard.h"
#include "mirrorball/codec/within_memory.h"

namespace mirrorball {
namespace {

using Span = std::span<const std::uint8_t>;

/// A part of the file.
struct Range {
  std::uint64_t begin = 0;
  std::uint64_t size = 0;
  std::string what;
};

struct LevelPlace {
  std::uint64_t offset;
  std::uint64_t size;
  std::uint64_t unpacked_size;
};

/// The header and the level index, as they stand in the file.
struct Ktx2Header {
  std::uint32_t vk_format = 0;
  std::uint32_t depth = 0;
  std::uint32_t scheme = 0;
  TextureShape shape;
  Range descriptor;
  Range key_values;
  Range global_data;
  std::vector<LevelPlace> levels;
};

constexpr const char* kKtx2Instead = "r16g16b16a16 sfloat";

Result<Ktx2Header> readKtx2Header(Span bytes) {
  if (bytes.size() < kKtx2HeaderSize)
    return fail(ErrorCode::bad_file, "the header ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                         std::to_string(kKtx2HeaderSize) + "; the file is truncated");
  const auto u32 = [&](std::size_t at) { return littleU32(bytes.data() + at); };
  const auto u64 = [&](std::size_t at) { return littleU64(bytes.data() + at); };
  Ktx2Header header;
  header.vk_format = u32(12);
  header.shape.width = u32(20);
  header.shape.height = u32(24);
  header.depth = u32(28);
  header.shape.layers = std::max(u32(32), 1u);  // 0: not an array
  header.shape.faces = u32(36);
  header.shape.levels = std::max(u32(40), 1u);  // 0: the levels below are to be made from the first
  header.scheme = u32(44);
  header.descriptor = {u32(48), u32(52), "the data format descriptor"};
  header.key_values = {u32(56), u32(60), "the key/value data"};
  header.global_data = {u64(64), u64(72), "the supercompression global data"};
  if (header.depth > 0) return unsupportedTexture("a three-dimensional texture", kKtx2Instead);
  if (header.shape.height == 0 && header.shape.width > 0)
    return unsupportedTexture("a one-dimensional texture", kKtx2Instead);
  MIRRORBALL_TRY_VOID(checkTextureShape(header.shape));

  const std::size_t index_end = kKtx2HeaderSize + header.shape.levels * kKtx2LevelSize;
  if (bytes.size() < index_end)
    return fail(ErrorCode::bad_file, "the level index ends early, at byte " + std::to_string(bytes.size()) + " of " +
                                         std::to_string(index_end) + "; the file is truncated");
  for (std::size_t at = kKtx2HeaderSize; at < index_end; at += kKtx2LevelSize)
    header.levels.push_back({u64(at), u64(at + 8), u64(at + 16)});
  return header;
}

/// The levels are those that lie within the file, if the largest is one of them. Most writers put it last, so that a
/// file that ends early has lost it.
///
/// returns  the remark on it; empty where all levels do
std::string settleLevels(std::size_t file_size, Ktx2Header& header) {
  const auto is_cut = [&](const LevelPlace& level) {
    return level.offset > file_size || level.size > file_size - level.offset;
  };
  const auto first_cut = std::find_if(header.levels.begin(), header.levels.end(), is_cut);
  if (first_cut == header.levels.begin() || first_cut == header.levels.end()) return {};
  const std::uint32_t stated = header.shape.levels;
  header.levels.erase(first_cut, header.levels.end());
  header.shape.levels = static_cast<std::uint32_t>(header.levels.size());
  return levelsRemark(stated, header.shape.levels);
}

/// All parts lie within the file, and no two of them in the same place.
Result<void> checkRanges(const Ktx2Header& header, std::size_t file_size) {
  std::vector<Range> ranges = {{0, kKtx2HeaderSize + header.levels.size() * kKtx2LevelSize, "the header"},
                               header.descriptor};
  // Where there is nothing of these, their offset means nothing.
  for (const Range& optional : {header.key_values, header.global_data})
    if (optional.size > 0) ranges.push_back(optional);
  for (std::size_t level = 0; level < header.levels.size(); ++level)
    ranges.push_back({header.levels[level].offset, header.levels[level].size, "level " + std::to_string(level)});
  for (const Range& range : ranges)
    if (range.begin > file_size || range.size > file_size - range.begin)
      return fail(ErrorCode::bad_file, range.what + " says it has " + counted(range.size, "byte") + " from byte " +
                                           std::to_string(range.begin) + " on, but the file has " +
                                           std::to_string(file_size) + "; it is truncated or damaged");
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.begin < b.begin; });
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i].begin < ranges[i - 1].begin + ranges[i - 1].size)
      return fail(ErrorCode::bad_file, ranges[i].what + " at byte " + std::to_string(ranges[i].begin) + " overlaps " +
                                           ranges[i - 1].what + "; the file is damaged");
  return {};
}

/// The format of the texels once they are decompressed.
Result<StoredFormat> ktx2TexelFormat(const Ktx2Header& header, const DescribedColor& color, ReadAs as) {
  constexpr int kModelEtc1s = 163;
  constexpr int kModelUastc = 166;
  if (header.scheme == 1 || (header.vk_format == 0 && (color.model == kModelEtc1s || color.model == kModelUastc)))
    return unsupportedTexture("Basis Universal block compression", kKtx2Instead);
  auto format = formatOfVulkan(header.vk_format);
  if (header.vk_format == 0 && color.model == kModelUastcHdr) format = storedFormat(TexelFormat::uastc_hdr);
  if (!format) return unsupportedTexture(nameOfVulkan(header.vk_format), kKtx2Instead);
  if (header.scheme == kKtx2Zstandard) MIRRORBALL_TRY_VOID(checkZstandard());
  if (header.scheme != kKtx2Plain && header.scheme != kKtx2Zstandard)
    return unsupportedTexture("supercompression scheme " + std::to_string(header.scheme), kKtx2Instead);
  // Some writers say "unorm" and mean sRGB; the descriptor tells.
  if (color.srgb && format->type == SampleType::unorm8) format->type = SampleType::srgb8;
  if (color.srgb && format->type != SampleType::srgb8 && as == ReadAs::light)
    return unsupportedTexture(formatName(*format) + " encoded as sRGB", kKtx2Instead);
  return *format;
}

/// A Zstandard block of 4 bytes stands for at most 128 KiB: more than that is a lie that would only cost memory.
bool mayUnpackTo(std::uint64_t size, std::uint64_t unpacked_size) {
  constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 17;
  constexpr std::uint64_t kSmallestBlock = 4;
  return unpacked_size / kLargestBlock <= size / kSmallestBlock;
}

/// The sizes that the level index states, against what the shape makes them.
Result<void> checkLevelSizes(const Ktx2Header& header, const StoredFormat& format) {
  for (std::size_t i = 0; i < header.levels.size(); ++i) {
    const LevelPlace& level = header.levels[i];
    const std::uint64_t expected = imageSize(header.shape, format, static_cast<int>(i)) * header.shape.imagesPerLevel();
    const std::string place = "level " + std::to_string(i) + " (byte " +
                              std::to_string(kKtx2HeaderSize + i * kKtx2LevelSize) + " of the file)";
    const bool is_plain = header.scheme == kKtx2Plain;
    const std::uint64_t stated = is_plain ? level.size : level.unpacked_size;
    if (stated != expected)
      return fail(ErrorCode::bad_file, place + " says it has " + counted(stated, "byte") + " of texels; as " +
                                           formatName(format) + " it has " + std::to_string(expected));
    if (!is_plain && !mayUnpackTo(level.size, expected))
      return fail(ErrorCode::bad_file, place + " has " + counted(level.size, "compressed byte") + ", too few for " +
                                           std::to_string(expected) + "; the file is damaged");
  }
  return {};
}

Result<std::unique_ptr<std::uint8_t[]>> unpacked(Span packed, std::size_t size, const std::string& place) {
  // Without values, so that a size that lies costs no memory: only what is unpacked is touched.
  auto texels = bytesWithoutValues(size);
  Result<void> done = unpackZstandard(packed, {texels.get(), size});
  if (!done) return fail(done.error().code, place + " " + done.error().message);
  return texels;
}

/// Decodes the images of one level into their places.
Result<void> unpackLevel(const StoredFormat& format, const std::uint8_t* texels, int level, const TextureShape& shape,
                         ImageSet& images) {
  const auto row = static_cast<std::size_t>(rowSize(shape, format, level));
  const auto size = static_cast<std::size_t>(imageSize(shape, format, level));
  for (int layer = 0; layer < images.layers(); ++layer)
    for (int face = 0; face < images.faces(); ++face, texels += size) {
      auto image = unpackTexels(format, texels, row, shape.widthAt(level), shape.heightAt(level));
      if (!image) return fail(image.error().code, placeName(shape, level, layer, face) + " " + image.error().message);
      images.at(level, face, layer) = std::move(*image);
    }
  return {};
}

Result<ImageSet> readLevels(Span bytes, const Ktx2Header& header, const StoredFormat& format) {
  const TextureShape& shape = header.shape;
  ImageSet images(static_cast<int>(shape.levels), static_cast<int>(shape.faces), static_cast<int>(shape.layers));
  for (int i = 0; i < images.levels(); ++i) {
    const LevelPlace& level = header.levels[std::size_t(i)];
    const Span stored = bytes.subspan(std::size_t(level.offset), std::size_t(level.size));
    if (header.scheme == kKtx2Plain) {
      MIRRORBALL_TRY_VOID(unpackLevel(format, stored.data(), i, shape, images));
      continue;
    }
    const std::string place = "level " + std::to_string(i) + " at byte " + std::to_string(level.offset);
    MIRRORBALL_TRY(texels, unpacked(stored, std::size_t(level.unpacked_size), place));
    MIRRORBALL_TRY_VOID(unpackLevel(format, texels.get(), i, shape, images));
  }
  return images;
}

/// What the descriptor and the format say of colours that are read as numbers.
std::string spaceStatedBy(const StoredFormat& format, const DescribedColor& color) {
  if (color.has_other_curve) return "a transfer function of its own";
  const bool is_srgb = color.srgb || hasSrgbCurve(format);
  const std::string space = statedSpace(
      {.transfer = is_srgb ? Transfer::srgb : Transfer::linear, .primaries = color.primaries}, imageChannels(format));
  return space.empty() && is_srgb ? "sRGB" : space;
}

}  // namespace

bool isKtx2(Span bytes) {
  return bytes.size() >= kKtx2Identifier.size() &&
         std::equal(kKtx2Identifier.begin(), kKtx2Identifier.end(), bytes.begin());
}

Result<DecodedImageSet> decodeKtx2(Span bytes, ReadAs as) {
  MIRRORBALL_TRY(header, readKtx2Header(bytes));
  const std::string levels_remark = settleLevels(bytes.size(), header);
  MIRRORBALL_TRY_VOID(checkRanges(header, bytes.size()));
  MIRRORBALL_TRY(color, readDataFormatDescriptor(bytes, std::size_t(header.descriptor.begin),
                                                 std::size_t(header.descriptor.size), as));
  MIRRORBALL_TRY(stored, ktx2TexelFormat(header, color, as));
  const StoredFormat format = as == ReadAs::light ? stored : withoutCurve(stored);
  MIRRORBALL_TRY_VOID(checkLevelSizes(header, format));
  MIRRORBALL_TRY_VOID(checkTextureMemory(header.shape, format));
  MIRRORBALL_TRY(values, readKtxKeyValues(bytes, std::size_t(header.key_values.begin),
                                          std::size_t(header.key_values.size), false));
  MIRRORBALL_TRY(images, readLevels(bytes, header, format));
  bool is_converted = hasSrgbCurve(format);
  forEachImage(images, [&](Image& image) {
    if (as == ReadAs::light) is_converted |= convertToRec709(image, color.primaries);
    if (images.faces() == 1) turnUpright(image, values);
  });
  std::vector<std::string> oddities;
  if (!levels_remark.empty()) oddities.push_back(levels_remark);
  if (color.is_missing) oddities.emplace_back("has no data format descriptor: read as its vkFormat says");
  if (!values.swizzle.empty()) oddities.push_back(swizzleRemark(values));
  if (as == ReadAs::numbers) tellUnapplied(spaceStatedBy(stored, color), oddities);
  const std::string text = describeColor(transferCurve(format), color.primaries, imageChannels(format));
  return DecodedImageSet{
      .images = std::move(images),
      .metadata = std::move(values.metadata),
      .format = "KTX2, " + formatName(stored) + (header.scheme == kKtx2Zstandard ? ", Zstandard" : ""),
      .color = as == ReadAs::light ? text : std::string(kAsStored),
      .oddities = std::move(oddities),
      .is_converted = is_converted};
}

}  // namespace mirrorball
