#include "mirrorball/environment/file/load.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/base/memory.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_file_testing.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/large_panorama.h"
#include "test_data.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Ours, changed by a word; "turn=" changes nothing.
CubeArrangement arrangementOf(std::string_view word) {
  return word == "turn=" ? CubeArrangement{} : *rearranged(CubeArrangement{}, word);
}

class LoadTest : public testing::FolderTest {};

TEST_F(LoadTest, AFileIsReadAndRecognised) {
  ASSERT_TRUE(writeImage(path("a.exr"), Image(8, 4, 3, 2.0f)));
  const auto loaded = loadEnvironment(path("a.exr"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->recognition->form.projection, Projection::equirect);
  EXPECT_EQ(loaded->environment.radiance({0, 0, 1}), glm::vec3(2.0f));
  EXPECT_EQ(loaded->file_size, glm::ivec2(8, 4));
}

TEST_F(LoadTest, ATexturesLevelsAreReadInItsForm) {
  ImageSet levels(2, 6);
  for (int face = 0; face < 6; ++face) {
    levels.at(0, face) = Image(2, 2, 4, static_cast<float>(face));
    levels.at(1, face) = Image(1, 1, 4, static_cast<float>(10 + face));
  }
  const MapForm as_seen{.projection = Projection::cube, .arrangement = asSeen(CubeArrangement{})};
  ASSERT_TRUE(writeImageSet(path("a.ktx2"), arranged(levels, as_seen.arrangement), {.metadata = metadataOf(as_seen)}));
  const EnvironmentLoadOptions twice{.light = {.scale = 2.0f}};
  const auto loaded = loadEnvironment(path("a.ktx2"), twice);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->levels, 2);
  const auto read = loadLevels(*loaded, {Projection::cube}, twice);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(*read);
  for (int face = 0; face < 6; ++face) {
    EXPECT_EQ((*read)->at(0, face).channels(), 3);
    EXPECT_EQ(rgbAt((*read)->at(0, face), 1, 1), rgbAt(loaded->environment.map()->face(face), 1, 1));
    EXPECT_EQ(rgbAt((*read)->at(1, face), 0, 0), glm::vec3(2.0f * static_cast<float>(10 + face)));
  }
  const auto rolled = loadEnvironment(path("a.ktx2"), {.from = *formHintNamed("cube:for=openexr")});
  ASSERT_TRUE(rolled) << rolled.error().message;
  EXPECT_FALSE(*loadLevels(*rolled, {Projection::cube})) << "its texels are other ones";
  ASSERT_TRUE(writeImage(path("b.exr"), Image(8, 4, 3, 2.0f)));
  EXPECT_FALSE(*loadLevels(*loadEnvironment(path("b.exr")), {}));
}

EnvironmentMap makeCube(RadianceFunction light, int side) {
  return *convert(Environment(std::move(light), 1), Projection::cube, side);
}

/// A cube in a picture that does not say how its faces lie.
std::string writeCube(const std::string& path, const MapForm& form, const EnvironmentMap& cube) {
  EXPECT_TRUE(writeImage(path, pictureOf(cube, form)));
  return path;
}

/// Light that is the same for (x, y, z) and (-x, -y, z), which is −Z turned by 180°, but for a little.
glm::vec3 nearlySymmetric(glm::vec3 d) {
  return 0.5f * (testing::waves(d) + testing::waves({-d.x, -d.y, d.z})) * (1.0f + 1e-3f * d.y);
}

/// A dim sky over a dim ground with a sun 10⁴ times as bright, as the codes of a camera that exposed for the sun.
glm::vec3 dimWithSun(glm::vec3 d) {
  const float sun = glm::dot(d, glm::normalize(glm::vec3(0.3f, 0.5f, 0.8f))) > 0.9998f ? 1.0f : 0.0f;
  return glm::vec3(sun + (d.y > 0.0f ? 0.003f + 0.002f * d.y : 0.001f) * (1.0f + 0.5f * std::sin(9.0f * d.x)));
}

/// Waves under strong noise, a value of its own for each texel.
RadianceFunction noisyWaves() {
  return [](glm::vec3 d) {
    const glm::vec3 cell = glm::fract(d * 7919.0f);
    const float chance = glm::fract(43758.547f * std::sin(glm::dot(cell, glm::vec3(12.9898f, 78.233f, 37.719f))));
    return testing::waves(d) * (0.7f + 0.6f * chance);
  };
}

