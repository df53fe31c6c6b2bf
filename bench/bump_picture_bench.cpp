// Holds pictures of bumps that a pixel averages away to pictures of very many samples, and prints the table of
// docs/truth/relief.md: the renderer's own, of a plane of a rough mirror whose bumps are told by
// heights or by a normal map. The error is that of radiance that is clipped at 1 in each pixel; beside it stands how
// much too bright the picture is. Derivative maps have the same moments as heights.
//   unfiltered   the finest level of the map, 4 samples a pixel
//   one lobe     widened by what is averaged away; of a normal map Toksvig's (2005, "Mipmapping normal maps")
//   strata       what the renderer does
//   truth        the 512 samples themselves, against the path tracer
// With a number as argument, bumps are as many times as steep.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include <glm/glm.hpp>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/scene/bumpy_plane_testing.h"
#include "mirrorball/trace/path_tracer.h"

using namespace mirrorball;

namespace {

constexpr glm::ivec2 kSize_px{64, 36};
constexpr int kTruthSamples = 512;
constexpr float kRoughness = 0.1f;

/// What was made, or the end.
template <typename Value>
Value orExit(Result<Value> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

Image drawn(Renderer& renderer, const Camera& camera, int samples, TextureFilter filter = TextureFilter::trilinear) {
  const FrameSettings settings{
      .size = kSize_px, .samples = samples, .resolve = Resolve::radiance, .texture_filter = filter};
  if (const auto done = renderer.draw(camera, settings); !done) {
    std::fprintf(stderr, "%s\n", done.error().message.c_str());
    std::exit(1);
  }
  return orExit(renderer.radiance());
}

/// One lobe where strata are not read: brushed so little that it is not seen.
Image drawnInOneLobe(Renderer& renderer, const Camera& camera, Scene scene) {
  Scene with_strata = scene;
  scene.materials.front().anisotropy = 1e-3f;
  if (!renderer.setScene(std::move(scene))) std::exit(1);
  Image image = drawn(renderer, camera, 4);
  if (!renderer.setScene(std::move(with_strata))) std::exit(1);
  return image;
}

Image traced(const Environment& light, const Camera& camera, Scene scene) {
  const PathTracer tracer = orExit(PathTracer::make(std::move(scene), light));
  TraceSettings settings{.size = kSize_px, .samples = kTruthSamples, .bounces = 1, .is_unoccluded = true};
  return orExit(tracer.render(camera, settings)).radiance;
}

struct Error {
  double rms = 0.0;
  double mean = 0.0;  ///< how much too bright without clipping, of the truth's mean
};

Error errorOf(const Image& found, const Image& truth) {
  double squares = 0.0, sum = 0.0, light = 0.0;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      const double expected = std::min(rgbAt(truth, x, y).y, 1.0f);
      const double difference = std::min(rgbAt(found, x, y).y, 1.0f) - expected;
      squares += difference * difference;
      sum += rgbAt(found, x, y).y - rgbAt(truth, x, y).y;
      light += rgbAt(truth, x, y).y;
    }
  return {std::sqrt(squares / double(truth.width() * truth.height())), sum / light};
}

void printError(const Image& found, const Image& truth) {
  const Error error = errorOf(found, truth);
  std::printf(" %.3f (%+.0f %%) |", error.rms, 100.0 * error.mean);
  std::fflush(stdout);
}

void printRow(Renderer& renderer, const Environment& light, HeightKind kind, testing::BumpForm form, float texels,
              float steepness) {
  const Scene scene = testing::bumpyPlane(kind, form, testing::whiteMetal(kRoughness), steepness);
  const Camera camera = testing::cameraOverPlane(texels, kSize_px);
  if (!renderer.setScene(scene)) std::exit(1);
  std::printf("| %s, %s, %g texels |", std::string(builtinHeightNames()[std::size_t(kind) - 1]).c_str(),
              testing::nameOf(form).c_str(), double(texels));
  const Image truth = drawn(renderer, camera, kTruthSamples);
  printError(drawn(renderer, camera, 4, TextureFilter::bilinear), truth);
  printError(drawnInOneLobe(renderer, camera, scene), truth);
  printError(drawn(renderer, camera, 4), truth);
  printError(drawn(renderer, camera, 8), truth);
  printError(truth, traced(light, camera, scene));
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  const float steepness = count > 1 ? std::strtof(arguments[1], nullptr) : 1.0f;
  const Environment light = orExit(builtinEnvironment("studio"));
  Renderer renderer = orExit(Renderer::headless());
  if (!renderer.setEnvironment(light, std::nullopt)) std::exit(1);
  std::printf("| surface, a pixel | unfiltered, 4 | one lobe, 4 | strata, 4 | strata, 8 | truth |\n");
  std::printf("|---|--:|--:|--:|--:|--:|\n");
  for (const HeightKind kind : {HeightKind::orange, HeightKind::brick, HeightKind::waves})
    for (const testing::BumpForm form : {testing::BumpForm::heights, testing::BumpForm::normal_map})
      for (const float texels : {2.0f, 8.0f, 32.0f}) printRow(renderer, light, kind, form, texels, steepness);
}
