// How far into their decoders changed pictures get: what a fuzzer's changes are worth.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include <avif/avif.h>
#include <gtest/gtest.h>
#include <jxl/decode.h>

#include "avif_mutation.h"
#include "chance.h"
#include "jxl_mutation.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/ldr/avif_testing.h"
#include "obus.h"
#include "picture.h"

namespace mirrorball::fuzz {
namespace {

/// Whether libavif takes what the boxes say and so goes on to the AV1 data.
bool avifHeadersAreRead(const Bytes& bytes) {
  const std::unique_ptr<avifDecoder, decltype(&avifDecoderDestroy)> decoder(avifDecoderCreate(), avifDecoderDestroy);
  decoder->strictFlags = AVIF_STRICT_DISABLED;
  avifDecoderSetIOMemory(decoder.get(), bytes.data(), bytes.size());
  return avifDecoderParse(decoder.get()) == AVIF_RESULT_OK;
}

/// Whether libjxl takes the headers and so goes on to a frame.
bool jxlHeadersAreRead(const Bytes& bytes) {
  const std::unique_ptr<JxlDecoder, decltype(&JxlDecoderDestroy)> decoder(JxlDecoderCreate(nullptr), JxlDecoderDestroy);
  JxlDecoderSubscribeEvents(decoder.get(), JXL_DEC_FRAME);
  JxlDecoderSetInput(decoder.get(), bytes.data(), bytes.size());
  JxlDecoderCloseInput(decoder.get());
  return JxlDecoderProcessInput(decoder.get()) == JXL_DEC_FRAME;
}

/// In hundredths, of how many files the picture was read, and of how many that or at least the headers.
struct Shares {
  int accepted = 0;
  int with_headers = 0;
};

/// Reads so many files in every way as well.
Shares countShares(const std::string& name, std::uint32_t count, const std::function<Bytes(std::uint32_t)>& file,
                   const std::function<bool(const Bytes&)>& headersAreRead) {
  std::uint32_t accepted = 0, with_headers = 0;
  for (std::uint32_t number = 0; number < count; ++number) {
    const Bytes bytes = file(number);
    readPicture(bytes.data(), bytes.size());
    const bool is_accepted = decodeImage(bytes).has_value();
    accepted += is_accepted ? 1 : 0;
    with_headers += is_accepted || headersAreRead(bytes) ? 1 : 0;
  }
  const Shares shares{static_cast<int>(100 * accepted / count), static_cast<int>(100 * with_headers / count)};
  std::printf("%s: %d %% are read, of %d %% the headers\n", name.c_str(), shares.accepted, shares.with_headers);
  return shares;
}

/// A file with one change anywhere, which is what a fuzzer does that knows nothing of it.
Bytes withAnyChange(Bytes bytes, std::uint32_t number) {
  std::mt19937 random(number);
  changeBytes(bytes, 0, random);
  return bytes;
}

/// Expects that of files with one change at least some are read, more than with a change anywhere, and of files with up
/// to three.
void expectMostAreRead(const std::string& format, const FileMutation& mutation,
                       const std::function<bool(const Bytes&)>& headersAreRead, Shares least, int least_mutated) {
  constexpr std::uint32_t kFiles = 300;
  const auto once = [&](std::uint32_t number) {
    std::mt19937 random(number);
    return mutation.changed(mutation.any(number), random);
  };
  const Shares changed = countShares(format + ", one change", kFiles, once, headersAreRead);
  EXPECT_GE(changed.accepted, least.accepted);
  EXPECT_GE(changed.with_headers, least.with_headers);
  const auto anywhere = [&](std::uint32_t number) { return withAnyChange(mutation.any(number), number); };
  EXPECT_GT(changed.accepted, countShares(format + ", a change anywhere", kFiles, anywhere, headersAreRead).accepted);
  const auto mutated = [&](std::uint32_t number) { return mutatedFile(mutation, number, number); };
  EXPECT_GE(countShares(format + ", up to three", kFiles, mutated, headersAreRead).accepted, least_mutated);
}

TEST(MutatedAvifs, MostAreReadOrFailInTheirTexels) {
  expectMostAreRead("AVIF", kAvifMutation, avifHeadersAreRead, {.accepted = 55, .with_headers = 70}, 50);
}

TEST(MutatedJxls, MostAreReadOrFailInTheirTexels) {
  expectMostAreRead("JPEG XL", kJxlMutation, jxlHeadersAreRead, {.accepted = 30, .with_headers = 90}, 40);
}

/// Wherever its items are, what they hold is the same.
TEST(AvifParts, AreThoseOfTheFileWhereverItsItemsAre) {
  for (std::uint32_t number = 0; number < 20; ++number) {
    const auto parts = avifPartsIn(anyAvif(number));
    ASSERT_TRUE(parts) << number;
    const auto plain = decodeImage(anyAvif(number));
    for (const AvifPlaces& places :
         {AvifPlaces{}, AvifPlaces{.version = 1, .is_in_meta = true}, AvifPlaces{.has_base = true, .extents = 3},
          AvifPlaces{.version = 2, .goes_back = true, .extents = 2}}) {
      const Bytes moved = avifOfParts(*parts, places);
      auto again = avifPartsIn(moved);
      ASSERT_TRUE(again) << number;
      EXPECT_TRUE(std::ranges::equal(again->items, parts->items, {}, &AvifItem::data, &AvifItem::data)) << number;
      const auto decoded = decodeImage(moved);
      ASSERT_EQ(decoded.has_value(), plain.has_value()) << number << ": " << decoded.error().message;
      if (plain) EXPECT_TRUE(std::ranges::equal(decoded->image.samples(), plain->image.samples())) << number;
    }
  }
}

/// Memory is taken for the size in the data, wherever that is. Where libavif says where it is, it is looked at before
/// decoding; in `idat` it is not, and dav1d refuses it by its limit.
TEST(AvifParts, DataLargerThanTheFileSaysIsRefusedWhereverItIs) {
  auto parts = avifPartsIn(testing::avifFile(Image8(1024, 1024, 3)));
  ASSERT_TRUE(parts);
  FileBox* iprp = firstBox(firstBox(parts->boxes, "meta")->boxes, "iprp");
  FileBox* size = firstBox(firstBox(iprp->boxes, "ipco")->boxes, "ispe");
  ASSERT_NE(size, nullptr);
  size->content = {0, 0, 0, 0, 0, 0, 0, 16, 0, 0, 0, 16};
  const std::uint64_t usual = memoryLimit();
  for (const AvifPlaces& places :
       {AvifPlaces{}, AvifPlaces{.version = 1, .is_in_meta = true}, AvifPlaces{.extents = 3}}) {
    const Bytes file = avifOfParts(*parts, places);
    const auto scaled = decodeImage(file);
    ASSERT_TRUE(scaled) << scaled.error().message;
    EXPECT_EQ(scaled->image.width(), 16) << "libavif scales it";
    setMemoryLimit(std::uint64_t{8} << 20u);
    EXPECT_FALSE(decodeImage(file)) << "where " << (places.is_in_meta ? "it is in idat" : "libavif knows its place");
    setMemoryLimit(usual);
  }
}

TEST(Obus, AreTheSameBytesAgain) {
  for (std::uint32_t number = 0; number < 20; ++number) {
    const auto parts = avifPartsIn(anyAvif(number));
    ASSERT_TRUE(parts) << number;
    const auto obus = obusIn(parts->items.back().data);
    ASSERT_TRUE(obus) << number;
    EXPECT_GE(obus->size(), 2u) << "a sequence's header and a frame";
    EXPECT_EQ(bytesOfObus(*obus), parts->items.back().data) << number;
  }
}

TEST(JxlParts, AreThoseOfTheFileInWhateverBoxes) {
  for (std::uint32_t number = 0; number < 40; ++number) {
    std::mt19937 random(number);
    const Bytes file = anyJxl(number);
    const auto parts = jxlPartsIn(file);
    ASSERT_TRUE(parts) << number;
    const Bytes other = jxlOfParts(*parts, random);
    EXPECT_EQ(jxlPartsIn(other)->code, parts->code);
    EXPECT_EQ(decodeImage(other).has_value(), decodeImage(file).has_value()) << number;
  }
}

}  // namespace
}  // namespace mirrorball::fuzz
