#include <ImfRgbaFile.h>
#include <ImfTiledRgbaFile.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/damage_testing.h"
#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::Damage;
using testing::DamagedFile;
using testing::gradient;
using testing::inPart;

Bytes scanLineExr(Imf::Compression compression, Imf::RgbaChannels channels) {
  return testing::foreignExr<Imf::RgbaOutputFile>(compression, channels);
}

/// Beyond its display window on the left and on top, and within it on the right and below.
Bytes overscanExr() {
  const Imf::Header header(Imath::Box2i({0, 0}, {29, 19}), Imath::Box2i({-4, -3}, {15, 8}));
  return testing::foreignFile(header, gradient(20, 12, 3), {"R", "G", "B"});
}

INSTANTIATE_TEST_SUITE_P(
    Exr, Damage,
    ::testing::Values(
        inPart("ExrFloat", [] { return *encodeExr(gradient(12, 20, 4), {}); }),
        inPart("ExrPiz", [] { return scanLineExr(Imf::PIZ_COMPRESSION, Imf::WRITE_RGBA); }),
        inPart("ExrB44", [] { return scanLineExr(Imf::B44_COMPRESSION, Imf::WRITE_RGBA); }),
        inPart("ExrPxr24", [] { return scanLineExr(Imf::PXR24_COMPRESSION, Imf::WRITE_RGBA); }),
        inPart("ExrDwab", [] { return scanLineExr(Imf::DWAB_COMPRESSION, Imf::WRITE_RGBA); }),
        DamagedFile{"ExrChroma", [] { return scanLineExr(Imf::ZIP_COMPRESSION, Imf::WRITE_YC); }},
        inPart("ExrChromaByRows", [] { return scanLineExr(Imf::NO_COMPRESSION, Imf::WRITE_YCA); }),
        inPart("ExrTiled",
               [] {
                 return testing::foreignExr<Imf::TiledRgbaOutputFile>(Imf::RLE_COMPRESSION, Imf::WRITE_RGB, 8, 8,
                                                                      Imf::ONE_LEVEL);
               }),
        inPart("ExrLayers",
               [] {
                 return testing::constantFile(
                     {{"AO.R", 1}, {"AO.G", 2}, {"AO.B", 3}, {"N.X", 4}, {"rgba.R", 5}, {"rgba.G", 6}, {"rgba.B", 7}});
               }),
        inPart("ExrParts",
               [] {
                 return testing::constantParts({{"depth", {{"Z", 5}}}, {"rgba", {{"R", 1}, {"G", 2}, {"B", 3}}}});
               }),
        inPart("ExrWindow", [] { return overscanExr(); })),
    testing::nameOfDamaged);

}  // namespace
}  // namespace mirrorball
