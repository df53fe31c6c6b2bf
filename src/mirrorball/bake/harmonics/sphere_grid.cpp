#include "mirrorball/bake/harmonics/sphere_grid.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "mirrorball/base/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mirrorball/bake/harmonics/sphere_grid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef MIRRORBALL_SPHERE_GRID_ONCE
#define MIRRORBALL_SPHERE_GRID_ONCE
namespace mirrorball {

/// The weights of the points at −1, 0, 1 and 2 for a place t in [0, 1] between 0 and 1: the uniform cubic B-spline.
inline std::array<float, 4> splineWeights(float t) {
  const float s = 1.0f - t;
  return {s * s * s / 6.0f, (4.0f + 3.0f * t * t * (t - 2.0f)) / 6.0f, (4.0f + 3.0f * s * s * (s - 2.0f)) / 6.0f,
          t * t * t / 6.0f};
}

/// The weights of the points at −2, …, 3: Lagrange's polynomial of degree 5 through them.
inline std::array<float, 6> lagrangeWeights(float t) {
  const float a = t + 2.0f;
  const float b = t + 1.0f;
  const float d = t - 1.0f;
  const float e = t - 2.0f;
  const float f = t - 3.0f;
  return {-b * t * d * e * f / 120.0f, a * t * d * e * f / 24.0f,  -a * b * d * e * f / 12.0f,
          a * b * t * e * f / 12.0f,   -a * b * t * d * f / 24.0f, a * b * t * d * e / 120.0f};
}

}  // namespace mirrorball
#endif

HWY_BEFORE_NAMESPACE();
namespace mirrorball::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void sampleGrid(const glm::vec4* first, std::size_t stride, int rings, int columns, const PointBatch& points,
                glm::vec4* values) {
  const hn::CappedTag<float, 4> d;  // one point: its four functions
  for (std::size_t i = 0; i < static_cast<std::size_t>(points.count); ++i) {
    const float x = points.u[i] * static_cast<float>(columns);
    const float y = points.v[i] * static_cast<float>(rings) + 0.5f;  // counted from the ring before the first
    const int column = std::min(static_cast<int>(x), columns - 1);
    const int ring = std::min(static_cast<int>(y), rings);
    const std::array<float, 4> across = splineWeights(x - static_cast<float>(column));
    const std::array<float, 6> down = lagrangeWeights(y - static_cast<float>(ring));
    const glm::vec4* corner = first + static_cast<std::size_t>(ring) * stride + static_cast<std::size_t>(column);
    for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
      auto sum = hn::Zero(d);
      for (std::size_t j = 0; j < 6; ++j) {
        const float* row = &corner[j * stride].x + lane;
        auto line = hn::Mul(hn::Set(d, across[0]), hn::LoadU(d, row));
        for (std::size_t k = 1; k < 4; ++k) line = hn::MulAdd(hn::Set(d, across[k]), hn::LoadU(d, row + 4 * k), line);
        sum = hn::MulAdd(hn::Set(d, down[j]), line, sum);
      }
      hn::StoreU(sum, d, &values[i].x + lane);
    }
  }
}

}  // namespace mirrorball::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mirrorball {

HWY_EXPORT(sampleGrid);

SphereGrid::SphereGrid(int rings, int columns)
    : rings_(rings),
      columns_(columns),
      values_(std::size_t(rings + 2 * kRingsBeyond) * std::size_t(columns + 2 * kColumnsBeyond)) {
  assert(rings % 2 == 0 && columns % 2 == 0 && rings >= kRingsBeyond && columns >= 2 * kColumnsBeyond);
}

void SphereGrid::close() {
  const auto continueOverSeam = [this](int j) {
    glm::vec4* values = ring(j);
    for (int i = 0; i < kColumnsBeyond; ++i) {
      values[i - kColumnsBeyond] = values[columns_ + i - kColumnsBeyond];
      values[columns_ + i] = values[i];
    }
  };
  const auto continueOverPole = [this](int from, int to) {
    const glm::vec4* source = ring(from);
    std::rotate_copy(source, source + columns_ / 2, source + columns_, ring(to));
  };
  for (int j = 0; j < kRingsBeyond; ++j) {
    continueOverPole(j, -1 - j);
    continueOverPole(rings_ - 1 - j, rings_ + j);
  }
  for (int j = -kRingsBeyond; j < rings_ + kRingsBeyond; ++j) continueOverSeam(j);
}

void SphereGrid::sample(const PointBatch& points, glm::vec4* values) const {
  // The first of the six rings and four columns around the point before the first ring and on the seam.
  const glm::vec4* first = values_.data() + offset(-3) - 1;
  HWY_DYNAMIC_DISPATCH(sampleGrid)
  (first, static_cast<std::size_t>(columns_ + 2 * kColumnsBeyond), rings_, columns_, points, values);
}

}  // namespace mirrorball
#endif
