// Models as readers hand them on, path traced as `render --reference` does.

#include <utility>

#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/trace/path_tracer.h"
#include "shown_model.h"

namespace mirrorball::fuzz {
namespace {

Result<TracedPicture> traced(Scene scene) {
  static const Environment light = lightToShowIn();
  TraceSettings settings;
  settings.size = kShownSize;
  settings.samples = 2;
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), {}, kShownSize));
  MIRRORBALL_TRY(tracer, PathTracer::make(std::move(scene), light));
  return tracer.render(camera, settings);
}

}  // namespace
}  // namespace mirrorball::fuzz

MIRRORBALL_HARNESS(reference) {
  using namespace mirrorball::fuzz;
  auto scene = modelToShow({data, size});
  if (!scene) return 0;
  const auto picture = traced(std::move(*scene));
  checkError(picture);
  if (picture) checkPicture(picture->radiance);
  return 0;
}
