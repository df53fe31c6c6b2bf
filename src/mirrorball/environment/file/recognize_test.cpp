#include "mirrorball/environment/file/recognize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

std::string formOfShape(int width, int height) {
  const auto recognition = recognize(width, height, {});
  return recognition ? textOf(recognition->form) + " by " + recognition->told_by : recognition.error().message;
}

TEST(Recognize, ByShape) {
  EXPECT_EQ(formOfShape(64, 32), "equirect by its shape, 2:1");
  EXPECT_EQ(formOfShape(64, 64), "sphere by its shape, 1:1");
  EXPECT_EQ(formOfShape(64, 48), "cube, hcross by its shape, 4:3");
  EXPECT_EQ(formOfShape(48, 64), "cube, vcross by its shape, 3:4");
  EXPECT_EQ(formOfShape(96, 16), "cube, hstrip by its shape, 6:1");
  EXPECT_EQ(formOfShape(16, 96), "cube, vstrip by its shape, 1:6");
  EXPECT_EQ(formOfShape(48, 32), "cube, 3x2 by its shape, 3:2");
  EXPECT_THAT(formOfShape(1000, 600), HasSubstr("is 1000x600, which is neither 2:1"));
}

TEST(Recognize, MetadataComesBeforeTheShape) {
  const auto probe = recognize(64, 64, {{"mirrorball:projection", "angular"}});
  EXPECT_EQ(textOf(probe->form), "angular");
  EXPECT_EQ(probe->told_by, "the file's metadata");
}

TEST(Recognize, WhatSaysThatItIsNoMapIsNone) {
  EXPECT_THAT(recognize(64, 64, metadataOfBrdfTable()).error().message, HasSubstr("is a BRDF table"));
  EXPECT_THAT(recognize(96, 24, metadataOfLobeRows()).error().message, HasSubstr("is a table of lobe rows"));
  EXPECT_THAT(recognize(64, 32, metadataOfLevelSheet()).error().message, HasSubstr("is a sheet of mip levels"));
  EXPECT_EQ(textOf(recognize(64, 64, metadataOfBrdfTable(), *formHintNamed("sphere"))->form), "sphere");
}

