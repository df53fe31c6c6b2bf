// Panoramas that their file, or --from, says are a part, tilted or nearly 2:1: what `convert` and `info` make of them.

#include <algorithm>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/cli_testing.h"
#include "cli/photo_sphere_testing.h"
#include "mirrorball/codec/ldr/jxl_testing.h"
#include "mirrorball/codec/ldr/png_testing.h"
#include "mirrorball/codec/ldr/webp_testing.h"
#include "mirrorball/codec/tiff/tiff_testing.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHalf = croppedArea("128", "64", "256", "128", "512", "256");
const std::string kStrip = croppedArea("0", "64", "512", "128", "512", "256");

/// Light between 0.1 and 0.9 that tells every direction from every other.
glm::vec3 lightTowards(glm::vec3 direction) { return 0.5f + 0.4f * direction; }

/// The texels of a panorama of 512 × 256 from `corner` on.
Image partOfPanorama(glm::ivec2 corner, glm::ivec2 size) {
  Image picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec2 uv = (glm::vec2(corner + glm::ivec2(x, y)) + 0.5f) / glm::vec2(512.0f, 256.0f);
      const glm::vec3 light = lightTowards(directionAt(Projection::equirect, {0, uv}));
      std::copy_n(&light.x, 3, picture.texel(x, y));
    }
  return picture;
}

/// The middle quarter, which is 2:1 by itself, and a strip of the whole circle, 4:1.
class PhotoSphereTest : public CliTest {
 protected:
  PhotoSphereTest() {
    write("part.jpg", partOfPanorama({128, 64}, {256, 128}));
    write("strip.jpg", partOfPanorama({0, 64}, {512, 128}));
    write("half.jpg", asPhotoSphere(bytes("part.jpg"), kHalf));
    write("ring.jpg", asPhotoSphere(bytes("strip.jpg"), kStrip));
  }

  /// The light of a map towards a direction.
  glm::vec3 lightIn(const std::string& name, glm::vec3 direction) const {
    return environment(name).environment.radiance(glm::normalize(direction));
  }

  /// Whether a map has the panorama's light there, as far as 8 bits have it.
  void expectLight(const std::string& name, glm::vec3 direction, glm::vec3 expected) const {
    const glm::vec3 found = lightIn(name, direction);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 0.02f) << name << " channel " << c;
  }
  void expectPanorama(const std::string& name, glm::vec3 direction) const {
    expectLight(name, direction, lightTowards(glm::normalize(direction)));
  }
};

TEST_F(PhotoSphereTest, APartIsInItsPlaceAndTheRestIsBlack) {
  const Outcome outcome = run("convert half.jpg --to equirect -o half.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(
      outcome.err,
      HasSubstr("note: half.jpg: holds 180 x 90 degrees of a panorama, as its GPano says: the rest of the sphere "
                "is black, and lights nothing; --from equirect:fill=smooth continues the picture into it, --from "
                "equirect:crop=none takes the picture as the whole\n"));
  EXPECT_EQ(image("half.exr").width(), 512);
  EXPECT_EQ(image("half.exr").height(), 256);
  for (const glm::vec3 seen : {glm::vec3(0, 0, 1), glm::vec3(-1, 0, 1), glm::vec3(1, 0.5, 1)})
    expectPanorama("half.exr", seen);
  for (const glm::vec3 unseen : {glm::vec3(0, 0.01, -1), glm::vec3(0, 1, 0.01), glm::vec3(-1, 0, -1)})
    EXPECT_EQ(lightIn("half.exr", unseen), glm::vec3(0.0f));
  succeed("convert half.jpg --from equirect:fill=black --to cube --size 64 -o cube.ktx2");
  expectPanorama("cube.ktx2", {0, 0, 1});
  EXPECT_EQ(lightIn("cube.ktx2", {0, 0, -1}), glm::vec3(0.0f));
}

TEST_F(PhotoSphereTest, AStripOfTheWholeCircleIsOne) {
  EXPECT_EQ(run("convert ring.jpg --to equirect -o ring.exr").exit_code, 0);
  for (const glm::vec3 seen : {glm::vec3(0, 0, 1), glm::vec3(0.01, 0, -1), glm::vec3(1, 0.5, -1)})
    expectPanorama("ring.exr", seen);
  EXPECT_EQ(lightIn("ring.exr", {0, 1, 0.01}), glm::vec3(0.0f));
  EXPECT_THAT(refuse(1, "convert strip.jpg --to equirect -o none.exr"),
              AllOf(HasSubstr("equirect:fov=HxV"), HasSubstr("equirect:crop=X,Y,W,H/FULLWxFULLH")));
}

