#include "mirrorball/metric/picture/lettering.h"

#include <algorithm>
#include <array>
#include <vector>

#include <stb/stb_easy_font.h>

#include "mirrorball/metric/picture/plain_letters.h"

namespace mirrorball {
namespace {

/// A corner of a stroke, as stb_easy_font.h hands it out.
struct Corner {
  float x;
  float y;
  float z;
  std::array<std::uint8_t, 4> color;
};
static_assert(sizeof(Corner) == 16);
using Stroke = std::array<Corner, 4>;  ///< an upright rectangle, from its upper left corner clockwise

constexpr int kLineHeight = 12;
constexpr int kCellWidth = 7;  ///< of the widest letter

/// The strokes of one letter, whose cell begins at x = 0.
std::vector<Stroke> letterStrokes(char letter) {
  std::vector<Stroke> strokes(32);  // '@' has 13
  std::array<char, 2> text{letter, '\0'};
  const int free = kCellWidth - stb_easy_font_width(text.data());
  const int count = stb_easy_font_print(static_cast<float>(free / 2), 0.0f, text.data(), nullptr, strokes.data(),
                                        static_cast<int>(strokes.size() * sizeof(Stroke)));
  strokes.resize(std::size_t(count));
  return strokes;
}

}  // namespace

int lineHeight(int scale) { return kLineHeight * scale; }

int textWidth(std::string_view text, int scale) {
  return scale * kCellWidth * static_cast<int>(plainLetters(text).size());
}

void drawText(Image8& picture, glm::ivec2 upper_left, int scale, glm::vec<3, std::uint8_t> color,
              std::string_view text) {
  for (const char letter : plainLetters(text)) {
    for (const Stroke& stroke : letterStrokes(letter)) {
      const int left = upper_left.x + scale * static_cast<int>(stroke[0].x);
      const int top = upper_left.y + scale * static_cast<int>(stroke[0].y);
      const int right = std::min(upper_left.x + scale * static_cast<int>(stroke[2].x), picture.width());
      const int bottom = std::min(upper_left.y + scale * static_cast<int>(stroke[2].y), picture.height());
      for (int y = std::max(top, 0); y < bottom; ++y)
        for (int x = std::max(left, 0); x < right; ++x) std::copy_n(&color.x, 3, picture.texel(x, y));
    }
    upper_left.x += scale * kCellWidth;
  }
}

}  // namespace mirrorball
