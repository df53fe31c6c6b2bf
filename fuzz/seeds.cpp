// usage: fuzz_seeds FOLDER
//
// Writes the seeds of each decoder's corpus to FOLDER/DECODER/seed_NAME: the smallest files that reach each of its
// ways.

#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <tuple>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#include <zlib.h>

#include "mirrorball/codec/color/icc_testing.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/exr/exr.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/ldr/avif_testing.h"
#include "mirrorball/codec/ldr/gain_map_metadata.h"
#include "mirrorball/codec/ldr/jpeg.h"
#include "mirrorball/codec/ldr/jxl_testing.h"
#include "mirrorball/codec/ldr/png.h"
#include "mirrorball/codec/ldr/ultra_hdr.h"
#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/codec/picture_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_levels.h"
#include "mirrorball/image/small_float.h"
#include "mirrorball/scene/gltf/gltf_testing.h"

namespace mirrorball {
namespace {

using testing::bytesOf;
using testing::bytesOfTexture;
using testing::foreignExr;
using testing::gradient;
using testing::textureOf;

/// Where the corpus stands, and whether all went well.
struct Corpus {
  std::filesystem::path folder;
  bool failed = false;

  void add(const std::string& decoder, const std::string& seed, const Bytes& bytes) {
    std::filesystem::create_directories(folder / decoder);
    const auto written = writeFile(folder / decoder / ("seed_" + seed), bytes);
    if (written) return;
    std::fprintf(stderr, "%s\n", written.error().message.c_str());
    failed = true;
  }
};

/// Blocks of every kind, and one that is none.
void addUastcHdrBlocks(Corpus& corpus) {
  Bytes all(kHalfBlockSize);
  for (std::uint8_t kind = 0; kind <= kUastcHdrModes.size(); ++kind) {
    UastcHdrBlock block{.is_solid = kind == kUastcHdrModes.size(), .color = {0x3c00, 0x3800, 0x3400}};
    block.mode = block.is_solid ? std::uint8_t{0} : kind;
    const UastcHdrMode& mode = kUastcHdrModes[block.mode];
    const EndpointLevels& levels = endpointLevels(mode.endpoints);
    for (std::size_t i = 0; i < std::size_t(mode.numbers()); ++i) block.colors[i] = levels.nearest[9 * i + kind];
    for (std::size_t i = 0; i < 16; ++i) block.weights[i] = static_cast<std::uint8_t>(i % std::size_t(mode.weights));
    std::array<std::uint8_t, kHalfBlockSize> bytes;
    writeUastcHdrBlock(block, bytes);
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  corpus.add("uastc_hdr", "every_kind", all);
}

void addTextures(Corpus& corpus) {
  const ImageSet cube = textureOf(2, 6, 1, 3, 2, 2);
  corpus.add("ktx2", "half_cube", bytesOfTexture(writeKtx2, cube));
  corpus.add("ktx2", "zstandard", bytesOfTexture(writeKtx2, cube, {.zstandard_level = 3}));
  corpus.add("ktx2", "float_array",
             bytesOfTexture(writeKtx2, textureOf(1, 1, 2, 4, 3, 2), {.format = TexelFormat::float32}));
  corpus.add("ktx2", "shared_exponent",
             bytesOfTexture(writeKtx2, textureOf(3, 1, 1, 3, 4, 3),
                            {.format = TexelFormat::e5b9g9r9, .metadata = {{"envmap", "latlong"}}}));
  corpus.add("ktx2", "two_channels",
             bytesOfTexture(writeKtx2, textureOf(1, 1, 1, 2, 3, 2), {.format = TexelFormat::rg_half}));
  corpus.add("ktx2", "bc6h_cube",
             bytesOfTexture(writeKtx2, textureOf(2, 6, 1, 3, 5, 5), {.format = TexelFormat::bc6h}));
  corpus.add(
      "ktx2", "bc6h_zstandard",
      bytesOfTexture(writeKtx2, textureOf(1, 1, 1, 3, 9, 5), {.format = TexelFormat::bc6h, .zstandard_level = 3}));
  corpus.add("ktx2", "uastc_hdr_cube",
             bytesOfTexture(writeKtx2, textureOf(2, 6, 1, 3, 5, 5), {.format = TexelFormat::uastc_hdr}));
  corpus.add("dds", "half_cube", bytesOfTexture(writeDds, cube));
  corpus.add("dds", "bc6h_array", bytesOfTexture(writeDds, textureOf(2, 1, 2, 3, 6, 5), {.format = TexelFormat::bc6h}));
  corpus.add("dds", "packed_array",
             bytesOfTexture(writeDds, textureOf(2, 1, 3, 3, 4, 3), {.format = TexelFormat::b10g11r11}));
  const testing::OldDds masks{
      .width = 3, .height = 2, .flags = 0x41, .bits = 32, .masks = {0xff0000, 0xff00, 0xff, 0xff000000}};
  corpus.add("dds", "masks", testing::oldDds(masks, Bytes(24, 99)));
  // Of which rows are padded, and a cube that lists no face.
  Bytes padded = testing::oldDds(
      {.width = 3, .height = 2, .flags = 0x40, .bits = 24, .masks = {0xff0000, 0xff00, 0xff, 0}}, Bytes(24, 99));
  padded[20] = 12;  // the pitch
  corpus.add("dds", "padded", padded);
  corpus.add("dds", "unlisted_faces", testing::oldDds({.flags = 4, .code = 113, .caps2 = 0x200}, Bytes(48, 60)));
  corpus.add("dds", "half_code", testing::oldDds({.flags = 4, .code = 113}, Bytes(8, 60)));

  for (const bool big_endian : {false, true}) {
    Bytes file = testing::ktx1Header({.width = 2, .height = 2, .faces = 6, .levels = 2, .big_endian = big_endian});
    for (const std::uint32_t size : {64u, 16u}) {
      testing::appendU32(file, size, big_endian);
      file.insert(file.end(), 6 * size, std::uint8_t{0x3f});
    }
    corpus.add("ktx1", big_endian ? "big_endian_cube" : "little_endian_cube", file);
  }
  Bytes rgb8 = testing::ktx1Header({.type = 0x1401,
                                    .type_size = 1,
                                    .format = 0x1907,
                                    .internal_format = 0x8c41,
                                    .width = 3,
                                    .height = 2,
                                    .layers = 2});
  testing::appendU32(rgb8, 48, false);
  rgb8.insert(rgb8.end(), 48, std::uint8_t{128});
  corpus.add("ktx1", "srgb_array", rgb8);
}

/// A PNG with another chunk behind its header.
Bytes withChunk(Bytes png, const std::string& type, const Bytes& data) {
  constexpr std::ptrdiff_t kEndOfHeader = 33;
  Bytes chunk;
  testing::appendU32(chunk, static_cast<std::uint32_t>(data.size()), true);
  chunk.insert(chunk.end(), type.begin(), type.end());
  chunk.insert(chunk.end(), data.begin(), data.end());
  const auto sum = crc32(0, chunk.data() + 4, static_cast<uInt>(chunk.size() - 4));
  testing::appendU32(chunk, static_cast<std::uint32_t>(sum), true);
  png.insert(png.begin() + kEndOfHeader, chunk.begin(), chunk.end());
  return png;
}

/// A PNG that states its colour by these chunks instead of sRGB's.
void addColoredPngs(Corpus& corpus) {
  Bytes plain = *encodePng(pictureFromLinear(gradient(9, 7, 3), 3), {});
  constexpr std::ptrdiff_t kSrgbChunk = 33;
  constexpr std::ptrdiff_t kSrgbSize = 13;
  plain.erase(plain.begin() + kSrgbChunk, plain.begin() + kSrgbChunk + kSrgbSize);
  Bytes gamma;
  testing::appendU32(gamma, 55556, true);
  corpus.add("png", "gamma", withChunk(plain, "gAMA", gamma));
  Bytes primaries;
  for (const std::uint32_t number : {31270u, 32900u, 70800u, 29200u, 17000u, 79700u, 13100u, 4600u})
    testing::appendU32(primaries, number, true);
  corpus.add("png", "primaries", withChunk(plain, "cHRM", primaries));
  Bytes profile = bytesOf(std::string("name\0\0", 6));
  const Bytes unpacked = testing::iccDisplayP3();
  Bytes packed(compressBound(unpacked.size()));
  uLongf size = packed.size();
  compress2(packed.data(), &size, unpacked.data(), unpacked.size(), 0);
  profile.insert(profile.end(), packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size));
  corpus.add("png", "profile", withChunk(plain, "iCCP", profile));
  corpus.add("png", "code_points", withChunk(plain, "cICP", {9, 16, 0, 1}));
}

void addImages(Corpus& corpus) {
  corpus.add("hdr", "new_rle", encodeHdr(gradient(13, 5, 3), {{"envmap", "cube"}}));
  Bytes old = bytesOf("#?RGBE\nEXPOSURE=2\nPRIMARIES=.7 .3 .2 .7 .1 .1 .3 .3\n\n+X 9 -Y 2\n");
  for (int column = 0; column < 9; ++column) old.insert(old.end(), {9, 8, 7, 130, 1, 1, 1, 1});
  corpus.add("hdr", "old_rle", old);
  Bytes flat = bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\nCOLORCORR=1 2 3\n\n-Y 1 +X 3\n");
  flat.insert(flat.end(), {9, 8, 7, 130, 1, 2, 3, 128, 0, 0, 0, 0});
  corpus.add("hdr", "flat_xyze", flat);
  Bytes odd = bytesOf(
      "\xef\xbb\xbf#?AUTOPANO\r\nFORMAT = 32-bit_rle_rgbe \nEXPOSURE=0\nCOLORCORR=1,5 2 1\nGAMMA=2.2\nPIXASPECT=2\n"
      "\tEXPOSURE=4\n \n\n-Y  1 +X   3 \n");
  odd.insert(odd.end(), {9, 8, 7, 130, 1, 2, 3, 128, 0, 0, 0, 0});
  corpus.add("hdr", "odd_header", odd);

  const Imf::Compression compressions[] = {Imf::NO_COMPRESSION,   Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                           Imf::ZIP_COMPRESSION,  Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION,
                                           Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION};
  for (const Imf::Compression compression : compressions)
    corpus.add("exr", "scan_lines_" + std::to_string(compression),
               foreignExr<Imf::RgbaOutputFile>(compression, Imf::WRITE_RGBA));
  corpus.add("exr", "chroma", foreignExr<Imf::RgbaOutputFile>(Imf::ZIP_COMPRESSION, Imf::WRITE_YC));
  corpus.add("exr", "tiles",
             foreignExr<Imf::TiledRgbaOutputFile>(Imf::RLE_COMPRESSION, Imf::WRITE_RGB, 8, 8, Imf::ONE_LEVEL));
  corpus.add("exr", "layers",
             testing::constantFile({{"AO.R", 1},
                                    {"AO.G", 2},
                                    {"AO.B", 3},
                                    {"N.X", 4},
                                    {"N.Y", 5},
                                    {"N.Z", 6},
                                    {"V.rgba.left.r", 7},
                                    {"V.rgba.left.g", 8},
                                    {"V.rgba.left.b", 9},
                                    {"Z", 10}}));
  corpus.add("exr", "parts",
             testing::constantParts({{"depth", {{"Z", 5}}}, {"rgba", {{"R", 1}, {"G", 2}, {"B", 3}, {"A", 1}}}}));
  const Imf::Header overscan(Imath::Box2i({0, 0}, {29, 19}), Imath::Box2i({-4, -3}, {15, 8}));
  corpus.add("exr", "window", testing::foreignFile(overscan, gradient(20, 12, 3), {"R", "G", "B"}));

  corpus.add("jpeg", "profile",
             testing::jpegWithProfile(*encodeJpeg(pictureFromLinear(gradient(9, 7, 3), 3), {}),
                                      testing::iccProfile4(u"Display P3")));
  corpus.add(
      "jpeg", "matrix_profile",
      testing::jpegWithProfile(*encodeJpeg(pictureFromLinear(gradient(9, 7, 3), 3), {}), testing::iccDisplayP3()));
  const GainMap numbers{.max_log2 = glm::vec3(4.0f)};
  const Bytes small = *encodeJpeg(Image8(8, 8, 1, 128), {});
  corpus.add("jpeg", "gain_map", joinedUltraHdr(small, small, numbers));
  corpus.add("gain_map", "file", joinedUltraHdr(small, small, numbers));
  corpus.add("gain_map", "xmp", bytesOf(gainMapXmp(numbers)));
  corpus.add("gain_map", "iso", gainMapIso(numbers));
  for (const int channels : {1, 3, 4}) {
    const Image8 picture = pictureFromLinear(gradient(9, 7, channels), channels);
    corpus.add("png", std::to_string(channels) + "_channels", *encodePng(picture, {{"envmap", "cube"}}));
    if (channels < 4)
      corpus.add("jpeg", std::to_string(channels) + "_channels", *encodeJpeg(picture, {{"envmap", "cube"}}));
  }
}

void addTiffs(Corpus& corpus) {
  const auto add = [&](const std::string& seed, testing::TiffForm form) {
    form.width = form.width == 5 ? 9 : form.width;
    corpus.add("tiff", seed, testing::tiffFile(form, testing::tiffSamples(form)));
  };
  add("lzw", {.compression = COMPRESSION_LZW, .predictor = PREDICTOR_HORIZONTAL});
  add("planes_big_endian", {.bits = 16, .compression = COMPRESSION_ADOBE_DEFLATE, .is_by_planes = true, .mode = "wb"});
  add("tiles", {.bits = 32,
                .kind = SAMPLEFORMAT_IEEEFP,
                .compression = COMPRESSION_ZSTD,
                .predictor = PREDICTOR_FLOATINGPOINT,
                .tile = 16});
  add("half", {.bits = 16, .kind = SAMPLEFORMAT_IEEEFP, .compression = COMPRESSION_PACKBITS});
  add("double_grey", {.samples = 1, .bits = 64, .kind = SAMPLEFORMAT_IEEEFP, .photometric = PHOTOMETRIC_MINISBLACK});
  add("palette", {.samples = 1,
                  .bits = 2,
                  .photometric = PHOTOMETRIC_PALETTE,
                  .palette = {0, 1, 2, 3, 0, 10, 20, 30, 0, 100, 200, 255}});
  add("bits", {.samples = 1, .bits = 1, .photometric = PHOTOMETRIC_MINISWHITE});
  add("twelve_bits", {.samples = 1, .bits = 12, .photometric = PHOTOMETRIC_MINISBLACK});
  add("alpha", {.samples = 4,
                .orientation = ORIENTATION_LEFTBOT,
                .mode = "w8",
                .extras = {EXTRASAMPLE_ASSOCALPHA},
                .profile = testing::iccProfile("Adobe RGB (1998)")});
  add("primaries", {.primaries = {0.3127f, 0.329f, 0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f}});
  add("jpeg", {.width = 16, .height = 16, .compression = COMPRESSION_JPEG, .rows_per_strip = 16});
  for (const auto& [name, samples, photometric, compression] :
       {std::tuple("log_luv", 3, PHOTOMETRIC_LOGLUV, COMPRESSION_SGILOG),
        std::tuple("log_luv_24", 3, PHOTOMETRIC_LOGLUV, COMPRESSION_SGILOG24),
        std::tuple("log_l", 1, PHOTOMETRIC_LOGL, COMPRESSION_SGILOG)}) {
    const testing::TiffForm form{.samples = static_cast<std::uint16_t>(samples),
                                 .bits = 32,
                                 .kind = SAMPLEFORMAT_IEEEFP,
                                 .photometric = static_cast<std::uint16_t>(photometric),
                                 .compression = static_cast<std::uint16_t>(compression)};
    corpus.add("tiff", name, testing::tiffFile(form, testing::bytesOfNumbers(testing::tiffFloats(form))));
  }
}

void addWebps(Corpus& corpus) {
  for (const int channels : {3, 4}) {
    const Image8 picture = pictureFromLinear(gradient(9, 7, channels), channels);
    for (const float quality : {80.0f, 101.0f})
      corpus.add("webp", (quality > 100 ? "lossless_" : "lossy_") + std::to_string(channels),
                 testing::encodedWebp(picture, quality));
    corpus.add("webp", "profile_" + std::to_string(channels),
               testing::extendedWebp(picture, channels == 4 ? 0x30 : 0x20, "ICCP", testing::iccProfile("Display P3")));
  }
}

void addAvifsAndJxls(Corpus& corpus) {
  for (const int channels : {3, 4}) {
    const std::string kind = std::to_string(channels);
    const Image8 picture = pictureFromLinear(gradient(9, 7, channels), channels);
    corpus.add("avif", "bits8_" + kind, testing::avifFile(picture));
    corpus.add("avif", "turned_" + kind, testing::avifFile(picture, testing::AvifForm{.quarters = 3, .mirrors = true}));
    ImageOf<std::uint16_t> codes(9, 7, channels, 1000);
    corpus.add("avif", "pq_" + kind, testing::avifFile(codes, testing::AvifForm{10, 9, 16}));
    corpus.add("jxl", "bits8_" + kind, testing::jxlFile(picture));
    corpus.add("jxl", "bits16_" + kind, testing::jxlFile(codes, testing::JxlForm{JXL_TRANSFER_FUNCTION_HLG}));
    corpus.add("jxl", "lossy_" + kind, testing::jxlFile(picture, testing::JxlForm{.is_lossy = true}));
    corpus.add("jxl", "floats_" + kind,
               testing::jxlFile(gradient(9, 7, channels), testing::JxlForm{JXL_TRANSFER_FUNCTION_LINEAR}));
  }
}

/// TGA, BMP, and Netpbm's.
void addPlainPictures(Corpus& corpus) {
  const Bytes texels(64, 99);
  corpus.add("tga", "colors", testing::tgaFile({.id = "name"}, texels));
  corpus.add("tga", "alpha", testing::withTgaFooter(testing::tgaFile({.bits = 32, .descriptor = 0x18}, texels), 4));
  corpus.add("tga", "short_colors",
             testing::tgaFile({.type = 10, .bits = 16, .descriptor = 1}, {131, 1, 2, 1, 3, 4, 5, 6}));
  corpus.add("tga", "grey", testing::tgaFile({.type = 11, .bits = 8}, {1, 9, 8, 131, 7}));
  corpus.add("tga", "grey_alpha", testing::tgaFile({.type = 3, .bits = 16}, texels));
  corpus.add("tga", "palette",
             testing::tgaFile({.type = 1, .bits = 8, .palette_first = 1, .palette_length = 2, .palette_bits = 24},
                              {1, 2, 3, 4, 5, 6, 1, 2, 1, 2, 1, 2}));

  corpus.add("bmp", "colors", testing::bmpFile({}, texels));
  corpus.add("bmp", "core", testing::bmpFile({.header = 12, .bits = 1, .palette = {0, 0xffffff}}, texels));
  corpus.add("bmp", "palette", testing::bmpFile({.height = -2, .bits = 4, .palette = {1, 2, 3, 4, 5, 6, 7}}, texels));
  const std::vector<std::uint32_t> colors{0, 0xff0000, 0xff00, 0xff};
  corpus.add("bmp", "rle8",
             testing::bmpFile({.bits = 8, .compression = 1, .palette = colors},
                              {2, 1, 1, 2, 0, 0, 0, 2, 1, 0, 0, 3, 1, 2, 3, 0, 0, 1}));
  corpus.add(
      "bmp", "rle4",
      testing::bmpFile({.bits = 4, .compression = 2, .palette = colors}, {3, 0x12, 0, 0, 0, 3, 0x12, 0x30, 0, 1}));
  corpus.add("bmp", "masks",
             testing::bmpFile({.header = 124,
                               .bits = 32,
                               .compression = 3,
                               .masks = {0x3ff00000, 0xffc00, 0x3ff, 0xc0000000},
                               .profile = testing::iccProfile("Display P3")},
                              texels));
  corpus.add("bmp", "short_colors", testing::bmpFile({.bits = 16}, texels));

  corpus.add("pnm", "pbm_text", bytesOf("P1 # one\n3 2\n1 0 1\n010"));
  corpus.add("pnm", "pgm_text", bytesOf("P2\n3 2 15\n1 2 3 4 5 15\n"));
  corpus.add("pnm", "ppm_text", bytesOf("P3 1 2 1000 0 1 2 3 4 1000"));
  corpus.add("pnm", "pbm", bytesOf("P4 3 2\nab"));
  corpus.add("pnm", "pgm", bytesOf("P5 3 2 65535\nabcdefghijkl"));
  corpus.add("pnm", "ppm", bytesOf("P6 1 2 255\nabcdef"));
  corpus.add("pnm", "pam",
             bytesOf("P7\nWIDTH 3\nHEIGHT 1\nDEPTH 2\nMAXVAL 255\nTUPLTYPE GRAYSCALE_ALPHA\nENDHDR\nabcdef"));
  corpus.add("pfm", "color", bytesOf("PF\n1 2\n-2.5\nabcdefghijklabcdefghijkl"));
  corpus.add("pfm", "grey", bytesOf("Pf 2 1 1.0\nabcdefgh"));
}

/// One triangle, with all that a format has to say about it.
void addModels(Corpus& corpus) {
  corpus.add("obj", "triangle",
             bytesOf("mtllib none.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"
                     "f -3//1 -2//1 -1//1\n"));
  corpus.add(
      "obj", "colors",
      bytesOf(
          "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 1 0 0 \\\n1\nv 0,5 1 nan\n#MRGB ffff0000ff00ff00\nvt nan 0\nvn 0 0 0\n"
          "f -4/1/1 -3/1/1 -2/1/1\nf 1 2 3 4\nf 1 2 9\n"));
  corpus.add("ply", "ascii",
             bytesOf("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
                     "property list uchar int vertex_indices\nend_header\n"
                     "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n"));
  corpus.add("ply", "faces",
             bytesOf("ply\nformat ascii 1.0\ncomment TextureFile none.png\nelement vertex 4\nproperty float x\n"
                     "property float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                     "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
                     "property int texnumber\nproperty ushort r\nproperty ushort g\nproperty ushort b\nend_header\n"
                     "0 0 0 0 0 1\n1 0 0 nan 0 0\n1 1 0 0 0 0\n0 nan 0 0 0 1\n3 0 1 2 6 0 0 1 0 1 1 0 255 0 7\n"
                     "4 0 1 2 3 0 1 9 9 9\n"));
  Bytes binary = bytesOf(
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n");
  const std::initializer_list<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (const float value : corners) testing::appendU32(binary, std::bit_cast<std::uint32_t>(value), false);
  binary.insert(binary.end(), {3, 0, 1, 2});
  corpus.add("ply", "binary", binary);

  corpus.add("stl", "text",
             bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                     "endfacet\nendsolid a\n"));
  Bytes stl(80, 0);
  testing::appendU32(stl, 1, false);
  for (int i = 0; i < 3; ++i) testing::appendU32(stl, 0, false);
  for (const float value : corners) testing::appendU32(stl, std::bit_cast<std::uint32_t>(value), false);
  stl.insert(stl.end(), {0, 0});
  corpus.add("stl", "binary", stl);
  const std::string_view magics("COLOR=\xff\x80\0\xff", 10);
  std::copy(magics.begin(), magics.end(), stl.begin());
  stl.back() = 0x80;
  corpus.add("stl", "colors", stl);

  const std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,2,3]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
      R"("materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"metallicFactor":0.5},)"
      R"("extensions":{"KHR_materials_ior":{"ior":1.4}}}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
      R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  corpus.add("gltf", "triangle", bytesOf(json));
  // The same as .glb: a header, and one chunk of JSON padded with spaces.
  std::string padded = json;
  padded.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes glb = bytesOf("glTF");
  for (const std::uint32_t number :
       {2u, static_cast<std::uint32_t>(20 + padded.size()), static_cast<std::uint32_t>(padded.size()), 0x4e4f534au})
    testing::appendU32(glb, number, false);
  glb.insert(glb.end(), padded.begin(), padded.end());
  corpus.add("gltf", "binary", glb);
}

