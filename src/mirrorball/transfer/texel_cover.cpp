#include "mirrorball/transfer/texel_cover.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace mirrorball {
namespace {

using glm::dvec2;

constexpr double kMostRepetitions = 16.0;

int wrapped(int index, int count) {
  const int rest = index % count;
  return rest < 0 ? rest + count : rest;
}

double crossOf(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A triangle in texels.
struct TexelTriangle {
  TexelTriangle(const UvTriangle& uv, glm::ivec2 size) {
    for (std::size_t k = 0; k < 3; ++k) corners[k] = dvec2(uv[k]) * dvec2(size);
    low = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    high = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    area = crossOf(corners[1] - corners[0], corners[2] - corners[0]);
  }

  /// The weights of the second and the third corner.
  dvec2 barycentricAt(dvec2 place) const {
    const dvec2 step = place - corners[0];
    return dvec2(crossOf(step, corners[2] - corners[0]), crossOf(corners[1] - corners[0], step)) / area;
  }

  std::array<dvec2, 3> corners;
  dvec2 low, high;
  double area;
};

/// How far inside a triangle a place is: 0 on its edges, ⅓ at its middle.
double depthOf(dvec2 barycentric) {
  return std::min({barycentric.x, barycentric.y, 1.0 - barycentric.x - barycentric.y});
}

}  // namespace

Result<TexelCover> TexelCover::make(std::vector<UvTriangle> triangles, glm::ivec2 size, int side) {
  assert(size.x >= 1 && size.y >= 1 && side >= 1);
  TexelCover cover(std::move(triangles), size, side);
  MIRRORBALL_TRY_VOID(cover.sortIntoRows());
  return cover;
}

Result<void> TexelCover::sortIntoRows() {
  // An entry a row that a triangle touches: counted, then put where the counts say.
  const auto forEachRow = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const TexelTriangle triangle(triangles_[i], size_);
      if (triangle.area == 0.0) continue;
      for (int row = int(std::floor(triangle.low.y)); row <= int(std::floor(triangle.high.y)); ++row)
        visit(i, row, std::size_t(wrapped(row, size_.y)));
    }
  };
  for (const UvTriangle& uv : triangles_) {
    const TexelTriangle triangle(uv, {1, 1});
    const double reach = std::max(triangle.high.x - triangle.low.x, triangle.high.y - triangle.low.y);
    const double place = std::max(glm::length(triangle.low), glm::length(triangle.high));
    constexpr double kFarthest = 10000.0;  // rows are counted by int
    if (!(reach <= kMostRepetitions && place <= kFarthest))
      return fail(ErrorCode::out_of_range,
                  "a triangle reaches over more of the texture than a map can hold; texture coordinates from 0 to 1 "
                  "are wanted");
  }
  begin_.assign(std::size_t(size_.y) + 1, 0);
  forEachRow([&](std::uint32_t, int, std::size_t row) { ++begin_[row + 1]; });
  for (std::size_t row = 0; row < std::size_t(size_.y); ++row) begin_[row + 1] += begin_[row];
  entries_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  forEachRow([&](std::uint32_t triangle, int row_beyond, std::size_t row) {
    entries_[next[row]++] = {triangle, row_beyond};
  });
  return {};
}

std::size_t TexelCover::coverRow(int y, std::span<CoverSample> samples) const {
  assert(samples.size() == std::size_t(size_.x) * samplesPerTexel());
  std::fill(samples.begin(), samples.end(), CoverSample());
  std::size_t overlapping = 0;
  for (std::size_t i = begin_[std::size_t(y)]; i < begin_[std::size_t(y) + 1]; ++i)
    overlapping += coverBy(entries_[i], samples);
  return overlapping;
}

std::size_t TexelCover::coverBy(const Entry& entry, std::span<CoverSample> samples) const {
  // What lies on an edge is of both its triangles; what rounding puts a little beyond it too.
  constexpr double kRounding = 1e-7, kWellInside = 1e-3;
  const TexelTriangle triangle(triangles_[entry.triangle], size_);
  std::size_t overlapping = 0;
  for (int column = int(std::floor(triangle.low.x)); column <= int(std::floor(triangle.high.x)); ++column) {
    const std::size_t texel = std::size_t(wrapped(column, size_.x)) * samplesPerTexel();
    for (int j = 0; j < side_; ++j)
      for (int i = 0; i < side_; ++i) {
        const dvec2 place = dvec2(column, entry.row) + (dvec2(i, j) + 0.5) / double(side_);
        const dvec2 barycentric = triangle.barycentricAt(place);
        const double depth = depthOf(barycentric);
        if (depth < -kRounding) continue;
        CoverSample& sample = samples[texel + std::size_t(j * side_ + i)];
        if (sample.triangle == CoverSample::kNothing) {
          sample = {entry.triangle, glm::vec2(barycentric)};
        } else if (!sample.is_shared && depth > kWellInside && depthOf(dvec2(sample.barycentric)) > kWellInside) {
          sample.is_shared = true;
          ++overlapping;
        }
      }
  }
  return overlapping;
}

}  // namespace mirrorball
