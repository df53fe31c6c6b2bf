#include "mirrorball/study/study.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "mirrorball/light_edit/sun_split.h"
#include "mirrorball/metric/picture/comparison_sheet.h"
#include "mirrorball/metric/picture/heat_map.h"
#include "mirrorball/render/stage/technique_choice.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/study/angle_error.h"
#include "mirrorball/study/shot_plan.h"
#include "mirrorball/study/subject.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A path-traced picture that more than one subject may ask for.
struct Traced {
  Image radiance;
  TraceCost cost;
};

/// A picture of the renderer.
struct Drawn {
  Image radiance;
  DrawCost cost;
};

/// How much there is to do, and how much of it is done.
class Steps {
 public:
  Steps(const ProgressFunction& progress, std::size_t total) : progress_(progress), total_(total) {}

  /// The function for the next part of the work.
  ProgressFunction next(std::size_t count) {
    const std::size_t first = std::exchange(done_, done_ + count);
    return partOf(progress_, first, count, total_);
  }

 private:
  const ProgressFunction& progress_;
  std::size_t total_;
  std::size_t done_ = 0;
};

/// Makes the pictures of subjects, one after the other.
class Workshop {
 public:
  Workshop(Renderer renderer, Scene scene, Environment environment, PreparedEnvironment prepared, bool has_strong_sun,
           const StudySettings& settings, Steps steps)
      : renderer_(std::move(renderer)),
        scene_(std::move(scene)),
        environment_(std::move(environment)),
        prepared_(std::move(prepared)),
        has_strong_sun_(has_strong_sun),
        settings_(settings),
        steps_(steps) {}

  std::string driver() const { return renderer_.driver(); }
  Result<StudiedSection> section(const Subject& subject, const std::vector<PlannedShot>& shots);

 private:
  /// What stands before the camera.
  struct Stage {
    Scene scene;
    FrameSettings frame;
  };

  Result<Stage> staged(const Subject& subject, const PlannedShot& shot) const;
  Result<Image> cosines(const Stage& stage);
  Result<StudiedShot> studied(const Subject& subject, const PlannedShot& shot, const Stage& stage,
                              const Image& cosines);
  Result<Drawn> draw(const Stage& stage, const Technique& technique);
  Result<const Traced*> trace(const Stage& stage, const PlannedShot& shot, std::string_view settings);
  Result<void> prepareTracer(Scene scene, const PlannedShot& shot);

  Renderer renderer_;
  Scene scene_;
  Environment environment_;
  PreparedEnvironment prepared_;
  bool has_strong_sun_;
  StudySettings settings_;
  Steps steps_;
  std::map<std::string, Traced> traced_;
  std::optional<PathTracer> tracer_ = {};  ///< made when it is first needed
  std::string tracer_shapes_ = {};         ///< PlannedShot::shapes of the scene that it has
  std::optional<PreparedEnvironment> directions_ = {};
};

Result<Workshop::Stage> Workshop::staged(const Subject& subject, const PlannedShot& shot) const {
  Stage stage{scene_, settings_.frame};
  if (!shot.model.empty()) {
    MIRRORBALL_TRY(model, loadModel(std::string(shot.model)));
    MIRRORBALL_TRY_VOID(changeMaterials(model, {.material = std::string(subject.material)}));
    MIRRORBALL_TRY_VOID(applyParameters(subject.parameters, model));
    MIRRORBALL_TRY_VOID(applySettings(subject.view, stage.frame));
    stage.scene = std::move(model);
  }
  MIRRORBALL_TRY_VOID(applySettings(subject.shows, stage.frame));
  if (shot.value) subject.series->change(*shot.value, stage.scene, stage.frame);
  return stage;
}

Result<Image> Workshop::cosines(const Stage& stage) {
  if (!directions_) {
    MIRRORBALL_TRY(prepared, prepareEnvironment(environmentOfDirections()));
    directions_ = std::move(prepared);
  }
  MIRRORBALL_TRY_VOID(renderer_.setEnvironment(environmentOfDirections(), *directions_));
  MIRRORBALL_TRY(cosines, cosinesOf(renderer_, stage.scene, stage.frame));
  MIRRORBALL_TRY_VOID(renderer_.setEnvironment(environment_, prepared_));
  return cosines;
}