// OpenEXR's attribute stands for its registration and its arrangement, and a hint for what the file does not say.
TEST(Recognize, OpenExrsAttributeIsTakenAtItsWord) {
  const auto panorama = recognize(64, 32, {{"envmap", "latlong"}});
  EXPECT_EQ(textOf(panorama->form), "equirect, OpenEXR's texels (resampled)");
  EXPECT_EQ(panorama->told_by, "the file's metadata");
  const auto cube = recognize(16, 96, {{"envmap", "cube"}});
  EXPECT_THAT(textOf(cube->form), HasSubstr("cube, vstrip, axes=+x+z-y"));
  EXPECT_TRUE(cube->form.has_texels_on_edges);
  EXPECT_EQ(metadataOf(cube->form), (Metadata{{"envmap", "cube"}}));
  EXPECT_EQ(recognize(64, 60, {{"envmap", "latlong"}}).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(recognize(96, 16, {{"envmap", "cube"}}).error().code, ErrorCode::bad_shape);
  EXPECT_EQ(textOf(recognize(64, 32, {{"envmap", "latlong"}}, *formHintNamed("equirect"))->form), "equirect");
}

TEST(Recognize, TheHintComesBeforeAll) {
  const auto angular = recognize(64, 64, {{"mirrorball:projection", "sphere"}}, *formHintNamed("angular"));
  EXPECT_EQ(textOf(angular->form), "angular");
  EXPECT_EQ(angular->told_by, "");
  EXPECT_EQ(textOf(recognize(48, 32, {}, *formHintNamed("cube"))->form), "cube, 3x2");
  EXPECT_EQ(textOf(recognize(64, 48, {}, *formHintNamed("hcross"))->form), "cube, hcross");

  EXPECT_THAT(recognize(100, 60, {}, *formHintNamed("equirect")).error().message, HasSubstr("2:1"));
  EXPECT_THAT(recognize(100, 60, {}, *formHintNamed("sphere")).error().message, HasSubstr("square"));
  EXPECT_THAT(recognize(100, 60, {}, *formHintNamed("cube")).error().message, HasSubstr("no cube layout"));
  EXPECT_THAT(recognize(100, 60, {}, *formHintNamed("vcross")).error().message, HasSubstr("3:4"));
}

// What convert writes is read back: 1:1 and 2:1 pictures of other projections are recognised by the file alone.
TEST(Recognize, EveryFormIsReadBackFromItsMetadata) {
  for (const Projection projection : testing::kEveryProjection)
    for (const CubeLayout layout : {CubeLayout::hcross, CubeLayout::vcross}) {
      const MapForm form{projection, layout};
      const bool is_cube = faceCount(projection) == 6;
      const glm::ivec2 cells = is_cube ? cellsOf(layout) : glm::ivec2(faceCount(projection), 1);
      const glm::ivec2 size = imageSize(projection, 8) * cells;
      const auto read = recognize(size.x, size.y, metadataOf(form));
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(textOf(read->form), textOf(form));
    }
  EXPECT_EQ(textOf(recognize(8, 8, {{"mirrorball:projection", "ball"}})->form), "ball:distance=20");
  const Metadata wrong{{"mirrorball:projection", "ball"}, {"mirrorball:ball_distance", "0.5"}};
  EXPECT_THAT(recognize(8, 8, wrong).error().message, HasSubstr("the distance of a ball's camera"));
}

TEST(Recognize, TheHintMayNameABallsDistance) {
  EXPECT_EQ(textOf(recognize(64, 64, {}, *formHintNamed("ball:distance=7.5"))->form), "ball:distance=7.5");
  EXPECT_EQ(textOf(recognize(48, 32, {}, *formHintNamed("eac"))->form), "eac, 3x2");
  EXPECT_THAT(formHintNamed("ball:distance=0").error().message, HasSubstr("at least 1.01"));
  EXPECT_THAT(recognize(64, 64, {}, *formHintNamed("paraboloid")).error().message, HasSubstr("2:1"));
  EXPECT_THAT(recognize(64, 32, {}, *formHintNamed("octahedral")).error().message, HasSubstr("square"));
}

// It is no mistake on the command line.
TEST(Recognize, MetadataThatIsWrongIsTheFilesMistake) {
  const auto wrong = recognize(64, 64, {{"mirrorball:projection", "sphxre"}}, {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::bad_file);
  EXPECT_EQ(wrong.error().fix_hint, FixHint::name_form);
  EXPECT_THAT(wrong.error().message, HasSubstr("its own metadata is wrong"));
}

TEST(Recognize, TheHintMaySayHowAMapLies) {
  const auto textFor = [](std::string_view from, int width, int height) {
    const auto hint = formHintNamed(from);
    return hint ? textOf(recognize(width, height, {}, *hint)->form) : hint.error().message;
  };
  EXPECT_EQ(textFor("hcross:as-seen", 64, 48), "cube, hcross, as-seen");
  EXPECT_EQ(textFor("lecture", 64, 48), "cube, lecture");
  EXPECT_EQ(textFor("eac:layout=vcross", 48, 64), "eac, vcross");
  EXPECT_EQ(textFor("eac:as-seen", 48, 32), "eac, 3x2, as-seen");
  EXPECT_EQ(textFor("cube:for=three,flip=horizontal,order=-x+x+y-y+z-z", 64, 48), "cube, hcross");
  EXPECT_EQ(textFor("cube:for=unity", 96, 16), "cube, hstrip, axes=-x-z-y|+x+z-y|+y-x+z|-y-x-z|+z-x-y|-z+x-y");
  EXPECT_EQ(textFor("equirect:for=blender", 64, 32), "equirect, centred on +x");
  EXPECT_EQ(textFor("equirect:centre=-Z", 64, 32), "equirect, centred on -z");
  EXPECT_EQ(textFor("equirect:for=openexr", 64, 32), "equirect, OpenEXR's texels (resampled)");

  EXPECT_THAT(textFor("cube:for=blender", 64, 48), HasSubstr("Blender has no cube maps"));
  EXPECT_THAT(textFor("cube:for=unty", 64, 48), HasSubstr("did you mean 'unity'?"));
  EXPECT_THAT(textFor("cube:as-sen", 64, 48), HasSubstr("did you mean 'as-seen'?"));
  EXPECT_THAT(textFor("equirect:as-seen", 64, 32), HasSubstr("for=PROGRAM, centre=AXIS, crop=X,Y,W,H"));
  EXPECT_THAT(textFor("equirect:centre=+y", 64, 32), HasSubstr("on the horizon"));
  EXPECT_THAT(textFor("angular:mirrored", 64, 64), HasSubstr("projection angular, which takes no parameters"));
  EXPECT_THAT(textFor("hcross:layout=vcross", 64, 48), HasSubstr("'layout=vcross'"));
}

// A number behind a comma belongs to the word before it.
TEST(Recognize, TheHintMaySayWhichPartOfAPanoramaAPictureShows) {
  const auto hint = formHintNamed("equirect:centre=-z,crop=0,64,512,128/512x256,fill=smooth,level=no");
  ASSERT_TRUE(hint) << hint.error().message;
  EXPECT_EQ(hint->centre, SignedAxis::minus_z);
  ASSERT_TRUE(hint->part);
  EXPECT_EQ(hint->part->end, glm::dvec2(1.0, 0.75));
  EXPECT_EQ(hint->rest, PanoramaRest::smooth);
  EXPECT_TRUE(hint->stays_tilted);
  EXPECT_EQ(textOf(recognize(512, 128, {}, *hint)->form), "equirect, centred on -z");
  EXPECT_TRUE(formHintNamed("equirect:crop=none")->is_whole);

  const auto refused = [](std::string_view from) { return formHintNamed(from).error().message; };
  EXPECT_THAT(refused("equirect:crop=none,fov=360x90"), HasSubstr("crop=none says"));
  EXPECT_THAT(refused("equirect:for=openexr,fov=360x90"), HasSubstr("a panorama with OpenEXR's texels is whole"));
  EXPECT_THAT(refused("equirect:fill=edge"), HasSubstr("fill=smooth or fill=black"));
  EXPECT_THAT(refused("cube:fov=360x90"), HasSubstr("fov=360x90"));
  EXPECT_THAT(recognize(512, 100, {}, *hint).error().message, HasSubstr("360 x 90 degrees of a panorama are 4:1"));
  EXPECT_THAT(recognize(512, 128, {}, *formHintNamed("equirect")).error().message, HasSubstr("equirect:fov=HxV"));
}

TEST(Recognize, NearlyTwoToOneIsAPanorama) {
  EXPECT_EQ(formOfShape(4096, 2047), "equirect by its shape, nearly 2:1");
  EXPECT_EQ(formOfShape(8191, 4096), "equirect by its shape, nearly 2:1");
  EXPECT_THAT(formOfShape(4096, 1024), HasSubstr("equirect:fov=HxV"));
}

TEST(Recognize, AFormThatIsNotOursIsReadBackFromItsMetadata) {
  for (const Preset& preset : presets())
    for (const Projection projection : {Projection::cube, Projection::equirect}) {
      const auto form = formFor(preset, projection, CubeLayout::vstrip);
      if (!form) continue;
      const glm::ivec2 cells = projection == Projection::cube ? cellsOf(CubeLayout::vstrip) : glm::ivec2(1);
      const glm::ivec2 size = imageSize(projection, 8) * cells;
      const auto read = recognize(size.x, size.y, metadataOf(*form));
      ASSERT_TRUE(read) << preset.name << ": " << read.error().message;
      EXPECT_EQ(textOf(read->form), textOf(*form)) << preset.name;
    }
}

// Metadata is untrusted: what makes no sense together is left alone, what makes none at all is an error.
TEST(Recognize, MetadataThatDoesNotFitIsHarmless) {
  const Metadata misplaced{{"mirrorball:projection", "angular"},
                           {"mirrorball:centre", "+x"},
                           {"mirrorball:arrangement", "as-seen"},
                           {"mirrorball:texels", "on-edges"}};
  EXPECT_EQ(textOf(recognize(8, 8, misplaced)->form), "angular");
  EXPECT_EQ(textOf(recognize(16, 8, {{"envmap", "sphere"}})->form), "equirect");
  const Metadata vertical{{"mirrorball:projection", "equirect"}, {"mirrorball:centre", "-y"}};
  EXPECT_THAT(recognize(16, 8, vertical).error().message, HasSubstr("the centre of a panorama"));
  const Metadata flat{{"mirrorball:projection", "cube"}, {"mirrorball:arrangement", "axes=+x"}};
  EXPECT_THAT(recognize(32, 24, flat).error().message, HasSubstr("'axes=+x' is no cube"));
}

TEST(Recognize, SixFacesAreWhatTheFirstSaysOrTheHint) {
  const Metadata as_seen = metadataOf({Projection::eac, CubeLayout::faces, asSeen(CubeArrangement{})});
  EXPECT_EQ(textOf(recognizeFaces({}, {}, "its name").form), "cube, faces");
  const Recognition told = recognizeFaces(as_seen, {}, "its name");
  EXPECT_EQ(textOf(told.form), "eac, faces, as-seen");
  EXPECT_EQ(told.told_by, "its name");
  EXPECT_EQ(textOf(recognizeFaces(as_seen, *formHintNamed("faces"), "").form), "eac, faces");
  EXPECT_EQ(textOf(recognizeFaces(as_seen, *formHintNamed("cube:flip=vertical,as-seen"), "").form.arrangement),
            textOf(flipped(CubeArrangement{}, Flip::both)));
  EXPECT_EQ(recognizeFaces(as_seen, *formHintNamed("faces:for=three"), "").told_by, "");

  const MapForm openexr = *formFor(*presetNamed("openexr"), Projection::cube, CubeLayout::faces);
  EXPECT_EQ(textOf(recognizeFaces(metadataOf(openexr), {}, "").form), textOf(openexr));
  EXPECT_EQ(textOf(recognizeFaces({{"envmap", "cube"}}, {}, "").form), "cube, faces");
}

TEST(Recognize, UnknownNamesListAll) {
  const auto hint = formHintNamed("picture");
  ASSERT_FALSE(hint);
  EXPECT_THAT(hint.error().message,
              HasSubstr("equirect, sphere, angular, cube, ball, paraboloid, octahedral, hemioctahedral, "
                        "equal-area, eac, dual-fisheye, faces, hcross"));
}

TEST(FormHintNamed, ExchangesRedAndBlueWithAnyFormOrWithoutOne) {
  EXPECT_TRUE(formHintNamed("swap=rb")->swaps_red_and_blue);
  EXPECT_FALSE(formHintNamed("swap=rb")->namesForm());
  EXPECT_TRUE(formHintNamed("ball:distance=3,swap=rb")->swaps_red_and_blue);
  EXPECT_EQ(formHintNamed("hcross:swap=rb,as-seen")->layout, CubeLayout::hcross);
  EXPECT_FALSE(formHintNamed("equirect")->swaps_red_and_blue);
  EXPECT_EQ(formHintNamed("equirect:swap=rg").error().code, ErrorCode::usage);
}

TEST(FormHintNamed, NamesALayerWithAnyFormOrWithoutOne) {
  EXPECT_EQ(formHintNamed("equirect:layer=rgba")->layer, "rgba");
  EXPECT_EQ(formHintNamed("equirect:centre=-z,layer=ViewLayer.Combined")->centre, SignedAxis::minus_z);
  EXPECT_EQ(formHintNamed("equirect:centre=-z,layer=ViewLayer.Combined")->layer, "ViewLayer.Combined");
  EXPECT_EQ(formHintNamed("sphere:layer=C")->layer, "C");
  EXPECT_EQ(formHintNamed("hcross:layer=C,as-seen")->layer, "C");
  const auto ball = formHintNamed("ball:distance=7.5,layer=left");
  EXPECT_EQ(ball->layer, "left");
  EXPECT_EQ(ball->projection->ball_distance, 7.5f);
  const auto alone = formHintNamed("layer=rgba");
  EXPECT_EQ(alone->layer, "rgba");
  EXPECT_FALSE(alone->projection || alone->layout);
  EXPECT_EQ(textOf(recognize(64, 32, {}, *alone)->form), "equirect") << "by its shape, as without a hint";
  EXPECT_EQ(formHintNamed("layer=\"key,fill\"")->layer, "key,fill");
  const auto quoted = formHintNamed("equirect:layer=\"a,b,-2,centre=+x\",centre=-z");
  EXPECT_EQ(quoted->layer, "a,b,-2,centre=+x");
  EXPECT_EQ(quoted->centre, SignedAxis::minus_z);
  EXPECT_EQ(formHintNamed("layer=6\" lens")->layer, "6\" lens") << "a mark within a name";
  EXPECT_THAT(formHintNamed("equirect:layer=\"key,fill").error().message, HasSubstr("lacks its second quotation mark"));
  for (const char* none : {"layer=", "layer=\"\""})
    EXPECT_THAT(formHintNamed(none).error().message, HasSubstr("should name one layer"));
  EXPECT_THAT(formHintNamed("equirect:layer=a,layer=b").error().message, HasSubstr("should name one layer"));
  EXPECT_THAT(formHintNamed("layer=rgba,centre=-z").error().message, HasSubstr("needs the form before it"));
}

}  // namespace
}  // namespace mirrorball
