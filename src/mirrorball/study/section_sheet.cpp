#include "mirrorball/study/section_sheet.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/metric/picture/lettering.h"
#include "mirrorball/metric/picture/side_by_side.h"

namespace mirrorball {
namespace {

constexpr int kGap_px = 8;
constexpr int kWidthOfDoubleLetters_px = 256;  ///< of a picture, from which on letters are twice as large
constexpr std::uint8_t kPaper = 28;
constexpr glm::vec<3, std::uint8_t> kInk{230, 230, 230};

/// A picture with its words below.
struct Panel {
  const Image8* picture;
  std::vector<std::string> words;
};

std::string twoDecimals(double number) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.2f", number);
  return text;
}

std::vector<Panel> panelsOf(const StudiedShot& shot, std::string_view compared_to) {
  std::vector<Panel> panels;
  for (const StudiedPicture& picture : shot.pictures)
    panels.push_back({&picture.picture, wordsOf(picture, shot, compared_to)});
  panels.push_back(
      {&shot.reference,
       {"path-traced", counted(std::size_t(shot.cost.paths), "path"), twoDecimals(shot.cost.time_s) + " s"}});
  return panels;
}

}  // namespace

std::vector<std::string> wordsOf(const StudiedPicture& picture, const StudiedShot& shot, std::string_view compared_to) {
  const auto unit = findBy(shot.pictures, compared_to, &StudiedPicture::technique);
  const double time_ms = picture.drawn->frame_ms;
  return {picture.technique, valueText(Metric::psnr, *picture.values[static_cast<std::size_t>(Metric::psnr)]),
          twoDecimals(time_ms) + " ms",
          twoDecimals(time_ms / unit->drawn->frame_ms) + " x " + std::string(compared_to)};
}

Image8 sectionSheet(const StudiedSection& section, std::string_view compared_to) {
  const Image8& tile = section.shots.front().reference;
  const int scale = tile.width() < kWidthOfDoubleLetters_px ? 1 : 2;
  const int line = lineHeight(scale);
  std::vector<std::vector<Panel>> rows;
  int column = tile.width();
  std::size_t lines = 0;
  for (const StudiedShot& shot : section.shots)
    for (const Panel& panel : rows.emplace_back(panelsOf(shot, compared_to))) {
      lines = std::max(lines, panel.words.size());
      for (const std::string& word : panel.words) column = std::max(column, textWidth(word, scale));
    }
  const int below = line + tile.height() + kGap_px / 2;
  const int row_height = below + static_cast<int>(lines) * line + kGap_px;
  const int width = kGap_px + static_cast<int>(rows.front().size()) * (column + kGap_px);
  Image8 sheet(width, kGap_px + static_cast<int>(rows.size()) * row_height, 3, kPaper);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int top = kGap_px + static_cast<int>(i) * row_height;
    drawText(sheet, {kGap_px, top}, scale, kInk, section.shots[i].label + " " + section.axis);
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const int left = kGap_px + static_cast<int>(j) * (column + kGap_px);
      place(*rows[i][j].picture, sheet, left, top + line);
      for (std::size_t k = 0; k < rows[i][j].words.size(); ++k)
        drawText(sheet, {left, top + below + static_cast<int>(k) * line}, scale, kInk, rows[i][j].words[k]);
    }
  }
  return sheet;
}

}  // namespace mirrorball