/// A bent sheet of 8 triangles as Draco compresses it.
///
/// attribute  becomes the number by which glTF finds the position
Bytes dracoSheet(int method, int& attribute) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(8);
  attribute = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const auto corner = [](int x, int y) {
    return draco::Vector3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y));
  };
  for (int cell = 0; cell < 4; ++cell) {
    const int x = cell % 2;
    const int y = cell / 2;
    const draco::Vector3f a = corner(x, y), b = corner(x + 1, y), c = corner(x + 1, y + 1), d = corner(x, y + 1);
    const draco::FaceIndex face(static_cast<std::uint32_t>(2 * cell));
    builder.SetAttributeValuesForFace(attribute, face, a.data(), b.data(), c.data());
    builder.SetAttributeValuesForFace(attribute, face + 1, a.data(), c.data(), d.data());
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  attribute = static_cast<int>(mesh->attribute(attribute)->unique_id());
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 8);
  draco::EncoderBuffer buffer;
  encoder.EncodeMeshToBuffer(*mesh, &buffer);
  return Bytes(buffer.buffer()->begin(), buffer.buffer()->end());
}

void addDracoModels(Corpus& corpus) {
  for (const auto& [method, name] : {std::pair{draco::MESH_SEQUENTIAL_ENCODING, "draco_sequential"},
                                     {draco::MESH_EDGEBREAKER_ENCODING, "draco_edgebreaker"}}) {
    int attribute = 0;
    testing::GltfMaker maker;
    maker.view(dracoSheet(method, attribute));
    maker.rawAccessor(R"({"componentType":5126,"count":9,"type":"VEC3"})");
    maker.rawAccessor(R"({"componentType":5123,"count":24,"type":"SCALAR"})");
    corpus.add("gltf", name,
               maker.glb(R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":)"
                         R"({"bufferView":0,"attributes":{"POSITION":)" +
                         std::to_string(attribute) + "}}}}"));
  }
}

