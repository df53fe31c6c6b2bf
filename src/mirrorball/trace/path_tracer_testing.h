#pragma once

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "mirrorball/environment/environment.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball::testing {

inline Environment lightOf(float radiance) {
  return Environment([=](glm::vec3) { return glm::vec3(radiance); }, 16);
}

inline Material matt(float albedo) {
  Material material;
  material.base_color = glm::vec3(albedo);
  material.specular = 0.0f;
  material.perceptual_roughness = 1.0f;
  return material;
}

/// A built-in shape of one material, from the front.
inline Image traced(Scene scene, Environment environment, const TraceSettings& settings) {
  const BoundingSphere bounds = boundingSphere(scene);
  const Camera camera = makeCamera({.azimuth_deg = 0.0f, .elevation_deg = 0.0f}, bounds, 1.0f);
  const auto tracer = PathTracer::make(std::move(scene), std::move(environment));
  EXPECT_TRUE(tracer) << tracer.error().message;
  auto image = tracer->render(camera, settings);
  EXPECT_TRUE(image) << image.error().message;
  return std::move(image->radiance);
}

inline Scene shapeOf(const std::string& name, const Material& material) {
  Scene scene = *loadModel(name);
  for (Material& one : scene.materials) one = material;
  return scene;
}

inline float meanOf(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += double(image.texel(x, y)[1]);
  return static_cast<float>(sum / (double(image.width()) * image.height()));
}

/// The mean of each channel.
inline glm::dvec3 meansOf(const Image& image) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += glm::dvec3(rgbAt(image, x, y));
  return sum / (double(image.width()) * image.height());
}

inline void expectWhite(const Image& image, double tolerance, const std::string& what) {
  const glm::dvec3 means = meansOf(image);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(means[channel], 1.0, tolerance) << what << ", channel " << channel;
}

inline TraceSettings small(int samples) { return {.size = {24, 24}, .samples = samples}; }

}  // namespace mirrorball::testing
