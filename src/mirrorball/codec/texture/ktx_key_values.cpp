#include "mirrorball/codec/texture/ktx_key_values.h"

#include <algorithm>
#include <string_view>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball {
namespace {

constexpr std::size_t kKeyValueAlignment = 4;

/// KTX 2 writes "rd", KTX 1 "S=r,T=d"; the letters say it all.
void readOrientation(std::string_view text, KtxKeyValues& values) {
  values.right_to_left = text.find('l') != std::string_view::npos;
  values.bottom_up = text.find('u') != std::string_view::npos;
}

/// A value is a text where it ends with a zero, which KTX 1 does not demand.
std::string_view textOf(std::string_view value) { return value.substr(0, value.find('\0')); }

}  // namespace

Result<KtxKeyValues> readKtxKeyValues(std::span<const std::uint8_t> bytes, std::size_t begin, std::size_t size,
                                      bool big_endian) {
  KtxKeyValues values;
  const std::size_t end = begin + size;
  for (std::size_t at = begin; at < end;) {
    const std::size_t left = end - at;
    const std::size_t length = left < 4 ? 0 : (big_endian ? bigU32(bytes.data() + at) : littleU32(bytes.data() + at));
    const std::string place = "the key/value entry at byte " + std::to_string(at);
    if (left < 4 || length > left - 4)
      return fail(ErrorCode::bad_file, place + " reaches beyond its data, which ends at byte " + std::to_string(end) +
                                           "; the file is damaged");
    const std::string_view entry(reinterpret_cast<const char*>(bytes.data()) + at + 4, length);
    const std::size_t key_end = entry.find('\0');
    if (key_end == std::string_view::npos)
      return fail(ErrorCode::bad_file, place + " has no zero behind its key; the file is damaged");
    const std::string_view key = entry.substr(0, key_end);
    const std::string_view text = textOf(entry.substr(key_end + 1));
    if (key == "KTXorientation") readOrientation(text, values);
    if (key == "KTXswizzle" && text != "rgba") values.swizzle = std::string(text);
    if (isMetadataKey(key)) values.metadata[std::string(key)] = std::string(text);
    at += std::min((4 + length + kKeyValueAlignment - 1) / kKeyValueAlignment * kKeyValueAlignment, left);
  }
  return values;
}

Bytes ktxKeyValues(const Metadata& metadata, KtxVersion version) {
  Metadata entries = metadata;  // a map: sorted by key
  const bool is_ktx2 = version == KtxVersion::ktx2;
  entries["KTXorientation"] = is_ktx2 ? "rd" : "S=r,T=d";
  if (is_ktx2) entries["KTXwriter"] = "mirrorball";
  LittleEndianWriter writer;
  for (const auto& [key, value] : entries) {
    writer.u32(static_cast<std::uint32_t>(key.size() + 1 + value.size() + 1));
    writer.text(key);
    writer.text(value);
    writer.alignTo(kKeyValueAlignment);
  }
  return writer.takeBytes();
}

std::string swizzleRemark(const KtxKeyValues& values) {
  return "says KTXswizzle=" + excerpt(values.swizzle, 8) + ": its channels are taken as they are stored";
}

void turnUpright(Image& image, const KtxKeyValues& values) {
  const int channels = image.channels();
  if (values.bottom_up)
    for (int y = 0; y < image.height() / 2; ++y)
      std::swap_ranges(image.row(y).begin(), image.row(y).end(), image.row(image.height() - 1 - y).begin());
  if (values.right_to_left)
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width() / 2; ++x)
        std::swap_ranges(image.texel(x, y), image.texel(x, y) + channels, image.texel(image.width() - 1 - x, y));
}

}  // namespace mirrorball
