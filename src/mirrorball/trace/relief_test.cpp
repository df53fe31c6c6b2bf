#include "mirrorball/scene/relief/relief.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "mirrorball/scene/shapes/builtin_shapes.h"
#include "mirrorball/trace/path_tracer_testing.h"

namespace mirrorball {
namespace {

using namespace testing;

/// Light from above, brighter from one side.
Environment sideLight() {
  return Environment([](glm::vec3 d) { return glm::vec3(0.3f + 0.7f * std::max(d.x, 0.0f)); }, 16);
}

struct View {
  const char* shape;
  HeightKind height;
  float elevation_deg;
};

Image tracedRelief(const View& view, ReliefKind kind, const Environment& light, glm::ivec2 size, int samples) {
  Material material = matt(0.8f);
  material.height = view.height;
  material.height_scale = 0.1f;
  material.height_frequency = 1.0f;
  Scene scene = shapeOf(view.shape, material);
  const BoundingSphere bounds = boundingSphere(scene);
  EXPECT_TRUE(prepareRelief(scene, kind));
  const Camera camera = makeCamera({.azimuth_deg = 30.0f, .elevation_deg = view.elevation_deg, .distance = 3.0f},
                                   bounds, static_cast<float>(size.x) / static_cast<float>(size.y));
  const auto tracer = PathTracer::make(std::move(scene), light);
  EXPECT_TRUE(tracer) << tracer.error().message;
  auto image = tracer->render(camera, {.size = size, .samples = samples, .bounces = 3, .relief = kind});
  EXPECT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->lost_paths, 0u);
  return std::move(image->radiance);
}

/// The share of pixels that differ by more than that, of 255 as displayed.
double shareThatDiffers(const Image& a, const Image& b, float steps) {
  int count = 0;
  const auto shown = [](float light) { return 255.0f * std::pow(std::clamp(light, 0.0f, 1.0f), 1.0f / 2.2f); };
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      float most = 0.0f;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(shown(a.texel(x, y)[c]) - shown(b.texel(x, y)[c])));
      count += most > steps ? 1 : 0;
    }
  return double(count) / (double(a.width()) * a.height());
}

}  // namespace
}  // namespace mirrorball
