#include "mirrorball/image/resize.h"

#include <numeric>

#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// Numbers that rise by 2 a column and by 3 a row, in the first channel, and fall in the second.
Image ramp(int width, int height) {
  Image image(width, height, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.texel(x, y)[0] = 2.0f * (float(x) + 0.5f) / float(width) + 3.0f * (float(y) + 0.5f) / float(height);
      image.texel(x, y)[1] = -image.texel(x, y)[0];
    }
  return image;
}

double meanOf(const Image& image) {
  return std::accumulate(image.samples().begin(), image.samples().end(), 0.0) / double(image.samples().size());
}

TEST(Resized, IsTheSameInItsOwnSize) {
  const Image image = ramp(7, 5);
  const Image same = resized(image, {7, 5});
  for (std::size_t i = 0; i < image.samples().size(); ++i) EXPECT_FLOAT_EQ(same.samples()[i], image.samples()[i]);
}

TEST(Resized, ARampStaysOneWhereTexelsAreMeansOfWholeOnes) {
  for (const glm::ivec2 size : {glm::ivec2(5, 7), {1, 1}, {10, 2}, {4, 14}}) {
    const Image small = resized(ramp(20, 14), size);
    ASSERT_EQ(glm::ivec2(small.width(), small.height()), size);
    const Image expected = ramp(size.x, size.y);
    for (std::size_t i = 0; i < expected.samples().size(); ++i)
      EXPECT_NEAR(small.samples()[i], expected.samples()[i], 1e-5f) << size.x << "x" << size.y << ", " << i;
  }
}

// Of sizes that do not divide each other each texel counts by what is covered of it.
TEST(Resized, ASmallerImageHasTheSameMean) {
  Image image(11, 13, 1);
  for (std::size_t i = 0; i < image.samples().size(); ++i) image.samples()[i] = float((i * 37) % 101);
  for (const glm::ivec2 size : {glm::ivec2(7, 3), {10, 12}, {1, 13}})
    EXPECT_NEAR(meanOf(resized(image, size)), meanOf(image), 1e-3) << size.x << "x" << size.y;
}

TEST(Resized, ALargerImageIsStraightBetweenTexels) {
  Image image(2, 1, 1);
  image.texel(1, 0)[0] = 1.0f;
  const Image large = resized(image, {8, 3});
  const float expected[] = {0.0f, 0.0f, 0.125f, 0.375f, 0.625f, 0.875f, 1.0f, 1.0f};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_FLOAT_EQ(large.texel(x, y)[0], expected[x]) << x;
  EXPECT_FLOAT_EQ(resized(Image(1, 1, 1, 5.0f), {3, 4}).texel(2, 3)[0], 5.0f);
}

}  // namespace
}  // namespace mirrorball
