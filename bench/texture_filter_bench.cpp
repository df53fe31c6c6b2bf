// Holds each --texture-filter to the mean over a pixel, and prints the tables of docs/truth/renderer.md, "Texture
// filtering": the error of a picture, its shimmer from one frame of a turn to the next, and the time of a frame.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material_changes.h"

using namespace mirrorball;

namespace {

constexpr int kFrames = 12;
constexpr float kStep_deg = 0.25f;
constexpr int kTruthSamples = 256;
constexpr int kTimedFrames = 15;
constexpr std::array<const char*, 4> kNames{"nearest", "bilinear", "trilinear", "anisotropic"};  // by TextureFilter

/// What was made, or the end.
template <typename Value>
Value orExit(Result<Value> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

/// A picture's subject and where it is seen from.
struct View {
  const char* title;
  const char* model;
  const char* environment;
  MaterialChanges changes;
  FrameSettings settings;
};

Renderer rendererOf(const View& view) {
  Renderer renderer = orExit(Renderer::headless());
  Scene scene = orExit(loadModel(view.model));
  if (const auto changed = changeMaterials(scene, view.changes); !changed) std::exit(1);
  if (!renderer.setScene(std::move(scene))) std::exit(1);
  if (!renderer.setEnvironment(orExit(builtinEnvironment(view.environment)), std::nullopt)) std::exit(1);
  return renderer;
}

/// The pictures of a turn.
std::vector<Image> framesOf(Renderer& renderer, FrameSettings settings) {
  std::vector<Image> frames;
  const float first = settings.camera.azimuth_deg;
  for (int frame = 0; frame < kFrames; ++frame) {
    settings.camera.azimuth_deg = first + kStep_deg * static_cast<float>(frame);
    frames.push_back(orExit(renderer.renderRadiance(settings)));
  }
  return frames;
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

struct Quality {
  double error;    ///< RMSE over all frames
  double shimmer;  ///< RMS of how much more a pixel changes to the next frame than it should
};

/// How much a sample changes from the frame before.
double changeOf(const std::vector<Image>& frames, std::size_t frame, std::size_t sample) {
  return std::abs(double(frames[frame].samples()[sample]) - double(frames[frame - 1].samples()[sample]));
}

Quality qualityOf(const std::vector<Image>& frames, const std::vector<Image>& truth) {
  std::vector<double> errors;
  std::vector<double> excess;
  for (std::size_t frame = 0; frame < frames.size(); ++frame)
    for (std::size_t i = 0; i < frames[frame].samples().size(); ++i) {
      errors.push_back(double(frames[frame].samples()[i]) - double(truth[frame].samples()[i]));
      if (frame > 0) excess.push_back(std::max(changeOf(frames, frame, i) - changeOf(truth, frame, i), 0.0));
    }
  return {rootMeanSquare(errors), rootMeanSquare(excess)};
}

/// The least of some frames with one sample a pixel, with what reads it back: processor time of all threads [ms], which
/// other programs disturb little. On a GPU it is the program's own alone.
double timeOf(Renderer& renderer, FrameSettings settings) {
  settings.size = {1280, 720};
  settings.samples = 1;
  double least = 1e9;
  for (int i = 0; i < kTimedFrames; ++i) {
    const std::clock_t begin = std::clock();
    orExit(renderer.render(settings));
    least = std::min(least, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

void printTable(const View& view) {
  Renderer renderer = rendererOf(view);
  FrameSettings settings = view.settings;
  settings.samples = kTruthSamples;
  settings.texture_filter = TextureFilter::bilinear;
  const std::vector<Image> truth = framesOf(renderer, settings);
  std::printf("\n%s\n\n| filter | 1 sample | 4 | 16 | shimmer, 1 | 4 | 16 | ms |\n|---|--:|--:|--:|--:|--:|--:|--:|\n",
              view.title);
  for (std::size_t filter = 0; filter < kNames.size(); ++filter) {
    settings.texture_filter = static_cast<TextureFilter>(filter);
    std::array<Quality, 3> found{};
    for (std::size_t i = 0; i < found.size(); ++i) {
      settings.samples = 1 << (2 * i);
      found[i] = qualityOf(framesOf(renderer, settings), truth);
    }
    std::printf("| `%s` | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.0f |\n", kNames[filter], found[0].error,
                found[1].error, found[2].error, found[0].shimmer, found[1].shimmer, found[2].shimmer,
                timeOf(renderer, settings));
  }
}

}  // namespace

int main() {
  FrameSettings plane{.size = {320, 160}};
  plane.camera = {.azimuth_deg = 25.0f, .elevation_deg = 6.0f, .distance = 1.2f};
  printTable(
      {"striped plane", "plane", "white", {.set = {"base_color_map=stripes", "base_color=1", "specular=0"}}, plane});
  FrameSettings ball{.size = {64, 64}};
  ball.camera = {.azimuth_deg = 25.0f, .elevation_deg = 6.0f};
  printTable({"mirror ball in `uv`", "sphere", "uv", {.material = "mirror"}, ball});
}
