#include "mirrorball/codec/ldr/gain_map_metadata.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/ldr/xmp_properties.h"

namespace mirrorball {
namespace {

constexpr std::string_view kHdrGainMap = "http://ns.adobe.com/hdr-gain-map/1.0/";
constexpr std::string_view kHdrPrefix = "hdrgm";

tl::unexpected<Error> damagedGainMap(const std::string& what) {
  return fail(ErrorCode::bad_file, "has a damaged gain map: " + what + "; save it anew, or without the gain map");
}

/// A number for each channel; one is for all.
///
/// absent   NaN: the property must be there
Result<glm::vec3> numbersOf(const XmpProperties& properties, const char* name, float absent) {
  const std::vector<std::string_view> values = properties.values(name);
  if (values.empty() && !std::isnan(absent)) return glm::vec3(absent);
  if (values.size() != 1 && values.size() != 3)
    return damagedGainMap("its " + std::string(name) + " has " + counted(values.size(), "value"));
  glm::vec3 numbers;
  for (int c = 0; c < 3; ++c) {
    const std::string_view value = values[values.size() == 1 ? 0 : std::size_t(c)];
    const auto number = parseNumber(value);
    if (!number) return damagedGainMap("its " + std::string(name) + " is '" + excerpt(value, 20) + "', no number");
    numbers[c] = static_cast<float>(*number);
  }
  return numbers;
}

constexpr float kRequired = std::numeric_limits<float>::quiet_NaN();

/// ISO's bits: three channels; one denominator for all fractions.
constexpr std::uint8_t kIsMultichannel = 0x80;
constexpr std::uint8_t kUsesBaseColors = 0x40;
constexpr std::uint8_t kHasCommonDenominator = 0x08;
constexpr std::size_t kIsoHeader = 5;  // two versions and those bits

/// Takes ISO's numbers one after the other.
class IsoReader {
 public:
  IsoReader(std::span<const std::uint8_t> data, bool has_common_denominator)
      : data_(data), has_common_(has_common_denominator), common_(has_common_denominator ? word() : 0) {}

  /// A fraction of 32 bits; NaN where its denominator is 0 or the data have ended.
  float fraction(bool is_signed) {
    const std::uint32_t bits = word();
    const double numerator = is_signed ? double(static_cast<std::int32_t>(bits)) : double(bits);
    const std::uint32_t denominator = has_common_ ? common_ : word();
    return denominator == 0 ? kRequired : static_cast<float>(numerator / denominator);
  }

 private:
  std::uint32_t word() {
    if (data_.size() < 4) return 0;
    const std::uint32_t word = bigU32(data_.data());
    data_ = data_.subspan(4);
    return word;
  }

  std::span<const std::uint8_t> data_;
  bool has_common_;
  std::uint32_t common_;
};

tl::unexpected<Error> baseIsHdr() {
  return fail(ErrorCode::unsupported,
              "has a gain map that makes an HDR picture darker; save it with the SDR picture as its base");
}

/// errors   as readGainMapXmp's
Result<GainMap> checkedGainMap(const GainMap& map) {
  MIRRORBALL_TRY_VOID(checkGainMap(map));
  if (map.headroom_max_log2 < map.headroom_min_log2) return baseIsHdr();
  return map;
}

}  // namespace

bool speaksOfGainMap(std::string_view xmp) {
  return xmp.find(kHdrGainMap) != std::string_view::npos &&
         !XmpProperties(xmp, kHdrGainMap, kHdrPrefix).values("Version").empty();
}

Result<GainMap> readGainMapXmp(std::string_view xmp) {
  const XmpProperties properties(xmp, kHdrGainMap, kHdrPrefix);
  const auto first = [&](const char* name) {
    const auto values = properties.values(name);
    return values.empty() ? std::string_view() : values.front();
  };
  if (first("Version") != "1.0")
    return fail(ErrorCode::unsupported, "has a gain map of version '" + excerpt(first("Version"), 20) +
                                            "'; save it as Ultra HDR with version 1.0");
  if (first("BaseRenditionIsHDR") == "True") return baseIsHdr();
  MIRRORBALL_TRY(min_log2, numbersOf(properties, "GainMapMin", 0.0f));
  MIRRORBALL_TRY(max_log2, numbersOf(properties, "GainMapMax", kRequired));
  MIRRORBALL_TRY(gamma, numbersOf(properties, "Gamma", 1.0f));
  MIRRORBALL_TRY(offset_sdr, numbersOf(properties, "OffsetSDR", 1.0f / 64.0f));
  MIRRORBALL_TRY(offset_hdr, numbersOf(properties, "OffsetHDR", 1.0f / 64.0f));
  MIRRORBALL_TRY(headroom_min, numbersOf(properties, "HDRCapacityMin", 0.0f));
  MIRRORBALL_TRY(headroom_max, numbersOf(properties, "HDRCapacityMax", kRequired));
  return checkedGainMap({min_log2, max_log2, gamma, offset_sdr, offset_hdr, headroom_min.x, headroom_max.x});
}

Result<GainMap> readGainMapIso(std::span<const std::uint8_t> data) {
  if (data.size() < kIsoHeader) return damagedGainMap("its ISO 21496-1 metadata are cut short");
  if (bigU16(data.data()) != 0)
    return fail(ErrorCode::unsupported, "has a gain map of ISO 21496-1 version " + std::to_string(bigU16(data.data())) +
                                            "; save it with version 0");
  const std::uint8_t bits = data[kIsoHeader - 1];
  IsoReader reader(data.subspan(kIsoHeader), (bits & kHasCommonDenominator) != 0);
  GainMap map;
  map.headroom_min_log2 = reader.fraction(false);
  map.headroom_max_log2 = reader.fraction(false);
  const int channels = (bits & kIsMultichannel) != 0 ? 3 : 1;
  for (int c = 0; c < channels; ++c) {
    map.min_log2[c] = reader.fraction(true);
    map.max_log2[c] = reader.fraction(true);
    map.gamma[c] = reader.fraction(false);
    map.offset_sdr[c] = reader.fraction(true);
    map.offset_hdr[c] = reader.fraction(true);
  }
  for (glm::vec3* numbers : {&map.min_log2, &map.max_log2, &map.gamma, &map.offset_sdr, &map.offset_hdr})
    if (channels == 1) *numbers = glm::vec3(numbers->x);
  return checkedGainMap(map);
}

namespace {

constexpr std::string_view kXmpBegin =
    R"(<x:xmpmeta xmlns:x="adobe:ns:meta/" x:xmptk="mirrorball"><rdf:RDF xmlns:rdf=")"
    R"(http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" xmlns:hdrgm=")"
    R"(http://ns.adobe.com/hdr-gain-map/1.0/" hdrgm:Version="1.0")";