TEST_F(PhotoSphereTest, ItsPacketIsReadInEveryFormat) {
  const Image part = partOfPanorama({128, 64}, {256, 128});
  const std::string packet = packetWith(kHalf);
  write("plain.png", part);
  const std::string keyword("XML:com.adobe.xmp\0", 18);
  write("half.png", withPngChunk(bytes("plain.png"), "iTXt", keyword + std::string(4, '\0') + packet));
  const Bytes zipped =
      withPngChunk(bytes("plain.png"), "iTXt", keyword + std::string("\1\0\0\0", 4) + deflated(packet));
  write("zipped.png", zipped);
  const std::string raw_profile = "Raw profile type xmp" + std::string(2, '\0') + deflated(rawProfile("xmp", packet));
  write("digits.png", withPngChunk(bytes("plain.png"), "zTXt", raw_profile));
  write("half.exr", part, {{"mirrorball:xmp", packet}});
  Image8 picture(256, 128, 3);
  std::fill(picture.samples().begin(), picture.samples().end(), std::uint8_t{128});
  write("half.webp", extendedWebp(picture, 0x04, "XMP ", Bytes(packet.begin(), packet.end())));
  write("half.tif", tiffFile({{TiffForm{.width = 256, .height = 128, .xmp = packet}, Bytes(256 * 128 * 3, 128)}}));
  write("half.jxl", jxlFile(picture, {.xmp = packet}));
  for (const std::string name :
       {"half.png", "zipped.png", "digits.png", "half.exr", "half.webp", "half.tif", "half.jxl"}) {
    succeed("convert " + name + " --from equirect:fill=black --to equirect -o " + name + ".hdr");
    EXPECT_EQ(image(name + ".hdr").width(), 512) << name;
    EXPECT_GT(lightIn(name + ".hdr", {0, 0, 1}).y, 0.1f) << name;
    EXPECT_EQ(lightIn(name + ".hdr", {0, 0.01, -1}), glm::vec3(0.0f)) << name;
  }
  expectPanorama("half.png.hdr", {-1, 0.3, 1});
}

TEST_F(PhotoSphereTest, InfoSaysWhatIsCovered) {
  EXPECT_THAT(run("info half.jpg").out,
              AllOf(HasSubstr("  size         256x128\n"), HasSubstr("equirect (recognised by its GPano)"),
                    HasSubstr("  covers       35.355 % of the sphere: 180 x 90 degrees, at (128, 64) of 512x256 (its "
                              "GPano)\n")));
  const nlohmann::json json = nlohmann::json::parse(run("info --json half.jpg").out);
  EXPECT_NEAR(json["covered"].get<double>(), std::sqrt(0.125), 1e-6);
  EXPECT_EQ(json["window"]["corner"], (nlohmann::json{128, 64}));
  EXPECT_EQ(json["window"]["size"], (nlohmann::json{256, 128}));
  EXPECT_EQ(json["window"]["whole"], (nlohmann::json{512, 256}));
  EXPECT_THAT(run("info part.jpg").out, Not(HasSubstr("covers")));
}

TEST_F(PhotoSphereTest, TheRestIsContinuedWhereThatIsAskedFor) {
  succeed("convert half.jpg --from equirect:fill=smooth --to equirect -o filled.exr");
  expectPanorama("filled.exr", {0, 0, 1});
  const glm::vec3 zenith = lightIn("filled.exr", {0, 1, 0.01});
  EXPECT_GT(zenith.y, lightIn("filled.exr", {0, -1, 0.01}).y + 0.2f) << "brighter above, as at the upper edge";
  EXPECT_GT(lightIn("filled.exr", {0, 0, -1}).y, 0.3f);
  EXPECT_LT(lightIn("filled.exr", {0, 0, -1}).y, 0.7f);
}

TEST_F(PhotoSphereTest, APartThatTheFileDoesNotStateIsNamed) {
  succeed("convert part.jpg --from equirect:crop=128,64,256,128/512x256,fill=black --to equirect -o crop.exr");
  succeed("convert strip.jpg --from equirect:fov=360x90,fill=black --to equirect -o fov.exr");
  expectPanorama("crop.exr", {-1, 0, 1});
  EXPECT_EQ(lightIn("crop.exr", {0, 0.01, -1}), glm::vec3(0.0f));
  expectPanorama("fov.exr", {-1, 0.2, -1});
  // Half of the size, with the same words.
  write("small.exr", Image(128, 64, 3, 0.5f));
  succeed("convert small.exr --from equirect:crop=128,64,256,128/512x256,fill=black -o small_whole.exr");
  EXPECT_EQ(image("small_whole.exr").width(), 256);
  EXPECT_THAT(run("convert part.jpg --from equirect:fov=180x90 -o noted.exr").err,
              HasSubstr("the word fill=smooth behind its crop or fov"));
  succeed("convert half.jpg --from equirect:crop=none -o whole.exr");
  EXPECT_EQ(image("whole.exr").width(), 256);
  EXPECT_THAT(refuse(2, "convert part.jpg --from equirect:crop=128,200,256,128/512x256 -o none.exr"),
              HasSubstr("reaches beyond a panorama of 512x256"));
  EXPECT_THAT(refuse(2, "convert part.jpg --from equirect:fov=400x90 -o none.exr"), HasSubstr("at most 360x180"));
  EXPECT_THAT(refuse(1, "convert part.jpg --from equirect:fov=360x90 -o none.exr"),
              HasSubstr("is 256x128, and 360 x 90 degrees of a panorama are 4:1"));
  EXPECT_THAT(refuse(2, "convert part.jpg --from sphere:fov=360x90 -o none.exr"), HasSubstr("takes no parameters"));
}

