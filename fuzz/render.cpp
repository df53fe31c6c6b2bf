// Models as readers hand them on, drawn by the real-time renderer as `render` draws them by default.

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "mirrorball/rays/occlusion_cache.h"
#include "mirrorball/rays/seen_from.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/settings/quality.h"
#include "shown_model.h"

namespace mirrorball::fuzz {
namespace {

/// One for all inputs: a driver takes longer to start than a picture to be drawn.
Renderer& renderer() {
  static Renderer made = [] {
    auto started = Renderer::headless();
    if (!started || !started->setEnvironment(lightToShowIn())) std::abort();
    return std::move(*started);
  }();
  return made;
}

/// What `render` decides before it draws.
Result<void> prepare(Scene& scene, FrameSettings& frame) {
  SceneTraits traits = traitsOf(scene);
  traits.can_trace_rays = true;
  if (dependsOnHiding(Quality::good, traits, {}, frame)) {
    MIRRORBALL_TRY(hides, hidesItself(scene));
    traits.hides_itself = hides;
  }
  fillIn(Quality::good, traits, {}, frame);
  frame.samples = 1;
  if (frame.occlusion == OcclusionKind::none) return {};
  return findOcclusionOnce(
      scene, {.finds_materials = frame.self_reflection, .refines = frame.reflect_at == ReflectAt::fragment}, {});
}

Result<Image> drawn(Scene scene) {
  FrameSettings frame;
  frame.size = kShownSize;
  MIRRORBALL_TRY_VOID(prepare(scene, frame));
  MIRRORBALL_TRY_VOID(renderer().setScene(std::move(scene)));
  return renderer().renderRadiance(frame);
}

}  // namespace
}  // namespace mirrorball::fuzz

MIRRORBALL_HARNESS(render) {
  mirrorball::fuzz::checkShown({data, size}, mirrorball::fuzz::drawn);
  return 0;
}
