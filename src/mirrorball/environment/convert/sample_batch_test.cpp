#include "mirrorball/environment/convert/sample_batch.h"

#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

/// Noise of every sign and size, with texels a thousand times brighter than their neighbours among it.
Image noise(int width, int height, int channels) {
  Image image(width, height, channels);
  unsigned state = 1;
  for (float& sample : image.samples()) {
    state = state * 1664525u + 1013904223u;
    sample = static_cast<float>(state >> 8) / 16777216.0f * (state % 61 == 0 ? 1000.0f : 1.0f);
  }
  return image;
}

EnvironmentMap noiseMap(Projection projection, int size, int channels) {
  const glm::ivec2 extent = imageSize(projection, size);
  ImageSet images(1, faceCount(projection));
  for (int face = 0; face < images.faces(); ++face) images.at(0, face) = noise(extent.x, extent.y, channels);
  return EnvironmentMap(projection, std::move(images));
}

// Points within images and across every edge: the vector instructions may only differ by rounding, which for a sum of
// 16 products of up to 1000 is 1e-4.
TEST(SampleBatch, IsTheScalarInterpolation) {
  for (const Projection projection : {Projection::equirect, Projection::cube, Projection::sphere, Projection::angular})
    for (const int channels : {1, 3, 4})
      for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::bicubic}) {
        const EnvironmentMap map = noiseMap(projection, 12, channels);
        PointBatch batch;
        batch.count = PointBatch::kCapacity;
        for (std::size_t i = 0; i < PointBatch::kCapacity; ++i) {
          const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / PointBatch::kCapacity;
          const float angle = 2.39996323f * static_cast<float>(i);
          batch.x[i] = std::sqrt(1.0f - y * y) * std::cos(angle);
          batch.y[i] = y;
          batch.z[i] = std::sqrt(1.0f - y * y) * std::sin(angle);
        }
        positionsOf(projection, batch);
        LightBatch light;
        sampleBatch(map, interpolation, batch, light);
        for (std::size_t i = 0; i < PointBatch::kCapacity; ++i) {
          const glm::vec3 expected = map.radiance({batch.x[i], batch.y[i], batch.z[i]}, interpolation);
          EXPECT_LT(glm::length(glm::vec3(light[i]) - expected), 2e-3f) << nameOf(projection) << channels << i;
        }
      }
}

}  // namespace
}  // namespace mirrorball
