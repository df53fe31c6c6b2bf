#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball {
namespace {

constexpr double kLeast_dB = 45.0;  // what is asked of pictures whose samples are drawn where they are needed

class SamplingTest : public gl::GlTest {
 protected:
  Renderer rendererOf(const char* model, const Environment& light) {
    return *testing::rendererOf(*loadModel(model), light, *testing::prepareOnce(light));
  }
  static Image8 pictureOf(Renderer& renderer, FrameSettings settings, Sampling sampling) {
    settings.sampling = sampling;
    auto picture = renderer.render(settings);
    EXPECT_TRUE(picture);
    return picture ? std::move(*picture) : Image8(settings.size.x, settings.size.y, 4);
  }
};

MIRRORBALL_WITH_BOTH_APIS(SamplingTest);

/// Of encoded values; infinite where all are the same.
double psnrOf(const Image8& a, const Image8& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.samples().size(); ++i) sum += std::pow(double(a.samples()[i]) - b.samples()[i], 2.0);
  return 10.0 * std::log10(255.0 * 255.0 * double(a.samples().size()) / sum);
}

std::vector<std::uint8_t> bytesOf(const Image8& picture) {
  return {picture.samples().begin(), picture.samples().end()};
}

FrameSettings smallFrame(int samples) { return {.size = {72, 48}, .samples = samples}; }

// A sun of 10⁵ of two degrees above, dim light elsewhere.
glm::vec3 sunny(glm::vec3 direction) {
  const bool is_sun = glm::dot(direction, glm::normalize(glm::vec3(1.0f, 1.0f, 1.0f))) > 0.9994f;
  return is_sun ? glm::vec3(1e5f) : glm::vec3(0.2f, 0.3f, 0.5f) + 0.2f * direction;
}

TEST_P(SamplingTest, OfSomePixelsIsAlmostThatOfAll) {
  const Environment light(sunny, 128);
  for (const char* model : {"teapot", "showcase", "knot"}) {
    Renderer renderer = rendererOf(model, light);
    for (const int samples : {4, 9}) {
      FrameSettings settings = smallFrame(samples);
      settings.behind = BehindKind::screen;
      settings.refraction = RefractionKind::automatic;
      const Image8 all = pictureOf(renderer, settings, Sampling::all);
      const Image8 some = pictureOf(renderer, settings, Sampling::adaptive);
      EXPECT_GT(psnrOf(some, all), kLeast_dB) << model << " with " << samples;
      EXPECT_NE(bytesOf(some), bytesOf(all)) << "no pixel was left out of " << model << " with " << samples;
    }
  }
}

TEST_P(SamplingTest, IsTheSameEachTimeAndAfterOtherFrames) {
  Renderer renderer = rendererOf("teapot", Environment(sunny, 128));
  const Image8 once = pictureOf(renderer, smallFrame(8), Sampling::adaptive);
  pictureOf(renderer, {.size = {40, 90}, .samples = 6}, Sampling::all);
  pictureOf(renderer, {.size = {40, 90}, .samples = 6}, Sampling::adaptive);
  EXPECT_EQ(bytesOf(pictureOf(renderer, smallFrame(8), Sampling::adaptive)), bytesOf(once));
}

TEST_P(SamplingTest, TakesAllSamplesOfRadianceAndOfFew) {
  Renderer renderer = rendererOf("teapot", Environment(sunny, 128));
  FrameSettings settings = smallFrame(16);
  settings.sampling = Sampling::adaptive;
  const auto some = renderer.renderRadiance(settings);
  settings.sampling = Sampling::all;
  const auto all = renderer.renderRadiance(settings);
  ASSERT_TRUE(some && all);
  EXPECT_TRUE(std::equal(some->samples().begin(), some->samples().end(), all->samples().begin(), all->samples().end()));
  for (const int samples : {1, 2, 3})
    EXPECT_EQ(bytesOf(pictureOf(renderer, smallFrame(samples), Sampling::adaptive)),
              bytesOf(pictureOf(renderer, smallFrame(samples), Sampling::all)));
}

/// What samples that are left out add to the change from one frame to the next, as a picture: 128 where there is none.
Image8 addedChange(const std::array<Image8, 2>& some, const std::array<Image8, 2>& all) {
  Image8 added = all[0];
  for (std::size_t i = 0; i < added.samples().size(); ++i) {
    const auto change = [&](const std::array<Image8, 2>& of) {
      return int(of[1].samples()[i]) - int(of[0].samples()[i]);
    };
    added.samples()[i] = static_cast<std::uint8_t>(std::clamp(128 + change(some) - change(all), 0, 255));
  }
  return added;
}

// A pixel that takes all samples in one frame and few in the next would flicker where nothing of the scene does.
TEST_P(SamplingTest, DoesNotShimmerWhileTheCameraMoves) {
  const Environment light(sunny, 128);
  for (const char* model : {"teapot", "showcase"}) {
    Renderer renderer = rendererOf(model, light);
    std::array<Image8, 2> some, all;
    for (int frame = 0; frame < 6; ++frame) {
      FrameSettings settings = smallFrame(4);
      settings.camera.azimuth_deg += 0.5f * static_cast<float>(frame);
      some = {std::move(some[1]), pictureOf(renderer, settings, Sampling::adaptive)};
      all = {std::move(all[1]), pictureOf(renderer, settings, Sampling::all)};
      if (frame == 0) continue;
      const Image8 added = addedChange(some, all);
      const Image8 still(added.width(), added.height(), 4, 128);
      EXPECT_GT(psnrOf(added, still), kLeast_dB) << model << " from frame " << frame - 1 << " to the next";
    }
  }
}

// Pixels that have finished count for as much as the others, whenever the picture is looked at.
TEST_P(SamplingTest, AnEvenPictureIsEvenAfterEachSample) {
  Renderer renderer = rendererOf("none", Environment([](glm::vec3) { return glm::vec3(0.25f, 0.5f, 0.75f); }, 16));
  FrameSettings settings = smallFrame(9);
  settings.sampling = Sampling::adaptive;
  ASSERT_TRUE(renderer.begin(settings));
  std::vector<std::uint8_t> first;
  while (!renderer.isDone()) {
    ASSERT_TRUE(renderer.drawSample());
    const auto picture = renderer.picture();
    ASSERT_TRUE(picture);
    const std::vector<std::uint8_t> shown = bytesOf(*picture);
    if (first.empty()) first = shown;
    EXPECT_EQ(shown, first);
  }
}

}  // namespace
}  // namespace mirrorball
