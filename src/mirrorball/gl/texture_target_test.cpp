#include "mirrorball/gl/texture_target.h"

#include "mirrorball/gl/gl_api.h"
#include "mirrorball/gl/gl_testing.h"

namespace mirrorball::gl {
namespace {

using TextureTargetTest = GlTest;
MIRRORBALL_WITH_BOTH_APIS(TextureTargetTest);

TEST_P(TextureTargetTest, DrawsIntoTheImageThatIsBoundAndNoOther) {
  auto cube = Texture::makeCube(Format::rgba16f, 8, 3);
  ASSERT_TRUE(cube) << cube.error().message;
  const TextureTarget target;
  const auto fill = [&](int level, int face, float value) {
    target.bind(*cube, level, face);
    ASSERT_TRUE(target.isComplete());
    glClearColor(value, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  };
  for (int level = 0; level < 3; ++level)
    for (int face = 0; face < 6; ++face) fill(level, face, static_cast<float>(10 * level + face));
  fill(1, 4, 99.0f);
  for (int level = 0; level < 3; ++level)
    for (int face = 0; face < 6; ++face) {
      const Image image = cube->read(level, face);
      const float expected = level == 1 && face == 4 ? 99.0f : static_cast<float>(10 * level + face);
      EXPECT_EQ(image.texel(0, 0)[0], expected) << level << ' ' << face;
      EXPECT_EQ(image.texel(image.width() - 1, image.height() - 1)[0], expected) << level << ' ' << face;
    }
}

TEST_P(TextureTargetTest, ViewportIsThatOfTheLevel) {
  auto cube = Texture::makeCube(Format::rgba16f, 8, 3);
  ASSERT_TRUE(cube) << cube.error().message;
  const TextureTarget target;
  target.bind(*cube, 2, 0);
  GLint viewport[4] = {};
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], 2);
  EXPECT_EQ(viewport[3], 2);
}

}  // namespace
}  // namespace mirrorball::gl
