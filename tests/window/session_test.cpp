// The window's own parts, whose context is taken away.

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "mirrorball/base/file.h"
#include "mirrorball/codec/image_file.h"
#include "window/display.h"
#include "window/session.h"

namespace mirrorball::testing {
namespace {

using window::Session;

class WindowSessionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("MIRRORBALL_WITHOUT_GL") != nullptr) GTEST_SKIP() << "the window needs OpenGL";
    display_ = std::make_unique<Display>();
    ASSERT_TRUE(display_->isThere());
    ASSERT_TRUE(glfwInit());
  }
  void TearDown() override { glfwTerminate(); }

  /// The part of a screenshot that is the viewer's.
  static Image8 pictureOf(Session& session, glm::ivec2 size_px) {
    const std::string path = ::testing::TempDir() + "session.png";
    const auto saved = session.saveScreenshot(path);
    EXPECT_TRUE(saved) << saved.error().message;
    const auto bytes = readFile(path);
    const auto window = bytes ? decodeTexture(*bytes) : Result<Image8>(fail(ErrorCode::io, "no file"));
    Image8 picture(size_px.x, size_px.y, 4);
    if (!window || window->width() < size_px.x || window->height() < size_px.y) return picture;
    for (int y = 0; y < size_px.y; ++y)
      std::copy_n(window->texel(0, window->height() - size_px.y + y), 4 * size_px.x, picture.texel(0, y));
    return picture;
  }

  std::unique_ptr<Display> display_;
};

TEST_F(WindowSessionTest, GoesOnInAnotherContext) {
  Workspace workspace;
  workspace.model = "sphere";
  workspace.maps = {"white"};
  workspace.frame = {{"samples", {"1"}}, {"quality", {"draft"}}, {"size", {"320x240"}}};
  auto opened = Session::open({}, History(workspace));
  ASSERT_TRUE(opened) << opened.error().message;
  std::unique_ptr<Session> session = std::move(*opened);
  ASSERT_TRUE(session->step());
  const Image8 before = pictureOf(*session, {320, 240});

  glfwMakeContextCurrent(nullptr);
  const auto stepped = session->step();
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().code, ErrorCode::no_gl);
  auto another = Session::anew(std::move(session), {});
  ASSERT_TRUE(another) << another.error().message;
  ASSERT_TRUE((*another)->step());
  EXPECT_EQ((*another)->workspace(), workspace);
  const Image8 after = pictureOf(**another, {320, 240});
  EXPECT_TRUE(std::equal(after.samples().begin(), after.samples().end(), before.samples().begin()));
  EXPECT_GT(*std::max_element(after.samples().begin(), after.samples().end() - 1), 100);
}

}  // namespace
}  // namespace mirrorball::testing