Result<Drawn> Workshop::draw(const Stage& stage, const Technique& technique) {
  FrameSettings frame = stage.frame;
  MIRRORBALL_TRY_VOID(applySettings(technique.settings, frame));
  Scene scene = stage.scene;
  MIRRORBALL_TRY_VOID(applyParameters(technique.parameters, scene));
  MIRRORBALL_TRY_VOID(prepareRelief(scene, frame.relief));
  TechniqueWishes wishes{.quality = technique.quality,
                         .given = namesOfSettings(technique.settings),
                         .has_strong_sun = has_strong_sun_,
                         .needs_all = true};
  wishes.given.insert("samples");  // those of all pictures
  MIRRORBALL_TRY_VOID(chooseTechniques(scene, wishes, frame));
  MIRRORBALL_TRY_VOID(renderer_.setScene(std::move(scene)));

  std::vector<double> times_ms;
  const ProgressFunction progress = steps_.next(kStepsOfDrawn);
  std::optional<Clock::time_point> last;
  const auto timed = [&](std::size_t done, std::size_t total) {
    // The first frame waits for what the driver puts off: compiling, uploading.
    if (last) times_ms.push_back(1e3 * secondsSince(*last));
    const bool goes_on = !progress || progress(done, total);
    last = Clock::now();
    return goes_on;
  };
  // The stage's camera, not the scene's: a mesh of cut triangles reaches lower, and would be framed in another way.
  MIRRORBALL_TRY(camera, framedCamera(stage.scene, boundingSphere(stage.scene), frame.camera, frame.size));
  MIRRORBALL_TRY_VOID(renderer_.draw(camera, frame, timed));
  if (times_ms.empty()) MIRRORBALL_TRY_VOID(renderer_.draw(camera, frame, timed));  // a single frame was the first
  DrawCost cost{.light = renderer_.lightCost()};
  if (!times_ms.empty()) {
    const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
    std::nth_element(times_ms.begin(), middle, times_ms.end());
    cost.frame_ms = *middle;
  }
  MIRRORBALL_TRY(radiance, renderer_.radiance());
  return Drawn{std::move(radiance), cost};
}

/// Sorts triangles anew only where they are others: for millions of them it takes longer than small pictures.
Result<void> Workshop::prepareTracer(Scene scene, const PlannedShot& shot) {
  if (!tracer_) {
    MIRRORBALL_TRY(made, PathTracer::make(std::move(scene), environment_));
    tracer_ = std::move(made);
  } else if (shot.shapes == tracer_shapes_) {
    tracer_->setMaterials(std::move(scene.materials));
  } else {
    MIRRORBALL_TRY_VOID(tracer_->setScene(std::move(scene)));
  }
  tracer_shapes_ = shot.shapes;
  return {};
}

Result<const Traced*> Workshop::trace(const Stage& stage, const PlannedShot& shot, std::string_view settings) {
  const std::string key = tracedKey(shot, settings);
  if (const auto found = traced_.find(key); found != traced_.end()) return &found->second;
  Scene scene = stage.scene;
  MIRRORBALL_TRY_VOID(prepareRelief(scene, stage.frame.relief));
  MIRRORBALL_TRY_VOID(prepareTracer(std::move(scene), shot));
  TraceSettings trace;
  MIRRORBALL_TRY_VOID(applySettings(settings, trace));
  trace.noise = settings_.noise;
  trace = tracedFrame(stage.frame, trace);
  if (settings_.paths) trace.samples = *settings_.paths;
  MIRRORBALL_TRY(camera, framedCamera(stage.scene, boundingSphere(stage.scene), stage.frame.camera, trace.size));
  const auto start = Clock::now();
  MIRRORBALL_TRY(picture, tracer_->render(camera, trace, {.progress = steps_.next(kStepsOfTraced)}));
  if (picture.is_interrupted) return fail(ErrorCode::interrupted, "interrupted; nothing was written");
  return &traced_
              .emplace(key, Traced{std::move(picture.radiance), {picture.samples, picture.noise, secondsSince(start)}})
              .first->second;
}

