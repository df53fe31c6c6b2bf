// Pictures of light by exposure and tone map, as thumbnails of panoramas are made.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/codec/color/srgb.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ConvertDisplayTest : public CliTest {
 protected:
  ConvertDisplayTest() { write("map.exr", smoothPanoramaWithLamp()); }

  /// The codes of a picture whose light is in a file of radiance.
  static Image8 shown(Image radiance, const Display& display) {
    showOn(display, radiance);
    return pictureFromLinear(radiance, radiance.channels());
  }

  Image8 codes(const std::string& file) const { return *decodeTexture(bytes(file)); }

  /// How many texels' codes differ, alpha too.
  static int differences(const Image8& a, const Image8& b) {
    int count = a.width() == b.width() && a.height() == b.height() ? 0 : 1;
    for (int y = 0; y < a.height() && count == 0; ++y)
      for (int x = 0; x < a.width(); ++x) {
        const int channels = std::min(a.channels(), b.channels());
        count += !std::equal(a.texel(x, y), a.texel(x, y) + channels, b.texel(x, y));
      }
    return count;
  }
};

TEST_F(ConvertDisplayTest, AGainMapHoldsTheLightBesideItsPicture) {
  const Image light = image("map.exr");
  for (const std::string display : {"", " --tone-map aces"}) {
    succeed("convert map.exr" + display + " -o plain.jpg");
    succeed("convert map.exr --gain-map" + display + " -o room.jpg");
    EXPECT_EQ(differences(codes("room.jpg"), codes("plain.jpg")), 0) << "other readers show the same picture";
    const Image back = image("room.jpg");
    EXPECT_NEAR(back.texel(20, 8)[1], 1e5f, 1.2e4f) << "the sun";
    double error = 0.0;
    for (int y = light.height() / 2; y < light.height(); ++y)
      for (int x = 0; x < light.width(); ++x) error += std::abs(back.texel(x, y)[1] / light.texel(x, y)[1] - 1.0f);
    EXPECT_LT(error / (light.width() * light.height() / 2), 0.03);
  }
  EXPECT_THAT(succeed("info room.jpg"), HasSubstr("gain map of"));
  succeed("convert room.jpg --to cube --size 16 -o cube.ktx2");
  EXPECT_THAT(succeed("compare room.jpg map.exr"), Not(HasSubstr("sRGB")));
  succeed("convert map.exr --gain-map --to cube --layout faces --size 8 -o six.jpg");
  EXPECT_GT(image("six_px.jpg").width(), 0);
  succeed("convert map.exr --gain-map --exposure 1 -o brighter.jpg");
  EXPECT_NEAR(image("brighter.jpg").texel(5, 25)[1], 2.0f * light.texel(5, 25)[1], 0.1f * light.texel(5, 25)[1]);
}

TEST_F(ConvertDisplayTest, OnlyAJpegHasAGainMap) {
  for (const std::string file : {"a.png", "a.exr", "a.ktx2"})
    EXPECT_THAT(refuse(2, "convert map.exr --gain-map -o " + file),
                HasSubstr(file + ": has no gain map beside its picture; write .jpg"));
}

TEST_F(ConvertDisplayTest, ALostGainMapIsRemarkedOn) {
  succeed("convert map.exr --gain-map -o room.jpg");
  const Bytes whole = bytes("room.jpg");
  constexpr std::array<std::uint8_t, 3> kBegin{0xff, 0xd8, 0xff};
  const auto map = std::find_end(whole.begin(), whole.end(), kBegin.begin(), kBegin.end());
  write("cut.jpg", Bytes(whole.begin(), map));
  EXPECT_THAT(run("convert cut.jpg -o cut.hdr").err, HasSubstr("cut.jpg: says that it has a gain map, and has lost"));
}

TEST_F(ConvertDisplayTest, APictureIsWhatADisplayShowsOfTheRadianceInEveryForm) {
  const Display display{1.0f, ToneMap::aces};
  for (const std::string form :
       {"equirect", "cube --layout vcross", "cube --layout hstrip --as-seen", "sphere", "angular", "ball:distance=3",
        "paraboloid", "octahedral", "equal-area", "eac", "equirect --for unity"}) {
    const std::string line = "convert map.exr --size 16 --to " + form;
    succeed(line + " -o light.exr");
    succeed(line + " -o shown.png --exposure 1 --tone-map aces");
    EXPECT_EQ(differences(shown(image("light.exr"), display), codes("shown.png")), 0) << form;
  }
  succeed("convert map.exr --size 16 --to cube --layout faces -o light.exr");
  succeed("convert map.exr --size 16 --to cube --layout faces -o shown.png --exposure 1 --tone-map aces");
  for (const char* face : {"_px", "_nx", "_py", "_ny", "_pz", "_nz"})
    EXPECT_EQ(differences(shown(image(std::string("light") + face + ".exr"), display),
                          codes(std::string("shown") + face + ".png")),
              0)
        << face;
}

TEST_F(ConvertDisplayTest, EveryCurveIsRenders) {
  const std::vector<std::string> names{"agx", "aces", "neutral", "reinhard", "linear"};
  for (std::size_t curve = 0; curve < names.size(); ++curve) {
    succeed("convert map.exr -o shown.png --exposure -0.5 --tone-map " + names[curve]);
    const Display display{-0.5f, static_cast<ToneMap>(curve)};
    EXPECT_EQ(differences(shown(image("map.exr"), display), codes("shown.png")), 0) << names[curve];
  }
}

