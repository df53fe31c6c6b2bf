#include "mirrorball/environment/file/cube_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/header_size.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class CubeFilesTest : public testing::FolderTest {
 protected:
  /// Six files of smooth light as Quake has them: sky_rt.exr sky_lf.exr sky_up.exr sky_dn.exr sky_ft.exr sky_bk.exr.
  void writeSky() const {
    const EnvironmentMap cube = *convert(Environment(testing::smoothRadiance, 64), Projection::cube, kSide);
    const MapForm form{.projection = Projection::cube, .arrangement = formHintNamed("faces:for=quake")->arrangement};
    const ImageSet images = imagesOf(cube, form);
    for (int slot = 0; slot < 6; ++slot)
      ASSERT_TRUE(
          writeImage(path("sky_" + std::string(endingsOf(FaceNaming::quake)[static_cast<std::size_t>(slot)]) + ".exr"),
                     images.at(0, slot)));
  }

  static constexpr int kSide = 64;
};

TEST_F(CubeFilesTest, AMissingBottomIsFilledAndRemarked) {
  writeSky();
  fs::remove(path("sky_dn.exr"));
  for (const std::string& name : {path("sky_ft.exr"), folder_.string()}) {
    const auto loaded = loadEnvironment(name);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_FALSE(loaded->oddities.empty());
    EXPECT_EQ(
        loaded->oddities[0],
        "is a cube without its lower face, sky_dn.exr: filled with the mean light of the lowest rows of its sides");
    EXPECT_EQ(loaded->files.size(), 5u);
    for (const glm::vec3 d : testing::manyDirections(200))
      if (glm::abs(d.y) < 0.5f)
        EXPECT_LT(glm::length(loaded->environment.radiance(d) - testing::smoothRadiance(d)), 0.03f);
    // Around the edges of the lower face the light is that of y = -1/√2 or less, in the mean over all directions.
    const glm::vec3 bottom = loaded->environment.radiance({0, -1, 0});
    EXPECT_EQ(bottom, loaded->environment.radiance(glm::normalize(glm::vec3(0.2f, -1.0f, 0.3f)))) << "one colour";
    EXPECT_NEAR(bottom.y, 1.0f - 0.6f * 0.66f, 0.05f);
  }
  EXPECT_THAT(loadEnvironment(path("sky_dn.exr")).error().message, HasSubstr("without sky_dn.exr"));
  fs::remove(path("sky_ft.exr"));
  EXPECT_THAT(loadEnvironment(path("sky_up.exr")).error().message, HasSubstr("without sky_dn.exr and sky_ft.exr"));
}

TEST_F(CubeFilesTest, AMissingSideIsRefused) {
  writeSky();
  fs::remove(path("sky_rt.exr"));
  EXPECT_THAT(loadEnvironment(path("sky_up.exr")).error().message, HasSubstr("without sky_rt.exr"));
  EXPECT_THAT(loadEnvironment(folder_.string()).error().message, HasSubstr("holds 5 of the six files of a cube"));
}

TEST_F(CubeFilesTest, SidesOfHalfAHeightAreTheUpperHalves) {
  writeSky();
  for (const char* side : {"rt", "lf", "ft", "bk"}) {
    const std::string file = path(std::string("sky_") + side + ".exr");
    const Image whole = readImage(file)->image;
    Image half(kSide, kSide / 2, 3);
    for (int y = 0; y < kSide / 2; ++y) std::copy_n(whole.texel(0, y), 3 * kSide, half.texel(0, y));
    ASSERT_TRUE(writeImage(file, half));
  }
  const auto loaded = loadEnvironment(path("sky_up.exr"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->oddities, ElementsAre("sky_rt.exr, sky_lf.exr, sky_ft.exr and sky_bk.exr are 64x32: taken as the "
                                            "upper half of faces, below which their last rows go on"));
  for (const glm::vec3 d : testing::manyDirections(200))
    if (d.y > 0.02f) EXPECT_LT(glm::length(loaded->environment.radiance(d) - testing::smoothRadiance(d)), 0.03f);
  const glm::vec3 below = glm::normalize(glm::vec3(0.0f, -0.7f, 1.0f));
  EXPECT_LT(glm::length(loaded->environment.radiance(below) - testing::smoothRadiance({0, 0, 1})), 0.03f);

  ASSERT_TRUE(writeImage(path("sky_up.exr"), Image(kSide, kSide / 2, 3)));
  EXPECT_THAT(loadEnvironment(path("sky_ft.exr")).error().message,
              StartsWith(path("sky_up.exr: is 64x32, and the six faces")));
}

TEST_F(CubeFilesTest, SixNumberedPanoramasAreSeenByTheirHeaders) {
  std::vector<std::string> names{"a.exr", "a.hdr", "a.png"};
  if (isInThisBuild(formatOf(ImageFormatId::jpeg))) names.emplace_back("a.jpg");
  for (const std::string& name : names) {
    ASSERT_TRUE(writeImage(path(name), Image(48, 24, 3, 0.5f)));
    EXPECT_EQ(sizeInHeader(path(name)), glm::ivec2(48, 24)) << name;
  }
  Bytes damaged = *readFile(path("a.hdr"));
  damaged.back() = 0;
  damaged[damaged.size() - 2] = 0;  // a run of no bytes
  ASSERT_TRUE(writeFile(path("a.hdr"), damaged));
  EXPECT_FALSE(readImage(path("a.hdr")));
  EXPECT_EQ(sizeInHeader(path("a.hdr")), glm::ivec2(48, 24)) << "what follows the header is not read";
  EXPECT_EQ(sizeInHeader(path("none.png")), std::nullopt);
  for (const std::string& name : names) {
    fs::resize_file(path(name), 10);
    EXPECT_EQ(sizeInHeader(path(name)), std::nullopt) << name;
  }
  for (int number = 0; number < 6; ++number)
    ASSERT_TRUE(writeImage(path("pano_" + std::to_string(number) + ".png"), Image(32, 16, 3, 0.1f * float(number))));
  const auto loaded = loadEnvironment(path("pano_3.png"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_THAT(loaded->files, ElementsAre(path("pano_3.png")));
  EXPECT_EQ(loaded->recognition->form.projection, Projection::equirect);
}

}  // namespace
}  // namespace mirrorball
