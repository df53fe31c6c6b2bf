#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "mirrorball/scene/camera/camera.h"

namespace mirrorball {

/// A rectangle of a pixel, which reaches from (0, 0) to (1, 1), right and up.
struct PixelCell {
  glm::vec2 middle;
  glm::vec2 size;
};

/// Where a sample of a frame lies in its pixel: its picture is shifted the other way (formula::sampleOffset).
glm::vec2 placeOfSample(int sample, int samples);

/// A camera whose picture is shifted by a part of a pixel.
///
/// size   of the picture [pixels]
Camera shiftedInPixel(Camera camera, glm::vec2 offset_px, glm::ivec2 size);

/// For each sample of a pixel the cell that it stands for. All have the same area, and together they are the pixel.
/// The cells of a pair of samples, which are mirror images (formula::sampleOffset), are mirror images, too, so that a
/// pair's mean lies in the pixel's middle; the one sample of an odd number has a cell there.
///
/// Columns of the samples that lie farthest to the left, the next ones and so on, each as wide as it has samples, and
/// cells over each other in each column likewise; or rows in place of columns. Of both, and of some numbers of columns,
/// that is chosen in which the cells reach least far from their samples. Of up to 65 samples, each lies no farther from
/// the middle of its cell than 1.1 sides of a square of the cell's area; of up to 1024, 3 sides.
///
/// samples  at least 1
/// cost     samples · log samples; of 64 some 50 µs
std::vector<PixelCell> pixelCells(int samples);

}  // namespace mirrorball
