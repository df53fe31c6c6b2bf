#pragma once

#include <array>
#include <cstring>
#include <mutex>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/little_endian_writer.h"
#include "mirrorball/codec/texture/dds.h"
#include "mirrorball/codec/texture/dds_layout.h"
#include "mirrorball/codec/texture/ktx2.h"
#include "mirrorball/image/image_set.h"

namespace mirrorball::testing {

/// A texture whose every sample differs from its neighbours. All values are multiples of 1/8 below 4, which every
/// format that is written holds exactly: b10g11r11's blue has 5 bits behind the leading one, and e5b9g9r9's mantissas
/// reach from the exponent of 2 down to 2⁻⁷.
inline ImageSet textureOf(int levels, int faces, int layers, int channels, int width, int height) {
  ImageSet images(levels, faces, layers);
  int seed = 0;
  for (int level = 0; level < levels; ++level)
    for (int layer = 0; layer < layers; ++layer)
      for (int face = 0; face < faces; ++face) {
        Image image(levelSide(width, level), levelSide(height, level), channels);
        for (float& sample : image.samples()) sample = static_cast<float>((seed = (seed * 17 + 29) % 251) % 32) / 8.0f;
        images.at(level, face, layer) = std::move(image);
      }
  return images;
}

/// The file as writeImageSet writes it, in memory.
template <typename Write>
Bytes bytesOfTexture(Write* write_texture, const ImageSet& images, const TextureWriteOptions& options = {}) {
  Bytes file;
  std::mutex mutex;  // texels come from several threads
  const WriteAt write = [&](std::uint64_t offset, std::span<const std::uint8_t> bytes) -> Result<void> {
    const std::lock_guard lock(mutex);
    const auto begin = static_cast<std::size_t>(offset);
    if (file.size() < begin + bytes.size()) file.resize(begin + bytes.size());
    std::memcpy(file.data() + begin, bytes.data(), bytes.size());
    return {};
  };
  const auto result = write_texture(images, options, write);
  EXPECT_TRUE(result) << result.error().message;
  return file;
}

/// A header from before DX10, 128 bytes.
struct OldDds {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t flags = 0;  ///< of the pixel format
  std::uint32_t code = 0;
  std::uint32_t bits = 0;
  std::array<std::uint32_t, 4> masks = {};  ///< red, green, blue, alpha
  std::uint32_t caps2 = 0;
};
inline Bytes oldDds(const OldDds& dds, const Bytes& texels) {
  LittleEndianWriter writer;
  writer.u32(dds::kMagic);
  for (const std::uint32_t number : {124u, 0x1007u, dds.height, dds.width, 0u, 0u, 0u}) writer.u32(number);
  writer.zeros(44);
  for (const std::uint32_t number : {32u, dds.flags, dds.code, dds.bits}) writer.u32(number);
  for (const std::uint32_t mask : dds.masks) writer.u32(mask);
  for (const std::uint32_t number : {0x1000u, dds.caps2, 0u, 0u, 0u}) writer.u32(number);
  writer.append(texels);
  return writer.takeBytes();
}

/// Numbers of a KTX 1 header; the rest of the file is put behind it by the caller.
struct Ktx1 {
  std::uint32_t type = 0x1406;  ///< GL_FLOAT
  std::uint32_t type_size = 4;
  std::uint32_t format = 0x1908;           ///< GL_RGBA
  std::uint32_t internal_format = 0x8814;  ///< GL_RGBA32F
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 0;
  std::uint32_t layers = 0;
  std::uint32_t faces = 1;
  std::uint32_t levels = 1;
  bool big_endian = false;
};

/// 32-bit numbers in the order that a KTX 1 file has chosen.
inline void appendU32(Bytes& bytes, std::uint32_t number, bool big_endian) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * (big_endian ? 3 - i : i)));
}

inline Bytes ktx1Header(const Ktx1& ktx, const Bytes& key_values = {}) {
  Bytes bytes = {0xab, 'K', 'T', 'X', ' ', '1', '1', 0xbb, '\r', '\n', 0x1a, '\n'};
  for (const std::uint32_t number :
       {0x04030201u, ktx.type, ktx.type_size, ktx.format, ktx.internal_format, ktx.format, ktx.width, ktx.height,
        ktx.depth, ktx.layers, ktx.faces, ktx.levels, static_cast<std::uint32_t>(key_values.size())})
    appendU32(bytes, number, ktx.big_endian);
  bytes.insert(bytes.end(), key_values.begin(), key_values.end());
  return bytes;
}

}  // namespace mirrorball::testing
