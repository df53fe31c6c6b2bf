#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace mirrorball {

/// A rectangle of a pixel, which reaches from (0, 0) to (1, 1), right and up.
struct PixelCell {
  glm::vec2 middle;
  glm::vec2 size;
};

/// Where a sample of a frame lies in its pixel: its picture is shifted the other way (formula::sampleOffset).
glm::vec2 placeOfSample(int sample, int samples);

/// For each sample of a pixel the cell that it stands for. All have the same area, and together they are the pixel.
///
/// Columns of the samples that lie farthest to the left, the next ones and so on, each as wide as it has samples, and
/// cells over each other in each column likewise: so each sample lies in its cell or near it.
///
/// samples  at least 1
/// cost     samples · log samples
std::vector<PixelCell> pixelCells(int samples);

}  // namespace mirrorball