constexpr std::string_view kXmpEnd = "</rdf:Description></rdf:RDF></x:xmpmeta>";

std::string attribute(const char* name, float number) {
  return " hdrgm:" + std::string(name) + "=\"" + formatNumber(double(number)) + "\"";
}

void putWord(Bytes& bytes, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

/// Numbers below 256, in steps of 2⁻²³: all floats of at least 1 are exact.
void putFraction(Bytes& bytes, float number) {
  constexpr double kDenominator = 1 << 23;
  putWord(bytes, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(double(number) * kDenominator))));
  putWord(bytes, static_cast<std::uint32_t>(kDenominator));
}

}  // namespace

std::string gainMapXmp(const GainMap& map) {
  return std::string(kXmpBegin) + attribute("GainMapMin", map.min_log2.x) + attribute("GainMapMax", map.max_log2.x) +
         attribute("Gamma", map.gamma.x) + attribute("OffsetSDR", map.offset_sdr.x) +
         attribute("OffsetHDR", map.offset_hdr.x) + attribute("HDRCapacityMin", map.headroom_min_log2) +
         attribute("HDRCapacityMax", map.headroom_max_log2) + " hdrgm:BaseRenditionIsHDR=\"False\">" +
         std::string(kXmpEnd);
}

std::string gainMapContainerXmp(std::size_t gain_map_bytes) {
  return std::string(kXmpBegin) +
         R"( xmlns:Container="http://ns.google.com/photos/1.0/container/")"
         R"( xmlns:Item="http://ns.google.com/photos/1.0/container/item/"><Container:Directory><rdf:Seq>)"
         R"(<rdf:li rdf:parseType="Resource"><Container:Item Item:Semantic="Primary" Item:Mime="image/jpeg"/></rdf:li>)"
         R"(<rdf:li rdf:parseType="Resource"><Container:Item Item:Semantic="GainMap" Item:Mime="image/jpeg" )"
         R"(Item:Length=")" +
         std::to_string(gain_map_bytes) + R"("/></rdf:li></rdf:Seq></Container:Directory>)" + std::string(kXmpEnd);
}

Bytes gainMapIso(const GainMap& map) {
  Bytes bytes = gainMapIsoVersion();
  bytes.push_back(kIsMultichannel | kUsesBaseColors);
  putFraction(bytes, map.headroom_min_log2);
  putFraction(bytes, map.headroom_max_log2);
  for (int c = 0; c < 3; ++c)
    for (const glm::vec3& numbers : {map.min_log2, map.max_log2, map.gamma, map.offset_sdr, map.offset_hdr})
      putFraction(bytes, numbers[c]);
  return bytes;
}

Bytes gainMapIsoVersion() { return {0, 0, 0, 0}; }

}  // namespace mirrorball