/// Two triangles as meshoptimizer compresses them: vertices, and indices in the coding of triangles.
void addMeshoptModel(Corpus& corpus) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1};
  const std::vector<std::uint32_t> indices{0, 1, 2, 2, 1, 3};
  Bytes vertices(meshopt_encodeVertexBufferBound(4, 12));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), positions.data(), 4, 12));
  Bytes corners(meshopt_encodeIndexBufferBound(6, 4));
  corners.resize(meshopt_encodeIndexBuffer(corners.data(), corners.size(), indices.data(), 6));
  const auto view = [](std::size_t length, std::size_t offset, std::size_t size, const std::string& how) {
    return R"({"buffer":1,"byteLength":)" + std::to_string(length) +
           R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"byteOffset":)" + std::to_string(offset) +
           R"(,"byteLength":)" + std::to_string(size) + "," + how + "}}}";
  };
  Bytes buffer = vertices;
  buffer.insert(buffer.end(), corners.begin(), corners.end());
  corpus.add(
      "gltf", "meshopt",
      bytesOf(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
              R"({"POSITION":0},"indices":1}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,)"
              R"("type":"VEC3"},{"bufferView":1,"componentType":5125,"count":6,"type":"SCALAR"}],"bufferViews":[)" +
              view(48, 0, vertices.size(), R"("byteStride":12,"count":4,"mode":"ATTRIBUTES","filter":"NONE")") + "," +
              view(24, vertices.size(), corners.size(), R"("byteStride":4,"count":6,"mode":"TRIANGLES")") +
              R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + R"(,"uri":"data:;base64,)" +
              testing::GltfMaker::base64(buffer) + R"("},{"byteLength":72}]})"));
}

