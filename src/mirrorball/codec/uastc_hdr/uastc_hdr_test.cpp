#include "mirrorball/codec/uastc_hdr/uastc_hdr.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>

#include "mirrorball/codec/byte_order.h"
#include "mirrorball/codec/half_blocks/half_blocks_testing.h"
#include "mirrorball/codec/texture/texture_testing.h"
#include "mirrorball/codec/uastc_hdr/uastc_hdr_block.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using testing::bytesOfTexture;
using ::testing::HasSubstr;

Image throughUastcHdr(const Image& image) { return testing::throughBlocks(testing::kUastcHdrCodec, image); }

/// A block of two colours in the shape of a partition, each with a little of its own.
Image inPartition(std::uint16_t second, glm::vec3 first_color, glm::vec3 second_color) {
  Image image(4, 4, 3);
  for (int i = 0; i < 16; ++i) {
    const float change = 1.0f + 0.02f * static_cast<float>(i % 3);
    const glm::vec3 color = (second >> i & 1 ? second_color : first_color) * change;
    for (int c = 0; c < 3; ++c) image.texel(i % 4, i / 4)[c] = color[c];
  }
  return image;
}

TEST(UastcHdr, OneColourIsExact) {
  for (const glm::vec3 color : {glm::vec3(1.0f), glm::vec3(0.5f, 2.0f, 704.0f), glm::vec3(65504.0f, 0.0f, 0.25f)}) {
    Image image(5, 3, 3);
    for (int i = 0; i < 15; ++i)
      for (int c = 0; c < 3; ++c) image.texel(i % 5, i / 5)[c] = color[c];
    EXPECT_EQ(testing::maxHalfError(throughUastcHdr(image), image), 0.0f) << color.x;
  }
}

/// Light of one hue, brighter and darker, is what ends with an offset are for.
TEST(UastcHdr, OneHueKeepsIt) {
  Image image(16, 16, 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c)
        image.texel(x, y)[c] = std::exp2(0.05f * static_cast<float>(x * y % 7)) * (c == 0   ? 2.0f
                                                                                   : c == 1 ? 1.0f
                                                                                            : 0.3f);
  EXPECT_LT(testing::maxHalfError(throughUastcHdr(image), image), 0.015f);
}

/// Two colours four octaves apart in the shape of each partition: only two subsets can be so near.
TEST(UastcHdr, EveryPartitionIsFound) {
  for (const UastcHdrPartition& partition : kUastcHdrPartitions) {
    const Image image = inPartition(partition.second(), glm::vec3(8.0f, 0.5f, 2.0f), glm::vec3(0.5f, 2.0f, 0.5f));
    EXPECT_LT(testing::maxHalfError(throughUastcHdr(image), image), 0.1f) << partition.seed;
  }
}

/// Each mode that the search tries wins somewhere; of one that never did it would be in vain.
TEST(UastcHdr, EveryModeThatIsTriedIsOfUse) {
  const Image noise = testing::octaveNoise(256, 256);
  Image mixed(256, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      for (int c = 0; c < 3; ++c) {
        // From smooth light of one hue on the left to noise on the right.
        const float share = static_cast<float>(x) / 256.0f;
        mixed.texel(x, y)[c] = std::exp2(share * share * std::log2(noise.texel(x, y)[y % 2 == 0 ? c : 0])) *
                               (1.0f + 0.01f * static_cast<float>(x + y));
      }
  const Bytes bytes = testing::encodedBlocks(testing::kUastcHdrCodec, mixed);
  std::set<std::string> found;
  for (std::size_t at = 0; at < bytes.size(); at += kHalfBlockSize) {
    const auto block = readUastcHdrBlock(std::span(bytes).subspan(at).first<kHalfBlockSize>());
    ASSERT_TRUE(block);
    const UastcHdrMode& mode = kUastcHdrModes[block->mode];
    if (!block->is_solid)
      found.insert(std::to_string(static_cast<int>(mode.color_mode)) + " " + std::to_string(mode.subsets) + " " +
                   std::to_string(mode.weights));
  }
  EXPECT_THAT(found,
              ::testing::UnorderedElementsAre("11 1 16", "11 1 12", "7 1 16", "7 2 8", "7 2 6", "11 2 4", "11 2 3"));
}

/// Files that leave ASTC's number out, or call themselves ASTC (162), hold the same blocks.
TEST(UastcHdrFile, OtherFormsAreRead) {
  const Image image = testing::colorRamp(8, 4);
  const Bytes file = bytesOfTexture(writeKtx2, ImageSet(image), {.format = TexelFormat::uastc_hdr});
  Bytes unnumbered = file;
  std::fill_n(unnumbered.begin() + 12, 4, std::uint8_t{0});
  Bytes astc = file;
  astc[littleU32(file.data() + 48) + 12] = 162;
  for (const Bytes& other : {file, unnumbered, astc}) {
    const auto read = decodeImageSet(other);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->format, "KTX2, uastc hdr 4x4");
    EXPECT_LT(testing::maxHalfError(read->images.at(0, 0), image), 0.012f);
  }
}

TEST(UastcHdrFile, OtherAstcIsNamed) {
  Bytes file = bytesOfTexture(writeKtx2, testing::textureOf(2, 6, 1, 3, 9, 9), {.format = TexelFormat::uastc_hdr});
  // The last of the nine blocks of face −Y of level 0, with two planes of weights.
  const std::uint64_t level = littleU64(file.data() + 80);
  file[std::size_t(level) + (3 * 9 + 5) * 16] = 0x42;
  file[std::size_t(level) + (3 * 9 + 5) * 16 + 1] |= 4;
  const auto read = decodeImageSet(file);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::unsupported);
  EXPECT_THAT(read.error().message, AllOf(HasSubstr("level 0, face -Y"), HasSubstr("UASTC HDR"),
                                          HasSubstr("block (2, 1)"), HasSubstr("r16g16b16a16 sfloat")));
}

TEST(UastcHdrFile, OtherContainersHaveNone) {
  for (const std::string name : {"a.dds", "a.ktx"}) {
    const auto written = writeImageSet(name, ImageSet(Image(4, 4, 3, 1.0f)), {.format = TexelFormat::uastc_hdr});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::usage);
    EXPECT_EQ(written.error().message, name + ": cannot hold uastc hdr 4x4 texels; use .ktx2");
  }
}

}  // namespace
}  // namespace mirrorball
