#include "mirrorball/codec/picture_layers.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/hdr/hdr.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/row_reader.h"

namespace mirrorball {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PictureLayers, AGuessGetsTheOptionThatMendsItWhereverItStands) {
  const std::string guess = "has several pictures";
  EXPECT_THAT(withOtherLayer({"is cropped", guess}, guess),
              ElementsAre("is cropped", "has several pictures; {option:layer} NAME takes another"));
  EXPECT_THAT(withOtherLayer({guess}, guess, "{option:from} layer=NAME"),
              ElementsAre("has several pictures; {option:from} layer=NAME takes another"));
  EXPECT_THAT(withOtherLayer({"is cropped", ""}, ""), ElementsAre("is cropped", ""));
  EXPECT_TRUE(withOtherLayer({}, guess).empty());
}

TEST(PictureLayers, FilesOfOnePictureHaveNone) {
  const std::string text = "P2 2 1 255\n1 2\n";
  for (const Bytes& bytes : {Bytes(text.begin(), text.end()), encodeHdr(Image(2, 1, 3, 0.5f), {})}) {
    EXPECT_TRUE(decodeImage(bytes));
    for (const Error& error :
         {decodeImage(bytes, {.layer = "rgba"}).error(), decodeNumbers(bytes, {.layer = "rgba"}).error(),
          decodeDataTexture(bytes, {.layer = "rgba"}).error()}) {
      EXPECT_EQ(error.code, ErrorCode::not_found);
      EXPECT_THAT(error.message, HasSubstr("has no layers, and none that is named 'rgba'"));
    }
  }
  const auto path = std::filesystem::path(::testing::TempDir()) / "picture_layers_test.hdr";
  ASSERT_TRUE(writeFile(path, encodeHdr(Image(2, 1, 3, 0.5f), {})));
  EXPECT_TRUE(*openRows(path));
  EXPECT_FALSE(*openRows(path, {.layer = "rgba"})) << "it is read as a whole, and refused";
}

}  // namespace
}  // namespace mirrorball
