#include "truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"

namespace mirrorball::bench {

Result<EnvironmentMap> panoramaFor(const std::string& environment, const std::vector<BlurTarget>& targets) {
  MIRRORBALL_TRY(loaded, loadEnvironment(environment));
  float narrowest = 1.0f;
  for (const BlurTarget& target : targets) narrowest = std::min(narrowest, target.lobe.width());
  const int min = static_cast<int>(std::ceil(2.5f / narrowest));
  const EnvironmentMap* map = loaded.environment.map();
  EnvironmentMap panorama;
  if (map && map->projection() == Projection::equirect && map->size() >= min) {
    panorama = *map;
  } else {
    const int height = std::max(min, loaded.environment.naturalSize(Projection::equirect));
    MIRRORBALL_TRY(converted, convert(loaded.environment, Projection::equirect, height));
    panorama = std::move(converted);
  }
  for (float& sample : panorama.face(0).samples()) sample = std::max(sample, 0.0f);
  return panorama;
}

std::vector<MapPosition> pickedTexels(int size) {
  std::vector<MapPosition> picked;
  std::mt19937 random(static_cast<unsigned>(size));
  const auto pick = [&](int face, int x, int y) {
    picked.push_back({face, (glm::vec2(x, y) + 0.5f) / static_cast<float>(size)});
  };
  for (int face = 0; face < 6; ++face) {
    if (size <= 7) {
      for (int i = 0; i < size * size; ++i) pick(face, i % size, i / size);
      continue;
    }
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
      pick(face, corner.x * (size - 1), corner.y * (size - 1));
    pick(face, size / 2, size / 2);
    for (int i = 0; i < 45; ++i) {
      const int x = static_cast<int>(random() % static_cast<unsigned>(size));
      pick(face, x, static_cast<int>(random() % static_cast<unsigned>(size)));
    }
  }
  return picked;
}

TexelSums::TexelSums(const EnvironmentMap& panorama) : image_(panorama.face(0)) {
  for (int x = 0; x < image_.width(); ++x) {
    const double phi = 2.0 * std::numbers::pi * (x + 0.5) / image_.width();
    columns_.emplace_back(std::sin(phi), std::cos(phi));
  }
}

/// kernel   of cos θ > 0
template <typename Kernel>
glm::dvec3 TexelSums::mean(const Kernel& kernel, glm::vec3 direction) const {
  const glm::dvec3 middle = glm::normalize(glm::dvec3(direction));
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (int y = 0; y < image_.height(); ++y) {
    const double upper = std::numbers::pi * y / image_.height();
    const double lower = std::numbers::pi * (y + 1) / image_.height();
    const double theta = (upper + lower) / 2;
    const double area = std::cos(upper) - std::cos(lower);
    const glm::dvec2 along = std::sin(theta) * glm::dvec2(middle.x, -middle.z);
    const double above = std::cos(theta) * middle.y;
    for (int x = 0; x < image_.width(); ++x) {
      const double cosine = glm::dot(columns_[static_cast<std::size_t>(x)], along) + above;
      if (cosine <= 0.0) continue;
      const double weight = area * kernel(cosine);
      sum += weight * glm::dvec3(rgbAt(image_, x, y));
      weights += weight;
    }
  }
  return sum / weights;
}

glm::dvec3 TexelSums::mean(const BlurTarget& target, glm::vec3 direction) const {
  if (target.is_irradiance) return mean([](double cosine) { return cosine; }, direction);
  const double alpha2 = std::pow(static_cast<double>(target.perceptual_roughness), 4.0);
  return mean(
      [alpha2](double cosine) {
        const double q = (1.0 + cosine) / 2.0 * (alpha2 - 1.0) + 1.0;
        return cosine / (q * q);
      },
      direction);
}

Error errorOf(const std::vector<glm::dvec3>& found, const std::vector<glm::dvec3>& truth) {
  double squares = 0.0;
  double truth_squares = 0.0;
  double sum = 0.0;
  double max = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double difference = std::abs(found[i][c] - truth[i][c]);
      const double relative = truth[i][c] > 0.0 ? difference / truth[i][c] : 0.0;
      squares += difference * difference;
      truth_squares += truth[i][c] * truth[i][c];
      sum += relative;
      max = std::max(max, relative);
    }
  return {std::sqrt(squares / truth_squares), sum / (3.0 * static_cast<double>(truth.size())), max};
}

}  // namespace mirrorball::bench
