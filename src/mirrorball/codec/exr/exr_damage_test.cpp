#include <vector>

#include <ImfHeader.h>
#include <ImfRgbaFile.h>
#include <ImfTiledRgbaFile.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_stream.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::Damage;
using testing::DamagedFile;
using testing::gradient;

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

Bytes scanLineExr(Imf::Compression compression, Imf::RgbaChannels channels) {
  return foreignExr<Imf::RgbaOutputFile>(compression, channels);
}

INSTANTIATE_TEST_SUITE_P(
    Exr, Damage,
    ::testing::Values(DamagedFile{"ExrFloat", [] { return *encodeExr(gradient(12, 20, 4), {}); }},
                      DamagedFile{"ExrPiz", [] { return scanLineExr(Imf::PIZ_COMPRESSION, Imf::WRITE_RGBA); }},
                      DamagedFile{"ExrB44", [] { return scanLineExr(Imf::B44_COMPRESSION, Imf::WRITE_RGBA); }},
                      DamagedFile{"ExrPxr24", [] { return scanLineExr(Imf::PXR24_COMPRESSION, Imf::WRITE_RGBA); }},
                      DamagedFile{"ExrDwab", [] { return scanLineExr(Imf::DWAB_COMPRESSION, Imf::WRITE_RGBA); }},
                      DamagedFile{"ExrChroma", [] { return scanLineExr(Imf::ZIP_COMPRESSION, Imf::WRITE_YC); }},
                      DamagedFile{"ExrTiled",
                                  [] {
                                    return foreignExr<Imf::TiledRgbaOutputFile>(Imf::RLE_COMPRESSION, Imf::WRITE_RGB, 8,
                                                                                8, Imf::ONE_LEVEL);
                                  }}),
    testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
