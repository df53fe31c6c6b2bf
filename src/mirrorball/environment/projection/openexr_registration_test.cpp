#include "mirrorball/environment/projection/openexr_registration.h"

#include <algorithm>
#include <cmath>

#include <ImfEnvmap.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/cube/preset.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

// The truth about OpenEXR's maps is OpenEXR's own library: each test asks it which direction a texel of a picture has.

MapForm openExrForm(Projection projection) { return *formFor(*presetNamed("openexr"), projection, CubeLayout::vstrip); }

Imath::Box2i windowOf(glm::ivec2 size) { return {{0, 0}, {size.x - 1, size.y - 1}}; }

glm::vec3 unit(const Imath::V3f& v) { return glm::normalize(glm::vec3(v.x, v.y, v.z)); }

/// Calls visit(texel, direction) for every texel of an OpenEXR panorama.
template <typename Visit>
void forEachTexelOfLatLong(glm::ivec2 size, const Visit& visit) {
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      visit(glm::ivec2(x, y), unit(Imf::LatLongMap::direction(windowOf(size), Imath::V2f(float(x), float(y)))));
}

/// The same of a cube's strip.
template <typename Visit>
void forEachTexelOfCube(int side, const Visit& visit) {
  const Imath::Box2i window = windowOf({side, 6 * side});
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const auto name = static_cast<Imf::CubeMapFace>(face);
        const Imath::V2f in_face(static_cast<float>(x), static_cast<float>(y));
        const Imath::V2f texel = Imf::CubeMap::pixelPosition(name, window, in_face);
        visit(glm::ivec2(std::lround(texel.x), std::lround(texel.y)),
              unit(Imf::CubeMap::direction(name, window, in_face)));
      }
}

/// How far texels that are 3 degrees apart are off smoothRadiance.
class Deviation {
 public:
  void add(const Image& picture, glm::ivec2 texel, glm::vec3 direction) {
    const float error = glm::length(rgbAt(picture, texel.x, texel.y) - testing::smoothRadiance(direction));
    max_ = std::max(max_, error);
    sum_ += error * error;
    ++count_;
  }

  /// The mean is that of cubic interpolation. Where three faces of a cube meet there are no 16 texels for it, and the
  /// corner itself is the mean of what the three continue to.
  void expectSmall() const {
    EXPECT_GT(count_, 0);
    EXPECT_LT(std::sqrt(sum_ / static_cast<float>(count_)), 3e-4f);
    EXPECT_LT(max_, 5e-3f);
  }

 private:
  float max_ = 0.0f;
  float sum_ = 0.0f;
  int count_ = 0;
};

TEST(OpenExrRegistration, APanoramaAnswersAtOpenExrsDirections) {
  for (const int height : {64, 65}) {
    const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 256), Projection::equirect, height);
    const Image picture = pictureOf(map, openExrForm(Projection::equirect));
    ASSERT_EQ(glm::ivec2(picture.width(), picture.height()), glm::ivec2(2 * height, height));
    Deviation deviation;
    forEachTexelOfLatLong({2 * height, height},
                          [&](glm::ivec2 texel, glm::vec3 d) { deviation.add(picture, texel, d); });
    deviation.expectSmall();
  }
}

TEST(OpenExrRegistration, ACubeAnswersAtOpenExrsDirections) {
  for (const int side : {32, 33}) {
    const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 256), Projection::cube, side);
    const Image picture = pictureOf(map, openExrForm(Projection::cube));
    ASSERT_EQ(glm::ivec2(picture.width(), picture.height()), glm::ivec2(side, 6 * side));
    Deviation deviation;
    forEachTexelOfCube(side, [&](glm::ivec2 texel, glm::vec3 d) { deviation.add(picture, texel, d); });
    deviation.expectSmall();
  }
}

TEST(OpenExrRegistration, OpenExrsPanoramaIsRead) {
  for (const int height : {64, 65}) {
    Image picture(2 * height, height, 3);
    forEachTexelOfLatLong({2 * height, height}, [&](glm::ivec2 texel, glm::vec3 d) {
      const glm::vec3 light = testing::smoothRadiance(d);
      std::copy_n(&light.x, 3, picture.texel(texel.x, texel.y));
    });
    const EnvironmentMap map = *mapOfPicture(std::move(picture), openExrForm(Projection::equirect));
    Deviation deviation;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < 2 * height; ++x) {
        const glm::vec2 uv = (glm::vec2(x, y) + 0.5f) / glm::vec2(2 * height, height);
        deviation.add(map.face(0), {x, y}, directionAt(Projection::equirect, {0, uv}));
      }
    deviation.expectSmall();
  }
}

TEST(OpenExrRegistration, OpenExrsCubeIsRead) {
  for (const int side : {32, 33}) {
    Image picture(side, 6 * side, 3);
    forEachTexelOfCube(side, [&](glm::ivec2 texel, glm::vec3 d) {
      const glm::vec3 light = testing::smoothRadiance(d);
      std::copy_n(&light.x, 3, picture.texel(texel.x, texel.y));
    });
    const EnvironmentMap map = *mapOfPicture(std::move(picture), openExrForm(Projection::cube));
    Deviation deviation;
    for (int face = 0; face < 6; ++face)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          deviation.add(map.face(face), {x, y},
                        directionAt(Projection::cube, {face, (glm::vec2(x, y) + 0.5f) / float(side)}));
    deviation.expectSmall();
  }
}

TEST(OpenExrRegistration, TheSmallestMapsComeBack) {
  for (const int size : {1, 2}) {
    const MapForm form = openExrForm(Projection::equirect);
    const Image picture = pictureOf(EnvironmentMap(form.projection, ImageSet(Image(2 * size, size, 3, 0.5f))), form);
    EXPECT_EQ(mapOfPicture(picture, form)->radiance({0, 0, 1}), glm::vec3(0.5f)) << size;
  }
}

}  // namespace
}  // namespace mirrorball
