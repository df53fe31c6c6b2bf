// The forms in which other programs store EXR files. OpenEXR itself writes them.

#include <array>
#include <numeric>

#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputPart.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <half.h>

#include "mirrorball/codec/color/primaries.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::addChannels;
using testing::decoded;
using testing::expectSameBits;
using testing::foreignFile;
using testing::frameOf;
using testing::gradient;
using ::testing::HasSubstr;
using testing::tiledFile;

const std::vector<std::string> kRgb{"R", "G", "B"};

Imf::Chromaticities chromaticities(const Primaries& primaries) {
  const auto xy = [](glm::dvec2 point) { return Imath::V2f(static_cast<float>(point.x), static_cast<float>(point.y)); };
  return {xy(primaries.red), xy(primaries.green), xy(primaries.blue), xy(primaries.white)};
}

/// An image whose samples are exact in half floats.
Image inHalves(Image image) {
  for (float& sample : image.samples()) sample = half(sample);
  return image;
}

/// R G B as half floats.
Bytes halfFile(Imf::Header header, const Image& image) {
  for (const std::string& name : kRgb) header.channels().insert(name, Imf::Channel(Imf::HALF));
  const std::vector<half> samples(image.samples().begin(), image.samples().end());
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < 3; ++c)
    frame.insert(kRgb[c], Imf::Slice::Make(Imf::HALF, samples.data() + c, header.dataWindow(), 3 * sizeof(half),
                                           3 * sizeof(half) * std::size_t(image.width())));
  ExrOutput stream;
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height());
  }
  return stream.takeBytes();
}

class ExrCompression : public ::testing::TestWithParam<int> {
 protected:
  Imf::Compression compression() const { return static_cast<Imf::Compression>(GetParam()); }
  bool isDwa() const { return compression() == Imf::DWAA_COMPRESSION || compression() == Imf::DWAB_COMPRESSION; }
  bool isB44() const { return compression() == Imf::B44_COMPRESSION || compression() == Imf::B44A_COMPRESSION; }
  Imf::Header header(int width, int height) const {
    Imf::Header made(width, height);
    made.compression() = compression();
    return made;
  }
};

TEST_P(ExrCompression, OfFloatsIsRead) {
  const Image image = gradient(70, 50, 3);
  const Image back = decoded(foreignFile(header(70, 50), image, kRgb)).image;
  // PXR24 keeps 24 bits; B44 keeps floats whole; DWA loses what its level 45 lets go.
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    ASSERT_NEAR(back.samples()[i], image.samples()[i], isDwa() ? 0.05f : 1e-4f);
}

TEST_P(ExrCompression, OfHalvesIsRead) {
  const Image image = inHalves(gradient(70, 50, 3));
  const DecodedImage back = decoded(halfFile(header(70, 50), image));
  EXPECT_THAT(back.format, HasSubstr("OpenEXR, half, "));
  if (!isDwa() && !isB44()) return expectSameBits(back.image, image);
  // B44 keeps 6 bits of the differences in a block of 4 × 4, which here span up to 4 binades.
  for (std::size_t i = 0; i < image.samples().size(); ++i)
    ASSERT_NEAR(back.image.samples()[i], image.samples()[i], 0.05f);
}

// Far more texels a byte than a picture has, which the check of sizes must still let through.
TEST_P(ExrCompression, OfABlackImageIsNotTakenForALie) {
  const DecodedImage back = decoded(foreignFile(header(2048, 1024), Image(2048, 1024, 3), kRgb));
  EXPECT_EQ(back.image.width(), 2048);
}

INSTANTIATE_TEST_SUITE_P(All, ExrCompression, ::testing::Range(0, static_cast<int>(Imf::NUM_COMPRESSION_METHODS)));

TEST(ExrForms, TilesAreRead) {
  const Image image = gradient(70, 50, 4);
  const DecodedImage back = decoded(tiledFile(Imf::Header(70, 50), image, {"R", "G", "B", "A"}, Imf::ONE_LEVEL));
  expectSameBits(back.image, image);
  EXPECT_EQ(back.format, "OpenEXR, float, ZIP, tiled");
}