/// Cameras, lights, variants, and a material of each extension.
void addScene(Corpus& corpus) {
  testing::GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  corpus.add(
      "gltf", "scene",
      bytesOf(maker.gltf(
          R"({"attributes":{"POSITION":0},"material":0,"extensions":{"KHR_materials_variants":{"mappings":)"
          R"([{"material":1,"variants":[0]}]}}})",
          R"("nodes":[{"mesh":0,"camera":0},{"camera":1,"extensions":{"KHR_lights_punctual":{"light":0}}}],)"
          R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}},)"
          R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":1}}],)"
          R"("extensions":{"KHR_materials_variants":{"variants":[{"name":"a"}]},"KHR_lights_punctual":{"lights":)"
          R"([{"type":"spot","color":[1,1,1],"range":1,"spot":{"innerConeAngle":0.1,"outerConeAngle":1}}]}},)"
          R"("materials":[{"extensions":{"KHR_materials_unlit":{}}},{"extensions":{"KHR_materials_specular":)"
          R"({"specularColorFactor":[1,1,1]},"KHR_materials_ior":{"ior":0},)"
          R"("KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,1,1,1],"glossinessFactor":1}}}])")));
}

/// A skin of two joints with a sparse morph target, moved in all three ways and by a pointer.
void addAnimation(Corpus& corpus) {
  testing::GltfMaker maker;
  maker.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  maker.accessor(std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4");
  maker.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
  maker.view(std::vector<std::uint8_t>{1});
  maker.view(std::vector<float>{0, 0, 1});
  maker.rawAccessor(R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":3,)"
                    R"("componentType":5121},"values":{"bufferView":4}}})");
  std::vector<float> binds(32, 0.0f);
  for (const std::size_t i : {0, 5, 10, 15, 16, 21, 26, 31}) binds[i] = 1.0f;
  maker.accessor(binds, "MAT4");
  testing::AnimationMaker walk(maker);
  walk.move(R"("node":1,"path":"rotation")", {0, 1}, {0, 0, 0, 1, 0, 1, 0, 0}, "VEC4")
      .move(R"("node":0,"path":"weights")", {0, 1}, {0, 0, 0, 0, 1, 0}, "SCALAR", "CUBICSPLINE")
      .move(R"("node":2,"path":"scale")", {0, 1}, {1, 1, 1, -1, 0, 2}, "VEC3", "STEP")
      .point("/materials/0/pbrMetallicRoughness/roughnessFactor", {0, 1}, {0, 1}, "SCALAR");
  corpus.add("gltf", "animation",
             maker.glb(R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"material":0,"targets":)"
                       R"([{"POSITION":3}]})",
                       R"("materials":[{}],"nodes":[{"mesh":0,"skin":0,"weights":[1]},{"children":[2]},{"mesh":0}],)"
                       R"("skins":[{"inverseBindMatrices":4,"joints":[1,2]}],"animations":[)" +
                           walk.json() + "]"));
}

