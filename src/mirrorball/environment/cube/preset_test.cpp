#include "mirrorball/environment/cube/preset.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/constants.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/environment_testing.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

/// u of our direction in a program's panorama, by the program's own formula.
using Longitude = float (*)(glm::vec3 direction);

/// atan2 in turns of the circle.
float turns(float y, float x) { return std::atan2(y, x) / formula::kTwoPi; }

TEST(Preset, EveryArrangementIsACube) {
  for (const Preset& preset : presets())
    if (preset.cube) {
      EXPECT_TRUE(isComplete(*preset.cube)) << preset.name;
    }
}

// Unity's look-ups and those of web engines mirror x, Unreal's exchange y and z; all then read by OpenGL's table.
TEST(Preset, ACubeAnswersByTheProgramsLookUp) {
  const EnvironmentMap cube = *convert(Environment(testing::smoothRadiance, 128), Projection::cube, 64);
  const auto expectLookUp = [&](std::string_view name, glm::mat3 program_from_ours) {
    const EnvironmentMap images(Projection::cube,
                                imagesOf(cube, *formFor(*presetNamed(name), Projection::cube, CubeLayout::faces)));
    for (const glm::vec3 d : testing::manyDirections(300))
      EXPECT_LT(glm::length(images.radiance(program_from_ours * d) - cube.radiance(d)), 1e-4f) << name;
  };
  const glm::mat3 x_mirrored(glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1));
  const glm::mat3 z_up(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0));
  for (const std::string_view name : {"opengl", "vulkan", "directx", "godot", "filament", "renderman"})
    expectLookUp(name, glm::mat3(1.0f));
  expectLookUp("unity", x_mirrored);
  for (const std::string_view name : {"three", "babylon", "playcanvas"}) expectLookUp(name, x_mirrored);
  expectLookUp("unreal", z_up);
  expectLookUp("krpano", x_mirrored);
  expectLookUp("ogre", glm::mat3(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)));
}

// MakeSkyVec of Quake III's tr_sky.c: a place (s, t) in [-1, 1]², t upwards, of each side of the sky.
TEST(Preset, AnImageOfQuakesSkyIsWhereMakeSkyVecPutsIt) {
  struct Side {
    int slot;       // of rt lf up dn ft bk
    int places[3];  // st_to_vec: 1 = s, 2 = t, 3 = 1
  };
  constexpr Side kSides[] = {{0, {3, -1, 2}},  {1, {-3, 1, 2}},  {5, {1, 3, 2}},
                             {4, {-1, -3, 2}}, {2, {-2, -1, 3}}, {3, {2, -1, -3}}};
  constexpr int kSide = 64;
  const EnvironmentMap cube = *convert(Environment(testing::smoothRadiance, 128), Projection::cube, kSide);
  const ImageSet images = imagesOf(cube, *formFor(*presetNamed("quake"), Projection::cube, CubeLayout::faces));
  for (const Side& side : kSides)
    for (const glm::ivec2 texel : {glm::ivec2(3, 5), glm::ivec2(60, 20), glm::ivec2(31, 62)}) {
      const glm::vec2 st = (glm::vec2(texel) + 0.5f) / float(kSide) * 2.0f - 1.0f;
      const glm::vec3 places(st.x, -st.y, 1.0f);  // row 0 is on top
      glm::vec3 quake;
      for (int axis = 0; axis < 3; ++axis) {
        const int place = side.places[axis];
        quake[axis] = place < 0 ? -places[-place - 1] : places[place - 1];
      }
      const glm::vec3 ours = glm::normalize(glm::vec3(quake.x, quake.z, -quake.y));
      EXPECT_LT(glm::length(rgbAt(images.at(0, side.slot), texel.x, texel.y) - testing::smoothRadiance(ours)), 2e-2f)
          << side.slot;
    }
}

