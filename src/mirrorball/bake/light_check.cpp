#include "mirrorball/bake/light_check.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mirrorball/bake/point_light_batch.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

constexpr int kPartsAcross = 32;
constexpr int kPartsDown = 16;
constexpr std::size_t kDetailed = 10;
constexpr int kScattered = 6;

/// How much a part of a map changes from texel to texel, for its light, and where most.
struct Detail {
  float share = 0.0f;
  float greatest = 0.0f;
  glm::ivec2 texel{0};
};

Detail detailOf(const Image& image, glm::ivec2 begin, glm::ivec2 end) {
  constexpr int kStep = 4;  // of rows
  Detail detail;
  double changes = 0.0;
  double light = 0.0;
  for (int y = begin.y; y < end.y; y += kStep)
    for (int x = begin.x; x < end.x; ++x) {
      const glm::vec3 here = rgbAt(image, x, y);
      const glm::vec3 across = glm::abs(here - rgbAt(image, x > 0 ? x - 1 : image.width() - 1, y));
      const glm::vec3 down = glm::abs(here - rgbAt(image, x, y > 0 ? y - 1 : 1));
      const float change = across.x + across.y + across.z + down.x + down.y + down.z;
      changes += static_cast<double>(change);
      light += static_cast<double>(here.x + here.y + here.z);
      // The last of equals: the first is at the edge of what repeats itself.
      if (change >= detail.greatest) {
        detail.greatest = change;
        detail.texel = {x, y};
      }
    }
  if (light > 0.0) detail.share = static_cast<float>(changes / light);
  return detail;
}

/// Evenly scattered over a sphere without its poles: golden angles.
std::vector<glm::vec3> scatteredDirections() {
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<glm::vec3> directions;
  for (int i = 0; i < kScattered; ++i) {
    const double y = 0.95 * ((2.0 * i + 1.0) / kScattered - 1.0);
    const double radius = std::sqrt(1.0 - y * y);
    directions.emplace_back(radius * std::sin(golden * i), y, -radius * std::cos(golden * i));
  }
  return directions;
}

/// The texels of a row as points of light.
void lightOfRow(const EnvironmentMap& panorama, int y, std::vector<PointOfLight>& texels) {
  const glm::ivec2 extent = panorama.extent();
  const float solid_angle = texelSolidAngle(Projection::equirect, extent, {0, y});
  texels.clear();
  PointBatch batch;
  batch.v.fill((static_cast<float>(y) + 0.5f) / static_cast<float>(extent.y));
  for (int begin = 0; begin < extent.x; begin += PointBatch::kCapacity) {
    batch.count = std::min(PointBatch::kCapacity, extent.x - begin);
    for (int i = 0; i < batch.count; ++i)
      batch.u[std::size_t(i)] = (static_cast<float>(begin + i) + 0.5f) / static_cast<float>(extent.x);
    directionsAt(Projection::equirect, batch);
    for (int i = 0; i < batch.count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      texels.push_back({{batch.x[at], batch.y[at], batch.z[at]}, rgbAt(panorama.face(0), begin + i, y) * solid_angle});
    }
  }
}

}  // namespace

std::vector<glm::vec3> doubtfulDirections(const EnvironmentMap& panorama) {
  const Image& image = panorama.face(0);
  const glm::ivec2 extent = panorama.extent();
  const glm::ivec2 parts(kPartsAcross, kPartsDown);
  assert(extent.x >= kPartsAcross && extent.y >= kPartsDown);
  // The first and the last row of parts have the poles.
  std::vector<Detail> details(std::size_t(kPartsAcross) * (kPartsDown - 2));
  parallelFor(details.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const glm::ivec2 part(i % kPartsAcross, 1 + i / kPartsAcross);
      details[i] = detailOf(image, part * extent / parts, (part + 1) * extent / parts);
    }
  });
  std::ranges::stable_sort(details, std::greater(), &Detail::share);
  std::vector<glm::vec3> directions = scatteredDirections();
  for (std::size_t i = 0; i < kDetailed; ++i)
    directions.push_back(
        directionAt(Projection::equirect, {0, (glm::vec2(details[i].texel) + 0.5f) / glm::vec2(extent)}));
  return directions;
}

PointBatch batchOf(const std::vector<glm::vec3>& directions) {
  PointBatch points;
  points.count = static_cast<int>(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    points.x[i] = directions[i].x;
    points.y[i] = directions[i].y;
    points.z[i] = directions[i].z;
  }
  return points;
}

std::vector<glm::vec3> sumOverTexels(const EnvironmentMap& panorama, const Lobe& lobe,
                                     const std::vector<glm::vec3>& directions) {
  const PointBatch points = batchOf(directions);
  const glm::ivec2 extent = panorama.extent();
  std::vector<LightChannels> rows(std::size_t(extent.y));
  parallelFor(rows.size(), 8, [&](std::size_t begin, std::size_t end) {
    std::vector<PointOfLight> texels;
    for (std::size_t y = begin; y < end; ++y) {
      lightOfRow(panorama, static_cast<int>(y), texels);
      rows[y] = lightOfPoints(texels, lobe, points);
    }
  });
  std::vector<glm::vec3> sums;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    glm::dvec3 sum(0.0);
    for (const LightChannels& row : rows) sum += glm::dvec3(row.channel[0][i], row.channel[1][i], row.channel[2][i]);
    sums.emplace_back(sum);
  }
  return sums;
}

}  // namespace mirrorball
