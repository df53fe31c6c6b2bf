#include "mirrorball/environment/convert/point_batch.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

/// The i-th of many directions that cover the sphere evenly, with the axes and the poles among the first.
glm::vec3 latticeDirection(int i) {
  constexpr std::array<glm::vec3, 8> kSpecial{{{1, 0, 0},
                                               {-1, 0, 0},
                                               {0, 1, 0},
                                               {0, -1, 0},
                                               {0, 0, 1},
                                               {0, 0, -1},
                                               {0.57735026f, 0.57735026f, 0.57735026f},
                                               {-0.70710678f, 0, 0.70710678f}}};
  if (i < 8) return kSpecial[static_cast<std::size_t>(i)];
  const float y = 1.0f - 2.0f * (static_cast<float>(i % 5000) + 0.5f) / 5000.0f;
  const float angle = 2.39996323f * static_cast<float>(i);
  const float radius = std::sqrt(1.0f - y * y);
  return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

TEST(PointBatch, PositionsAreTheFormulas) {
  for (const Projection projection : {Projection::equirect, Projection::cube, Projection::sphere}) {
    for (int start = 0; start < 5000; start += PointBatch::kCapacity) {
      PointBatch batch;
      batch.count = PointBatch::kCapacity - start % 7;
      for (int i = 0; i < batch.count; ++i) {
        const glm::vec3 d = latticeDirection(start + i);
        const auto index = static_cast<std::size_t>(i);
        batch.x[index] = d.x;
        batch.y[index] = d.y;
        batch.z[index] = d.z;
      }
      positionsOf(projection, batch);
      for (int i = 0; i < batch.count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const MapPosition expected = positionOf(projection, latticeDirection(start + i));
        EXPECT_EQ(batch.face[index], expected.face);
        // At the poles every u is right.
        const bool is_pole = std::abs(latticeDirection(start + i).y) == 1.0f && projection == Projection::equirect;
        const float beside = batch.u[index] - expected.uv.x;
        // Three units in the last place of the angle, as a part of a turn; 0 and 1 are the same meridian.
        if (!is_pole) {
          EXPECT_NEAR(beside - std::round(beside), 0.0f, 4e-7f) << nameOf(projection) << start + i;
        }
        EXPECT_NEAR(batch.v[index], expected.uv.y, 4e-7f) << nameOf(projection) << start + i;
      }
    }
  }
}

TEST(PointBatch, DirectionsAreTheFormulas) {
  for (const Projection projection : {Projection::equirect, Projection::cube, Projection::angular})
    for (int face = 0; face < faceCount(projection); ++face) {
      PointBatch batch;
      batch.count = 200;
      for (std::size_t i = 0; i < 200; ++i) {
        batch.face[i] = face;
        batch.u[i] = 0.2f + 0.6f * static_cast<float>(i) / 199.0f;
        batch.v[i] = 0.2f + 0.6f * static_cast<float>(i * 37 % 200) / 199.0f;
      }
      directionsAt(projection, batch);
      for (std::size_t i = 0; i < 200; ++i) {
        const glm::vec3 expected = directionAt(projection, {face, {batch.u[i], batch.v[i]}});
        EXPECT_LT(glm::length(glm::vec3(batch.x[i], batch.y[i], batch.z[i]) - expected), 6e-7f)
            << nameOf(projection) << " face " << face;
      }
    }
}

TEST(PointBatch, TurnsAsTheMatrixDoes) {
  const glm::mat3 rotation(glm::rotate(glm::mat4(1.0f), 1.0f, glm::vec3(1, 2, 3)));
  PointBatch batch;
  batch.count = 1;
  batch.x[0] = 0.6f;
  batch.y[0] = 0.8f;
  turn(rotation, batch);
  const glm::vec3 expected = rotation * glm::vec3(0.6f, 0.8f, 0.0f);
  EXPECT_FLOAT_EQ(batch.x[0], expected.x);
  EXPECT_FLOAT_EQ(batch.y[0], expected.y);
  EXPECT_FLOAT_EQ(batch.z[0], expected.z);
}

}  // namespace
}  // namespace mirrorball