TEST(ExrForms, OfSeveralLevelsTheLargestIsRead) {
  const Image image = gradient(70, 50, 3);
  for (const Imf::LevelMode levels : {Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS})
    expectSameBits(decoded(tiledFile(Imf::Header(70, 50), image, kRgb, levels)).image, image);
}

TEST(ExrForms, RowsMayBeStoredInAnyOrder) {
  const Image image = gradient(70, 50, 3);
  Imf::Header header(70, 50);
  header.lineOrder() = Imf::DECREASING_Y;
  expectSameBits(decoded(foreignFile(header, image, kRgb)).image, image);
  expectSameBits(decoded(tiledFile(header, image, kRgb, Imf::ONE_LEVEL)).image, image);
  header.lineOrder() = Imf::RANDOM_Y;
  expectSameBits(decoded(tiledFile(header, image, kRgb, Imf::RIPMAP_LEVELS)).image, image);
}

TEST(ExrForms, UnsignedIntegersBecomeFloats) {
  std::vector<unsigned> samples{0, 1, 70000};
  Imf::Header header(3, 1);
  header.channels().insert("Y", Imf::Channel(Imf::UINT));
  ExrOutput stream;
  {
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::UINT, samples.data(), header.dataWindow()));
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  const DecodedImage back = decoded(stream.takeBytes());
  EXPECT_THAT(back.image.samples(), ::testing::ElementsAre(0.0f, 1.0f, 70000.0f));
  EXPECT_EQ(back.format, "OpenEXR, uint, ZIP");
  EXPECT_EQ(back.color, "linear, grey");
}

TEST(ExrForms, EachChannelMayHaveItsOwnType) {
  const std::array<half, 2> reds{half(0.5f), half(2.0f)};
  const std::array<float, 2> greens{0.1f, 1e6f};
  const std::array<unsigned, 2> blues{7, 9};
  Imf::Header header(2, 1);
  header.compression() = Imf::PIZ_COMPRESSION;
  header.channels().insert("R", Imf::Channel(Imf::HALF));
  header.channels().insert("G", Imf::Channel(Imf::FLOAT));
  header.channels().insert("B", Imf::Channel(Imf::UINT));
  ExrOutput stream;
  {
    Imf::FrameBuffer frame;
    frame.insert("R", Imf::Slice::Make(Imf::HALF, reds.data(), header.dataWindow()));
    frame.insert("G", Imf::Slice::Make(Imf::FLOAT, greens.data(), header.dataWindow()));
    frame.insert("B", Imf::Slice::Make(Imf::UINT, blues.data(), header.dataWindow()));
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  EXPECT_THAT(decoded(stream.takeBytes()).image.samples(), ::testing::ElementsAre(0.5f, 0.1f, 7.0f, 2.0f, 1e6f, 9.0f));
}

/// A picture of one colour as luminance and chroma.
DecodedImage throughChroma(const Imf::Header& header, glm::vec3 color, Imf::RgbaChannels channels) {
  const int width = header.dataWindow().max.x - header.dataWindow().min.x + 1;
  const int height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
  const std::vector<Imf::Rgba> texels(std::size_t(width * height), Imf::Rgba(color.r, color.g, color.b, 0.5f));
  ExrOutput stream;
  {
    Imf::RgbaOutputFile file(stream, header, channels);
    // The frame's base is where texel (0, 0) would be.
    const Imf::Slice slice = Imf::Slice::Make(Imf::HALF, texels.data(), header.dataWindow(), sizeof(Imf::Rgba),
                                              sizeof(Imf::Rgba) * std::size_t(width));
    file.setFrameBuffer(reinterpret_cast<const Imf::Rgba*>(slice.base), 1, std::size_t(width));
    file.writePixels(height);
  }
  return decoded(stream.takeBytes());
}

/// Chroma is filtered in half floats, whose steps are up to 1e-3 here.
void expectColorEverywhere(const Image& image, glm::vec3 color) {
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(image.texel(x, y)[c], color[c], 3e-3f) << x << ", " << y;
}

constexpr glm::vec3 kOrange(0.75f, 0.5f, 0.25f);

TEST(ExrForms, LuminanceAndChromaAreRead) {
  const DecodedImage back = throughChroma(Imf::Header(30, 20), kOrange, Imf::WRITE_YC);
  ASSERT_EQ(back.image.channels(), 3);
  expectColorEverywhere(back.image, kOrange);
  EXPECT_THAT(back.format, HasSubstr("luminance and chroma"));
  const Imf::Header elsewhere(Imath::Box2i({-6, 40}, {23, 59}), Imath::Box2i({-6, 40}, {23, 59}));
  const DecodedImage with_alpha = throughChroma(elsewhere, kOrange, Imf::WRITE_YCA);
  ASSERT_EQ(with_alpha.image.channels(), 4);
  expectColorEverywhere(with_alpha.image, kOrange);
  EXPECT_EQ(with_alpha.image.texel(29, 19)[3], 0.5f);
}

TEST(ExrForms, LuminanceAndChromaLieInTheirDisplayWindow) {
  const Imf::Header beyond(Imath::Box2i({0, 0}, {99, 99}), Imath::Box2i({-6, 40}, {23, 59}));
  const DecodedImage back = throughChroma(beyond, kOrange, Imf::WRITE_YCA);
  ASSERT_EQ(back.image.width(), 100);
  ASSERT_EQ(back.image.height(), 100);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(back.image.texel(23, 59)[c], kOrange[c], 3e-3f);
    EXPECT_NEAR(back.image.texel(0, 40)[c], kOrange[c], 3e-3f);
    EXPECT_EQ(back.image.texel(24, 59)[c], 0.0f);
    EXPECT_EQ(back.image.texel(0, 39)[c], 0.0f);
  }
}

