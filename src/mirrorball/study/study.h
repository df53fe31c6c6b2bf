#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/option.h"
#include "mirrorball/base/progress.h"
#include "mirrorball/base/result.h"
#include "mirrorball/image/image.h"
#include "mirrorball/metric/comparison.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/frame/renderer.h"

namespace mirrorball {

/// How pictures are made that are held against each other.
struct StudySettings {
  /// Size, camera, display, and how the environment stands. `samples` is of the renderer's pictures, at
  /// most `paths`; what a technique is about, such as `blur`, it sets itself.
  FrameSettings frame = {.size = {256, 256}, .samples = 64};
  std::optional<int> paths = {};  ///< a pixel of what is path-traced; without it 256, or with `noise` what that takes
  float noise = 0.0f;             ///< as TraceSettings::noise
};

/// The table of those settings that only a study has.
std::span<const Option<StudySettings>> studyOptions();
/// Those rows of frameOptions() that a study takes.
std::span<const Option<FrameSettings>> studyFrameOptions();

/// n·v from 0 to 1 in as many steps of equal width.
inline constexpr std::size_t kAngleSteps = 10;
using ErrorByAngle = std::array<std::optional<double>, kAngleSteps>;

/// What a path-traced picture took.
struct TraceCost {
  int paths = 0;       ///< a pixel
  float noise = 0.0f;  ///< TracedPicture::noise
  double time_s = 0.0;
};

/// What a picture of the renderer took.
struct DrawCost {
  double frame_ms = 0.0;  ///< the median of the frames of one sample that the picture is the mean of, without the first
  LightCost light;
};

/// A technique's picture, held to the reference.
struct StudiedPicture {
  std::string technique;
  std::string settings;                                            ///< that make it: "mapping=sphere"
  std::array<std::optional<double>, kMetrics.size()> values = {};  ///< Comparison::values
  std::optional<DrawCost> drawn = {};                              ///< one of the two
  std::optional<TraceCost> traced = {};
  Image8 picture = {};         ///< encoded, 3 channels, as are the others
  Image8 flip = {};            ///< flipHeatMap
  Image8 difference = {};      ///< signedHeatMap at the shot's scale
  ErrorByAngle by_angle = {};  ///< root of relMSE over the pixels that show the model under these angles
};

/// One scene in one place, with every technique's picture of it.
struct StudiedShot {
  std::string label;                 ///< "0.45", "bowl"
  std::optional<double> value = {};  ///< of the subject's series
  TraceCost cost = {};               ///< of the reference
  Image8 reference = {};
  float scale = 1.0f;  ///< the difference of radiance that has the full colour in `difference`
  std::vector<StudiedPicture> pictures = {};
};

/// A subject, studied.
struct StudiedSection {
  std::string id;
  std::string title;
  std::string teaches;
  std::string compared_with;  ///< "up to 16 bounces"
  std::string axis;           ///< of the series; empty: there is none
  bool by_angle = false;
  std::vector<StudiedShot> shots = {};
};

/// All that a page shows (page/page.h).
struct Study {
  std::string driver;  ///< what the renderer ran on
  glm::ivec2 size{0};
  int samples = 0;  ///< of a pixel of the renderer's pictures
  std::vector<StudiedSection> sections = {};
  std::size_t planned = 0;  ///< how many sections there are to be: more than there are after an interruption

  bool isInterrupted() const { return sections.size() < planned; }
};

/// Watches the making of a study.
struct StudyObserver {
  ProgressFunction progress = {};           ///< tells of pictures, a path-traced one as several
  std::function<void()> section_done = {};  ///< after each subject
};

/// Renders a scene by every technique that applies to it, and measures each against the path-traced reference.
///
/// is_built_in  not the scene that was given, but those that each subject has for itself
/// returns      the same for any number of threads, but for times; after an interruption, the subjects that are done
/// errors       as Renderer's and PathTracer's; interrupted before the first subject is done
/// cost         for the built-in scenes some 30 path-traced pictures and 50 of the renderer
Result<Study> study(RenderInputs inputs, bool is_built_in, const StudySettings& settings,
                    const StudyObserver& observer = {});

/// One subject in the scene that was given, over its series alone.
///
/// subject  Subject::id
/// errors   usage (there is none such, or it has no series); as study's
/// cost     a path-traced picture for each value of the series, one of the renderer for each technique too
Result<StudiedSection> studySeries(RenderInputs inputs, std::string_view subject, const StudySettings& settings,
                                   const ProgressFunction& progress = {});

}  // namespace mirrorball
