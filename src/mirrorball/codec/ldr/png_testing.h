#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <zlib.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/ldr/png.h"

namespace mirrorball::testing {

/// A PNG with another chunk behind its header.
inline Bytes withPngChunk(Bytes png, std::string_view type, const std::string& data) {
  constexpr std::ptrdiff_t kEndOfHeader = 8 + 12 + 13;
  const auto append = [](Bytes& bytes, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  };
  Bytes chunk;
  append(chunk, static_cast<std::uint32_t>(data.size()));
  chunk.insert(chunk.end(), type.begin(), type.end());
  chunk.insert(chunk.end(), data.begin(), data.end());
  append(chunk, static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), chunk.data() + 4, chunk.size() - 4)));
  png.insert(png.begin() + kEndOfHeader, chunk.begin(), chunk.end());
  return png;
}

/// A small picture with it.
inline Bytes pngWithChunk(std::string_view type, const std::string& data) {
  return withPngChunk(*encodePng(Image8(2, 1, 3, 99), {}), type, data);
}

/// A text as zlib packs it.
inline std::string deflated(const std::string& text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::string packed(size, '\0');
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                     static_cast<uLong>(text.size())),
            Z_OK);
  packed.resize(size);
  return packed;
}

/// A profile as ImageMagick writes it into text: its name, its size, and its digits, 36 bytes a line.
inline std::string rawProfile(const std::string& name, const std::string& content) {
  constexpr std::size_t kBytesOfLine = 36;
  std::string text =
      "\n" + name + "\n" + std::string(8 - std::to_string(content.size()).size(), ' ') + std::to_string(content.size());
  for (std::size_t i = 0; i < content.size(); ++i) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", static_cast<unsigned char>(content[i]));
    text += (i % kBytesOfLine == 0 ? "\n" : "") + std::string(digits);
  }
  return text + "\n";
}

}  // namespace mirrorball::testing
