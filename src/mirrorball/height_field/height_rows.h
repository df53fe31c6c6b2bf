#pragma once

#include "mirrorball/height_field/height_field.h"

namespace mirrorball {

/// A row of heights between its neighbours.
struct HeightRows {
  const float* above;
  const float* row;
  const float* below;
  int width;
};

/// What is written of slopes.
enum class SlopeMap { normals, derivatives };

/// Writes three samples a texel: normalFromSlope, or (∂d/∂u, 0, ∂d/∂v). In vector instructions, but for the ends, where
/// formula/relief/slope.glsl is called.
void writeSlopes(const HeightRows& rows, const HeightFieldSettings& settings, SlopeMap map, float* to);

/// Whether a row's heights are all finite.
bool areFinite(const float* row, int width);

/// The maxima of the patches between two rows of texels: to[i] of texels i and i + 1 of both.
///
/// count   of patches; the rows have at least one texel more
void writePatchMaxima(const float* row, const float* below, int count, float* to);

/// The maxima of 2 × 2 cells: to[i] of cells 2 i and 2 i + 1 of both rows.
///
/// count   of maxima; the rows have at least twice as many cells
void writePairMaxima(const float* row, const float* below, int count, float* to);

}  // namespace mirrorball