TEST_F(LoadTest, EdgesTellHowTheFacesOfACubeLie) {
  const CubeArrangement seen = asSeen(CubeArrangement{});
  const EnvironmentMap waves = makeCube(testing::waves, 256);
  for (const MapForm& form :
       {MapForm{Projection::cube, CubeLayout::hcross}, MapForm{Projection::cube, CubeLayout::lecture},
        MapForm{Projection::cube, CubeLayout::vcross}, MapForm{Projection::cube, CubeLayout::tiles},
        MapForm{Projection::cube, CubeLayout::tiles, seen}, MapForm{Projection::cube, CubeLayout::vstrip, seen},
        MapForm{Projection::cube, CubeLayout::vcross, arrangementOf("turn=-z")},
        MapForm{Projection::cube, CubeLayout::hcross, arrangementOf("turn=-z")},
        MapForm{Projection::cube, CubeLayout::hcross, arrangementOf("turn=+y-y")},
        MapForm{Projection::cube, CubeLayout::hstrip,
                formFor(*presetNamed("openexr"), Projection::cube, CubeLayout::faces)->arrangement}}) {
    const auto loaded = loadEnvironment(writeCube(path("cube.exr"), form, waves));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(textOf(loaded->recognition->form), textOf(form));
    EXPECT_EQ(loaded->doubt.message, "") << textOf(form);
    for (const glm::vec3 d : {glm::vec3(0.6f, 0.0f, 0.8f), glm::vec3(0.0f, 0.6f, -0.8f)})
      EXPECT_NEAR(loaded->environment.radiance(d).x, testing::waves(d).x, 0.02f) << textOf(form);
  }
}

/// What a vertical cross is taken for whose −Z is as the word says.
std::string crossTakenFor(const EnvironmentMap& cube, const std::string& path, const char* word) {
  const auto loaded =
      loadEnvironment(writeCube(path, {Projection::cube, CubeLayout::vcross, arrangementOf(word)}, cube));
  EXPECT_EQ(loaded->doubt.message, "") << path << " " << word;
  return textOf(loaded->recognition->form);
}

TEST_F(LoadTest, EdgesTellWhetherMinusZStandsOnItsHead) {
  const auto expectTold = [&](const EnvironmentMap& cube, const std::string& name) {
    EXPECT_EQ(crossTakenFor(cube, path(name), "turn="), "cube, vcross") << name;
    EXPECT_EQ(crossTakenFor(cube, path(name), "turn=-z"), "cube, vcross, turn=-z") << name;
  };
  expectTold(*convert(*builtinEnvironment("studio"), Projection::cube, 128), "studio.hdr");
  expectTold(makeCube(noisyWaves(), 128), "noise.exr");
  expectTold(makeCube(dimWithSun, 128), "sun.png");
  // Where hardly anything tells, the cross that hangs together stays.
  for (const EnvironmentMap& cube :
       {makeCube(nearlySymmetric, 128), makeCube([](glm::vec3) { return glm::vec3(0.7f); }, 32)}) {
    EXPECT_EQ(crossTakenFor(cube, path("cross.exr"), "turn="), "cube, vcross");
    EXPECT_EQ(crossTakenFor(cube, path("cross.exr"), "turn=-z"), "cube, vcross");
  }
}

TEST_F(LoadTest, RealPanoramasTellWhetherMinusZStandsOnItsHead) {
  for (const char* name : {"chinese_garden_1k.hdr", "lightroom_14b.hdr", "courtyard.exr", "studio.exr"}) {
    const auto panorama = testing::sharedData(name);
    if (!panorama) GTEST_SKIP() << "no shared/data/" << name;
    const EnvironmentMap cube = *convert(loadEnvironment(panorama->string())->environment, Projection::cube, 128);
    for (const char* extension : {".hdr", ".jpg"}) {
      const std::string file = path(name) + extension;
      EXPECT_EQ(crossTakenFor(cube, file, "turn="), "cube, vcross") << file;
      EXPECT_EQ(crossTakenFor(cube, file, "turn=-z"), "cube, vcross, turn=-z") << file;
    }
  }
}

TEST_F(LoadTest, WhereMinusZIsTurnedIsSaidByFrom) {
  const MapForm form{Projection::cube, CubeLayout::vcross, arrangementOf("turn=-z")};
  const EnvironmentMap cube = makeCube(testing::waves, 256);
  const auto loaded =
      loadEnvironment(writeCube(path("cross.exr"), form, cube), {.from = *formHintNamed("vcross:turn=-z")});
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->recognition->told_by, "");
  const glm::vec3 behind = glm::normalize(glm::vec3(0.2f, 0.3f, -1.0f));
  EXPECT_NEAR(loaded->environment.radiance(behind).x, testing::waves(behind).x, 0.02f);
  // What is said goes before what the edges tell.
  const auto upright = loadEnvironment(path("cross.exr"), {.from = *formHintNamed("vcross")});
  EXPECT_EQ(textOf(upright->recognition->form), "cube, vcross");
}

