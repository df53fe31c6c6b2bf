// The tables of what a study is told.

#include <algorithm>
#include <array>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/study/study.h"

namespace mirrorball {
namespace {

const auto kOptions = std::to_array<Option<StudySettings>>({
    {{.name = "samples",
      .value = "N",
      .minimum = 1,
      .maximum = 65536,
      .help =
          "paths a pixel of each path-traced picture, and up to 64 samples of the renderer's; without it 256, or with "
          "{option:noise} as many as that takes",
      .group = "Reference"},
     &StudySettings::paths},
    {{.name = "noise",
      .value = "X",
      .minimum = 1e-5,
      .maximum = 1,
      .help = "trace until the mean standard error of each picture is below X; 0.004 is one step of an 8-bit picture",
      .group = "Reference"},
     &StudySettings::noise},
});

}  // namespace

std::span<const Option<StudySettings>> studyOptions() { return kOptions; }

std::span<const Option<FrameSettings>> studyFrameOptions() {
  static const std::vector<Option<FrameSettings>> options = [] {
    constexpr auto kNames =
        std::to_array<std::string_view>({"size", "exposure", "tone-map", "camera", "target", "fov", "orthographic",
                                         "env-rotation", "env-intensity", "light-intensity"});
    std::vector<Option<FrameSettings>> chosen;
    std::copy_if(frameOptions().begin(), frameOptions().end(), std::back_inserter(chosen),
                 [&](const Option<FrameSettings>& option) { return contains(kNames, option.text.name); });
    return chosen;
  }();
  return options;
}

}  // namespace mirrorball
