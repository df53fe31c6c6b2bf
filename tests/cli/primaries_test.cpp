// Files with other primaries than Rec.709's: what they state, what they hold, and which there are.

#include "mirrorball/codec/color/primaries.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/cli_testing.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/codec/color/srgb.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

struct Named {
  std::string option;
  OutputPrimaries primaries;
  std::string shown;  ///< by info
};

std::vector<Named> wider() {
  return {{"p3", OutputPrimaries::p3, "Display P3"},
          {"rec2020", OutputPrimaries::rec2020, "Rec.2020"},
          {"acescg", OutputPrimaries::acescg, "ACES AP1"}};
}

/// The greatest difference of two images' colours, in parts of the greatest channel of the texel.
float difference(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height()) return 1e9f;
  float greatest = 0.0f;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const glm::vec3 light = rgbAt(b, x, y);
      const float scale = std::max({std::abs(light.x), std::abs(light.y), std::abs(light.z), 1e-6f});
      for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(rgbAt(a, x, y)[c] - light[c]) / scale);
    }
  return greatest;
}

class ConvertPrimariesTest : public CliTest {
 protected:
  ConvertPrimariesTest() { write("map.exr", smoothPanoramaWithLamp()); }
};

TEST_F(ConvertPrimariesTest, LightIsStatedAndComesBackInEveryForm) {
  succeed("convert map.exr --to cube --size 16 -o map.ktx2 --format float32");
  for (const auto& [option, primaries, shown] : wider()) {
    for (const auto& [file, tolerance] :
         std::vector<std::pair<std::string, float>>{{"a.exr", 1e-6f}, {"a.hdr", 0.012f}}) {
      succeed("convert map.exr --primaries " + option + " -o " + file);
      EXPECT_LT(difference(image(file), image("map.exr")), tolerance) << option << " " << file;
      EXPECT_THAT(succeed("info " + file), HasSubstr("primaries of the file (" + shown + "): converted"));
    }
    for (const std::string way : {"", " --zstd 3"}) {  // by strips, and as a whole
      succeed("convert map.exr --to cube --size 16 --format float32 --primaries " + option + way + " -o a.ktx2");
      for (int face = 0; face < 6; ++face)
        EXPECT_LT(difference(texture("a.ktx2").at(0, face), texture("map.ktx2").at(0, face)), 1e-6f) << option << way;
      EXPECT_THAT(succeed("info a.ktx2"), HasSubstr("primaries of the file (" + shown + "): converted"));
    }
  }
  succeed("convert map.exr --primaries rec709 -o told.hdr");
  succeed("convert map.exr -o plain.hdr");
  EXPECT_TRUE(bytes("told.hdr") == bytes("plain.hdr"));
}

// P3's green and Rec.2020's are negative in Rec.709's red and blue, and are so no more in their own primaries.
TEST_F(ConvertPrimariesTest, ColoursBeyondRec709AreKept) {
  Image green(8, 4, 3);
  for (int i = 0; i < 32; ++i) green.texel(i % 8, i / 8)[1] = 0.5f;
  convertToRec709(green, kRec2020);
  ASSERT_LT(green.texel(0, 0)[0], -0.2f);
  write("green.exr", green);
  for (const std::string file : {"a.hdr", "a.png"}) {
    succeed("convert green.exr --primaries rec2020 -o " + file);
    EXPECT_LT(difference(image(file), green), 0.01f) << file;
  }
  for (const std::string format : {"b10g11r11", "bc6h"}) {
    const Outcome written = run("convert green.exr --primaries rec2020 --format " + format + " -o a.ktx2");
    EXPECT_EQ(written.err, "") << "nothing is negative";
    EXPECT_LT(difference(image("a.ktx2"), green), 0.02f) << format;
  }
  EXPECT_THAT(run("convert green.exr -o plain.hdr").err, HasSubstr("negative"));
}

TEST_F(ConvertPrimariesTest, APictureIsToneMappedBeforeItIsConverted) {
  const Display display{1.0f, ToneMap::aces};
  Image light = image("map.exr");
  showOn(display, light);
  convertFromRec709(light, OutputPrimaries::p3);
  succeed("convert map.exr --exposure 1 --tone-map aces --primaries p3 -o a.png");
  const Image8 codes = *decodeTexture(bytes("a.png"));
  const Image8 expected = pictureFromLinear(light, 3);
  int differing = 0;
  for (int y = 0; y < codes.height(); ++y)
    for (int x = 0; x < codes.width(); ++x)
      differing += !std::equal(expected.texel(x, y), expected.texel(x, y) + 3, codes.texel(x, y));
  EXPECT_EQ(differing, 0);
  EXPECT_THAT(succeed("info a.png"), HasSubstr("sRGB, primaries of the file (Display P3): converted"));
}