TEST_F(LoadTest, APhotographOfACubesShapeIsDoubted) {
  Image photograph(768, 512, 3);
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 768; ++x)
      std::fill_n(photograph.texel(x, y), 3, 0.1f + 0.8f * float(y) / 512.0f + 0.1f * std::sin(0.2f * float(x)));
  ASSERT_TRUE(writeImage(path("photo.png"), photograph));
  const auto loaded = loadEnvironment(path("photo.png"));
  ASSERT_TRUE(loaded);
  EXPECT_THAT(loaded->doubt.message, HasSubstr("its faces do not meet"));
  FormHint hint;
  hint.layout = CubeLayout::tiles;
  EXPECT_EQ(loadEnvironment(path("photo.png"), {.from = hint})->doubt.message, "");
  Image upright(384, 512, 3);
  for (int y = 0; y < 512; ++y) std::copy_n(photograph.texel(0, y), upright.row(y).size(), upright.texel(0, y));
  ASSERT_TRUE(writeImage(path("upright.png"), upright));
  const auto refused = loadEnvironment(path("upright.png"));
  ASSERT_FALSE(refused) << "it fills the cells that a cross leaves empty";
  EXPECT_EQ(refused.error().code, ErrorCode::bad_shape);
  EXPECT_THAT(refused.error().message, HasSubstr("{option:from} vcross reads it as a cube all the same"));
  EXPECT_TRUE(loadEnvironment(path("upright.png"), {.from = *formHintNamed("vcross")}));
  // Where its faces meet by chance, as dim ones do.
  Image dim(128, 96, 3);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x)
      std::fill_n(dim.texel(x, y), 3, 0.5f + 0.05f * std::sin(float(x)) * std::cos(0.9f * float(y)));
  ASSERT_TRUE(writeImage(path("dim.exr"), dim));
  EXPECT_THAT(loadEnvironment(path("dim.exr"))->doubt.message, HasSubstr("light fills the cells"));
}

TEST_F(LoadTest, SixFacesAreOneCube) {
  const std::array<const char*, 6> names{"a_px.exr", "a_nx.exr", "a_py.exr", "a_ny.exr", "a_pz.exr", "a_nz.exr"};
  for (std::size_t face = 0; face < 6; ++face)
    ASSERT_TRUE(writeImage(path(names[face]), Image(4, 4, 3, static_cast<float>(face))));
  const auto loaded = loadEnvironment(path("a_py.exr"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->environment.radiance({-1, 0, 0}), glm::vec3(1.0f));
  EXPECT_EQ(loaded->environment.radiance({0, 1, 0}), glm::vec3(2.0f));

  ASSERT_TRUE(writeImage(path("a_nz.exr"), Image(4, 5, 3)));
  EXPECT_THAT(loadEnvironment(path("a_px.exr")).error().message,
              StartsWith(path("a_nz.exr: is 4x5, and the six faces")));
  fs::remove(path("a_pz.exr"));
  EXPECT_THAT(loadEnvironment(path("a_px.exr")).error().message,
              HasSubstr("is one of the six faces of a cube, without a_pz.exr; put all in one folder"));
  EXPECT_EQ(loadEnvironment(path("b.exr"), {.from = *formHintNamed("faces")}).error().code, ErrorCode::usage);
}

TEST_F(LoadTest, TheFilesNameStandsInFrontOfAnErrorOnce) {
  ASSERT_TRUE(writeImage(path("a.exr"), Image(5, 3, 3)));
  EXPECT_THAT(loadEnvironment(path("a.exr")).error().message, StartsWith(path("a.exr: is 5x3, which is neither")));
  ASSERT_TRUE(writeImage(path("a.exr"), Image(8, 4, 3, std::numeric_limits<float>::infinity())));
  EXPECT_THAT(loadEnvironment(path("a.exr")).error().message, StartsWith(path("a.exr: 32 texels are NaN")));
  ASSERT_TRUE(writeImageSet(path("a.ktx2"), ImageSet(Image(8, 4, 3))));
  fs::resize_file(path("a.ktx2"), 200);
  EXPECT_THAT(loadEnvironment(path("a.ktx2")).error().message, StartsWith(path("a.ktx2: ")));
}

TEST_F(LoadTest, EveryProjectionIsReadBackFromItsFile) {
  for (const Projection projection : testing::kEveryProjection) {
    const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 64), projection, 32);
    const MapForm form{projection, CubeLayout::hcross};
    ASSERT_TRUE(writeImage(path("map.exr"), pictureOf(map, form), {.metadata = metadataOf(form)}));
    const auto loaded = loadEnvironment(path("map.exr"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->environment.map()->projection(), projection);
    for (const glm::vec3 direction : testing::manyDirections(200))
      EXPECT_EQ(loaded->environment.radiance(direction), map.radiance(direction)) << textOf(form);
  }
}