Result<StudiedShot> Workshop::studied(const Subject& subject, const PlannedShot& shot, const Stage& stage,
                                      const Image& cosines) {
  MIRRORBALL_TRY(reference, trace(stage, shot, subject.reference));
  const ComparisonSettings display{.exposure = stage.frame.display.exposure(),
                                   .tone_map = static_cast<int>(stage.frame.display.tone_map)};
  StudiedShot studied{.label = shot.label, .value = shot.value, .cost = reference->cost, .scale = 0.0f};
  std::vector<Image> differences;
  for (const Technique& technique : subject.techniques) {
    StudiedPicture made{.technique = std::string(technique.name),
                        .settings = std::string(technique.settings) + std::string(technique.parameters)};
    Image radiance;
    if (technique.maker == Technique::Maker::renderer) {
      MIRRORBALL_TRY(drawn, draw(stage, technique));
      radiance = std::move(drawn.radiance);
      made.drawn = drawn.cost;
    } else {
      MIRRORBALL_TRY(traced, trace(stage, shot, technique.settings));
      radiance = traced->radiance;
      made.traced = traced->cost;
    }
    if (!cosines.empty()) made.by_angle = errorByAngle(radiance, reference->radiance, cosines);
    MIRRORBALL_TRY(test, comparedImage(std::move(radiance), ImageKind::light));
    MIRRORBALL_TRY(right, comparedImage(reference->radiance, ImageKind::light));
    MIRRORBALL_TRY(comparison, compareImages(std::move(test), std::move(right), ImageKind::light, display));
    made.values = comparison.values;
    made.picture = codesOf(comparison.shown_test);
    made.flip = flipHeatMap(comparison.flip);
    studied.reference = codesOf(comparison.shown_reference);
    studied.scale = std::max(studied.scale, usualScale(comparison.difference));
    differences.push_back(std::move(comparison.difference));
    studied.pictures.push_back(std::move(made));
  }
  for (std::size_t i = 0; i < differences.size(); ++i)
    studied.pictures[i].difference = signedHeatMap(differences[i], studied.scale);
  return studied;
}

Result<StudiedSection> Workshop::section(const Subject& subject, const std::vector<PlannedShot>& shots) {
  StudiedSection section{.id = std::string(subject.id),
                         .title = std::string(subject.title),
                         .teaches = std::string(subject.teaches),
                         .compared_with = std::string(subject.compared_with),
                         .axis = subject.series ? std::string(subject.series->axis) : "",
                         .by_angle = subject.by_angle};
  Image angles;
  for (const PlannedShot& shot : shots) {
    MIRRORBALL_TRY(stage, staged(subject, shot));
    if (subject.by_angle && angles.empty()) {
      MIRRORBALL_TRY(found, cosines(stage));
      angles = std::move(found);
    }
    MIRRORBALL_TRY(done, studied(subject, shot, stage, angles));
    section.shots.push_back(std::move(done));
  }
  return section;
}

Result<Study> studied(RenderInputs inputs, const StudyPlan& plan, StudySettings settings,
                      const StudyObserver& observer) {
  settings.frame.samples = std::min(settings.frame.samples, settings.paths.value_or(settings.frame.samples));
  settings.frame.resolve = Resolve::radiance;
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(inputs.environment, inputs.prepared));
  MIRRORBALL_TRY(has_strong_sun, hasStrongSun(inputs.environment));
  Workshop workshop(std::move(renderer), std::move(inputs.scene), std::move(inputs.environment),
                    std::move(inputs.prepared), has_strong_sun, settings, Steps(observer.progress, stepsOf(plan)));
  Study study{.driver = workshop.driver(),
              .size = settings.frame.size,
              .samples = settings.frame.samples,
              .planned = plan.size()};
  for (const PlannedSection& planned : plan) {
    auto section = workshop.section(*planned.subject, planned.shots);
    if (!section && section.error().code == ErrorCode::interrupted && !study.sections.empty()) return study;
    if (!section) return tl::unexpected<Error>(std::move(section.error()));
    study.sections.push_back(std::move(*section));
    if (observer.section_done) observer.section_done();
  }
  return study;
}

}  // namespace

Result<Study> study(RenderInputs inputs, bool is_built_in, const StudySettings& settings,
                    const StudyObserver& observer) {
  const StudyPlan plan = is_built_in ? planOfAll() : planFor(inputs.scene);
  return studied(std::move(inputs), plan, settings, observer);
}

Result<StudiedSection> studySeries(RenderInputs inputs, std::string_view id, const StudySettings& settings,
                                   const ProgressFunction& progress) {
  MIRRORBALL_TRY(plan, planOfSeries(id));
  MIRRORBALL_TRY(study, studied(std::move(inputs), plan, settings, {.progress = progress}));
  return std::move(study.sections.front());
}

}  // namespace mirrorball
