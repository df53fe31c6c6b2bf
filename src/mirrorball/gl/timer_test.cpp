#include "mirrorball/gl/timer.h"

#include <gtest/gtest.h>

#include "mirrorball/gl/framebuffer.h"
#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::gl {
namespace {

class TimerTest : public GlTest {};

MIRRORBALL_WITH_BOTH_APIS(TimerTest);

/// Fills a picture so many times.
void fill(const Framebuffer& framebuffer, int times) {
  framebuffer.bind();
  for (int i = 0; i < times; ++i) {
    glClearColor(static_cast<float>(i), 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    (void)framebuffer.readFloat();
  }
}

TEST_P(TimerTest, MeasuresWhatIsDrawn) {
  const auto framebuffer = Framebuffer::make(Format::rgba8, 512, 512);
  ASSERT_TRUE(framebuffer);
  Timer timer;
  EXPECT_FALSE(timer.seconds()) << "nothing was drawn";
  timer.begin(context());
  fill(*framebuffer, 1);
  timer.end();
  const auto once = timer.seconds();
  timer.begin(context());
  fill(*framebuffer, 50);
  timer.end();
  const auto often = timer.seconds();
  ASSERT_EQ(once.has_value(), context().api() == Api::desktop43);
  if (!once) return;
  EXPECT_GT(*once, 0.0);
  EXPECT_GT(*often, *once);
}

}  // namespace
}  // namespace mirrorball::gl