TEST(ExrForms, LuminanceIsThatOfTheFilesPrimaries) {
  Imf::Header header(30, 20);
  Imf::addChromaticities(header, chromaticities(kRec2020));
  const DecodedImage back = throughChroma(header, kOrange, Imf::WRITE_YC);
  expectColorEverywhere(back.image, *rec709FromPrimaries(kRec2020) * kOrange);
  EXPECT_EQ(back.color, "linear, primaries of the file (Rec.2020): converted");
}

TEST(ExrForms, ChromaticitiesAreConverted) {
  for (const Primaries& primaries : {kRec2020, kDisplayP3, kAcesAp0, kAcesAp1, kCieXyz}) {
    Imf::Header header(2, 1);
    Imf::addChromaticities(header, chromaticities(primaries));
    Image image(2, 1, 4, 0.25f);
    image.texel(1, 0)[0] = 1.0f;
    const DecodedImage back = decoded(foreignFile(header, image, {"R", "G", "B", "A"}));
    const glm::vec3 expected = *rec709FromPrimaries(primaries) * glm::vec3(1.0f, 0.25f, 0.25f);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(back.image.texel(0, 0)[c], 0.25f, 1e-4f) << back.color << ": grey stays grey";
      EXPECT_NEAR(back.image.texel(1, 0)[c], expected[c], 1e-3f) << back.color;
    }
    EXPECT_EQ(back.image.texel(1, 0)[3], 0.25f);
    EXPECT_THAT(back.color, ::testing::EndsWith("): converted"));
  }
}

