#include "mirrorball/render/stage/technique_choice.h"

#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/render/stage/scene_preparation.h"

namespace mirrorball {
namespace {

Result<SceneTraits> traitsFor(const Scene& scene, const TechniqueWishes& wishes, const FrameSettings& settings) {
  SceneTraits traits = traitsOf(scene);
  traits.can_trace_rays = !wishes.objects_move;
  traits.has_strong_sun = wishes.has_strong_sun;
  if (!dependsOnHiding(wishes.quality, traits, wishes.given, settings)) return traits;
  MIRRORBALL_TRY(hides, hidesItself(scene));
  traits.hides_itself = hides;
  return traits;
}

}  // namespace

Result<std::string> chooseTechniques(Scene& scene, const TechniqueWishes& wishes, FrameSettings& settings,
                                     const std::optional<CacheFolder>& cache, const Observer& observer) {
  const FrameSettings as_given = settings;
  MIRRORBALL_TRY(traits, traitsFor(scene, wishes, settings));
  std::string chosen = fillIn(wishes.quality, traits, wishes.given, settings);
  if (settings.occlusion == OcclusionKind::none) return chosen;
  const Result<void> found = observer.timed("model: occlusion", [&] {
    return findOcclusionOnce(scene, occlusionSettingsFor(settings), cache, observer.progressOf("occlusion"));
  });
  if (found) return chosen;
  const bool was_asked_for = wishes.needs_all || as_given.self_reflection || as_given.occlusion != OcclusionKind::none;
  if (was_asked_for || found.error().code != ErrorCode::too_large) return tl::unexpected<Error>(found.error());
  // What nobody asked for must not end what was asked for.
  settings = as_given;
  traits.is_huge = true;
  return fillIn(wishes.quality, traits, wishes.given, settings);
}

}  // namespace mirrorball
