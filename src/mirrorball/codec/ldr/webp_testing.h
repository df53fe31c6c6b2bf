#pragma once

#include <string_view>

#include <gtest/gtest.h>
#include <webp/encode.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/image/image.h"

namespace mirrorball::testing {

/// A picture of 3 or 4 channels as libwebp writes it.
///
/// quality  0 to 100; 101: lossless, the colours of what is transparent too
inline Bytes encodedWebp(const Image8& picture, float quality) {
  WebPConfig config;
  EXPECT_TRUE(WebPConfigInit(&config));
  config.lossless = quality > 100.0f ? 1 : 0;
  config.quality = std::min(quality, 100.0f);
  config.exact = 1;
  WebPPicture encoded;
  EXPECT_TRUE(WebPPictureInit(&encoded));
  encoded.width = picture.width();
  encoded.height = picture.height();
  encoded.use_argb = config.lossless;
  const int stride = picture.width() * picture.channels();
  EXPECT_TRUE(picture.channels() == 4 ? WebPPictureImportRGBA(&encoded, picture.samples().data(), stride)
                                      : WebPPictureImportRGB(&encoded, picture.samples().data(), stride));
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  encoded.writer = WebPMemoryWrite;
  encoded.custom_ptr = &writer;
  EXPECT_TRUE(WebPEncode(&config, &encoded));
  Bytes bytes(writer.mem, writer.mem + writer.size);
  WebPMemoryWriterClear(&writer);
  WebPPictureFree(&encoded);
  return bytes;
}

/// The same picture in the extended form, with another chunk before it.
///
/// flags    0x20 there is a profile, 0x02 an animation
inline Bytes extendedWebp(const Image8& picture, std::uint8_t flags, std::string_view type, const Bytes& data) {
  const Bytes simple = encodedWebp(picture, 101);
  Bytes chunks;
  const auto append = [&](std::string_view name, const Bytes& content) {
    chunks.insert(chunks.end(), name.begin(), name.end());
    appendLittle(chunks, static_cast<std::uint32_t>(content.size()), 4);
    chunks.insert(chunks.end(), content.begin(), content.end());
    if (content.size() % 2 == 1) chunks.push_back(0);
  };
  Bytes extended{flags, 0, 0, 0};
  appendLittle(extended, static_cast<std::uint32_t>(picture.width() - 1), 3);
  appendLittle(extended, static_cast<std::uint32_t>(picture.height() - 1), 3);
  append("VP8X", extended);
  append(type, data);
  chunks.insert(chunks.end(), simple.begin() + 12, simple.end());
  Bytes bytes{'R', 'I', 'F', 'F'};
  appendLittle(bytes, static_cast<std::uint32_t>(4 + chunks.size()), 4);
  bytes.insert(bytes.end(), {'W', 'E', 'B', 'P'});
  bytes.insert(bytes.end(), chunks.begin(), chunks.end());
  return bytes;
}

}  // namespace mirrorball::testing
