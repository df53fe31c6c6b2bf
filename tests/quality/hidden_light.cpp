// usage: hidden_light write FOLDER
//        hidden_light trace|one-bounce [PATHS] [SCENE…]
//        hidden_light measure [SCENE…]
//        hidden_light page
//        hidden_light sheet FILE [SCENE…]
//
// Of the scenes of hidden_scenes.h, or of those named:
//
//   write       writes each into a folder as NAME.glb, and prints how it is rendered
//   trace       path-traces the references: tests/quality/references, and their noise in hidden_references.txt
//   one-bounce  path-traces each with --bounces 1, and compares it with its reference: hidden_references.txt
//   measure     draws each in every quality and compares it with its reference: hidden_figures.txt
//   page        writes the numbers of all into the page hidden.md
//   sheet       writes a sheet with the reference above what `good` draws, for each scene
//
// PATHS of a pixel, else 1024, with which `trace` and `one-bounce` take half a minute of a processor for each scene;
// `measure` takes some seconds.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/srgb.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/metric/picture/lettering.h"
#include "mirrorball/metric/picture/side_by_side.h"
#include "quality/hidden_figures.h"
#include "quality/hidden_page.h"
#include "quality/hidden_scenes.h"
#include "quality/scene_parts.h"

namespace mirrorball::quality {
namespace {

/// The scenes of those names; all where there are none.
Result<std::vector<HiddenScene>> chooseScenes(const std::vector<std::string>& names) {
  const auto all = hiddenScenes();
  if (names.empty()) return std::vector<HiddenScene>(all.begin(), all.end());
  std::vector<HiddenScene> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& scene) { return scene.name == name; });
    if (found == all.end()) return fail(ErrorCode::usage, "there is not a scene '" + name + "'");
    chosen.push_back(*found);
  }
  return chosen;
}

/// Writes the rows of a table again and again, so that one that is interrupted has what was measured.
Result<void> setRow(const std::filesystem::path& file, std::size_t columns, const std::string& name,
                    const std::vector<double>& numbers) {
  MIRRORBALL_TRY(table, readNumberTable(file, columns));
  table[name] = numbers;
  std::printf("%s", name.c_str());
  for (const double number : numbers) std::printf("\t%.4f", number);
  std::printf("\n");
  std::fflush(stdout);
  return writeNumberTable(file, table);
}

Result<void> write(const std::vector<std::string>& arguments) {
  if (arguments.size() != 1) return fail(ErrorCode::usage, "write takes one folder");
  std::filesystem::create_directories(arguments.front());
  for (const HiddenScene& scene : hiddenScenes()) {
    MIRRORBALL_TRY(file, writeGlb(scene.make(), scene.name, arguments.front()));
    std::printf("render %s %s\n", file.c_str(), shownBy(scene, "--quality good").c_str());
  }
  return {};
}

/// The row is without --bounces 1 until that is compared.
Result<void> traceReference(const HiddenScene& scene, int paths) {
  MIRRORBALL_TRY(reference, makePicture(scene, tracedBy(paths)));
  MIRRORBALL_TRY(noise, parseNoise(reference.printed));
  std::filesystem::create_directories(referencePath(scene.name).parent_path());
  MIRRORBALL_TRY_VOID(savePicture(referencePath(scene.name), pictureFromLinear(reference.image, 3)));
  return setRow(referenceTablePath(), kReferenceColumns, scene.name,
                {double(paths), noise, kNotMeasured, kNotMeasured});
}

Result<void> compareOneBounce(const HiddenScene& scene, int paths) {
  MIRRORBALL_TRY(reference, readReference(scene.name));
  MIRRORBALL_TRY(table, readNumberTable(referenceTablePath(), kReferenceColumns));
  MIRRORBALL_TRY(one_bounce, makePicture(scene, tracedBy(paths) + " --bounces 1"));
  MIRRORBALL_TRY(error, findError(one_bounce.image, reference));
  return setRow(referenceTablePath(), kReferenceColumns, scene.name,
                {table[scene.name].at(kPathsColumn), table[scene.name].at(kNoiseColumn), error.flip, error.rmse});
}

Result<void> measure(const HiddenScene& scene) {
  MIRRORBALL_TRY(reference, readReference(scene.name));
  std::vector<double> figures;
  for (const char* quality : {"draft", "good", "best"}) {
    MIRRORBALL_TRY(drawn, makePicture(scene, std::string("--quality ") + quality));
    MIRRORBALL_TRY(error, findError(drawn.image, reference));
    figures.push_back(error.flip);
    figures.push_back(error.rmse);
  }
  return setRow(figureTablePath(), kFigureColumns, scene.name, figures);
}

/// The reference of a scene above what `good` draws of it, and its name.
Result<Image8> drawCell(const HiddenScene& scene) {
  MIRRORBALL_TRY(reference, readReference(scene.name));
  MIRRORBALL_TRY(drawn, makePicture(scene, "--quality good"));
  const int width = reference.width(), height = reference.height();
  constexpr int kTextHeight = 14;
  Image8 cell(width, 2 * height + kTextHeight, 3, 255);
  place(pictureFromLinear(reference, 3), cell, 0, 0);
  place(pictureFromLinear(drawn.image, 3), cell, 0, height);
  drawText(cell, {2, 2 * height + 2}, 1, {0, 0, 0}, scene.name);
  return cell;
}

Result<void> drawSheet(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return fail(ErrorCode::usage, "sheet takes a file, and names of scenes");
  MIRRORBALL_TRY(scenes, chooseScenes({arguments.begin() + 1, arguments.end()}));
  constexpr int kColumns = 7, kGap_px = 4;
  Image8 sheet;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    MIRRORBALL_TRY(cell, drawCell(scenes[i]));
    const int columns = std::min<int>(kColumns, static_cast<int>(scenes.size()));
    const int rows = (static_cast<int>(scenes.size()) + columns - 1) / columns;
    const int width = cell.width() + kGap_px, height = cell.height() + kGap_px;
    if (sheet.empty()) sheet = Image8(columns * width - kGap_px, rows * height - kGap_px, 3, 255);
    const int number = static_cast<int>(i);
    place(cell, sheet, number % columns * width, number / columns * height);
  }
  return savePicture(arguments.front(), sheet);
}

Result<void> run(const std::string& task, const std::vector<std::string>& arguments) {
  if (task == "write") return write(arguments);
  if (task == "page") return writeHiddenPage();
  if (task == "sheet") return drawSheet(arguments);
  const auto paths = arguments.empty() ? std::nullopt : parseNumber(arguments.front());
  MIRRORBALL_TRY(scenes, chooseScenes({arguments.begin() + (paths ? 1 : 0), arguments.end()}));
  const auto all = [&](const auto& each) -> Result<void> {
    for (const HiddenScene& scene : scenes) MIRRORBALL_TRY_VOID(each(scene, static_cast<int>(paths.value_or(1024))));
    return {};
  };
  if (task == "measure") return all([](const HiddenScene& scene, int) { return measure(scene); });
  if (task == "one-bounce") return all(compareOneBounce);
  if (task == "trace") return all(traceReference);
  return fail(ErrorCode::usage, "'" + task + "' is not a task");
}

}  // namespace
}  // namespace mirrorball::quality

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: hidden_light write|trace|one-bounce|measure|page|sheet [FOLDER|FILE|PATHS] [SCENE...]\n");
    return 2;
  }
  const auto ended = mirrorball::quality::run(argv[1], {argv + 2, argv + argc});
  if (!ended) std::fprintf(stderr, "hidden_light: %s\n", ended.error().message.c_str());
  return ended ? 0 : 1;
}
