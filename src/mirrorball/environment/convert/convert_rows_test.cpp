#include "mirrorball/environment/convert/convert_rows.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <limits>

#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/left_out_testing.h"
#include "mirrorball/environment/convert/rows_needed.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball {
namespace {

using testing::kEveryProjection;

constexpr std::size_t kMuch = std::size_t{1} << 30;

/// A file of its own for each test, gone with it.
class ConvertRows : public ::testing::Test {
 protected:
  ~ConvertRows() override { std::filesystem::remove(path_); }

  /// A panorama of that height with light that differs from texel to texel.
  Image panorama(int height, int channels = 3) {
    Image image(2 * height, height, channels);
    unsigned state = 1;
    for (float& sample : image.samples())
      sample = static_cast<float>(((state = state * 1664525u + 1013904223u) >> 20) % 1000) / 256.0f;
    return image;
  }

  /// In OpenEXR where this build writes it: with Radiance's it is one of the two that are read row by row.
  void write(const Image& image) { write(image, testing::checkFormat(ImageFormatId::exr) ? "exr" : "hdr"); }

  void write(const Image& image, const std::string& extension) {
    path_ = std::filesystem::temp_directory_path() /
            ("convert_rows_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + "." +
             extension);
    ASSERT_TRUE(writeImage(path_, image));
  }

  std::filesystem::path path_;
};

bool sameBits(const Image& a, const Image& b) {
  return a.samples().size() == b.samples().size() &&
         std::memcmp(a.samples().data(), b.samples().data(), a.samples().size_bytes()) == 0;
}

void expectTheBitsOfTheWhole(const std::string& path, std::initializer_list<int> sizes) {
  const glm::mat3 turned =
      glm::mat3(glm::vec3(0.6f, 0.0f, -0.8f), glm::vec3(0.64f, 0.6f, 0.48f), glm::vec3(0.48f, -0.8f, 0.36f));
  const LoadedEnvironment whole = *loadEnvironment(path);
  for (const Projection to : kEveryProjection)
    for (const glm::mat3& rotation : {glm::mat3(1.0f), turned})
      for (const int size : sizes) {
        const Resampling resampling{.source_from_target = rotation};
        const EnvironmentMap expected = *convert(whole.environment, to, size, resampling);
        auto rows = *openRows(path);
        ImageSet images = *imagesFor(to, size);
        const auto done = convertRows(*rows, kMuch, to, size, resampling, copyInto(images));
        ASSERT_TRUE(done) << done.error().message;
        for (int face = 0; face < images.faces(); ++face)
          EXPECT_TRUE(sameBits(images.at(0, face), expected.face(face))) << testing::testName(to) << " " << size;
      }
}

TEST_F(ConvertRows, GivesTheBitsOfTheWholePanorama) {
  write(panorama(320));
  expectTheBitsOfTheWhole(path_.string(), {1, 17, 96});
}

// Of more texels than the panorama has; apart from the small ones, which the sanitizers take alone.
TEST_F(ConvertRows, GivesTheBitsOfALargePanorama) {
  write(panorama(320));
  expectTheBitsOfTheWhole(path_.string(), {500});
}

TEST_F(ConvertRows, ReadsRadiancePicturesToo) {
  write(panorama(200), "hdr");
  const EnvironmentMap expected = *convert(loadEnvironment(path_.string())->environment, Projection::cube, 64);
  auto rows = *openRows(path_);
  ImageSet images = *imagesFor(Projection::cube, 64);
  ASSERT_TRUE(convertRows(*rows, kMuch, Projection::cube, 64, {}, copyInto(images)));
  for (int face = 0; face < 6; ++face) EXPECT_TRUE(sameBits(images.at(0, face), expected.face(face)));
}

TEST_F(ConvertRows, TakesNoMoreMemoryThanItMay) {
  write(panorama(256));
  auto rows = *openRows(path_);
  ImageSet images = *imagesFor(Projection::cube, 8);
  const auto refused = convertRows(*rows, 1 << 20, Projection::cube, 8, {}, copyInto(images));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::too_large);
  EXPECT_EQ(refused.error().fix_hint, FixHint::raise_memory);
}

TEST_F(ConvertRows, NamesTheFirstTexelThatIsNoNumber) {
  MIRRORBALL_NEEDS(testing::checkFormat(ImageFormatId::exr));
  Image image = panorama(100);
  image.texel(7, 70)[1] = std::numeric_limits<float>::quiet_NaN();
  write(image);
  auto rows = *openRows(path_);
  ImageSet images = *imagesFor(Projection::cube, 32);
  const auto refused = convertRows(*rows, kMuch, Projection::cube, 32, {}, copyInto(images));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::non_finite);
  EXPECT_EQ(refused.error().fix_hint, FixHint::repair);
  EXPECT_NE(refused.error().message.find("(7, 70)"), std::string::npos) << refused.error().message;
}

TEST_F(ConvertRows, StopsWhenItIsTold) {
  write(panorama(200));
  auto rows = *openRows(path_);
  ImageSet images = *imagesFor(Projection::cube, 128);
  const auto stopped = convertRows(*rows, kMuch, Projection::cube, 128, {}, copyInto(images),
                                   [](std::size_t, std::size_t) { return false; });
  EXPECT_EQ(stopped.error().code, ErrorCode::interrupted);
}

// The rows that a strip needs are found without looking its texels up; here every texel's row is compared with them.
TEST(RowsNeeded, HoldEveryTexelOfTheStrip) {
  constexpr int kHeight = 4096;
  for (const Projection to : kEveryProjection)
    for (const int size : {3, 40, 300}) {
      const Conversion conversion(to, size, {});
      for (const Strip& strip : conversion.strips()) {
        const RowRange rows = rowsNeeded(conversion, strip, kHeight);
        for (int y = strip.begin.y; y < strip.end.y; ++y)
          for (int x = strip.begin.x; x < strip.end.x; ++x)
            for (const glm::vec2 inside : {glm::vec2(0.05f), glm::vec2(0.5f), glm::vec2(0.05f, 0.95f)}) {
              const glm::vec2 uv = (glm::vec2(x, y) + inside) / glm::vec2(conversion.extent());
              if (!covers(to, uv)) continue;
              const auto place = positionOf(Projection::equirect, directionAt(to, {strip.face, uv}));
              const int row = static_cast<int>(place.uv.y * kHeight);
              ASSERT_TRUE(row - 2 >= rows.begin || rows.begin == 0) << testing::testName(to) << " " << x << " " << y;
              ASSERT_TRUE(row + 2 < rows.end || rows.end == kHeight) << testing::testName(to) << " " << x << " " << y;
            }
      }
    }
}

// A window must move: a strip needs far fewer rows than there are.
TEST(RowsNeeded, AreFew) {
  const Conversion conversion(Projection::cube, 4096, {});
  int max = 0;
  for (const Strip& strip : conversion.strips()) max = std::max(max, rowsNeeded(conversion, strip, 8192).count());
  EXPECT_LT(max, 8192 / 5);
}

}  // namespace
}  // namespace mirrorball
