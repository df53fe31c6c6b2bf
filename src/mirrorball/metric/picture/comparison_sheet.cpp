#include "mirrorball/metric/picture/comparison_sheet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/metric/picture/color_ramp.h"
#include "mirrorball/metric/picture/heat_map.h"
#include "mirrorball/metric/picture/lettering.h"
#include "mirrorball/metric/picture/side_by_side.h"

namespace mirrorball {
namespace {

constexpr int kMinColumn_px = 440;
constexpr int kTallestMagnified_px = 1024;
constexpr std::uint8_t kPaper = 28;
constexpr glm::vec<3, std::uint8_t> kInk{230, 230, 230};

int magnificationOf(int width, int height) {
  const int wanted = (kMinColumn_px + width - 1) / width;
  return std::clamp(wanted, 1, std::max(kTallestMagnified_px / height, 1));
}

Image8 magnified(const Image8& picture, int factor) {
  if (factor == 1) return picture;
  Image8 large = Image8::withoutValues(picture.width() * factor, picture.height() * factor, 3);
  for (int y = 0; y < large.height(); ++y)
    for (int x = 0; x < large.width(); ++x) std::copy_n(picture.texel(x / factor, y / factor), 3, large.texel(x, y));
  return large;
}

/// A title with a name, of which the end tells more than the beginning where not all fits.
std::string fitted(const std::string& title, const std::string& name, int width, int scale) {
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    const std::string shown = title + (begin == 0 ? name : "..." + name.substr(begin));
    if (textWidth(shown, scale) <= width) return shown;
  }
  return title;
}

/// Lines that fit: what is longer goes on in the next one, indented.
std::vector<std::string> wrapped(const std::vector<std::string>& lines, std::size_t max_length) {
  const std::string indent(10, ' ');
  std::vector<std::string> result;
  for (std::string line : lines) {
    while (line.size() > max_length) {
      const std::size_t space = line.rfind(' ', max_length);
      const bool has_space = space != std::string::npos && line.find_first_not_of(' ') < space;
      const std::size_t end = has_space ? space : max_length;
      result.push_back(line.substr(0, end));
      line = indent + line.substr(has_space ? end + 1 : end);
    }
    result.push_back(std::move(line));
  }
  return result;
}

/// The map's colours from the least to the max, with what they mean.
void drawScale(Image8& sheet, glm::ivec2 upper_left, int width, int text_scale, HeatMapKind kind, float scale) {
  const bool is_signed = kind == HeatMapKind::difference;
  const int height = lineHeight(text_scale);
  for (int x = 0; x < width; ++x) {
    const float t = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
    const glm::vec3 color = is_signed ? divergingColor(2.0f * t - 1.0f) : sequentialColor(t);
    for (int y = 0; y < height; ++y)
      for (int channel = 0; channel < 3; ++channel)
        sheet.texel(upper_left.x + x, upper_left.y + y)[channel] =
            static_cast<std::uint8_t>(color[channel] * 255.0f + 0.5f);
  }
  const std::string max = is_signed ? "+" + formatNumber(double(scale)) : "1";
  const std::string min = is_signed ? "-" + formatNumber(double(scale)) : "0";
  const std::string middle = is_signed ? "0" : "0.5";
  const int below = upper_left.y + height + 2 * text_scale;
  drawText(sheet, {upper_left.x, below}, text_scale, kInk, min);
  drawText(sheet, {upper_left.x + (width - textWidth(middle, text_scale)) / 2, below}, text_scale, kInk, middle);
  drawText(sheet, {upper_left.x + width - textWidth(max, text_scale), below}, text_scale, kInk, max);
}

}  // namespace

Image8 codesOf(const Image& encoded) {
  Image8 picture = Image8::withoutValues(encoded.width(), encoded.height(), 3);
  std::transform(encoded.samples().begin(), encoded.samples().end(), picture.samples().begin(),
                 [](float value) { return static_cast<std::uint8_t>(value * 255.0f + 0.5f); });
  return picture;
}

Image8 heatMapOf(const Comparison& comparison, HeatMapKind kind, float scale) {
  return kind == HeatMapKind::flip ? flipHeatMap(comparison.flip) : signedHeatMap(comparison.difference, scale);
}

Image8 comparisonSheet(const Comparison& comparison, HeatMapKind kind, float scale, const SheetText& text) {
  const int factor = magnificationOf(comparison.flip.width(), comparison.flip.height());
  const std::array<Image8, 3> panels{magnified(codesOf(comparison.shown_test), factor),
                                     magnified(codesOf(comparison.shown_reference), factor),
                                     magnified(heatMapOf(comparison, kind, scale), factor)};
  // A column is at least as wide as its text needs; letters grow with the pictures.
  const int column = std::max(panels[0].width(), kMinColumn_px);
  const int text_scale = std::max(2, 3 * column / 800);
  const int margin = 4 * text_scale;
  const int line = lineHeight(text_scale);
  const int below = margin + line + panels[0].height() + margin;
  const int map_left = margin + 2 * (column + margin);
  const std::vector<std::string> written =
      wrapped(text.lines, std::size_t((map_left - 2 * margin) / textWidth(" ", text_scale)));
  const int lines = std::max(static_cast<int>(written.size()), 3);
  Image8 sheet(4 * margin + 3 * column, below + lines * line + margin, 3, kPaper);
  const std::array<std::string, 3> titles{fitted("A: ", text.test, column, text_scale),
                                          fitted("B: ", text.reference, column, text_scale), text.map};
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int left = margin + static_cast<int>(i) * (column + margin);
    drawText(sheet, {left, margin}, text_scale, kInk, titles[i]);
    place(panels[i], sheet, left, margin + line);
  }
  for (std::size_t i = 0; i < written.size(); ++i)
    drawText(sheet, {margin, below + static_cast<int>(i) * line}, text_scale, kInk, written[i]);
  drawScale(sheet, {map_left, below}, column, text_scale, kind, scale);
  return sheet;
}

}  // namespace mirrorball
