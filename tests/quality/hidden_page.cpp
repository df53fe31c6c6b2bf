#include "quality/hidden_page.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "quality/hidden_figures.h"
#include "quality/hidden_scenes.h"

namespace mirrorball::quality {
namespace {

constexpr std::string_view kBegin = "<!-- table made by hidden_light page -->\n";
constexpr std::string_view kEnd = "<!-- end of the table -->\n";

/// "0.031, 0.046"; of what was not measured, "–"
std::string written(double flip, double rmse) {
  if (flip == kNotMeasured) return "–";
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3f, %.3f", flip, rmse);
  return text.data();
}

struct Tables {
  NumberTable references, first, now;
};

/// A row of the page, and a sum that the means are made of.
Result<std::string> writeRow(const Tables& tables, const std::string& name, std::array<double, 14>& sums) {
  for (const NumberTable* table : {&tables.references, &tables.first, &tables.now})
    if (!table->contains(name))
      return fail(ErrorCode::bad_file, name + ": has no row; `hidden_light trace` and `measure` make them");
  const auto& reference = tables.references.at(name);
  const auto& first = tables.first.at(name);
  const auto& now = tables.now.at(name);
  std::array<char, 48> noise{};
  std::snprintf(noise.data(), noise.size(), "%.0f, %.4f", reference[kPathsColumn], reference[kNoiseColumn]);
  std::string row = "| " + name + " | " + noise.data() + " | " + written(reference[2], reference[3]);
  std::size_t sum = 0;
  const auto add = [&](double flip, double rmse) {
    sums.at(sum++) += flip;
    sums.at(sum++) += rmse;
  };
  add(reference[2], reference[3]);
  for (const auto* const figures : {&first, &now})
    for (std::size_t quality = 0; quality < 3; ++quality) {
      row += " | " + written((*figures)[2 * quality], (*figures)[2 * quality + 1]);
      add((*figures)[2 * quality], (*figures)[2 * quality + 1]);
    }
  return row + " |\n";
}

Result<std::string> writeTable(const Tables& tables) {
  std::string text =
      "| scene | paths, noise | `--bounces 1` | `draft` first | `good` first | `best` first | `draft` | `good` | "
      "`best` |\n"
      "| --- | --: | --: | --: | --: | --: | --: | --: | --: |\n";
  std::array<double, 14> sums{};
  for (const HiddenScene& scene : hiddenScenes()) {
    MIRRORBALL_TRY(row, writeRow(tables, scene.name, sums));
    text += row;
  }
  const auto count = static_cast<double>(hiddenScenes().size());
  text += "| mean | | ";  // --bounces 1 is not measured of all
  for (std::size_t i = 2; i < sums.size(); i += 2) text += " | " + written(sums.at(i) / count, sums.at(i + 1) / count);
  return text + " |\n";
}

}  // namespace

Result<void> writeHiddenPage() {
  MIRRORBALL_TRY(references, readNumberTable(referenceTablePath(), kReferenceColumns));
  MIRRORBALL_TRY(first, readNumberTable(firstFigureTablePath(), kFigureColumns));
  MIRRORBALL_TRY(now, readNumberTable(figureTablePath(), kFigureColumns));
  MIRRORBALL_TRY(table, writeTable({std::move(references), std::move(first), std::move(now)}));
  const auto page = std::filesystem::path(MIRRORBALL_SOURCE_DIR) / "docs/truth/hidden.md";
  MIRRORBALL_TRY(text, readText(page));
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos)
    return fail(ErrorCode::bad_file, page.string() + " has no marks around its table");
  text.replace(begin + kBegin.size(), end - begin - kBegin.size(), table);
  return writeText(page, text);
}

}  // namespace mirrorball::quality
