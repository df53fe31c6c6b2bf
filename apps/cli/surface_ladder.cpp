#include "cli/surface_ladder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "cli/files.h"
#include "cli/stage_clock.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/scene/relief/height_texture.h"
#include "mirrorball/study/section_sheet.h"

namespace mirrorball::cli {
namespace {

const Option<LadderOptions> kLadder{
    {.name = "ladder",
     .help = "instead of a map, a picture (.png, .jpg): the surface by all kinds of --relief of `render`, 60, 30 and "
             "10 degrees above the plane, beside the path-traced one; below each its PSNR to that, the time of a "
             "sample, and that as a multiple of bump's",
     .group = "Ladder"},
    &LadderOptions::is_wanted};

constexpr std::string_view kComparedTo = "bump";
constexpr float kSideOfPlane = std::numbers::sqrt2_v<float>;  ///< planeMesh()

/// Rows of a table, under one heading.
template <typename Target>
std::vector<Option<Target>> rowsOfLadder(std::span<const Option<Target>> table,
                                         std::span<const std::string_view> names) {
  std::vector<Option<Target>> rows = rowsNamed(table, names);
  for (Option<Target>& row : rows) row.text.group = "Ladder";
  return rows;
}

std::span<const Option<SceneRequest>> sceneRows() {
  constexpr std::array<std::string_view, 2> kNames{"env", "no-cache"};
  static const auto rows = rowsOfLadder(sceneOptions(), kNames);
  return rows;
}

std::span<const Option<FrameSettings>> frameRows() {
  constexpr std::array<std::string_view, 2> kNames{"size", "relief-steps"};
  static const auto rows = rowsOfLadder(frameOptions(), kNames);
  return rows;
}

std::span<const Option<StudySettings>> studyRows() {
  constexpr std::array<std::string_view, 2> kNames{"samples", "noise"};
  static const auto rows = rowsOfLadder(studyOptions(), kNames);
  return rows;
}

/// The assignments of --set that give a model these heights; its grey is such that bright light does not hide them.
std::vector<std::string> materialOf(const std::string& input, float scale) {
  const auto names = builtinHeightNames();
  const auto builtin = std::ranges::find(names, input);
  const bool is_file = builtin == names.end();
  // A word without a dot or a slash would be a built-in's name.
  const std::string file = input.find_first_of("./") == std::string::npos ? "./" + input : input;
  std::vector<std::string> assignments{"base_color=0.4", "height=" + (is_file ? file : input)};
  if (scale == 0.0f) return assignments;
  const auto kind =
      is_file ? HeightKind::map
              : static_cast<HeightKind>(builtin - names.begin() + static_cast<std::ptrdiff_t>(HeightKind::orange));
  const float tile = kSideOfPlane / ownSize(kind).frequency;
  assignments.push_back("height_scale=" + formatNumber(double(scale * tile)));
  return assignments;
}

/// What stands on the sheet, a line for each picture.
void tellWords(const StudiedSection& section) {
  for (const StudiedShot& shot : section.shots)
    for (const StudiedPicture& picture : shot.pictures)
      tell(shot.label + "  " + join(wordsOf(picture, shot, kComparedTo), "  "));
}

}  // namespace

void addLadder(Command& command, LadderOptions& options) {
  addOptions(command, std::span(&kLadder, 1), options);
  addOptions(command, sceneRows(), options.scene, &options.given);
  addOptions(command, frameRows(), options.study.frame, &options.given);
  addOptions(command, studyRows(), options.study, &options.given);
}

Result<void> checkLadder(const LadderOptions& options) {
  if (options.is_wanted || options.given.empty()) return {};
  return fail(ErrorCode::usage, "--" + std::string(*options.given.begin()) + " is of the ladder; add --ladder");
}

Result<void> drawLadder(const std::string& input, float scale, LadderOptions options, const std::string& output) {
  MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::picture}));
  MIRRORBALL_TRY_VOID(checkFolder(output));
  StageClock clock;
  MIRRORBALL_TRY(inputs, loadInputs(options.scene, {.set = materialOf(input, scale)}, options.study.frame,
                                    options.given, {&output, 1}, clock));
  // So near that the tile fills the pictures, and its outline is seen.
  options.study.frame.camera.distance = 1.3f;
  MIRRORBALL_TRY(section, studySeries(std::move(inputs), "relief", options.study, progressBar("ladder")));
  MIRRORBALL_TRY_VOID(savePicture(output, sectionSheet(section, kComparedTo)));
  announce(output);
  tellWords(section);
  return {};
}

}  // namespace mirrorball::cli
