#include "mirrorball/contact/contact_sheet.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"

namespace mirrorball {
namespace {

using Code3 = glm::vec<3, std::uint8_t>;

constexpr Code3 kPaper(42);
constexpr Code3 kRed(200, 0, 0);

/// The pixels of a color in a rectangle.
int countPixels(const Image8& sheet, Code3 color, glm::ivec2 corner, glm::ivec2 size) {
  int count = 0;
  for (int y = corner.y; y < corner.y + size.y; ++y)
    for (int x = corner.x; x < corner.x + size.x; ++x)
      count += std::equal(&color.x, &color.x + 3, sheet.texel(x, y)) ? 1 : 0;
  return count;
}

int countPixels(const Image8& sheet, Code3 color) {
  return countPixels(sheet, color, {0, 0}, {sheet.width(), sheet.height()});
}

Image8 red(glm::ivec2 size) {
  Image8 picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) std::copy_n(&kRed.x, 3, picture.texel(x, y));
  return picture;
}

TEST(ContactLayout, CellsAreInOrderBesideEachOtherAndOnTheSheet) {
  for (const std::size_t cells : {1, 2, 3, 7, 200})
    for (const int columns : {0, 1, 3, 1000}) {
      const auto layout = contactLayout(cells, {64, 32}, columns);
      ASSERT_TRUE(layout);
      const glm::ivec2 sheet = layout->sheetSize();
      EXPECT_GE(layout->grid.x * layout->grid.y, int(cells));
      EXPECT_LT(layout->grid.x * (layout->grid.y - 1), int(cells)) << "a row without cells";
      for (std::size_t i = 0; i < cells; ++i) {
        const glm::ivec2 corner = layout->corner(i);
        const glm::ivec2 end = corner + layout->cellSize();
        EXPECT_TRUE(corner.x > 0 && corner.y > 0 && end.x < sheet.x && end.y < sheet.y) << i;
        if (i == 0) continue;
        const glm::ivec2 before = layout->corner(i - 1);
        const bool is_right = corner.y == before.y && corner.x > before.x + layout->cellSize().x;
        const bool is_below = corner.y > before.y + layout->cellSize().y && corner.x == layout->corner(0).x;
        EXPECT_TRUE(is_right || is_below) << i;
      }
    }
}

TEST(ContactLayout, TakesTheColumnsThatItIsAskedForAndElseALandscapeShape) {
  EXPECT_EQ(contactLayout(12, {64, 32}, 5)->grid, glm::ivec2(5, 3));
  EXPECT_EQ(contactLayout(2, {64, 32}, 5)->grid, glm::ivec2(2, 1));
  for (const std::size_t cells : {12, 50, 200})
    for (const glm::ivec2 picture : {glm::ivec2(320, 160), glm::ivec2(320, 240), glm::ivec2(32, 24)}) {
      const glm::vec2 sheet(contactLayout(cells, picture, 0)->sheetSize());
      EXPECT_GT(sheet.x / sheet.y, 1.2f) << cells;
      EXPECT_LT(sheet.x / sheet.y, 2.2f) << cells;
    }
}

TEST(ContactLayout, RefusesASheetThatIsTooLarge) {
  EXPECT_EQ(contactLayout(10000, {4096, 3072}, 0).error().code, ErrorCode::too_large);
  const std::uint64_t before = memoryLimit();
  setMemoryLimit(1 << 20);
  const auto layout = contactLayout(100, {320, 160}, 0);
  setMemoryLimit(before);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, ErrorCode::too_large);
}

TEST(ContactSheet, HasEachPictureWholeInTheMiddleOfItsCell) {
  const auto layout = contactLayout(3, {64, 48}, 2);
  const std::vector<ContactCell> cells{
      {red({64, 32}), "a.hdr", "1x1"}, {red({64, 48}), "b.glb", ""}, {red({1, 1}), "", ""}};
  const Image8 sheet = drawContactSheet(cells, *layout, kPaper);
  EXPECT_EQ(glm::ivec2(sheet.width(), sheet.height()), layout->sheetSize());
  EXPECT_EQ(countPixels(sheet, kRed), 64 * 32 + 64 * 48 + 1);
  EXPECT_EQ(countPixels(sheet, kRed, layout->corner(0) + glm::ivec2(0, 8), {64, 32}), 64 * 32);
  EXPECT_EQ(countPixels(sheet, kRed, layout->corner(2) + glm::ivec2(31, 23), {1, 1}), 1);
  const glm::ivec2 fourth = layout->corner(3);
  EXPECT_EQ(countPixels(sheet, kPaper, fourth, layout->cellSize()), layout->cellSize().x * layout->cellSize().y);
}

TEST(ContactSheet, ACellWithoutAPictureSaysSo) {
  const auto layout = contactLayout(1, {320, 160}, 0);
  const Image8 sheet = drawContactSheet(std::vector<ContactCell>{{std::nullopt, "", ""}}, *layout, kPaper);
  const int letters = countPixels(sheet, Code3(230), layout->corner(0), {320, 160});
  EXPECT_GT(letters, 50);
  EXPECT_EQ(countPixels(sheet, kPaper, layout->corner(0), {320, 160}), 0);
}

TEST(ContactSheet, NamesStayBelowTheirCells) {
  const auto layout = contactLayout(2, {64, 32}, 2);
  const std::string endless(10000, 'W');
  const Image8 sheet = drawContactSheet(
      std::vector<ContactCell>{{red({64, 32}), endless, endless}, {red({64, 32}), "", ""}}, *layout, kPaper);
  EXPECT_GT(countPixels(sheet, Code3(230), layout->corner(0), layout->cellSize()), 50);
  const glm::ivec2 cell = layout->cellSize();
  EXPECT_EQ(countPixels(sheet, Code3(230)), countPixels(sheet, Code3(230), layout->corner(0), cell));
  EXPECT_EQ(countPixels(sheet, kPaper, layout->corner(1) + glm::ivec2(0, 32), {64, cell.y - 32}), 64 * (cell.y - 32));
}

TEST(ContactSheet, LettersAreDarkOnLightPaper) {
  const auto layout = contactLayout(1, {64, 32}, 0);
  const std::vector<ContactCell> cells{{red({64, 32}), "attic.hdr", ""}};
  for (const Code3 paper : {Code3(0), Code3(42), Code3(100)})
    EXPECT_GT(countPixels(drawContactSheet(cells, *layout, paper), Code3(230)), 20);
  for (const Code3 paper : {Code3(140), Code3(255)})
    EXPECT_GT(countPixels(drawContactSheet(cells, *layout, paper), Code3(25)), 20);
}

}  // namespace
}  // namespace mirrorball