/// What MadeInput::number() reads.
void append(Bytes& bytes, std::initializer_list<float> numbers) {
  for (const float number : numbers) {
    const std::uint16_t half = halfFromFloat(number);
    bytes.push_back(static_cast<std::uint8_t>(half & 0xff));
    bytes.push_back(static_cast<std::uint8_t>(half >> 8));
  }
}

/// As heights.cpp reads them.
void addHeights(Corpus& corpus) {
  const auto add = [&](const std::string& seed, int width, int height, int flags,
                       std::initializer_list<float> numbers) {
    Bytes bytes{static_cast<std::uint8_t>(width - 1), static_cast<std::uint8_t>(height - 1),
                static_cast<std::uint8_t>(flags)};
    append(bytes, {0.25f});
    bytes.insert(bytes.end(), {0, 0});
    append(bytes, numbers);
    corpus.add("heights", seed, bytes);
  };
  add("hill", 3, 3, 2, {0, 0.25f, 0, 0.5f, 1, 0.5f, 0, 0.25f, 0});
  add("relaxed_clamped_row", 5, 1, 8 + 4 + 1, {0, 1, 0.5f, 0.5f, -1});
  add("nan", 2, 1, 3, {1, std::numeric_limits<float>::quiet_NaN()});
  add("normals", 2, 2, 16 + 2, {0.5f, 0, 1, -0.5f, 0, 1, 0.5f, 0.5f, 1, -0.5f, -0.5f, 0.25f});
  add("slopes_clamped", 1, 3, 32 + 16 + 4, {0.5f, 0, 0.5f, 1, 0, 0, 0, 0, 1});
}

