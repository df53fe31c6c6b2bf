#include "mirrorball/metric/picture/side_by_side.h"

#include <algorithm>
#include <cassert>

namespace mirrorball {

void place(const Image8& picture, Image8& sheet, int left, int top) {
  assert(picture.channels() == sheet.channels());
  for (int y = 0; y < picture.height(); ++y) {
    const auto row = picture.row(y);
    std::copy(row.begin(), row.end(), sheet.texel(left, top + y));
  }
}

Image8 sideBySide(std::span<const Image8> panels, int gap_px, std::uint8_t paper) {
  assert(!panels.empty());
  int width = -gap_px;
  int height = 0;
  for (const Image8& panel : panels) {
    width += gap_px + panel.width();
    height = std::max(height, panel.height());
  }
  Image8 sheet(width, height, 3, paper);
  int left = 0;
  for (const Image8& panel : panels) {
    place(panel, sheet, left, 0);
    left += panel.width() + gap_px;
  }
  return sheet;
}

}  // namespace mirrorball
