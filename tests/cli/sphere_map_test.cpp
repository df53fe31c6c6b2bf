// What the whole program must hold: a mirror sphere is the sphere map, and white light stays white.

#include <string>

#include "cli/cli_testing.h"
#include "cli/measure.h"

namespace mirrorball::testing {
namespace {

class SphereMapCliTest : public RenderCliTest {
 protected:
  /// The picture of a mirror sphere against the sphere map that `convert` writes, tone mapped, r² < 0.9 [dB].
  double psnrOfMirrorSphere(const std::string& environment) const {
    succeed("render sphere --material mirror --orthographic 2 --camera 0,0 --size 512x512 -o a.exr -e " + environment);
    succeed("convert " + environment + " --to sphere --size 512 -o b.exr");
    return psnrOnDisplay(image("a.exr"), image("b.exr"), [](int x, int y) {
      const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / 256.0f - 1.0f;
      return glm::dot(p, p) < 0.9f;
    });
  }
};

// The renderer interpolates twice, once from the panorama into a cube of half floats and once out of it; `convert`
// reads the panorama itself. With one sample a pixel that leaves 66 dB of this panorama. A picture that is half a pixel
// beside the other has 44.5 dB: below 45 dB it would be another picture.
TEST_F(SphereMapCliTest, AMirrorSphereInARealRoomIsItsSphereMap) {
  if (!share("lightroom_14b.hdr")) GTEST_SKIP() << "lightroom_14b.hdr is not there";
  const double psnr = psnrOfMirrorSphere("lightroom_14b.hdr");
  RecordProperty("psnr_db", std::to_string(psnr));
  EXPECT_GE(psnr, 45.0);
}

// The studio's lamps are brighter: 58.0 dB were measured, one sample a pixel leaves 53.2,
// and an eighth of a pixel's shift 47.9.
TEST_F(SphereMapCliTest, AMirrorSphereInTheStudioIsItsSphereMap) {
  const double psnr = psnrOfMirrorSphere("studio");
  RecordProperty("psnr_db", std::to_string(psnr));
  EXPECT_GE(psnr, 50.0);
}

TEST_F(SphereMapCliTest, WhiteLightStaysWhite) {
  for (const std::string surface : {"--material mirror", "--set base_color=1 --set specular=0",
                                    "--set base_color=1 --set perceptual_roughness=0.5"}) {
    succeed("render sphere -e white --size 64x64 --background transparent -o furnace.exr " + surface);
    const Image picture = image("furnace.exr");
    int whole = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const glm::vec4 texel = rgbaAt(picture, x, y);
        whole += texel.w == 1.0f;
        // Premultiplied: where the sphere covers a part of a pixel, that part of 1.
        for (int channel = 0; channel < 3; ++channel)
          ASSERT_NEAR(texel[channel], texel.w, 1e-3f * texel.w) << surface << " at " << x << ", " << y;
      }
    EXPECT_GT(whole, 1500) << surface;
  }
}

}  // namespace
}  // namespace mirrorball::testing