TEST_F(ConvertDisplayTest, WithoutThemLightIsClippedAsEver) {
  for (const std::string file : {"a.png", "a.jpg"}) {
    succeed("convert map.exr -o " + file);
    succeed("convert map.exr --exposure 0 --tone-map linear -o told_" + file);
    EXPECT_TRUE(bytes(file) == bytes("told_" + file)) << file;
  }
  EXPECT_EQ(differences(pictureFromLinear(image("map.exr"), 3), codes("a.png")), 0);
}

// Beside a disc a map is transparent, whatever a curve makes of black.
TEST_F(ConvertDisplayTest, BesideADiscIsNothing) {
  succeed("convert map.exr --to sphere --size 16 --exposure 4 --tone-map agx -o ball.png");
  EXPECT_EQ(rgbaAt(image("ball.png"), 0, 0), glm::vec4(0.0f));
  EXPECT_EQ(rgbaAt(image("ball.png"), 8, 8).w, 1.0f);
}

// A sun of 10⁵ on light of about 1: its surroundings are as bright as they are without it, and nothing is black.
TEST_F(ConvertDisplayTest, ASunHasNoRing) {
  write("dull.exr", smoothPanorama());
  for (const std::string name : {"map", "dull"})
    succeed("convert " + name + ".exr --size 128 --exposure 2 --tone-map aces -o " + name + ".png");
  const Image with = image("map.png");
  const Image without = image("dull.png");
  int white = 0;
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x) {
      const glm::vec3 less = rgbAt(without, x, y) - rgbAt(with, x, y);
      EXPECT_LT(std::max({less.x, less.y, less.z}), 0.05f) << x << " " << y;
      const glm::vec3 light = rgbAt(with, x, y);
      white += std::min({light.x, light.y, light.z}) > 0.99f;
    }
  EXPECT_GE(white, 16) << "the sun's texel is 4 x 4";
}

TEST_F(ConvertDisplayTest, NoExposureIsTooMuch) {
  for (const std::string curve : {"agx", "aces", "neutral", "reinhard", "linear"}) {
    succeed("convert map.exr --exposure 30 --scale-light 1e30 --tone-map " + curve + " -o white.png");
    const Image white = image("white.png");
    for (const float sample : white.samples()) ASSERT_GT(sample, 0.9f) << curve;
    succeed("convert map.exr --exposure -30 --scale-light 1e-20 --tone-map " + curve + " -o black.png");
    const Image black = image("black.png");
    for (const float sample : black.samples()) ASSERT_LT(sample, 0.01f) << curve;
  }
}

TEST_F(ConvertDisplayTest, BadTexelsAreRefusedOrMended) {
  Image bad = smoothPanorama();
  bad.texel(3, 3)[1] = std::numeric_limits<float>::quiet_NaN();
  write("bad.exr", bad);
  EXPECT_THAT(refuse(1, "convert bad.exr --tone-map aces -o a.png"), HasSubstr("--repair"));
  succeed("convert bad.exr --tone-map aces --repair -o a.png");
  EXPECT_GT(rgbAt(image("a.png"), 3, 3).y, 0.01f);
}

TEST_F(ConvertDisplayTest, ByRowsTheSame) {
  succeed("convert map.exr --tone-map agx --exposure 1 -o whole.png");
  succeed("convert map.exr --tone-map agx --exposure 1 --max-memory 1M -o rows.png");
  EXPECT_TRUE(bytes("rows.png") == bytes("whole.png"));
}

TEST_F(ConvertDisplayTest, OfManyAndOnStandardOutput) {
  succeed("convert map.exr --size 8 --tone-map aces -o one.png");
  const std::string piped = succeed("convert map.exr --size 8 --tone-map aces -o -.png");
  EXPECT_TRUE(Bytes(piped.begin(), piped.end()) == bytes("one.png"));
  write("other.exr", smoothPanorama());
  succeed("convert map.exr other.exr --size 8 --tone-map aces --extension png -o previews/");
  EXPECT_TRUE(bytes("previews/map.png") == bytes("one.png"));
  EXPECT_FALSE(bytes("previews/other.png") == bytes("one.png"));
}

// Where light stays light they would do nothing, and whoever gives them expects something.
TEST_F(ConvertDisplayTest, WhatHoldsLightIsToldWhatToDoInstead) {
  for (const std::string output : {"a.exr", "a.hdr", "a.ktx2", "a.dds"})
    for (const std::string to : {"", " --to cube"}) {
      EXPECT_THAT(refuse(2, "convert map.exr --exposure 1.5 -o " + output + to),
                  AllOf(StartsWith(output + ": holds light as it is"), HasSubstr("--exposure"),
                        HasSubstr(".png or .jpg"), HasSubstr("--scale-light 2.828427")));
      EXPECT_THAT(refuse(2, "convert map.exr --tone-map linear -o " + output + to), HasSubstr("--tone-map"));
      EXPECT_THAT(refuse(2, "convert map.exr --tone-map aces --exposure 0 -o " + output + to),
                  HasSubstr("--exposure and --tone-map"));
    }
  write("other.exr", smoothPanorama());
  EXPECT_THAT(refuse(2, "convert map.exr other.exr --extension hdr --exposure 1 -o out/"),
              AllOf(HasSubstr("out/map.hdr: "), HasSubstr("--scale-light 2")));
  EXPECT_THAT(files(), ElementsAre("map.exr", "other.exr"));
}

}  // namespace
}  // namespace mirrorball::testing
