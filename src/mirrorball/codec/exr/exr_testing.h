#pragma once

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
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

/// A channel that has one value everywhere.
struct ConstantChannel {
  std::string name;
  float value;
};

/// Such channels of 8 × 4 texels, which must outlive the frame.
class ConstantChannels {
 public:
  explicit ConstantChannels(const std::vector<ConstantChannel>& channels) {
    for (const ConstantChannel& channel : channels) {
      header_.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
      images_.emplace_back(8, 4, 1, channel.value);
    }
    for (std::size_t c = 0; c < channels.size(); ++c)
      frame_.insert(channels[c].name, *frameOf(images_[c], {"Y"}, header_.dataWindow()).findSlice("Y"));
  }

  const Imf::Header& header() const { return header_; }
  const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  Imf::Header header_ = Imf::Header(8, 4);
  std::vector<Image> images_;
  Imf::FrameBuffer frame_;
};

/// A file of such channels.
inline Bytes constantFile(const std::vector<ConstantChannel>& channels) {
  const ConstantChannels constant(channels);
  ExrOutput stream;
  {
    Imf::OutputFile file(stream, constant.header());
    file.setFrameBuffer(constant.frame());
    file.writePixels(4);
  }
  return stream.takeBytes();
}

/// A part of a file of several.
struct ConstantPart {
  std::string name;
  std::vector<ConstantChannel> channels;
};

inline Bytes constantParts(const std::vector<ConstantPart>& parts) {
  std::vector<ConstantChannels> constants;
  std::vector<Imf::Header> headers;
  for (const ConstantPart& part : parts) {
    Imf::Header& header = headers.emplace_back(constants.emplace_back(part.channels).header());
    header.setName(part.name);
    header.setType(Imf::SCANLINEIMAGE);
  }
  ExrOutput stream;
  {
    Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
    for (std::size_t i = 0; i < constants.size(); ++i) {
      Imf::OutputPart part(file, static_cast<int>(i));
      part.setFrameBuffer(constants[i].frame());
      part.writePixels(4);
    }
  }
  return stream.takeBytes();
}

}  // namespace mirrorball::testing
