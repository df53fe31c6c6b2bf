#include "mirrorball/render/surface/pixel_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "formula/surface.h"

namespace mirrorball {
namespace {

/// How many cells each column has, nearly evenly and the same from both ends, so that the cells are mirror images about
/// the middle in pairs, and of an odd number one lies there. Empty: there is no such arrangement.
std::vector<int> cellsOfColumns(int samples, int columns) {
  const int parity = samples % 2;
  int in_middle = 0;  // of an odd number of columns
  if (columns % 2 == 1)
    in_middle = std::max(
        2 * static_cast<int>(std::lround((samples / static_cast<double>(columns) - parity) / 2)) + parity, 2 - parity);
  const int aside = (samples - in_middle) / 2;
  const int columns_aside = columns / 2;
  if (2 * aside + in_middle != samples || aside < columns_aside || (columns_aside == 0 && aside > 0)) return {};
  std::vector<int> counts(static_cast<std::size_t>(columns), in_middle);
  for (int i = 0; i < columns_aside; ++i) {
    const int count = (i + 1) * aside / columns_aside - i * aside / columns_aside;
    counts[std::size_t(i)] = counts[std::size_t(columns - 1 - i)] = count;
  }
  return counts;
}

/// Cells of the samples in such columns, or rows.
///
/// axis   0: columns; 1: rows
std::vector<PixelCell> arrangedCells(const std::vector<glm::vec2>& places, const std::vector<int>& counts, int axis) {
  std::vector<int> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  const auto sortBy = [&](int by, auto begin, auto end) {
    std::sort(begin, end, [&](int a, int b) { return places[std::size_t(a)][by] < places[std::size_t(b)][by]; });
  };
  sortBy(axis, order.begin(), order.end());
  std::vector<PixelCell> cells(places.size());
  const auto all = static_cast<float>(places.size());
  int first = 0;
  for (const int count : counts) {
    sortBy(1 - axis, order.begin() + first, order.begin() + first + count);
    const auto of_column = static_cast<float>(count);
    for (int i = 0; i < count; ++i) {
      PixelCell& cell = cells[std::size_t(order[std::size_t(first + i)])];
      cell.middle[axis] = (static_cast<float>(first) + 0.5f * of_column) / all;
      cell.size[axis] = of_column / all;
      cell.middle[1 - axis] = (static_cast<float>(i) + 0.5f) / of_column;
      cell.size[1 - axis] = 1.0f / of_column;
    }
    first += count;
  }
  return cells;
}

/// How far from its sample the farthest corner of a cell lies, at most.
float reach(const std::vector<glm::vec2>& places, const std::vector<PixelCell>& cells) {
  float farthest = 0.0f;
  for (std::size_t i = 0; i < cells.size(); ++i)
    farthest = std::max(farthest, glm::length(glm::abs(places[i] - cells[i].middle) + 0.5f * cells[i].size));
  return farthest;
}

}  // namespace

glm::vec2 placeOfSample(int sample, int samples) { return 1.0f - formula::sampleOffset(sample, samples); }

Camera shiftedInPixel(Camera camera, glm::vec2 offset_px, glm::ivec2 size) {
  const glm::vec2 ndc = offset_px * 2.0f / glm::vec2(size);
  camera.clip_from_view = glm::translate(glm::mat4(1.0f), glm::vec3(ndc, 0.0f)) * camera.clip_from_view;
  return camera;
}

std::vector<PixelCell> pixelCells(int samples) {
  constexpr int kMoreOrFewer = 1;  // else some would be long
  std::vector<glm::vec2> places;
  for (int i = 0; i < samples; ++i) places.push_back(placeOfSample(i, samples));
  const int square = static_cast<int>(std::lround(std::sqrt(static_cast<double>(samples))));
  std::vector<PixelCell> best;
  float least = std::numeric_limits<float>::max();
  for (int columns = std::max(1, square - kMoreOrFewer); columns <= square + kMoreOrFewer; ++columns) {
    const std::vector<int> counts = cellsOfColumns(samples, columns);
    if (counts.empty()) continue;
    for (const int axis : {0, 1}) {
      std::vector<PixelCell> cells = arrangedCells(places, counts, axis);
      const float reached = reach(places, cells);
      if (reached >= least) continue;
      least = reached;
      best = std::move(cells);
    }
  }
  return best;
}

}  // namespace mirrorball
