#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

inline void appendBigU32(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// A tag of a profile and its value.
struct IccTag {
  std::string_view signature;
  Bytes value;
};

/// A profile of RGB with these tags.
inline Bytes iccProfileOf(std::vector<IccTag> tags) {
  Bytes profile(8);
  for (const char letter : std::string_view("\4\0\0\0mntrRGB XYZ ", 16))
    profile.push_back(static_cast<std::uint8_t>(letter));
  profile.resize(36);
  for (const char letter : std::string_view("acsp")) profile.push_back(static_cast<std::uint8_t>(letter));
  profile.resize(68);
  for (const std::uint32_t coordinate : {0xf6d6u, 0x10000u, 0xd32du}) appendBigU32(profile, coordinate);  // D50
  profile.resize(128);
  appendBigU32(profile, static_cast<std::uint32_t>(tags.size()));
  std::size_t at = 128 + 4 + 12 * tags.size();
  for (IccTag& tag : tags) {
    tag.value.resize((tag.value.size() + 3) / 4 * 4);  // as all parts of a profile are
    for (const char letter : tag.signature) profile.push_back(static_cast<std::uint8_t>(letter));
    appendBigU32(profile, static_cast<std::uint32_t>(at));
    appendBigU32(profile, static_cast<std::uint32_t>(tag.value.size()));
    at += tag.value.size();
  }
  for (const IccTag& tag : tags) profile.insert(profile.end(), tag.value.begin(), tag.value.end());
  for (int byte = 0; byte < 4; ++byte) profile[std::size_t(byte)] = static_cast<std::uint8_t>(at >> (24 - 8 * byte));
  return profile;
}

/// A profile of one tag, its description.
inline Bytes iccProfileOf(Bytes description) { return iccProfileOf({{"desc", std::move(description)}}); }

/// A value of 32-bit numbers behind its type: XYZType, parametricCurveType.
inline Bytes iccValue(std::string_view type, const std::vector<double>& numbers,
                      std::vector<std::uint32_t> words = {}) {
  Bytes value(type.begin(), type.end());
  value.resize(8);
  for (const std::uint32_t word : words) appendBigU32(value, word);
  for (const double number : numbers)
    appendBigU32(value, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(number * 65536.0))));
  return value;
}

/// The description as version 2 has it.
inline Bytes iccDescriptionValue(std::string_view name) {
  Bytes value{'d', 'e', 's', 'c', 0, 0, 0, 0};
  appendBigU32(value, static_cast<std::uint32_t>(name.size() + 1));
  value.insert(value.end(), name.begin(), name.end());
  value.push_back(0);
  return value;
}

/// sRGB's curve: parametricCurveType of form 3.
inline Bytes iccSrgbCurve() {
  return iccValue("para", {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045}, {0x00030000});
}

/// The same of form 4, as Android's pictures have it.
inline Bytes iccSrgbCurveOfForm4() {
  return iccValue("para", {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045, 0.0, 0.0}, {0x00040000});
}

/// A profile of a matrix and one curve.
///
/// columns  XYZ of red, green and blue, adapted to D50
inline Bytes iccMatrixProfile(std::string_view name, const std::array<std::vector<double>, 3>& columns,
                              const Bytes& curve) {
  return iccProfileOf({{"desc", iccDescriptionValue(name)},
                       {"rXYZ", iccValue("XYZ ", columns[0])},
                       {"gXYZ", iccValue("XYZ ", columns[1])},
                       {"bXYZ", iccValue("XYZ ", columns[2])},
                       {"rTRC", curve},
                       {"gTRC", curve},
                       {"bTRC", curve}});
}

/// Display P3, as phones embed it: the numbers of Apple's profile.
inline Bytes iccDisplayP3() {
  return iccMatrixProfile("Display P3",
                          {{{0.51512, 0.24120, -0.00105}, {0.29198, 0.69225, 0.04189}, {0.15710, 0.06657, 0.78407}}},
                          iccSrgbCurve());
}

/// With the description as version 2 has it.
inline Bytes iccProfile(std::string_view name) { return iccProfileOf(iccDescriptionValue(name)); }

/// With the description as version 4 has it, in one language.
inline Bytes iccProfile4(std::u16string_view name) {
  Bytes value{'m', 'l', 'u', 'c', 0, 0, 0, 0};
  for (const std::uint32_t number : {1u, 12u, 0x656e5553u}) appendBigU32(value, number);  // "enUS"
  appendBigU32(value, static_cast<std::uint32_t>(2 * name.size()));
  appendBigU32(value, 28);
  for (const char16_t letter : name)
    value.insert(value.end(), {static_cast<std::uint8_t>(letter >> 8), static_cast<std::uint8_t>(letter)});
  return iccProfileOf(value);
}

/// A JPEG with the profile in its first marker.
inline Bytes jpegWithProfile(Bytes bytes, const Bytes& profile) {
  Bytes marker{0xff, 0xe2, 0, 0};
  const std::string head("ICC_PROFILE\0\1\1", 14);  // the first part of one
  marker.insert(marker.end(), head.begin(), head.end());
  marker.insert(marker.end(), profile.begin(), profile.end());
  marker[2] = static_cast<std::uint8_t>((marker.size() - 2) >> 8);
  marker[3] = static_cast<std::uint8_t>(marker.size() - 2);
  bytes.insert(bytes.begin() + 2, marker.begin(), marker.end());
  return bytes;
}

}  // namespace mirrorball::testing
