#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mirrorball/base/file.h"

namespace mirrorball::testing {

inline void appendLittle(Bytes& bytes, std::uint32_t number, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

/// The header of a TGA.
struct TgaForm {
  std::uint8_t type = 2;  ///< 1 palette, 2 colours, 3 grey; 8 more: run-length coded
  std::uint32_t width = 3;
  std::uint32_t height = 2;
  std::uint8_t bits = 24;
  std::uint8_t descriptor = 0x20;  ///< bits of alpha; 0x10 from the right, 0x20 from the top
  std::uint32_t palette_first = 0;
  std::uint32_t palette_length = 0;
  std::uint8_t palette_bits = 0;
  std::string_view id = {};
};
inline Bytes tgaFile(const TgaForm& form, const Bytes& rest) {
  Bytes bytes{static_cast<std::uint8_t>(form.id.size()), form.palette_length > 0 ? std::uint8_t{1} : std::uint8_t{0},
              form.type};
  appendLittle(bytes, form.palette_first, 2);
  appendLittle(bytes, form.palette_length, 2);
  bytes.push_back(form.palette_bits);
  appendLittle(bytes, 0, 4);
  appendLittle(bytes, form.width, 2);
  appendLittle(bytes, form.height, 2);
  bytes.insert(bytes.end(), {form.bits, form.descriptor});
  bytes.insert(bytes.end(), form.id.begin(), form.id.end());
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

/// With version 2's areas behind it.
///
/// alpha_type  0 none, 3 straight, 4 premultiplied
inline Bytes withTgaFooter(Bytes bytes, std::uint8_t alpha_type) {
  const auto area = static_cast<std::uint32_t>(bytes.size());
  bytes.resize(bytes.size() + 495);
  bytes[area] = 495 & 255;
  bytes[area + 1] = 495 >> 8;
  bytes[area + 494] = alpha_type;
  appendLittle(bytes, area, 4);
  appendLittle(bytes, 0, 4);
  constexpr std::string_view kSignature("TRUEVISION-XFILE.", 18);
  bytes.insert(bytes.end(), kSignature.begin(), kSignature.end());
  return bytes;
}

/// The header of a bitmap.
struct BmpForm {
  std::uint32_t header = 40;  ///< its size, and so its version
  std::int32_t width = 3;
  std::int32_t height = 2;  ///< negative: from the top
  std::uint32_t bits = 24;
  std::uint32_t compression = 0;
  std::vector<std::uint32_t> masks = {};    ///< red, green, blue and perhaps alpha
  std::vector<std::uint32_t> palette = {};  ///< 0xrrggbb
  Bytes profile = {};                       ///< ICC, for a header of 124 bytes
};
inline Bytes bmpFile(const BmpForm& form, const Bytes& texels) {
  Bytes header;
  const int side = form.header == 12 ? 2 : 4;
  appendLittle(header, form.header, 4);
  appendLittle(header, static_cast<std::uint32_t>(form.width), side);
  appendLittle(header, static_cast<std::uint32_t>(form.height), side);
  appendLittle(header, 1, 2);
  appendLittle(header, form.bits, 2);
  if (form.header > 12) {
    appendLittle(header, form.compression, 4);
    header.resize(header.size() + 12);
    appendLittle(header, static_cast<std::uint32_t>(form.palette.size()), 4);
    appendLittle(header, 0, 4);
    for (const std::uint32_t mask : form.masks) appendLittle(header, mask, 4);
  }
  if (header.size() < form.header) header.resize(form.header);
  for (const std::uint32_t color : form.palette) appendLittle(header, color, form.header == 12 ? 3 : 4);
  const auto begin = static_cast<std::uint32_t>(14 + header.size());
  if (!form.profile.empty()) {
    Bytes place;
    appendLittle(place, 0x4d424544, 4);
    std::copy(place.begin(), place.end(), header.begin() + 56);
    place.clear();
    appendLittle(place, begin - 14 + static_cast<std::uint32_t>(texels.size()), 4);
    appendLittle(place, static_cast<std::uint32_t>(form.profile.size()), 4);
    std::copy(place.begin(), place.end(), header.begin() + 112);
  }
  Bytes bytes{'B', 'M'};
  appendLittle(bytes, begin + static_cast<std::uint32_t>(texels.size() + form.profile.size()), 4);
  appendLittle(bytes, 0, 4);
  appendLittle(bytes, begin, 4);
  bytes.insert(bytes.end(), header.begin(), header.end());
  bytes.insert(bytes.end(), texels.begin(), texels.end());
  bytes.insert(bytes.end(), form.profile.begin(), form.profile.end());
  return bytes;
}

}  // namespace mirrorball::testing
