// What a change costs on a stage that lives, and what a second view of it takes.
//
// usage: stage_bench MODEL ENVIRONMENT

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "mirrorball/environment/file/load.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/render/frame/view.h"
#include "mirrorball/scene/load_model.h"

using namespace mirrorball;

namespace {

/// Of this process, now [MiB]; a software driver's textures are in it.
double memory() {
  std::ifstream file("/proc/self/statm");
  long pages = 0, resident = 0;
  file >> pages >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// The time of `act`, drawn to its end [ms].
double msOf(const std::function<void()>& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The median of nine such times.
double timeOf(const std::function<Result<void>(int turn)>& act) {
  std::vector<double> times;
  for (int turn = 0; turn < 9; ++turn)
    times.push_back(msOf([&] {
      if (const auto done = act(turn); !done) std::printf("%s\n", done.error().message.c_str());
    }));
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

Result<void> firstSample(View& view, const FrameSettings& settings) {
  MIRRORBALL_TRY_VOID(view.begin(settings));
  MIRRORBALL_TRY_VOID(view.drawSample());
  return {};
}

Result<void> measure(const std::string& model, const std::string& environment) {
  MIRRORBALL_TRY(device, Device::headless());
  Stage stage(device);
  MIRRORBALL_TRY(loaded, loadEnvironment(environment));
  MIRRORBALL_TRY_VOID(stage.setEnvironment(std::move(loaded.environment), *CacheFolder::ofUser()));
  MIRRORBALL_TRY(scene, loadModel(model));
  MIRRORBALL_TRY_VOID(stage.setScene(std::move(scene)));
  FrameSettings settings{.size = {1280, 720}, .samples = 2};
  const FrameSettings small{.size = {16, 16}, .samples = 2};
  View view(stage);
  const double empty = memory();
  MIRRORBALL_TRY_VOID(view.draw(settings));
  const double one = memory();
  View second(stage);
  settings.relief = ReliefKind::none;
  MIRRORBALL_TRY_VOID(second.draw(settings));
  std::printf("memory: %.0f MiB before the first frame, %.0f with one view of 1280 x 720, %.0f with two\n", empty, one,
              memory());
  View moved(stage);
  MIRRORBALL_TRY_VOID(moved.draw(small));
  std::printf("first sample of 16 x 16 pixels: %.2f ms after nothing, ",
              timeOf([&](int) { return firstSample(moved, small); }));
  std::printf("%.2f ms after a camera's move, ", timeOf([&](int turn) -> Result<void> {
                FrameSettings turned = small;
                turned.camera.azimuth_deg = static_cast<float>(10 * turn);
                return firstSample(moved, turned);
              }));
  std::printf("%.2f ms after a material's number\n", timeOf([&](int turn) -> Result<void> {
                Material material = stage.scene().materials[0];
                material.perceptual_roughness = 0.1f * static_cast<float>(turn);
                MIRRORBALL_TRY_VOID(stage.setMaterial(0, material));
                return firstSample(moved, small);
              }));
  const auto timeOfCopy = [&](const char* what, const std::function<void(Scene&, int turn)>& change) {
    std::printf("  %.2f ms after a copy with %s\n", timeOf([&](int turn) -> Result<void> {
                  Scene copy = stage.scene();
                  change(copy, turn);
                  MIRRORBALL_TRY_VOID(stage.setScene(std::move(copy)));
                  return firstSample(moved, small);
                }),
                what);
  };
  timeOfCopy("nothing else", [](Scene&, int) {});
  timeOfCopy("another mesh", [](Scene& copy, int) { copy.meshes[0].edit().vertices[0].position *= 1.0001f; });
  timeOfCopy("another pixel", [](Scene& copy, int turn) {
    if (!copy.textures.empty()) copy.textures[0].image.edit().texel(0, 0)[0] = static_cast<std::uint8_t>(turn);
  });
  std::printf("  %.2f ms after a node's move\n", timeOf([&](int turn) -> Result<void> {
                MIRRORBALL_TRY_VOID(stage.setNode(0, {.translation = {0.001 * turn, 0.0, 0.0}}));
                return firstSample(moved, small);
              }));
  return {};
}

/// The longest step of a change to a technique that no device has drawn yet, and all of it [ms].
Result<void> measurePrograms(const std::string& model) {
  MIRRORBALL_TRY(device, Device::headless());
  Stage stage(device);
  MIRRORBALL_TRY(studio, loadEnvironment("studio"));
  MIRRORBALL_TRY_VOID(stage.setEnvironment(std::move(studio.environment), *CacheFolder::ofUser()));
  MIRRORBALL_TRY(scene, loadModel(model));
  MIRRORBALL_TRY_VOID(stage.setScene(std::move(scene)));
  View view(stage);
  MIRRORBALL_TRY_VOID(view.draw({.size = {1280, 720}, .samples = 1}));
  MIRRORBALL_TRY_VOID(view.begin({.size = {1280, 720}, .samples = 2, .mapping = Mapping::normal}));
  glFinish();
  double longest = 0.0, all = 0.0;
  int programs = 0;
  Result<int> left = 1;
  for (; left && *left > 0; ++programs) {
    const double step = msOf([&] { left = view.makeProgram(); });
    longest = std::max(longest, step);
    all += step;
  }
  if (!left) return tl::unexpected<Error>(left.error());
  Result<int> drawn = 0;
  const double first = msOf([&] { drawn = view.drawSample(); });
  const double second = msOf([&] { drawn = view.drawSample(); });
  std::printf(
      "another technique: %d programs in %.0f ms, one in %.0f ms at most; the first sample in %.0f ms, the second in "
      "%.0f ms\n",
      programs, all, longest, first, second);
  return {};
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "usage: stage_bench MODEL ENVIRONMENT\n");
    return 2;
  }
  const auto measured = measure(words[1], words[2]);
  if (!measured) std::fprintf(stderr, "%s\n", measured.error().message.c_str());
  if (const auto programs = measurePrograms(words[1]); !programs)
    std::fprintf(stderr, "%s\n", programs.error().message.c_str());
  return measured ? 0 : 1;
}
