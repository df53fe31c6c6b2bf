// A host's context ends under a viewer.

#include <optional>

#include <gtest/gtest.h>

#include "mirrorball/gl/context.h"
#include "mirrorball/view/viewer/viewer_testing.h"

namespace mirrorball {
namespace {

using testing::finish;
using testing::kViewerSize;

class ViewerLostContextTest : public testing::ViewerTest {};

TEST_F(ViewerLostContextTest, GoesOnInAnotherWithAllThatWasDone) {
  auto host = gl::Context::createHeadless();
  ASSERT_TRUE(host) << host.error().message;
  std::optional<gl::Context> context(std::move(*host));
  Workspace workspace;
  workspace.model = "sphere";
  workspace.maps = {"white"};
  workspace.frame = {{"samples", {"1"}}, {"quality", {"draft"}}};
  std::optional<Viewer> viewer;
  viewer.emplace(device(), workspace, kViewerSize);
  viewer->history().change("Another view", withLightTurned(workspace, glm::vec3(40.0f)));
  finish(*viewer);
  const Image8 before = *viewer->picture();

  context.reset();
  const auto advanced = viewer->advance(0.01);
  const auto shown = viewer->picture();
  ASSERT_TRUE(!advanced || !shown) << "it must be told";
  EXPECT_EQ((advanced ? shown.error() : advanced.error()).code, ErrorCode::no_gl);
  const History history = viewer->history();
  viewer.reset();

  auto next = gl::Context::createHeadless();
  ASSERT_TRUE(next) << next.error().message;
  Viewer another(device(), history.now(), kViewerSize);
  another.history() = history;
  finish(another);
  EXPECT_TRUE(another.picture()->samples().size() == before.samples().size());
  EXPECT_EQ(testing::differing(*another.picture(), before, 0, kViewerSize.x), 0);
  EXPECT_EQ(another.history().undoName(), "Another view");
}

}  // namespace
}  // namespace mirrorball