TEST(ExrForms, PrimariesAreAlwaysStatedAndComeBack) {
  for (const OutputPrimaries primaries :
       {OutputPrimaries::rec709, OutputPrimaries::p3, OutputPrimaries::rec2020, OutputPrimaries::acescg}) {
    Image light(2, 1, 4, 0.25f);
    light.texel(0, 0)[1] = 1e5f;
    light.texel(1, 0)[2] = -0.125f;
    Image image = light;
    convertFromRec709(image, primaries);
    const Bytes file = *encodeExr(image, {.metadata = {}, .primaries = primaries});
    ExrInput stream(file);
    const Imf::Header header = Imf::InputFile(stream).header();
    ASSERT_TRUE(Imf::hasChromaticities(header));
    const Imf::Chromaticities expected = chromaticities(chromaticitiesOf(primaries));
    EXPECT_EQ(Imf::chromaticities(header).red, expected.red);
    EXPECT_EQ(Imf::chromaticities(header).white, expected.white);
    const Image back = decoded(file).image;
    for (int x = 0; x < 2; ++x)
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(back.texel(x, 0)[c], light.texel(x, 0)[c], x == 0 && c < 3 ? 0.2f : 1e-6f) << x << " " << c;
  }
  const Bytes grey = *encodeExr(Image(1, 1, 1, 0.5f), {.metadata = {}, .primaries = OutputPrimaries::p3});
  ExrInput stream(grey);
  EXPECT_FALSE(Imf::hasChromaticities(Imf::InputFile(stream).header())) << "which has no colours";
}

// ITU-R BT.2407-0, eq. 4: Rec.2020's red.
TEST(ExrForms, Rec2020RedIsOutsideRec709) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, chromaticities(kRec2020));
  Image red(1, 1, 3);
  red.samples()[0] = 1.0f;
  const Image back = decoded(foreignFile(header, red, kRgb)).image;
  EXPECT_NEAR(back.samples()[0], 1.6605f, 1e-3f);
  EXPECT_NEAR(back.samples()[1], -0.1246f, 1e-3f);
}

/// Two parts in one file: a depth, and the colour as scan lines or tiles.
Bytes filesOfParts(const Image& image, bool tiled, const Primaries& primaries) {
  const Imath::Box2i screen({0, 0}, {image.width() - 1, image.height() - 1});  // one for all parts
  std::vector<Imf::Header> headers{Imf::Header(screen, Imath::Box2i({0, 0}, {2, 1})), Imf::Header(screen, screen)};
  addChannels(headers[0], {"Z"});
  addChannels(headers[1], kRgb);
  for (Imf::Header& header : headers) {
    header.setName(&header == headers.data() ? "depth" : "colour");
    header.setType(Imf::SCANLINEIMAGE);
    // One for all parts too.
    Imf::addChromaticities(header, chromaticities(primaries));
  }
  if (tiled) {
    headers[1].setType(Imf::TILEDIMAGE);
    headers[1].setTileDescription(Imf::TileDescription(4, 4));
  }
  ExrOutput stream;
  {
    Imf::MultiPartOutputFile file(stream, headers.data(), 2);
    Imf::OutputPart depth(file, 0);
    const Image depths(3, 2, 1);
    depth.setFrameBuffer(frameOf(depths, {"Z"}, headers[0].dataWindow()));
    depth.writePixels(2);
    const Imf::FrameBuffer frame = frameOf(image, kRgb, screen);
    if (tiled) {
      Imf::TiledOutputPart part(file, 1);
      part.setFrameBuffer(frame);
      part.writeTiles(0, part.numXTiles() - 1, 0, part.numYTiles() - 1);
    } else {
      Imf::OutputPart part(file, 1);
      part.setFrameBuffer(frame);
      part.writePixels(image.height());
    }
  }
  return stream.takeBytes();
}

TEST(ExrForms, TheFirstPartWithColourIsRead) {
  const Image image = gradient(6, 5, 3);
  const DecodedImage lines = decoded(filesOfParts(image, false, kRec709));
  expectSameBits(lines.image, image);
  EXPECT_EQ(lines.format, "OpenEXR, float, ZIP, layer colour, part 2");
  const DecodedImage tiles = decoded(filesOfParts(image, true, kRec709));
  expectSameBits(tiles.image, image);
  EXPECT_EQ(tiles.format, "OpenEXR, float, ZIP, tiled, layer colour, part 2");
  EXPECT_EQ(tiles.color, "linear, Rec.709");
  EXPECT_EQ(decoded(filesOfParts(image, false, kAcesAp1)).color, "linear, primaries of the file (ACES AP1): converted");
}

}  // namespace
}  // namespace mirrorball
