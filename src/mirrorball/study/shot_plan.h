#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/result.h"
#include "mirrorball/scene/scene.h"
#include "mirrorball/study/subject.h"

namespace mirrorball {

/// A picture that is to be made of a subject.
struct PlannedShot {
  std::string label;
  std::optional<double> value = {};
  std::string_view model = {};  ///< built-in; empty: the scene that was given
  std::string key;              ///< what it shows: those of one key are the same
  std::string shapes;           ///< its meshes and where they are: likewise
};

/// A subject, with all its pictures.
struct PlannedSection {
  const Subject* subject;
  std::vector<PlannedShot> shots;
};
using StudyPlan = std::vector<PlannedSection>;

/// All subjects, in their built-in scenes.
StudyPlan planOfAll();
/// Those that apply to a scene that is given.
StudyPlan planFor(const Scene& scene);
/// One subject in a scene that is given, over its series alone.
///
/// errors   usage (there is none such, or it has no series)
Result<StudyPlan> planOfSeries(std::string_view id);

/// What the path-traced picture of a shot shows: those of one key are the same.
std::string tracedKey(const PlannedShot& shot, std::string_view settings);

/// What a picture counts for in the progress, about in proportion to its time.
inline constexpr std::size_t kStepsOfDrawn = 100;
inline constexpr std::size_t kStepsOfTraced = 1000;

/// All the steps of a plan: each path-traced picture counts once.
std::size_t stepsOf(const StudyPlan& plan);

}  // namespace mirrorball