// The formulas are those of the sources in docs/conventions.md, with each program's axes written in ours.
TEST(Preset, APanoramaAnswersByTheProgramsFormula) {
  const EnvironmentMap map = *convert(Environment(testing::smoothRadiance, 256), Projection::equirect, 128);
  const auto expectLongitude = [&](std::string_view name, Longitude longitude) {
    const Image picture = pictureOf(map, *formFor(*presetNamed(name), Projection::equirect, CubeLayout::faces));
    for (const glm::vec3 d : testing::manyDirections(300)) {
      const float v = std::acos(d.y) / formula::kPi;
      if (v < 0.05f || v > 0.95f) continue;
      const glm::vec2 position(glm::fract(longitude(d)) * 256.0f, v * 128.0f);
      const auto fetch = [&](int x, int y) { return glm::vec4(rgbAt(picture, (x + 256) % 256, y), 1.0f); };
      EXPECT_LT(glm::length(glm::vec3(bilinear(position, fetch)) - testing::smoothRadiance(d)), 3e-3f) << name;
    }
  };
  for (const std::string_view name : {"opengl", "vulkan", "directx", "godot", "renderman"})
    expectLongitude(name, [](glm::vec3 d) { return turns(d.x, -d.z); });
  expectLongitude("filament", [](glm::vec3 d) { return 0.5f + turns(-d.x, d.z); });
  for (const std::string_view name : {"babylon", "playcanvas"})
    expectLongitude(name, [](glm::vec3 d) { return 0.5f + turns(-d.x, d.z); });
  expectLongitude("three", [](glm::vec3 d) { return 0.5f + turns(d.z, d.x); });
  expectLongitude("unity", [](glm::vec3 d) { return 0.5f - turns(d.z, -d.x); });
  expectLongitude("unreal", [](glm::vec3 d) { return 0.5f + turns(d.x, -d.z); });
  expectLongitude("blender", [](glm::vec3 d) { return 0.5f - turns(-d.z, d.x); });
}

TEST(Preset, WhatAProgramDoesNotTakeIsTold) {
  const auto messageFor = [](std::string_view name, Projection projection) {
    return formFor(*presetNamed(name), projection, CubeLayout::hcross).error().message;
  };
  EXPECT_THAT(messageFor("blender", Projection::cube), HasSubstr("Blender has no cube maps"));
  EXPECT_THAT(messageFor("gltf", Projection::cube), HasSubstr("glTF has no cube maps"));
  EXPECT_THAT(messageFor("three", Projection::angular), HasSubstr("no map of projection angular"));
  EXPECT_THAT(messageFor("openexr", Projection::eac), HasSubstr("no map of projection eac"));
  EXPECT_THAT(messageFor("openexr", Projection::cube), HasSubstr("in the layout vstrip (or faces) only, not hcross"));
  EXPECT_THAT(presetNamed("unreel").error().message, HasSubstr("did you mean 'unreal'?"));
}

TEST(Preset, FilesOfWhichAProgramMakesNoLightAreTold) {
  const auto insteadOf = [](std::string_view name, Projection projection, std::string_view extension) {
    return importedInstead(*presetNamed(name), projection, extension).value_or("");
  };
  EXPECT_EQ(insteadOf("unreal", Projection::equirect, "dds"),
            "Unreal Engine makes light of a panorama in .hdr and of a cube in .dds, not of a panorama in .dds");
  EXPECT_THAT(insteadOf("unreal", Projection::cube, "hdr"), HasSubstr("not of a cube in .hdr"));
  EXPECT_EQ(insteadOf("unreal", Projection::equirect, "hdr"), "");
  EXPECT_EQ(insteadOf("unreal", Projection::cube, "dds"), "");
  EXPECT_THAT(insteadOf("unity", Projection::cube, "ktx2"), HasSubstr("not of a cube in .ktx2"));
  EXPECT_EQ(insteadOf("unity", Projection::cube, "tiff"), "");
  EXPECT_THAT(insteadOf("godot", Projection::cube, "ktx2"), HasSubstr(".hdr or .exr"));
  EXPECT_EQ(insteadOf("blender", Projection::equirect, "ktx2"),
            "Blender makes light of a panorama in .hdr or .exr or .png or .jpg or .tif or .webp, not of a panorama in "
            ".ktx2");
  for (const Preset& preset : presets())
    if (preset.panorama_files.empty())
      EXPECT_FALSE(importedInstead(preset, Projection::equirect, "ktx")) << preset.name;
}

TEST(Preset, EachHasARowInTheConventions) {
  std::ifstream stream(std::string(MIRRORBALL_SOURCE_DIR) + "/docs/conventions.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  for (const Preset& preset : presets())
    EXPECT_NE(text.find("| `" + std::string(preset.name) + "` |"), std::string::npos) << preset.name;
}

}  // namespace
}  // namespace mirrorball
