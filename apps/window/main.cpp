// A window on a viewer (src/mirrorball/view): it forwards what hands do, and shows pictures and panels. What any of it
// means is the viewer's.

#include <cstdio>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "mirrorball/view/workspace/view_request.h"
#include "window/session.h"

using namespace mirrorball;

namespace {

/// What must end in this order.
struct Closing {
  ~Closing() { glfwTerminate(); }
};

int failed(const std::string& message) {
  std::fprintf(stderr, "mirrorball: %s\n", message.c_str());
  return 1;
}

Result<void> view(const ViewRequest& request) {
  MIRRORBALL_TRY(session, window::Session::open(request.window, History(request.workspace)));
  if (!request.window.screenshot.empty()) return session->saveScreenshot(request.window.screenshot);
  for (bool stays = true; stays;) {
    MIRRORBALL_TRY(is_open, session->step());
    stays = is_open;
  }
  return {};
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  const auto request = viewRequestOf(arguments);
  if (!request) return failed(request.error().message);
  if (request->wants_help) {
    std::fputs(viewHelp().c_str(), stdout);
    return 0;
  }
  glfwSetErrorCallback([](int, const char*) {});
  if (!glfwInit()) return failed("there is no display for a window; `mirrorball render` makes pictures without one");
  const Closing closing;
  const auto ended = view(*request);
  return ended ? 0 : failed(ended.error().message);
}