// As pictures the faces of both kinds of cube look alike: the files say which they are, or the caller does.
TEST_F(LoadTest, SixFacesMayBeAnEquiangularCube) {
  for (const char* suffix : {"px", "nx", "py", "ny", "pz", "nz"}) {
    const Metadata metadata = metadataOf({Projection::eac, CubeLayout::faces});
    ASSERT_TRUE(writeImage(path(std::string("told_") + suffix + ".exr"), Image(4, 4, 3), {.metadata = metadata}));
    ASSERT_TRUE(writeImage(path(std::string("mute_") + suffix + ".exr"), Image(4, 4, 3)));
  }
  EXPECT_EQ(textOf(loadEnvironment(path("told_px.exr"))->recognition->form), "eac, faces");
  EXPECT_EQ(textOf(loadEnvironment(path("mute_px.exr"))->recognition->form), "cube, faces");
  const auto named = loadEnvironment(path("mute_px.exr"), {.from = *formHintNamed("eac")});
  EXPECT_EQ(textOf(named->recognition->form), "eac, faces");
  EXPECT_EQ(named->recognition->told_by, "");
}

TEST_F(LoadTest, SixFilesOfAnotherProgramAreReadByItsName) {
  const EnvironmentMap cube = *convert(Environment(testing::smoothRadiance, 64), Projection::cube, 8);
  const MapForm form = *formFor(*presetNamed("three"), Projection::cube, CubeLayout::faces);
  const ImageSet images = imagesOf(cube, form);
  for (int slot = 0; slot < 6; ++slot) {
    const std::string ending(endingsOf(FaceNaming::top)[static_cast<std::size_t>(slot)]);
    ASSERT_TRUE(writeImage(path(ending + ".exr"), images.at(0, slot)));
    ASSERT_TRUE(writeImage(path("told-" + ending + ".exr"), images.at(0, slot), {.metadata = metadataOf(form)}));
  }
  const auto named = loadEnvironment(path("top.exr"), {.from = *formHintNamed("faces:for=three")});
  const auto told = loadEnvironment(path("told-left.exr"));
  ASSERT_TRUE(named && told);
  EXPECT_EQ(told->recognition->told_by, "its name, one of six faces right left top bottom front back");
  for (const glm::vec3 direction : testing::manyDirections(200)) {
    EXPECT_EQ(named->environment.radiance(direction), cube.radiance(direction));
    EXPECT_EQ(told->environment.radiance(direction), cube.radiance(direction));
  }
  EXPECT_THAT(loadEnvironment(folder_.string()).error().message, HasSubstr("holds 2 cubes"));
  for (const std::string_view ending : endingsOf(FaceNaming::top)) fs::remove(path(std::string(ending) + ".exr"));
  EXPECT_EQ(loadEnvironment(folder_.string())->environment.radiance({0, 1, 0}), cube.radiance({0, 1, 0}));
  EXPECT_EQ(loadEnvironment(folder_.string(), {.from = *formHintNamed("sphere")}).error().code, ErrorCode::usage);
}

/// Six files of a world of waves; without metadata they say no more than their names.
void writeFaces(const std::string& before, FaceNaming naming, const std::string& hint,
                const std::string& extension = ".exr") {
  const MapForm form{.projection = Projection::cube, .arrangement = formHintNamed(hint)->arrangement};
  static const EnvironmentMap cube = makeCube(testing::waves, 256);
  const ImageSet images = imagesOf(cube, form);
  for (int slot = 0; slot < 6; ++slot)
    ASSERT_TRUE(writeImage(before + std::string(endingsOf(naming)[static_cast<std::size_t>(slot)]) + extension,
                           images.at(0, slot)));
}

/// How far the light of a map is from the waves.
float largestError(const LoadedEnvironment& loaded) {
  float error = 0.0f;
  for (const glm::vec3 d : testing::manyDirections(200))
    error = std::max(error, std::abs(loaded.environment.radiance(d).x - testing::waves(d).x));
  return error;
}

