// A window on a viewer (src/mirrorball/view): it forwards what hands do, and shows pictures and panels. What any of it
// means is the viewer's.

#include <cstdio>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "mirrorball/view/workspace/recent_files.h"
#include "mirrorball/view/workspace/view_request.h"
#include "window/display_loss.h"
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

/// What has ended the window, and how to go on where it was.
std::string withKept(const std::string& reason, const Workspace& workspace) {
  const auto recent = RecentFiles::ofUser();
  if (!recent) return reason;
  const auto path = recent->keep(workspace);
  return reason + (path ? "; to go on: mirrorball view " + *path : "; " + path.error().message);
}

/// Shows it until it is closed. A context that is lost gives way to another, unless it is lost at once.
Result<void> view(const ViewRequest& request) {
  constexpr double kSoon_s = 5.0;
  MIRRORBALL_TRY(session, window::Session::open(request.window, History(request.workspace)));
  if (!request.window.screenshot.empty()) return session->saveScreenshot(request.window.screenshot);
  const window::AtDisplayLoss at_loss([&session = session, start = request.workspace] {
    failed(withKept("the connection to the display broke", session ? session->workspace() : start));
  });
  for (double begun_s = glfwGetTime();;) {
    const auto is_open = session->step();
    if (is_open && !*is_open) return {};
    if (is_open) continue;
    const std::string reason = is_open.error().message;
    const Workspace workspace = session->workspace();
    const auto lost = [&](const std::string& why) { return fail(ErrorCode::no_gl, withKept(why, workspace)); };
    if (glfwGetTime() - begun_s < kSoon_s) return lost(reason);
    auto another = window::Session::anew(std::move(session), request.window);
    if (!another) return lost(another.error().message);
    session = std::move(*another);
    session->tell(reason);
    begun_s = glfwGetTime();
  }
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
