#include "mirrorball/render/settings/capture_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mirrorball/render/settings/frame_checks.h"

namespace mirrorball {
namespace {

/// What has no meaning for a map of all directions, or a map's own option in its place.
constexpr std::array<std::string_view, 11> kOptionsOfPictures{"size",   "sampling",     "exposure", "tone-map",
                                                              "dither", "resolve",      "camera",   "target",
                                                              "fov",    "orthographic", "stand"};

/// Choices without the last one.
constexpr std::string_view allButLast(std::string_view choices) { return choices.substr(0, choices.rfind('|')); }

}  // namespace

std::span<const Option<FrameSettings>> captureFrameOptions() {
  static const std::vector<Option<FrameSettings>> options = [] {
    std::vector<Option<FrameSettings>> kept;
    for (const Option<FrameSettings>& option : frameOptions())
      if (std::find(kOptionsOfPictures.begin(), kOptionsOfPictures.end(), option.text.name) == kOptionsOfPictures.end())
        kept.push_back(option);
    for (Option<FrameSettings>& option : kept) {
      if (option.text.name == "mapping") {
        // A sphere map is right for one viewing direction, and a capture looks into all.
        option.text.choices = allButLast(option.text.choices);
        option.text.help = "what addresses the environment map: the reflected ray, or the surface normal";
      }
      if (option.text.name == "background") option.text.value = allButLast(option.text.value);  // transparent
    }
    return kept;
  }();
  return options;
}

Result<void> checkCapture(const FrameSettings& settings, const std::set<std::string_view>& given) {
  if (settings.background == BackgroundKind::transparent)
    return fail(ErrorCode::usage, "a map has light for every direction; {option:background} 0,0,0 leaves it dark");
  return checkSettings(settings, given);
}

}  // namespace mirrorball
