#include "mirrorball/contact/contact_sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "formula/color.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/contact/cell_label.h"
#include "mirrorball/metric/picture/lettering.h"
#include "mirrorball/metric/picture/plain_letters.h"
#include "mirrorball/metric/picture/side_by_side.h"

namespace mirrorball {
namespace {

using Code3 = glm::vec<3, std::uint8_t>;

constexpr double kLandscape = 1.6;
constexpr const char* kNoPicture = "cannot be read";

/// 1 for cells so narrow that larger letters would leave no words.
int letterScale(int width_px) { return width_px < 256 ? 1 : 2 + (width_px - 256) / 512; }

double distanceFromLandscape(glm::ivec2 size) { return std::abs(std::log(double(size.x) / size.y / kLandscape)); }

glm::ivec2 gridFor(std::size_t cells, int columns) {
  const auto count = static_cast<int>(cells);
  return {std::min(columns, count), (count + columns - 1) / columns};
}

/// A colour between ink and paper.
Code3 mixed(Code3 a, Code3 b, float share_of_b) {
  return Code3(glm::mix(glm::vec3(a), glm::vec3(b), share_of_b) + 0.5f);
}

void fill(Image8& sheet, glm::ivec2 corner, glm::ivec2 size, Code3 color) {
  for (int y = corner.y; y < corner.y + size.y; ++y)
    for (int x = corner.x; x < corner.x + size.x; ++x) std::copy_n(&color.x, 3, sheet.texel(x, y));
}

/// Draws a line that is shortened to the width of a cell.
void drawFitted(Image8& sheet, glm::ivec2 corner, int width_px, int scale, Code3 color, const std::string& text) {
  const auto longest = static_cast<std::size_t>(width_px / textWidth(" ", scale));
  drawText(sheet, corner, scale, color, shortenedInTheMiddle(plainLetters(text), longest));
}

}  // namespace

int ContactLayout::gap_px() const { return 4 + 4 * name_scale; }

glm::ivec2 ContactLayout::cellSize() const {
  return {picture_px.x, picture_px.y + gap_px() / 2 + lineHeight(name_scale) + lineHeight(facts_scale)};
}

glm::ivec2 ContactLayout::sheetSize() const { return gap_px() + grid * (cellSize() + gap_px()); }

glm::ivec2 ContactLayout::corner(std::size_t cell) const {
  const auto index = static_cast<int>(cell);
  return gap_px() + glm::ivec2(index % grid.x, index / grid.x) * (cellSize() + gap_px());
}

Result<ContactLayout> contactLayout(std::size_t cells, glm::ivec2 picture_px, int columns) {
  const int scale = letterScale(picture_px.x);
  ContactLayout layout{.picture_px = picture_px, .name_scale = scale, .facts_scale = std::max(scale - 1, 1)};
  layout.grid = gridFor(cells, std::max(columns, 1));
  for (int more = 2; columns == 0 && more <= static_cast<int>(cells); ++more) {
    ContactLayout other = layout;
    other.grid = gridFor(cells, more);
    if (distanceFromLandscape(other.sheetSize()) >= distanceFromLandscape(layout.sheetSize())) continue;
    layout = other;
  }
  constexpr std::uint64_t kChannels = 3;
  const auto bytes = [](glm::ivec2 size) { return kChannels * std::uint64_t(size.x) * std::uint64_t(size.y); };
  const glm::ivec2 size = layout.sheetSize();
  MIRRORBALL_TRY_VOID(checkDimensions(size.x, size.y));
  MIRRORBALL_TRY_VOID(withName("the sheet", checkMemory(bytes(size) + cells * bytes(picture_px))));
  return layout;
}

Image8 drawContactSheet(std::span<const ContactCell> cells, const ContactLayout& layout, Code3 paper) {
  constexpr float kMiddleCode = 118.0f;  // of middle grey, 0.18
  const bool is_dark = formula::luminance(glm::vec3(paper)) < kMiddleCode;
  const Code3 ink = is_dark ? Code3(230) : Code3(25);
  const glm::ivec2 size = layout.sheetSize();
  Image8 sheet = Image8::withoutValues(size.x, size.y, 3);
  fill(sheet, glm::ivec2(0), size, paper);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const ContactCell& cell = cells[i];
    const glm::ivec2 corner = layout.corner(i);
    const int width = layout.picture_px.x;
    if (cell.picture) {
      const glm::ivec2 shown(cell.picture->width(), cell.picture->height());
      assert(shown.x <= width && shown.y <= layout.picture_px.y);
      const glm::ivec2 beside = (layout.picture_px - shown) / 2;
      place(*cell.picture, sheet, corner.x + beside.x, corner.y + beside.y);
    } else {
      fill(sheet, corner, layout.picture_px, mixed(paper, ink, 0.15f));
      const glm::ivec2 text(std::min(textWidth(kNoPicture, layout.facts_scale), width), lineHeight(layout.facts_scale));
      drawFitted(sheet, corner + (layout.picture_px - text) / 2, width, layout.facts_scale, ink, kNoPicture);
    }
    const glm::ivec2 below(corner.x, corner.y + layout.picture_px.y + layout.gap_px() / 2);
    drawFitted(sheet, below, width, layout.name_scale, ink, cell.name);
    drawFitted(sheet, {below.x, below.y + lineHeight(layout.name_scale)}, width, layout.facts_scale,
               mixed(ink, paper, 0.35f), cell.facts);
  }
  return sheet;
}

}  // namespace mirrorball
