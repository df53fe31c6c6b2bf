#include "mirrorball/render/surface/pixel_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "formula/surface.h"

namespace mirrorball {

glm::vec2 placeOfSample(int sample, int samples) { return 1.0f - formula::sampleOffset(sample, samples); }

std::vector<PixelCell> pixelCells(int samples) {
  std::vector<int> order(static_cast<std::size_t>(samples));
  std::iota(order.begin(), order.end(), 0);
  const auto sortBy = [&](int axis, auto begin, auto end) {
    std::sort(begin, end, [&](int a, int b) {
      const float of_a = placeOfSample(a, samples)[axis];
      const float of_b = placeOfSample(b, samples)[axis];
      return of_a < of_b || (of_a == of_b && a < b);
    });
  };
  sortBy(0, order.begin(), order.end());
  std::vector<PixelCell> cells(order.size());
  const int columns = static_cast<int>(std::lround(std::sqrt(static_cast<double>(samples))));
  const auto all = static_cast<float>(samples);
  for (int column = 0; column < columns; ++column) {
    const int first = column * samples / columns;
    const int last = (column + 1) * samples / columns;
    sortBy(1, order.begin() + first, order.begin() + last);
    const auto rows = static_cast<float>(last - first);
    for (int i = first; i < last; ++i)
      cells[std::size_t(order[std::size_t(i)])] = {
          {0.5f * static_cast<float>(first + last) / all, (static_cast<float>(i - first) + 0.5f) / rows},
          {rows / all, 1.0f / rows}};
  }
  return cells;
}

}  // namespace mirrorball
