#pragma once

#include <array>

#include <glm/glm.hpp>

#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {

/// Many points of the sphere at once, each quantity in an array of its own so that vector instructions can work on
/// several points together. What is set at the moment depends on how far the work has gone.
struct PointBatch {
  static constexpr int kCapacity = 256;
  template <typename Value>
  using Values = std::array<Value, kCapacity>;

  int count = 0;
  alignas(64) Values<float> x{}, y{}, z{};  ///< unit directions
  alignas(64) Values<int> face{};           ///< positions as MapPosition has them
  alignas(64) Values<float> u{}, v{};
};

/// directionAt for a whole batch: reads face, u and v (one face for all: the first one's), writes x, y and z.
void directionsAt(Projection projection, PointBatch& batch);

/// positionOf for a whole batch: reads x, y and z, writes face, u and v.
void positionsOf(Projection projection, PointBatch& batch);

/// Turns all directions.
void turn(const glm::mat3& rotation, PointBatch& batch);

}  // namespace mirrorball
