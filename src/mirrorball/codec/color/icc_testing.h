#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

inline void appendBigU32(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// A profile of one tag, its description.
inline Bytes iccProfileOf(Bytes description) {
  description.resize((description.size() + 3) / 4 * 4);  // as all parts of a profile are
  Bytes profile;
  constexpr std::size_t kValueAt = 128 + 4 + 12;
  appendBigU32(profile, static_cast<std::uint32_t>(kValueAt + description.size()));
  profile.resize(8);
  for (const char letter : std::string_view("\4\0\0\0mntrRGB XYZ ", 16))
    profile.push_back(static_cast<std::uint8_t>(letter));
  profile.resize(36);
  for (const char letter : std::string_view("acsp")) profile.push_back(static_cast<std::uint8_t>(letter));
  profile.resize(68);
  for (const std::uint32_t coordinate : {0xf6d6u, 0x10000u, 0xd32du}) appendBigU32(profile, coordinate);  // D50
  profile.resize(128);
  appendBigU32(profile, 1);
  for (const char letter : std::string_view("desc")) profile.push_back(static_cast<std::uint8_t>(letter));
  appendBigU32(profile, kValueAt);
  appendBigU32(profile, static_cast<std::uint32_t>(description.size()));
  profile.insert(profile.end(), description.begin(), description.end());
  return profile;
}

/// With the description as version 2 has it.
inline Bytes iccProfile(std::string_view name) {
  Bytes value{'d', 'e', 's', 'c', 0, 0, 0, 0};
  appendBigU32(value, static_cast<std::uint32_t>(name.size() + 1));
  value.insert(value.end(), name.begin(), name.end());
  value.push_back(0);
  return iccProfileOf(value);
}

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