// A camera that looks up by 30 degrees has the horizon that far below the middle; one that is rolled clockwise sees
// what is on its right higher than it is.
TEST_F(PhotoSphereTest, ATiltedPanoramaIsLevelled) {
  const auto tilted = [&](const std::string& name, glm::vec3 place, const std::string& attributes) {
    Image picture(512, 256, 3, 0.1f);
    const glm::vec2 uv = positionOf(Projection::equirect, glm::normalize(place)).uv;
    const glm::ivec2 middle(uv * glm::vec2(512.0f, 256.0f));
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) std::fill_n(picture.texel(middle.x + x, middle.y + y), 3, 1.0f);
    write("plain.jpg", picture);
    write(name, asPhotoSphere(bytes("plain.jpg"), "GPano:ProjectionType=\"equirectangular\" " + attributes));
  };
  const float tilt = glm::radians(30.0f);
  tilted("up.jpg", {0.0f, -std::sin(tilt), std::cos(tilt)}, "GPano:PosePitchDegrees=\"30\"");
  const Outcome outcome = run("convert up.jpg -o up.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("note: up.jpg: was taken with the camera tilted, as its GPano says (pitch 30, roll 0 "
                        "degrees): levelled; --from equirect:level=no leaves it as it is"));
  EXPECT_GT(lightIn("up.exr", {0, 0, 1}).x, 0.9f) << "a light of the horizon";
  succeed("convert up.jpg --from equirect:level=no -o as_it_is.exr");
  EXPECT_LT(lightIn("as_it_is.exr", {0, 0, 1}).x, 0.2f);

  // −X is on the right of the middle.
  tilted("rolled.jpg", {-std::cos(tilt), std::sin(tilt), 0.0f}, "GPano:PoseRollDegrees=\"30\"");
  EXPECT_EQ(run("convert rolled.jpg -o rolled.exr").exit_code, 0);
  EXPECT_GT(lightIn("rolled.exr", {-1, 0, 0}).x, 0.9f);
}

TEST_F(PhotoSphereTest, OtherProjectionsAreNamedAndNothingIsGuessed) {
  write("cylinder.jpg", asPhotoSphere(bytes("part.jpg"), "GPano:ProjectionType=\"cylindrical\""));
  EXPECT_THAT(refuse(1, "convert cylinder.jpg -o none.exr"),
              AllOf(HasSubstr("cylinder.jpg: is a panorama in the projection 'cylindrical', as its GPano says"),
                    HasSubstr("or name its form with --from")));
  write("wrong.jpg", asPhotoSphere(bytes("part.jpg"), croppedArea("128", "200", "256", "128", "512", "256")));
  EXPECT_THAT(run("convert wrong.jpg -o wrong.exr").err,
              AllOf(HasSubstr("which reaches beyond a panorama of 512x256: that crop is ignored"),
                    HasSubstr("--from equirect:crop=X,Y,W,H/FULLWxFULLH says it by hand")));
  EXPECT_EQ(image("wrong.exr").width(), 256);
}

TEST_F(PhotoSphereTest, NearlyTwoToOneIsAPanorama) {
  write("odd.exr", Image(256, 127, 3, 0.5f));
  const Outcome outcome = run("convert odd.exr --to equirect -o even.exr");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err,
              HasSubstr("note: odd.exr: is nearly 2:1, 256x127: taken as a whole panorama, resampled to 256x128"));
  const Image even = image("even.exr");
  EXPECT_EQ(even.height(), 128);
  for (const float sample : even.samples()) ASSERT_NEAR(sample, 0.5f, 1e-4f);
  EXPECT_THAT(run("info odd.exr").out, HasSubstr("equirect (recognised by its shape, nearly 2:1)"));
}

}  // namespace
}  // namespace mirrorball::testing
