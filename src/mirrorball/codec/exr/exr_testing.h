#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledRgbaFile.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_stream.h"

namespace mirrorball::testing {

inline DecodedImage decoded(const Bytes& bytes) {
  auto result = decodeExr(bytes);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    return {Image(1, 1, 3), {}, ""};
  }
  return std::move(*result);
}

inline void expectSameBits(const Image& actual, const Image& expected) {
  ASSERT_EQ(actual.width(), expected.width());
  ASSERT_EQ(actual.height(), expected.height());
  ASSERT_EQ(actual.channels(), expected.channels());
  EXPECT_EQ(std::memcmp(actual.samples().data(), expected.samples().data(), expected.samples().size_bytes()), 0);
}

/// A frame over an image's channels with those names.
inline Imf::FrameBuffer frameOf(const Image& image, const std::vector<std::string>& names, const Imath::Box2i& window) {
  Imf::FrameBuffer frame;
  const std::size_t texel = sizeof(float) * std::size_t(image.channels());
  for (std::size_t c = 0; c < names.size(); ++c)
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, image.samples().data() + c, window, texel,
                                            texel * std::size_t(image.width())));
  return frame;
}

inline void addChannels(Imf::Header& header, const std::vector<std::string>& names) {
  for (const std::string& name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
}

/// A file written by OpenEXR with channels that this program does not write itself.
inline Bytes foreignFile(Imf::Header header, const Image& image, const std::vector<std::string>& names) {
  addChannels(header, names);
  ExrOutput stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, names, header.dataWindow()));
    file.writePixels(image.height());
  }
  return stream.takeBytes();
}

/// The same in tiles of 32 × 32. All levels hold the image's top left corner.
inline Bytes tiledFile(Imf::Header header, const Image& image, const std::vector<std::string>& names,
                       Imf::LevelMode levels) {
  header.setTileDescription(Imf::TileDescription(32, 32, levels));
  addChannels(header, names);
  ExrOutput stream;
  {
    Imf::TiledOutputFile file(stream, header);
    file.setFrameBuffer(frameOf(image, names, header.dataWindow()));
    for (int y = 0; y < file.numYLevels(); ++y)
      for (int x = 0; x < file.numXLevels(); ++x)
        if (file.isValidLevel(x, y)) file.writeTiles(0, file.numXTiles(x) - 1, 0, file.numYTiles(y) - 1, x, y);
  }
  return stream.takeBytes();
}

/// A small file by another of OpenEXR's writers, an Imf::RgbaOutputFile or an Imf::TiledRgbaOutputFile, with its
/// further arguments.
template <typename File, typename... Arguments>
Bytes foreignExr(Imf::Compression compression, Arguments... arguments) {
  Imf::Header header(12, 10);
  header.compression() = compression;
  const std::vector<Imf::Rgba> texels(12 * 10, Imf::Rgba(0.5f, 0.25f, 2.0f, 1.0f));
  ExrOutput stream;
  {
    File file(stream, header, arguments...);
    file.setFrameBuffer(texels.data(), 1, 12);
    if constexpr (std::is_same_v<File, Imf::TiledRgbaOutputFile>)
      file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    else
      file.writePixels(10);
  }
  return stream.takeBytes();
}

}  // namespace mirrorball::testing