/// As transfer.cpp reads it: a square of two triangles, with its normals where they are asked for.
void appendSquare(Bytes& bytes, float height, bool with_normals) {
  bytes.insert(bytes.end(), {0, static_cast<std::uint8_t>(with_normals ? 1 : 0), 2, 3});
  for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
    append(bytes, {x, y, height, x, 1.0f - y});
    if (with_normals) append(bytes, {0.25f - 0.5f * x, 0.0f, 1.0f});
  }
  bytes.insert(bytes.end(), {0, 1, 2, 0, 2, 3, 0});
}

void addTransfers(Corpus& corpus) {
  const auto add = [&](const std::string& seed, std::initializer_list<std::uint8_t> settings, bool with_normals) {
    Bytes bytes = settings;
    appendSquare(bytes, 0.01f, with_normals);
    appendSquare(bytes, 0.0f, false);
    corpus.add("transfer", seed, bytes);
  };
  // Side of the map, flags, perhaps a cage, padding, triangles.
  add("plates", {3, 0, 2, 1}, false);
  add("everything", {7, 1 + 4 + 8, 4, 0}, true);
  add("caged_object_space", {7, 2 + 8 + 16, 4, 1, 1}, true);
}

}  // namespace
}  // namespace mirrorball

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
    return 2;
  }
  mirrorball::Corpus corpus{arguments[1]};
  mirrorball::addTextures(corpus);
  mirrorball::addUastcHdrBlocks(corpus);
  mirrorball::addImages(corpus);
  mirrorball::addColoredPngs(corpus);
  mirrorball::addTiffs(corpus);
  mirrorball::addWebps(corpus);
  mirrorball::addAvifsAndJxls(corpus);
  mirrorball::addPlainPictures(corpus);
  mirrorball::addModels(corpus);
  mirrorball::addDracoModels(corpus);
  mirrorball::addMeshoptModel(corpus);
  mirrorball::addScene(corpus);
  mirrorball::addAnimation(corpus);
  mirrorball::addHeights(corpus);
  mirrorball::addTransfers(corpus);
  return corpus.failed ? 1 : 0;
}
