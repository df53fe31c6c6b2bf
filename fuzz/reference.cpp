// Models as readers hand them on, path traced as `render --reference` does.

#include <utility>

#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/trace/path_tracer.h"
#include "shown_model.h"

namespace mirrorball::fuzz {
namespace {

Result<Image> traced(Scene scene) {
  static const Environment light = lightToShowIn();
  TraceSettings settings;
  settings.size = kShownSize;
  settings.samples = 2;
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), {}, kShownSize));
  MIRRORBALL_TRY(tracer, PathTracer::make(std::move(scene), light));
  MIRRORBALL_TRY(picture, tracer.render(camera, settings));
  return std::move(picture.radiance);
}

}  // namespace
}  // namespace mirrorball::fuzz

MIRRORBALL_HARNESS(reference) {
  mirrorball::fuzz::checkShown({data, size}, mirrorball::fuzz::traced);
  return 0;
}
