#include "mirrorball/study/shot_plan.h"

#include <set>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

/// What a picture shows of a built-in model; without one, of the scene that was given.
std::string keyOf(const Subject& subject, std::string_view model, const std::string& change) {
  std::string key = std::string(model) + " " + std::string(subject.shows) + " " + change;
  if (!model.empty())
    for (const std::string_view part : {subject.material, subject.view, subject.parameters})
      key += " " + std::string(part);
  return key;
}

/// Its meshes, with heights as they are shown.
std::string shapesOf(const Subject& subject, std::string_view model, const std::string& change) {
  const std::string heights = std::string(subject.shows) + " " + (model.empty() ? "" : std::string(subject.parameters));
  return std::string(model) + " " + heights + " " + change;
}

void planSeries(std::vector<PlannedShot>& shots, const Subject& subject, std::string_view model) {
  for (const double value : subject.series->values) {
    const std::string label = formatNumber(value);
    const std::string change = std::string(subject.series->axis) + "=" + label;
    shots.push_back({label, value, model, keyOf(subject, model, change),
                     shapesOf(subject, model, subject.series->changes_shapes ? change : "")});
  }
}

std::vector<PlannedShot> shotsOfBuiltIn(const Subject& subject) {
  std::vector<PlannedShot> shots;
  for (const std::string_view model : subject.models) {
    if (subject.series)
      planSeries(shots, subject, model);
    else
      shots.push_back({std::string(model), {}, model, keyOf(subject, model, ""), shapesOf(subject, model, "")});
  }
  return shots;
}

std::vector<PlannedShot> shotsOfScene(const Subject& subject) {
  std::vector<PlannedShot> shots;
  shots.push_back({.label = "as it is", .key = keyOf(subject, "", ""), .shapes = shapesOf(subject, "", "")});
  if (subject.series && subject.series->is_of_any_scene) planSeries(shots, subject, "");
  return shots;
}

}  // namespace

StudyPlan planOfAll() {
  StudyPlan plan;
  for (const Subject& subject : subjects()) plan.push_back({&subject, shotsOfBuiltIn(subject)});
  return plan;
}

StudyPlan planFor(const Scene& scene) {
  StudyPlan plan;
  for (const Subject& subject : subjects())
    if (subject.applies(scene)) plan.push_back({&subject, shotsOfScene(subject)});
  return plan;
}

Result<StudyPlan> planOfSeries(std::string_view id) {
  const auto subject = findBy(subjects(), id, &Subject::id);
  if (subject == subjects().end() || !subject->series)
    return fail(ErrorCode::usage, "there is no subject " + std::string(id) + " with a series");
  std::vector<PlannedShot> shots;
  planSeries(shots, *subject, "");
  return StudyPlan{{&*subject, std::move(shots)}};
}

std::string tracedKey(const PlannedShot& shot, std::string_view settings) {
  return shot.key + " " + std::string(settings);
}

std::size_t stepsOf(const StudyPlan& plan) {
  std::set<std::string> to_trace;
  std::size_t to_draw = 0;
  for (const PlannedSection& section : plan)
    for (const PlannedShot& shot : section.shots) {
      to_trace.insert(tracedKey(shot, section.subject->reference));
      for (const Technique& technique : section.subject->techniques) {
        if (technique.maker == Technique::Maker::renderer)
          ++to_draw;
        else
          to_trace.insert(tracedKey(shot, technique.settings));
      }
    }
  return to_trace.size() * kStepsOfTraced + to_draw * kStepsOfDrawn;
}

}  // namespace mirrorball
