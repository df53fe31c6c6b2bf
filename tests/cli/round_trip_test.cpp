// Panorama → another form → panorama, each step through a file and a run of the program of its own.

#include <algorithm>
#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball::testing {
namespace {

bool everywhere(glm::vec3) { return true; }

/// A sphere map shows the directions with r² = (1 − z) / 2 ≥ 0.9, a tenth of the sphere, 4π/10 = 1.26 sr around −Z, in
/// a rim where a texel spans ever more of them; they are left out.
bool beforeTheRim(glm::vec3 d) { return (1.0f - d.z) / 2.0f < 0.9f; }

/// The studio as a panorama of 256 rows, and how near to it what came back is, as a display shows both [dB].
///
/// Its lamps have edges of two texels, which each of the two interpolations softens; that is what the floors allow, a
/// decibel or two below what was measured. A panorama that is turned by half a texel has 35.2 dB.
class RoundTripTest : public CliTest {
 protected:
  void SetUp() override { succeed("convert studio --to equirect --size 256 -o original.exr"); }

  double psnr(const std::string& file, bool (*counts)(glm::vec3)) {
    const Environment again = displayed(environment(file).environment);
    const Environment original = displayed(environment("original.exr").environment);
    const double decibels = testing::psnr(again, original, counts);
    RecordProperty("psnr_db", std::to_string(decibels));
    return decibels;
  }
};

TEST_F(RoundTripTest, ThroughACube) {
  for (const std::string between : {"cube.exr", "cube.hdr", "cube.exr --format half"}) {
    succeed("convert original.exr --to cube --size 256 -o " + between);
    succeed("convert " + between.substr(0, 8) + " --to equirect --size 256 -o again.exr");
    EXPECT_GT(psnr("again.exr", everywhere), 42.0) << between;
  }
}

TEST_F(RoundTripTest, ThroughASphereMap) {
  for (const std::string between : {"ball.exr", "ball.hdr", "ball.exr --format half"}) {
    succeed("convert original.exr --to sphere --size 512 -o " + between);
    succeed("convert " + between.substr(0, 8) + " --to equirect --size 256 -o again.exr");
    EXPECT_GT(psnr("again.exr", beforeTheRim), 39.5) << between;
  }
}

TEST_F(RoundTripTest, ThroughAnAngularMap) {
  succeed("convert original.exr --to angular --size 512 -o probe.exr");
  succeed("convert probe.exr --to equirect --size 256 -o again.exr");
  EXPECT_GT(psnr("again.exr", everywhere), 41.0);
}

// A layout moves texels about and does nothing else, so all of them come back as the same file.
TEST_F(RoundTripTest, EveryCubeLayoutComesBackTheSame) {
  succeed("convert original.exr --to cube --size 64 -o hcross.exr");
  succeed("convert hcross.exr --to equirect --size 64 -o through_hcross.exr");
  for (const std::string layout : {"vcross", "hstrip", "vstrip", "3x2", "faces"}) {
    succeed("convert original.exr --to cube --size 64 -o " + layout + ".exr --layout " + layout);
    const std::string input = layout == "faces" ? "faces_pz.exr" : layout + ".exr";
    succeed("convert " + input + " --to equirect --size 64 -o through_" + layout + ".exr");
    EXPECT_TRUE(bytes("through_" + layout + ".exr") == bytes("through_hcross.exr")) << layout;
  }
}

TEST_F(RoundTripTest, TheSamePanoramaAgainIsTheSameFile) {
  succeed("convert original.exr --to equirect -o again.exr");
  // A float's angles put a place 10⁻⁵ of a texel beside its centre, where a lamp's edge falls by 9 from texel to texel.
  EXPECT_LT(maxDifference(image("again.exr"), image("original.exr")), 3e-4);
}

// What each file can hold of light: 32-bit floats all, halves 11 bits, RGBE 8 bits of the greatest channel,
// half a step of which is at most 1/255 of it.
TEST_F(RoundTripTest, FilesKeepTheirPrecision) {
  succeed("convert original.exr --to cube --size 32 -o float.exr");
  succeed("convert original.exr --to cube --size 32 -o half.exr --format half");
  succeed("convert original.exr --to cube --size 32 -o rgbe.hdr");
  EXPECT_LT(bytes("half.exr").size(), bytes("float.exr").size());
  const Image exact = image("float.exr");
  const Image half = image("half.exr");
  const Image rgbe = image("rgbe.hdr");
  for (int y = 0; y < exact.height(); ++y)
    for (int x = 0; x < exact.width(); ++x) {
      const glm::vec3 light = rgbAt(exact, x, y);
      const float max = std::max({light.x, light.y, light.z});
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(rgbAt(half, x, y)[channel], light[channel], light[channel] / 2048.0f);
        EXPECT_NEAR(rgbAt(rgbe, x, y)[channel], light[channel], max / 255.0f);
      }
    }
}

TEST_F(RoundTripTest, HalfFloatsClipWhatTheyCannotHold) {
  write("bright.exr", Image(4, 2, 3, 1e6f));
  EXPECT_THAT(run("convert bright.exr --to equirect --format half -o half.exr").err,
              ::testing::HasSubstr("93 % of the light is lost"));
  const Image half = image("half.exr");
  for (const float sample : half.samples()) EXPECT_EQ(sample, 65504.0f);
}

// A PNG keeps colours of [0, 1] to half a step of its 8 bits, and is read as it was written.
TEST_F(RoundTripTest, APngIsReadAsItWasWritten) {
  succeed("convert uv --to equirect --size 64 -o uv.exr");
  succeed("convert uv --to equirect --size 64 -o uv.png");
  // The steepest part of sRGB's curve, at white, makes a step of 1/255 a difference of 2.3/255 in light.
  EXPECT_LT(maxDifference(image("uv.png"), image("uv.exr")), 0.5 * 2.3 / 255.0);
  succeed("convert uv.png --to equirect -o again.png");
  EXPECT_EQ(maxDifference(image("uv.png"), image("again.png")), 0.0);
}

}  // namespace
}  // namespace mirrorball::testing
