// A file's picture is its display window, whatever of it the data window holds.

#include <array>

#include <ImfStandardAttributes.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/exr/exr_rows.h"
#include "mirrorball/codec/exr/exr_testing.h"
#include "mirrorball/codec/image_file_testing.h"

namespace mirrorball {
namespace {

using testing::decoded;
using testing::expectSameBits;
using testing::foreignFile;
using testing::gradient;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::tiledFile;

const std::vector<std::string> kColors{"R", "G", "B"};

/// Windows of sizes, the display window's upper left corner at (3, -2), so that nothing begins at 0 by chance.
Imf::Header windows(glm::ivec2 whole, glm::ivec2 corner, glm::ivec2 size) {
  const Imath::V2i origin(3, -2);
  const Imath::V2i first = origin + Imath::V2i(corner.x, corner.y);
  return Imf::Header(Imath::Box2i(origin, origin + Imath::V2i(whole.x - 1, whole.y - 1)),
                     Imath::Box2i(first, first + Imath::V2i(size.x - 1, size.y - 1)));
}

/// What lies in the display window.
Image inWindow(const Image& data, glm::ivec2 whole, glm::ivec2 corner) {
  Image picture(whole.x, whole.y, data.channels());
  for (int y = 0; y < data.height(); ++y)
    for (int x = 0; x < data.width(); ++x) {
      const glm::ivec2 at = corner + glm::ivec2(x, y);
      if (at.x < 0 || at.y < 0 || at.x >= whole.x || at.y >= whole.y) continue;
      std::copy_n(data.texel(x, y), data.channels(), picture.texel(at.x, at.y));
    }
  return picture;
}

/// The picture of a file, read some rows at a time.
Image byRows(const Bytes& bytes, const ImageReadOptions& options = {}) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "exr_window_test.exr";
  EXPECT_TRUE(writeFile(path, bytes));
  const auto rows = openExrRows(std::move(*FileReader::open(path)), options);
  if (!rows) {
    ADD_FAILURE() << rows.error().message;
    return Image(1, 1, 1);
  }
  const RowReader::Description& description = (*rows)->description();
  Image picture(description.width, description.height, description.channels);
  for (int y = 0; y < picture.height();) {
    const auto part = (*rows)->read(std::min(7, picture.height() - y));
    if (!part) {
      ADD_FAILURE() << part.error().message;
      break;
    }
    std::copy(part->samples().begin(), part->samples().end(), picture.texel(0, y));
    y += part->height();
  }
  return picture;
}

struct WindowCase {
  const char* name;
  glm::ivec2 corner;
  glm::ivec2 size;
  const char* remark;
};

constexpr std::array<WindowCase, 6> kWindowCases{{
    {"middle", {20, 10}, {30, 15}, "holds 30x15 of the 80x40 texels of its display window: what lies outside is black"},
    {"no sky", {0, 25}, {80, 15}, "holds 80x15 of the 80x40 texels of its display window: what lies outside is black"},
    {"one texel", {79, 39}, {1, 1}, "holds 1x1 of the 80x40 texels of its display window: what lies outside is black"},
    {"overscan",
     {-8, -4},
     {96, 48},
     "holds 96x48 texels, beyond its display window of 80x40: what lies outside is cut off"},
    {"overscan of rows",
     {0, -4},
     {80, 48},
     "holds 80x48 texels, beyond its display window of 80x40: what lies outside is cut off"},
    {"across a corner",
     {-10, 30},
     {40, 30},
     "holds 40x30 texels, beyond its display window of 80x40: what lies outside is cut off, and what it lacks is "
     "black"},
}};

TEST(ExrWindow, ThePictureIsTheDisplayWindow) {
  constexpr glm::ivec2 kWhole(80, 40);
  for (const WindowCase& c : kWindowCases) {
    SCOPED_TRACE(c.name);
    const Image data = gradient(c.size.x, c.size.y, 4);
    const std::vector<std::string> names{"R", "G", "B", "A"};
    const Image right = inWindow(data, kWhole, c.corner);
    for (const Imf::LineOrder order : {Imf::INCREASING_Y, Imf::DECREASING_Y}) {
      Imf::Header header = windows(kWhole, c.corner, c.size);
      header.lineOrder() = order;
      for (const Bytes& bytes :
           {foreignFile(header, data, names), tiledFile(header, data, names, Imf::MIPMAP_LEVELS)}) {
        const DecodedImage back = decoded(bytes);
        expectSameBits(back.image, right);
        expectSameBits(byRows(bytes), right);
        EXPECT_THAT(back.oddities, ::testing::ElementsAre(c.remark));
        ASSERT_TRUE(back.window);
        EXPECT_EQ(back.window->whole, kWhole);
        EXPECT_EQ(back.window->corner, c.corner);
        EXPECT_EQ(back.window->size, c.size);
      }
    }
  }
}

TEST(ExrWindow, ThatIsTheDataWindowIsNotTold) {
  const Image image = gradient(8, 4, 3);
  const DecodedImage back = decoded(foreignFile(windows({8, 4}, {0, 0}, {8, 4}), image, kColors));
  expectSameBits(back.image, image);
  EXPECT_FALSE(back.window);
  EXPECT_THAT(back.oddities, IsEmpty());
}

TEST(ExrWindow, OfGreyWithAlphaAndOfTwoNumbersIsBlackOutside) {
  const Image data = gradient(10, 6, 3);
  const Imf::Header header = windows({20, 10}, {4, -2}, {10, 6});
  const Image grey = decoded(foreignFile(header, data, {"Y", "A", "Z"})).image;
  ASSERT_EQ(grey.channels(), 4);
  EXPECT_EQ(grey.texel(4, 0)[2], data.texel(0, 2)[0]);
  EXPECT_EQ(grey.texel(4, 0)[3], data.texel(0, 2)[1]);
  EXPECT_EQ(grey.texel(3, 0)[0], 0.0f);
  EXPECT_EQ(grey.texel(3, 0)[3], 0.0f);
  const auto numbers = decodeExr(foreignFile(header, data, {"uv.u", "uv.v", "Z"}), {.layer = "uv"});
  ASSERT_TRUE(numbers);
  ASSERT_EQ(numbers->image.channels(), 3);
  EXPECT_EQ(numbers->image.texel(13, 3)[1], data.texel(9, 5)[1]);
  EXPECT_EQ(numbers->image.texel(13, 3)[2], 0.0f);
  EXPECT_EQ(numbers->image.texel(14, 3)[0], 0.0f);
}

// ImfEnvmap.h: directions follow the data window.
TEST(ExrWindow, OfAnEnvironmentMapOfOpenExrIsTheDataWindow) {
  const Image image = gradient(8, 4, 3);
  Imf::Header header = windows({100, 100}, {20, 30}, {8, 4});
  Imf::addEnvmap(header, Imf::ENVMAP_LATLONG);
  const DecodedImage back = decoded(foreignFile(header, image, kColors));
  expectSameBits(back.image, image);
  EXPECT_THAT(back.oddities, IsEmpty());
}

TEST(ExrWindow, WithoutATexelOfTheFileIsNotMeant) {
  const Image image = gradient(5, 4, 3);
  const Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), Imath::Box2i({-7, 20}, {-3, 23}));
  const DecodedImage back = decoded(foreignFile(header, image, kColors));
  expectSameBits(back.image, image);
  expectSameBits(byRows(foreignFile(header, image, kColors)), image);
  EXPECT_THAT(back.oddities, ::testing::ElementsAre("has no texel in its display window: read without that window"));
}

TEST(ExrWindow, FarLargerThanTheFileIsRefused) {
  const Image image = gradient(5, 4, 3);
  const auto wide = decodeExr(foreignFile(windows({1 << 18, 1 << 9}, {0, 0}, {5, 4}), image, kColors));
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().code, ErrorCode::bad_file);
  EXPECT_THAT(wide.error().message, HasSubstr("says its display window is 262144x512"));
  const auto huge = decodeExr(foreignFile(windows({1 << 20, 1 << 20}, {0, 0}, {5, 4}), image, kColors));
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().code, ErrorCode::too_large);
  EXPECT_THAT(huge.error().message, HasSubstr("its display window"));
}

}  // namespace
}  // namespace mirrorball
