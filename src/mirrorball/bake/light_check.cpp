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
std::vector<glm::ivec2> scatteredTexels(glm::ivec2 extent) {
  constexpr double kGolden = 0.3819660112501051;  // of a turn
  std::vector<glm::ivec2> texels;
  for (int i = 0; i < kScattered; ++i) {
    const double turns = kGolden * i;
    const double y = 0.95 * (1.0 - (2.0 * i + 1.0) / kScattered);
    const double down = std::acos(y) / std::numbers::pi;
    texels.emplace_back(extent.x * (turns - std::floor(turns)), extent.y * down);
  }
  return texels;
}

/// sin²(φ/2) for the angles between two columns of so many, one after the other, twice around and a vector more.
std::vector<float> haversines(int columns) {
  std::vector<float> values;
  for (int i = 0; i < 2 * columns + static_cast<int>(TexelRow::kVector); ++i) {
    const double sine = std::sin(std::numbers::pi * (i % columns) / columns);
    values.push_back(static_cast<float>(sine * sine));
  }
  return values;
}

/// Where a row of texels lies on the sphere.
struct Ring {
  double angle;  ///< [rad] from the pole
  double sine;

  Ring(int y, int height) : angle(std::numbers::pi * (y + 0.5) / height), sine(std::sin(angle)) {}
};

void load(const Image& image, int y, TexelRow& row) {
  for (int x = 0; x < image.width(); ++x)
    for (int c = 0; c < 3; ++c) row.channel[std::size_t(c)][std::size_t(x)] = rgbAt(image, x, y)[c];
}

}  // namespace

std::vector<glm::ivec2> doubtfulTexels(const EnvironmentMap& panorama) {
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
  std::vector<glm::ivec2> texels = scatteredTexels(extent);
  for (std::size_t i = 0; i < kDetailed; ++i) texels.push_back(details[i].texel);
  return texels;
}

std::vector<glm::vec3> directionsOf(const std::vector<glm::ivec2>& texels, glm::ivec2 extent) {
  std::vector<glm::vec3> directions;
  for (const glm::ivec2 texel : texels)
    directions.push_back(directionAt(Projection::equirect, {0, (glm::vec2(texel) + 0.5f) / glm::vec2(extent)}));
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
                                     const std::vector<glm::ivec2>& points) {
  const Image& image = panorama.face(0);
  const std::vector<float> columns = haversines(image.width());
  const std::size_t count = points.size();
  std::vector<glm::vec3> of_rows(std::size_t(image.height()) * count);
  parallelFor(std::size_t(image.height()), 8, [&](std::size_t begin, std::size_t end) {
    TexelRow texels;
    texels.resize(image.width());
    for (std::size_t y = begin; y < end; ++y) {
      load(image, static_cast<int>(y), texels);
      const Ring ring(static_cast<int>(y), image.height());
      const float solid_angle = texelSolidAngle(Projection::equirect, panorama.extent(), {0, y});
      for (std::size_t i = 0; i < count; ++i) {
        const Ring to(points[i].y, image.height());
        const double half = std::sin((ring.angle - to.angle) / 2.0);
        of_rows[y * count + i] = solid_angle * lightOfRow(texels, lobe,
                                                          {.least = static_cast<float>(half * half),
                                                           .growth = static_cast<float>(ring.sine * to.sine),
                                                           .haversines = columns.data() + image.width() - points[i].x});
      }
    }
  });
  std::vector<glm::vec3> sums;
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 sum(0.0);
    for (std::size_t at = i; at < of_rows.size(); at += count) sum += glm::dvec3(of_rows[at]);
    sums.emplace_back(sum);
  }
  return sums;
}

}  // namespace mirrorball