TEST_F(LoadTest, SixFacesAreReadAsTheirEngineHasThem) {
  for (const auto& [naming, hint] :
       {std::pair(FaceNaming::px, "faces"), std::pair(FaceNaming::pos_x, "faces"), std::pair(FaceNaming::c00, "faces"),
        std::pair(FaceNaming::quake, "faces:for=quake"), std::pair(FaceNaming::ogre, "faces:for=ogre"),
        std::pair(FaceNaming::unity_cameras, "faces:as-seen"), std::pair(FaceNaming::letters, "faces:for=krpano"),
        std::pair(FaceNaming::from_0, "faces"), std::pair(FaceNaming::from_1, "faces:for=krpano,order=+z+x-z-x+y-y")}) {
    writeFaces(path("a_"), naming, hint);
    const auto loaded = loadEnvironment(path("a_" + std::string(endingsOf(naming)[2]) + ".exr"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_LT(largestError(*loaded), 0.02f) << hint;
    EXPECT_EQ(loaded->recognition->told_by, "its name, one of six faces " + textOf(naming));
    for (const std::string_view ending : endingsOf(naming)) fs::remove(path("a_" + std::string(ending) + ".exr"));
  }
}

TEST_F(LoadTest, EdgesTellWhereFacesLieOtherwiseThanTheirNamesSay) {
  writeFaces(path("a_"), FaceNaming::quake, "faces:for=krpano");
  const auto seen = loadEnvironment(path("a_up.exr"));
  ASSERT_TRUE(seen);
  EXPECT_LT(largestError(*seen), 0.02f);
  EXPECT_THAT(seen->doubt.other_forms, ElementsAre("faces", "sphere")) << "whether it is mirrored they do not show";
  writeFaces(path("b_"), FaceNaming::px, "faces:for=quake");
  const auto turned = loadEnvironment(path("b_px.exr"));
  EXPECT_LT(largestError(*turned), 0.02f);
  EXPECT_THAT(turned->recognition->told_by, HasSubstr("and how its edges meet"));
  writeFaces(path("c_"), FaceNaming::from_0, "faces:for=krpano,order=+z+x-z-x+y-y");
  EXPECT_LT(largestError(*loadEnvironment(path("c_3.exr"))), 0.02f);
}

TEST_F(LoadTest, OneOfSixFacesSaysWithWhichOthersItIsRead) {
  writeFaces(path("a_"), FaceNaming::px, "faces");
  const auto loaded = loadEnvironment(path("a_py.exr"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->doubt.message,
            "is read as one of the six faces of a cube, with a_px.exr, a_nx.exr, a_ny.exr, a_pz.exr and a_nz.exr, "
            "by OpenGL's table; their edges meet in the mirrored world, too");
  EXPECT_THAT(loaded->doubt.other_forms, ElementsAre("faces:for=krpano", "sphere"));
  EXPECT_THAT(loadEnvironment(folder_.string())->doubt.other_forms, ElementsAre("faces:for=krpano"));
  EXPECT_EQ(loadEnvironment(path("a_py.exr"), {.from = *formHintNamed("faces")})->doubt.message, "");
  const auto alone = loadEnvironment(path("a_py.exr"), {.from = *formHintNamed("sphere")});
  EXPECT_EQ(textOf(alone->recognition->form), "sphere");
  EXPECT_THAT(alone->files, ElementsAre(path("a_py.exr")));
  EXPECT_TRUE(alone->oddities.empty());
}

TEST_F(LoadTest, AFaceWithoutTheOthersSaysWhichAreMissing) {
  writeFaces(path("a_"), FaceNaming::px, "faces");
  for (const char* missing : {"a_nx.exr", "a_nz.exr"}) fs::remove(path(missing));
  const auto refused = loadEnvironment(path("a_py.exr"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::not_found);
  EXPECT_THAT(refused.error().message, HasSubstr("without a_nx.exr and a_nz.exr"));
  fs::remove(path("a_ny.exr"));
  const auto alone = loadEnvironment(path("a_py.exr"));
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_EQ(textOf(alone->recognition->form), "sphere");
  EXPECT_EQ(alone->doubt.message,
            "is named like one of the six faces of a cube, of which a_nx.exr, a_ny.exr and a_nz.exr are missing: read "
            "alone, as a sphere map");
  EXPECT_THAT(alone->oddities, IsEmpty()) << "in one remark";
}

TEST_F(LoadTest, ASmallFaceIsEnlargedAndAGreyOneGetsItsColours) {
  writeFaces(path("sky_"), FaceNaming::quake, "faces:for=quake");
  ASSERT_TRUE(writeImage(path("sky_dn.exr"), Image(4, 4, 1, 0.25f)));
  const auto loaded = loadEnvironment(path("sky_ft.exr"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->file_size, glm::ivec2(256));
  EXPECT_THAT(loaded->oddities,
              ElementsAre("sky_dn.exr is 4x4, and the largest of the six faces is 256x256: enlarged"));
  EXPECT_EQ(loaded->environment.radiance({0, -1, 0}), glm::vec3(0.25f));
  const glm::vec3 up = glm::normalize(glm::vec3(0.2f, 1.0f, 0.3f));
  EXPECT_NEAR(loaded->environment.radiance(up).x, testing::waves(up).x, 0.02f);
}

TEST_F(LoadTest, FacesAreNotEnlargedBeyondTheMemory) {
  writeFaces(path("sky_"), FaceNaming::quake, "faces:for=quake");
  for (const char* small : {"up", "lf", "rt", "ft", "bk"})
    ASSERT_TRUE(writeImage(path(std::string("sky_") + small + ".exr"), Image(1, 1, 3, 0.25f)));
  const std::uint64_t limit = memoryLimit();
  setMemoryLimit(4 << 20);  // for one face of 256 x 256, and not for six
  const auto loaded = loadEnvironment(path("sky_ft.exr"));
  setMemoryLimit(limit);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::too_large);
}

TEST_F(LoadTest, AFolderWithoutAnotherFormIsRemarkedAsItIs) {
  writeFaces(path("sky_"), FaceNaming::quake, "faces:for=quake");
  const auto folder = loadEnvironment(folder_.string());
  ASSERT_TRUE(folder) << folder.error().message;
  EXPECT_EQ(folder->doubt.message, "");
  EXPECT_THAT(folder->oddities, ElementsAre(HasSubstr("as faces:for=quake has them")));
}

TEST_F(LoadTest, SixNumberedPicturesAreACubeOnlyIfTheyMeet) {
  for (int number = 1; number <= 6; ++number) {
    const auto shot = [&](glm::vec3 d) { return testing::waves(glm::normalize(d + 0.3f * float(number))); };
    ASSERT_TRUE(writeImage(path("v_" + std::to_string(number) + ".exr"), makeCube(shot, 256).face(4)));
  }
  const auto loaded = loadEnvironment(path("v_2.exr"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(textOf(loaded->recognition->form), "sphere");
  EXPECT_TRUE(loaded->oddities.empty());
  EXPECT_THAT(loaded->doubt.message, HasSubstr("without a sign that the six are a cube: read alone"));
  EXPECT_THAT(loaded->doubt.other_forms, ElementsAre("faces"));
  EXPECT_EQ(textOf(loadEnvironment(path("v_2.exr"), {.from = *formHintNamed("faces")})->recognition->form),
            "cube, faces");
  // Nor if one is no square.
  ASSERT_TRUE(writeImage(path("v_3.exr"), Image(16, 8, 3)));
  EXPECT_EQ(textOf(loadEnvironment(path("v_2.exr"))->recognition->form), "sphere");
}

TEST_F(LoadTest, SixLayersAreACubeIfTheyMeet) {
  const EnvironmentMap cube = makeCube(testing::waves, 256);
  ImageSet layers(1, 1, 6);
  for (int face = 0; face < 6; ++face) layers.at(0, 0, face) = cube.face(face);
  for (const char* name : {"a.dds", "a.ktx", "a.ktx2"}) {
    ASSERT_TRUE(writeImageSet(path(name), layers, {.format = TexelFormat::float32}));
    const auto loaded = loadEnvironment(path(name));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(textOf(loaded->recognition->form), "cube, faces") << name;
    EXPECT_LT(largestError(*loaded), 0.02f) << name;
    EXPECT_THAT(loaded->doubt.message, HasSubstr("is an array of six pictures, whose edges meet")) << name;
    const auto first = loadEnvironment(path(name), {.from = *formHintNamed("sphere")});
    EXPECT_EQ(textOf(first->recognition->form), "sphere") << name;
  }
  std::swap(layers.at(0, 0, 0), layers.at(0, 0, 3));
  ASSERT_TRUE(writeImageSet(path("b.dds"), layers, {.format = TexelFormat::float32}));
  const auto loaded = loadEnvironment(path("b.dds"));
  EXPECT_EQ(textOf(loaded->recognition->form), "sphere");
  EXPECT_THAT(loaded->doubt.message, HasSubstr("whose edges do not show that they are a cube: the first is read"));
  EXPECT_THAT(loaded->doubt.other_forms, ElementsAre("cube"));
  EXPECT_EQ(textOf(loadEnvironment(path("b.dds"), {.from = *formHintNamed("cube")})->recognition->form), "cube, faces");
}

TEST_F(LoadTest, WhatIsOddInAPanoramaThatIsReadByRowsIsRemarked) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=0\n\n-Y 1 +X 2\n";
  Bytes file(header.begin(), header.end());
  file.insert(file.end(), {16, 32, 64, 136, 16, 32, 64, 136});
  ASSERT_TRUE(writeFile(path("a.hdr"), file));
  auto panorama = openPanorama(path("a.hdr"));
  ASSERT_TRUE(panorama && *panorama);
  std::vector<std::string> remarks;
  const Observer observer{.remark = [&](const Remark& remark) { remarks.push_back(remark.message); }};
  tellAbout(**panorama, path("a.hdr"), observer);
  tellAbout(*loadEnvironment(path("a.hdr")), observer);
  const std::string remark = path("a.hdr") + ": line 3 says EXPOSURE=0, which cannot be divided out: taken as 1";
  EXPECT_THAT(remarks, ElementsAre(remark, remark));
  EXPECT_EQ(rgbAt(*(*panorama)->rows->read(1), 1, 0), glm::vec3(16, 32, 64));
}

TEST_F(LoadTest, WhatIsOddInATextureIsTold) {
  ImageSet cube(1, 6);
  for (int face = 0; face < 6; ++face) cube.at(0, face) = Image(4, 4, 3, static_cast<float>(face));
  ASSERT_TRUE(writeImageSet(path("a.dds"), cube));
  Bytes file = *readFile(path("a.dds"));
  file[136] = 0;  // DX10's flag of a cube
  ASSERT_TRUE(writeFile(path("a.dds"), file));
  const auto loaded = loadEnvironment(path("a.dds"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->environment.radiance({0, 1, 0}), glm::vec3(2.0f));
  EXPECT_THAT(loaded->oddities, ElementsAre("says only in its old header that it is a cube: read as one"));
}

TEST_F(LoadTest, TwoNearlyEqualPanoramasAreTwoEyes) {
  const auto eye = [](float metres) {
    return *convert(Environment(
                        [=](glm::vec3 d) {
                          return testing::smoothRadiance(d + glm::vec3(0.02f * metres, 0, 0)) *
                                 (d.y > 0.0f ? 1.0f : 0.3f);
                        },
                        64),
                    Projection::equirect, 128);
  };
  const EnvironmentMap left = eye(0.0f), right = eye(1.0f);
  Image above(256, 256, 3), beside(512, 128, 3);
  for (int y = 0; y < 128; ++y) {
    std::copy_n(left.face(0).texel(0, y), 3 * 256, above.texel(0, y));
    std::copy_n(right.face(0).texel(0, y), 3 * 256, above.texel(0, 128 + y));
    std::copy_n(left.face(0).texel(0, y), 3 * 256, beside.texel(0, y));
    std::copy_n(right.face(0).texel(0, y), 3 * 256, beside.texel(256, y));
  }
  ASSERT_TRUE(writeImage(path("above.exr"), above));
  ASSERT_TRUE(writeImage(path("beside.exr"), beside));
  for (const char* name : {"above.exr", "beside.exr"}) {
    const auto loaded = loadEnvironment(path(name));
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->recognition->form.projection, Projection::equirect);
    for (const glm::vec3 d : testing::manyDirections(100)) EXPECT_EQ(loaded->environment.radiance(d), left.radiance(d));
    EXPECT_THAT(loaded->oddities, ElementsAre(HasSubstr("holds two panoramas that are nearly equal"))) << name;
    EXPECT_FALSE(*openPanorama(path(name))) << "their light decides";
  }
  EXPECT_THAT(loadEnvironment(path("beside.exr"))->oddities[0], HasSubstr("equirect:eye=right reads the other"));
  const auto alone = loadEnvironment(path("above.exr"), {.from = *formHintNamed("sphere")});
  EXPECT_EQ(alone->recognition->form.projection, Projection::sphere);
}

TEST_F(LoadTest, TwoDiscsAreRefusedUnlessTheyAreNamed) {
  const EnvironmentMap discs = *convert(Environment(testing::smoothRadiance, 64), Projection::paraboloid, 64);
  ASSERT_TRUE(writeImage(path("discs.png"), pictureOf(discs, {Projection::paraboloid})));
  EXPECT_THAT(loadEnvironment(path("discs.png")).error().message, HasSubstr("shows two discs on black"));
  for (const char* form : {"paraboloid", "equirect"})
    EXPECT_TRUE(loadEnvironment(path("discs.png"), {.from = *formHintNamed(form)})) << form;
}

TEST_F(LoadTest, WhatIsTooLargeForAWholeIsLookedAtAsWell) {
  const Environment smooth(testing::smoothRadiance, 64);
  const Image discs = pictureOf(*convert(smooth, Projection::paraboloid, 64), {Projection::paraboloid});
  const Image front = convert(smooth, Projection::cube, 64)->face(4);
  Image halves(128, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (const int x : {0, 64}) std::copy_n(front.texel(0, y), 3 * 64, halves.texel(x, y));
  const std::uint64_t usual = memoryLimit();
  for (const char* name : {"a.hdr", "a.exr"}) {
    ASSERT_TRUE(writeImage(path(name), discs));
    EXPECT_FALSE(*openLargePanorama(path(name))) << "it is small";
    setMemoryLimit(128 * 64 * 3 * 4);
    const auto refused = openLargePanorama(path(name));
    ASSERT_FALSE(refused) << name;
    EXPECT_THAT(refused.error().message, StartsWith(path(name) + ": is 2:1 and shows two discs on black"));
    EXPECT_TRUE(*openLargePanorama(path(name), {.from = *formHintNamed("equirect")}));
    setMemoryLimit(usual);
    ASSERT_TRUE(writeImage(path(name), halves));
    setMemoryLimit(128 * 64 * 3 * 4);
    const auto doubted = openLargePanorama(path(name));
    setMemoryLimit(usual);
    ASSERT_TRUE(doubted && *doubted) << name;
    EXPECT_THAT((*doubted)->doubt.message, HasSubstr("two nearly equal halves"));
    std::string remarks;
    tellAbout(**doubted, name, {.remark = [&](const Remark& remark) { remarks += remark.message; }});
    EXPECT_EQ(remarks, std::string(name) + ": " + (*doubted)->doubt.message);
    EXPECT_EQ(rgbAt(*(*doubted)->rows->read(1), 1, 0),
              rgbAt(loadEnvironment(path(name))->environment.map()->face(0), 1, 0))
        << "it begins at the first row";
  }
}

// Two eyes are no cube.
TEST_F(LoadTest, APairOfLeftAndRightIsNoCube) {
  ASSERT_TRUE(writeImage(path("left.exr"), Image(8, 4, 3, 1.0f)));
  ASSERT_TRUE(writeImage(path("right.exr"), Image(8, 4, 3, 2.0f)));
  EXPECT_EQ(textOf(loadEnvironment(path("right.exr"))->recognition->form), "equirect");
}

TEST_F(LoadTest, OpenExrsMapsAreResampledAndMendedBefore) {
  const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 256), Projection::equirect, 64);
  const MapForm form = *formFor(*presetNamed("openexr"), Projection::equirect, CubeLayout::faces);
  Image picture = pictureOf(map, form);
  picture.texel(20, 30)[1] = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(writeImage(path("map.exr"), picture, {.metadata = metadataOf(form)}));
  const auto loaded = loadEnvironment(path("map.exr"), {.repair = true});
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(textOf(loaded->recognition->form), "equirect, OpenEXR's texels (resampled)");
  EXPECT_EQ(loaded->bad_texels.count, 1u);
  for (const glm::vec3 direction : testing::manyDirections(500))
    EXPECT_LT(glm::length(loaded->environment.radiance(direction) - testing::smoothRadiance(direction)), 4e-3f);
}

TEST_F(LoadTest, BadTexelsAreRefusedCountedOrRepaired) {
  Image image(8, 4, 3, 2.0f);
  image.texel(3, 1)[0] = std::numeric_limits<float>::quiet_NaN();
  image.texel(5, 2)[2] = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(writeImage(path("bad.exr"), image));

  const auto refused = loadEnvironment(path("bad.exr"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::non_finite);
  EXPECT_EQ(refused.error().message, path("bad.exr: 2 texels are NaN or infinite, the first at (3, 1)"));
  EXPECT_EQ(refused.error().fix_hint, FixHint::repair);

  const auto counted = loadEnvironment(path("bad.exr"), {.keep_bad = true});
  ASSERT_TRUE(counted);
  EXPECT_EQ(counted->bad_texels.count, 2u);

  const auto repaired = loadEnvironment(path("bad.exr"), {.repair = true});
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->environment.map()->face(0).texel(3, 1)[0], 2.0f);
}

TEST_F(LoadTest, WrongShapesAndNamesAreTold) {
  ASSERT_TRUE(writeImage(path("odd.exr"), Image(7, 4, 3)));
  EXPECT_THAT(loadEnvironment(path("odd.exr")).error().message, HasSubstr("is 7x4"));
  EXPECT_THAT(loadEnvironment(path("none.hdr")).error().message, HasSubstr("no such file"));
  EXPECT_EQ(loadEnvironment("studoi").error().code, ErrorCode::not_found);
  EXPECT_TRUE(loadEnvironment("studio"));
}

}  // namespace
}  // namespace mirrorball
