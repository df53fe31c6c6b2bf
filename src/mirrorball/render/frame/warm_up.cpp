#include "mirrorball/render/frame/warm_up.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "mirrorball/gl/driver_cache.h"
#include "mirrorball/render/frame/renderer.h"

namespace mirrorball {
namespace {

/// A smaller frame of the same shape and programs. Drivers compile other code for textures whose sides are powers of
/// two: such sides stay powers of two, and others never become one.
glm::ivec2 smallerFrame(glm::ivec2 size) {
  constexpr int kLeast = 64;
  while (size.x % 2 == 0 && size.y % 2 == 0 && std::min(size.x, size.y) >= 2 * kLeast) size /= 2;
  return size;
}

/// Makes the programs of a frame one by one, which `progress` counts.
Result<void> makePrograms(Renderer& renderer, const FrameSettings& settings, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(renderer.begin(settings));
  for (std::size_t made = 1;; ++made) {
    MIRRORBALL_TRY(left, renderer.makeProgram());
    if (!progress(made, made + static_cast<std::size_t>(left)))
      return fail(ErrorCode::interrupted, "interrupted; what was compiled is kept");
    if (left == 0) return {};
  }
}

/// Draws a frame small, to the picture, and one sample of it as it is: which surfaces are drawn twice, and how large
/// shadows and probes are, depends on the number of pixels.
Result<void> drawFirst(Renderer& renderer, const FrameSettings& settings, const FrameSettings& small,
                       const ProgressFunction& goes_on, Shown shown) {
  MIRRORBALL_TRY_VOID(renderer.draw(small, goes_on));
  if (shown == Shown::light) {
    MIRRORBALL_TRY_VOID(renderer.displayedLight());
  } else {
    MIRRORBALL_TRY_VOID(renderer.picture());
  }
  if (small == settings) return {};
  MIRRORBALL_TRY_VOID(renderer.begin(settings));
  MIRRORBALL_TRY_VOID(renderer.drawSample());
  return {};
}

}  // namespace

Result<void> warmUp(RenderInputs inputs, const FrameSettings& settings, const ProgressFunction& progress, Shown shown) {
  // A program whose first code llvmpipe takes from its cache has its second code there under another key than one whose
  // first code was compiled, so that a second process may compile again, and a third one. Usually two rounds do.
  constexpr int kMostRounds = 4;
  FrameSettings small = settings;
  small.size = smallerFrame(settings.size);
  const ProgressFunction report = progress ? progress : [](std::size_t, std::size_t) { return true; };
  const ProgressFunction goes_on = [&](std::size_t, std::size_t) { return report(0, 0); };
  const auto cache = gl::findDriverCache(inputs.context.version());
  for (int round = 1; round <= kMostRounds; ++round) {
    const std::uintmax_t bytes_before = cache ? cache->contents().bytes : 0;
    if (round > 1) {
      MIRRORBALL_TRY(context, gl::Context::createHeadless());
      inputs.context = std::move(context);
    }
    {
      MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
      MIRRORBALL_TRY_VOID(renderer.setEnvironment(inputs.environment, inputs.prepared));
      MIRRORBALL_TRY_VOID(renderer.setScene(inputs.scene));
      MIRRORBALL_TRY_VOID(renderer.stage().prepare(settings, goes_on));
      if (round == 1) MIRRORBALL_TRY_VOID(makePrograms(renderer, small, report));
      MIRRORBALL_TRY_VOID(drawFirst(renderer, settings, small, goes_on, shown));
    }  // whose end waits until the driver has written all
    if (cache ? cache->contents().bytes == bytes_before : round == 2) break;
  }
  return {};
}

}  // namespace mirrorball
