// convert without --to: another format or size, the same projection.

#include <string>

#include "cli/cli_testing.h"

namespace mirrorball::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ConvertSameTest : public CliTest {
 protected:
  ConvertSameTest() {
    Image map = smoothPanorama();
    map.texel(10, 10)[1] = 1000.0f;
    write("map.exr", map);
  }

  std::string projectionOf(const std::string& file) const {
    const std::string said = succeed("info " + file);
    const std::size_t begin = said.find("projection   ") + 13;
    return said.substr(begin, said.find(" (", begin) - begin);
  }
};

TEST_F(ConvertSameTest, AnotherFormatHasTheVeryTexels) {
  succeed("convert map.exr -o out.exr");
  EXPECT_TRUE(bytes("out.exr") == [&] {
    write("told.exr", image("map.exr"), {{"mirrorball:projection", "equirect"}});
    return bytes("told.exr");
  }());
  succeed("convert map.exr -o out.ktx2 --format float32");
  const Image& original = image("map.exr");
  const ImageSet texture_images = texture("out.ktx2");
  for (int y = 0; y < original.height(); ++y)
    for (int x = 0; x < original.width(); ++x)
      ASSERT_EQ(rgbAt(texture_images.at(0, 0), x, y), rgbAt(original, x, y)) << x << " " << y;
  succeed("convert map.exr --max-memory 1M -o rows.exr");
  EXPECT_TRUE(bytes("rows.exr") == bytes("out.exr")) << "by rows too";
}

TEST_F(ConvertSameTest, EveryProjectionAndLayoutStays) {
  for (const std::string form :
       {"sphere", "angular", "ball:distance=7", "paraboloid", "octahedral", "equal-area", "eac"}) {
    succeed("convert map.exr --to " + form + " --size 16 -o form.exr");
    succeed("convert form.exr -o same.exr");
    EXPECT_TRUE(bytes("same.exr") == bytes("form.exr")) << form;
    succeed("convert form.exr --size 8 -o half.exr");
    EXPECT_EQ(projectionOf("half.exr"), projectionOf("form.exr")) << form;
    EXPECT_EQ(image("half.exr").height() * 2, image("form.exr").height()) << form;
  }
  succeed("convert map.exr --to cube --layout vcross --size 16 -o cross.exr");
  succeed("convert cross.exr -o cross.hdr");
  EXPECT_EQ(projectionOf("cross.hdr"), "cube, vcross");
  succeed("convert cross.exr --layout 3x2 -o tiles.hdr");
  EXPECT_EQ(projectionOf("tiles.hdr"), "cube, 3x2");
  succeed("convert cross.exr -o cube.ktx2");
  succeed("convert cube.ktx2 -o of_texture.exr");
  EXPECT_EQ(projectionOf("of_texture.exr"), "cube, hcross") << "a texture's cube has no layout";
  succeed("convert map.exr --to cube --layout faces --size 16 -o six.exr");
  succeed("convert six_px.exr -o again.hdr");
  EXPECT_TRUE(std::filesystem::exists(path("again_nz.hdr"))) << "six files stay six files";
}

TEST_F(ConvertSameTest, ATurnIsNoCopy) {
  succeed("convert map.exr --rotate 90 -o turned.exr");
  EXPECT_FALSE(bytes("turned.exr") == bytes("map.exr"));
  EXPECT_EQ(projectionOf("turned.exr"), "equirect");
  succeed("convert map.exr --env-rotation 90 -o turned_too.exr");
  EXPECT_TRUE(bytes("turned_too.exr") == bytes("turned.exr"));
}

TEST_F(ConvertSameTest, ManyKeepTheirOwn) {
  succeed("convert map.exr --to sphere --size 16 -o ball.exr");
  succeed("convert map.exr ball.exr --extension hdr -o out/");
  EXPECT_EQ(projectionOf("out/map.hdr"), "equirect");
  EXPECT_EQ(projectionOf("out/ball.hdr"), "sphere");
}

TEST_F(ConvertSameTest, WhatHasNoProjectionNeedsOne) {
  EXPECT_THAT(refuse(2, "convert sky -o out.exr"), AllOf(HasSubstr("sky: "), HasSubstr("--to equirect|sphere")));
}

TEST_F(ConvertSameTest, AnOutputWithoutItsLetterIsToldHowItIsWritten) {
  EXPECT_THAT(refuse(2, "convert map.exr out.hdr"),
              HasSubstr("out.hdr: there is no such file; to write it say -o out.hdr"));
  EXPECT_THAT(refuse(2, "convert map.exr out.ktx2 --to cube"), HasSubstr("say -o out.ktx2"));
  EXPECT_THAT(refuse(2, "bake map.exr out"), HasSubstr("say -o out"));
  EXPECT_THAT(refuse(2, "render none out.png"), HasSubstr("say -o out.png"));
  EXPECT_THAT(refuse(2, "convert map.exr map.exr"), HasSubstr("-o FILE")) << "that one is there: it is an input";
  EXPECT_THAT(refuse(2, "convert map.exr -o"), HasSubstr("--output needs a file name"));
  EXPECT_THAT(refuse(2, std::vector<std::string>{"convert", "map.exr", "-o", ""}),
              HasSubstr("--output needs a file name"));
  EXPECT_THAT(refuse(2, "convert map.exr --to"), HasSubstr("--to needs a value: PROJECTION"));
  EXPECT_THAT(refuse(2, "convert"), HasSubstr("name an input map"));
  EXPECT_THAT(refuse(2, "bake -o out"), HasSubstr("name an input map"));
}

}  // namespace
}  // namespace mirrorball::testing