TEST_F(ConvertPrimariesTest, AChainKeepsItsLevels) {
  succeed("bake map.exr --size 16 --levels 3 --format float32 -o chain.ktx2");
  succeed("convert chain.ktx2 --mips --format float32 --primaries acescg -o wide.ktx2");
  for (int level = 0; level < 3; ++level)
    EXPECT_LT(difference(texture("wide.ktx2").at(level, 2), texture("chain.ktx2").at(level, 2)), 2e-6f) << level;
}

TEST_F(ConvertPrimariesTest, WhatCannotStateThemIsRefused) {
  for (const std::string file : {"a.jpg", "a.dds", "a.ktx"})
    EXPECT_THAT(refuse(2, "convert map.exr --to cube --primaries p3 -o " + file),
                HasSubstr(file + ": cannot state other primaries than Rec.709's; write .hdr, .exr, .png or .ktx2"));
  EXPECT_THAT(refuse(2, "convert map.exr --gain-map --primaries p3 -o a.jpg"), HasSubstr("cannot state other"));
  EXPECT_THAT(refuse(2, "convert map.exr --primaries acescg -o a.png"),
              HasSubstr("a.png: holds what a display shows, and ACEScg is linear light"));
  EXPECT_THAT(refuse(2, "convert map.exr --for three --primaries p3 -o a.exr"),
              HasSubstr("a.exr: a file for three.js has Rec.709's primaries"));
  EXPECT_THAT(refuse(2, "convert map.exr --primaries adobe -o a.exr"), HasSubstr("primaries"));
  succeed("convert map.exr --for openexr --primaries acescg -o a.exr");
  EXPECT_THAT(succeed("info a.exr"), HasSubstr("ACES AP1"));
  EXPECT_THAT(refuse(2, "bake map.exr --primaries p3 -o baked/"), HasSubstr("--primaries"));
}

class RenderPrimariesTest : public RenderCliTest {
 protected:
  const std::string gold_ = "render sphere --material gold --size 48x24 ";
};

TEST_F(RenderPrimariesTest, RadianceComesBack) {
  succeed(gold_ + "-o plain.exr");
  for (const auto& [option, primaries, shown] : wider()) {
    succeed(gold_ + "--primaries " + option + " -o wide.exr");
    EXPECT_LT(difference(image("wide.exr"), image("plain.exr")), 2e-6f) << option;
    EXPECT_THAT(succeed("info wide.exr"), HasSubstr(shown));
  }
}

TEST_F(RenderPrimariesTest, APictureShowsTheSameInAllPrimaries) {
  for (const std::string background : {"transparent", "#3080ff", "env"}) {
    succeed(gold_ + "--samples 16 --dither none --background " + background + " -o plain.png");
    for (const std::string option : {"p3", "rec2020"}) {
      succeed(gold_ + "--samples 16 --dither none --primaries " + option + " --background " + background +
              " -o wide.png");
      EXPECT_THAT(succeed("info wide.png"), HasSubstr("): converted"));
      const Image wide = image("wide.png"), plain = image("plain.png");
      ASSERT_EQ(wide.channels(), plain.channels());
      for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x)
          for (int c = 0; c < plain.channels(); ++c) {
            if (plain.channels() == 4 && plain.texel(x, y)[3] < 0.5f) continue;
            const auto code = [&](const Image& of) { return int(srgb8FromLinear(of.texel(x, y)[c])); };
            ASSERT_NEAR(code(wide), code(plain), 3) << option << ", " << background << " at " << x << " " << y;
          }
    }
  }
}

TEST_F(RenderPrimariesTest, WhatCannotStateThemIsRefused) {
  EXPECT_THAT(refuse(2, gold_ + "--primaries p3 -o a.jpg"),
              HasSubstr("a.jpg: cannot state other primaries than Rec.709's; write .hdr, .exr or .png, or leave"));
  EXPECT_THAT(refuse(2, gold_ + "--primaries acescg -o a.png"), HasSubstr("write .hdr or .exr"));
  EXPECT_THAT(refuse(2, gold_ + "--reference --layers --primaries p3 -o a.exr"), HasSubstr("leave --primaries out"));
}

using ReferencePrimariesTest = CliTest;

TEST_F(ReferencePrimariesTest, AReferenceHasOtherPrimariesToo) {
  const std::string line = "render sphere --material gold --size 16x12 --reference --samples 4 ";
  trace(line + "-o plain.exr");
  trace(line + "--primaries rec2020 -o wide.exr");
  EXPECT_LT(difference(image("wide.exr"), image("plain.exr")), 2e-6f);
  trace(line + "--primaries p3 -o wide.png");
  EXPECT_THAT(succeed("info wide.png"), AllOf(HasSubstr("Display P3"), Not(HasSubstr("Rec.2020"))));
}

}  // namespace
}  // namespace mirrorball::testing
