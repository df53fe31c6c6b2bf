// usage: view_bench WORDS…
//
// How a viewer feels, without a window: WORDS are those of `mirrorball view`, as in
//   view_bench FlightHelmet.gltf -e lightroom_14b.hdr
// Prints how long it takes until the first picture and the whole one, how many pictures a second there are while a hand
// turns the model at 1280 x 720, and of what size, how long the whole picture takes after the hand rests, and how long
// until a changed material is seen.

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "mirrorball/base/cache_folder.h"
#include "mirrorball/render/stage/device.h"
#include "mirrorball/view/viewer/viewer.h"
#include "mirrorball/view/workspace/view_request.h"

using namespace mirrorball;

namespace {

class Watch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Lets time go on as a window does.
class Host {
 public:
  explicit Host(Viewer& viewer) : viewer_(viewer) {}

  /// returns   whether there is another picture
  bool step() {
    const double now_s = watch_.seconds();
    const auto drawn = viewer_.advance(now_s - before_s_);
    before_s_ = now_s;
    if (!drawn) std::fprintf(stderr, "%s\n", drawn.error().message.c_str());
    if (viewer_.isWaiting()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return drawn && *drawn;
  }
  double untilPicture() {
    const Watch watch;
    while (!step() && viewer_.status().problem.empty()) {
    }
    return watch.seconds();
  }
  double untilDone() {
    const Watch watch;
    while (!viewer_.isDone()) step();
    return watch.seconds();
  }

 private:
  Viewer& viewer_;
  Watch watch_;
  double before_s_ = 0.0;
};

void turn(Viewer& viewer, Host& host) {
  constexpr double kSeconds = 4.0;
  viewer.handle(PointerPressed{PointerButton::left, {400, 300}});
  const Watch watch;
  int pictures = 0;
  double fewest_pixels = 1e9;
  glm::ivec2 smallest(0);
  for (int move = 1; watch.seconds() < kSeconds; ++move) {
    viewer.handle(PointerMoved{{400 + 4 * move, 300 + (move % 7)}});
    if (!host.step()) continue;
    ++pictures;
    const glm::ivec2 size = viewer.status().sides[0].size_px;
    if (double(size.x) * size.y >= fewest_pixels) continue;
    fewest_pixels = double(size.x) * size.y;
    smallest = size;
  }
  const double seconds = watch.seconds();
  viewer.handle(PointerReleased{PointerButton::left});
  std::printf("turning              %6.1f pictures a second, %d x %d at least\n", pictures / seconds, smallest.x,
              smallest.y);
  std::printf("whole after rest     %6.2f s\n", host.untilDone());
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  const Watch watch;
  auto request = viewRequestOf(arguments);
  if (!request) {
    std::fprintf(stderr, "%s\n", request.error().message.c_str());
    return 1;
  }
  const auto device = Device::headless();
  if (!device) {
    std::fprintf(stderr, "%s\n", device.error().message.c_str());
    return 1;
  }
  auto cache = CacheFolder::ofUser();
  Viewer viewer(*device, request->workspace, {1280, 720},
                {.frame_s = 1e-3 * double(request->window.frame_ms),
                 .cache = cache ? std::move(*cache) : std::optional<CacheFolder>()});
  Host host(viewer);
  std::printf("driver               %s\n", device->driver().c_str());
  host.untilPicture();
  std::printf("first picture        %6.2f s\n", watch.seconds());
  host.untilDone();
  std::printf("whole picture        %6.2f s\n", watch.seconds());
  turn(viewer, host);
  for (const char* const material : {"gold", "rough-metal"}) {
    auto next = withOption(viewer.workspace(), OptionTable::material, "material", material);
    if (next) viewer.history().change("Material", std::move(*next));
    std::printf("material %-11s %6.3f s\n", material, host.untilPicture());
    host.untilDone();
  }
  return 0;
}
