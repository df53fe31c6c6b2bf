// Every answer to every question, and every pair of answers, makes shaders that compile: by glslang in tests/parity,
// which needs no driver, and here the names of what the rooms share.

#include "mirrorball/render/surface/surface_variant.h"

#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/render/surface/surface_shaders.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class SurfaceVariantTest : public gl::GlTest {};

MIRRORBALL_WITH_BOTH_APIS(SurfaceVariantTest);

// A row of the table that the struct in formula/material.glsl lacks, or the other way round, is found here.
TEST_P(SurfaceVariantTest, TheMaterialBlockHasTheTablesParameters) {
  const auto shaders = surfaceShaders(GetParam(), {});
  ASSERT_TRUE(shaders) << shaders.error().message;
  auto program = gl::Program::build(shaders->vertex, shaders->fragment, "surface");
  ASSERT_TRUE(program) << program.error().message;
  const auto layout = program->connect("MaterialBlock", 0);
  ASSERT_TRUE(layout);
  for (const MaterialParameter& parameter : materialParameters()) {
    const bool is_number = std::holds_alternative<float Material::*>(parameter.field) ||
                           std::holds_alternative<glm::vec3 Material::*>(parameter.field);
    if (!is_number) continue;
    EXPECT_NE(layout->find("material." + std::string(parameter.text.name)), nullptr) << parameter.text.name;
  }
}

TEST(SurfaceVariant, FollowsMaterialAndSettings) {
  Material material;
  material.height = HeightKind::orange;
  material.transmission = 0.5f;
  material.roughness_map.texture = 0;
  FrameSettings settings;
  settings.reflect_at = ReflectAt::triangle;
  std::vector<MapSource> maps(materialMaps().size());
  maps[2] = {.unit = 0};
  const SurfaceVariant variant = surfaceVariant(material, maps, settings, {.lamps = 2});
  EXPECT_TRUE(variant.has(Part::normal, NormalPart::bump));
  EXPECT_TRUE(variant.has(Part::detail, DetailPart::none));
  EXPECT_TRUE(variant.has(Part::coordinates, CoordinatesPart::at_triangle));
  EXPECT_TRUE(variant.has(Part::look_up, LookUpPart::environment));
  EXPECT_TRUE(variant.has(Part::transmission, TransmissionPart::single));
  EXPECT_TRUE(variant.has(Part::lamps, LampsPart::listed));
  EXPECT_EQ(variant.lamp_count, 2);
  EXPECT_EQ(variant.maps, maps);
}

TEST(SurfaceVariant, CompilesOnlyWhatItUses) {
  const auto plain = surfaceShaders(gl::Api::es30, {});
  ASSERT_TRUE(plain);
  for (const char* unused :
       {"orangeHeight", "sampler2D sphere_map", "normal_map;", "map_layers", "LAMP_COUNT", "#include"})
    EXPECT_THAT(plain->fragment.text, Not(HasSubstr(unused)));
}

// A branch by a uniform costs a software driver both of its sides in each pixel.
TEST(SurfaceVariant, WhatAFrameAndAMaterialDecideAreConstants) {
  Material material;
  material.fresnel = formula::kFresnelSchlick;
  material.dispersion = 0.3f;
  FrameSettings settings{.texture_filter = TextureFilter::nearest};
  settings.blur = BlurKind::cone;
  const ShaderConstants plain = shaderConstants(material, settings);
  const ShaderConstants expected{.texture_filter = formula::kFilterNearest,
                                 .blur_kind = 2,
                                 .lobe_taps = 1,  // of a cone
                                 .fresnel = formula::kFresnelSchlick,
                                 .disperses = true};
  EXPECT_EQ(plain, expected);

  material.conductor_k.y = 2.0f;
  settings.blur = BlurKind::exact;
  material.specular_color_map.texture = 0;
  const ShaderConstants rich = shaderConstants(material, settings);
  EXPECT_TRUE(rich.has_conductor_index);
  EXPECT_TRUE(rich.has_specular_color);
  EXPECT_EQ(rich.lobe_taps, 4);
  EXPECT_THAT(definitionsOf(rich),
              AllOf(Contains("LOBE_TAPS 4"), Contains("FRESNEL 1"), Contains("HAS_SPECULAR_COLOR true")));

  // What a variant does not read makes no other program.
  const auto constantsOf = [&](const Material& of) {
    return surfaceVariant(of, std::vector<MapSource>(materialMaps().size()), settings, {}).constants;
  };
  EXPECT_EQ(constantsOf(material).lobe_taps, 4);
  material.perceptual_roughness = 0.0f;
  EXPECT_EQ(constantsOf(material).lobe_taps, 1);
  material.normal_map.texture = 0;  // whose strata have no lobes to tell apart
  EXPECT_EQ(constantsOf(material).lobe_taps, 1);
  material.clearcoat = 1.0f;
  material.clearcoat_roughness = 0.0f;
  EXPECT_TRUE(constantsOf(material).has_smooth_coat);
  EXPECT_EQ(seenFromInside(constantsOf(material)),
            (ShaderConstants{.texture_filter = formula::kFilterNearest, .lobe_taps = 1}));
  material.unlit = true;
  EXPECT_EQ(constantsOf(material), ShaderConstants{.texture_filter = formula::kFilterNearest});

  const auto shaders = surfaceShaders(gl::Api::es30, {.constants = rich});
  ASSERT_TRUE(shaders);
  EXPECT_THAT(shaders->fragment.text, HasSubstr("#define LOBE_TAPS 4"));
  for (const char* uniform : {"int texture_filter;", "int lobe_taps;", "int blur_kind;"})
    EXPECT_THAT(shaders->fragment.text, Not(HasSubstr(uniform)));
}

// From the first level of a chain on, whose lobes are of roughness .0635 where there are eight more.
TEST(SurfaceVariant, WideLobesReadNoEnvironmentBesideItsChain) {
  const formula::Blur chain{.kind = 0, .first_level = 1.0f, .last_level = 8.0f, .texels_per_radian = 80.0f};
  const ShaderConstants one{.lobe_taps = 1}, four{.lobe_taps = 4};
  Material material;
  material.perceptual_roughness = 0.1f;
  EXPECT_TRUE(hasWideLobes(material, one, chain));
  EXPECT_FALSE(hasWideLobes(material, four, chain)) << "the narrowest of a row has a third of the roughness";
  material.perceptual_roughness = 0.5f;
  EXPECT_TRUE(hasWideLobes(material, four, chain));
  EXPECT_FALSE(hasWideLobes(material, four, formula::Blur{0, 0.0f, 1.0f, 4.0f})) << "of a small probe";
  EXPECT_FALSE(hasWideLobes(material, {.blur_kind = 1}, chain)) << "mip levels";
  material.clearcoat = 1.0f;
  EXPECT_FALSE(hasWideLobes(material, four, chain)) << "a smooth coat";
  material.clearcoat_roughness = 0.6f;
  EXPECT_TRUE(hasWideLobes(material, four, chain));
  material.roughness_map.texture = 0;
  EXPECT_FALSE(hasWideLobes(material, four, chain)) << "a map may be dark";
}

TEST(SurfaceVariant, MetalsWithAndWithoutAnIndexShareAProgram) {
  std::array<SurfaceVariant, 3> variants;
  variants[1].constants.has_conductor_index = true;
  variants[2].lamp_count = 1;
  const SurfaceVariant with_index = variants[1], lit_by_lamp = variants[2];
  shareVariants(variants);
  EXPECT_EQ(variants[0], with_index);
  EXPECT_EQ(variants[1], with_index);
  EXPECT_EQ(variants[2], lit_by_lamp) << "no other one is like it";
}

TEST(SurfaceVariant, MapsWithTheSameUnitReadOneSampler) {
  SurfaceVariant variant;
  variant.maps[0] = {.unit = 0};
  variant.maps[1] = {.unit = 1};
  variant.maps[2] = {.unit = 1};
  const auto shaders = surfaceShaders(gl::Api::es30, variant);
  ASSERT_TRUE(shaders);
  EXPECT_THAT(
      shaders->fragment.text,
      AllOf(HasSubstr("uniform sampler2D base_color_map;"), HasSubstr("uniform sampler2D metallic_map;"),
            Not(HasSubstr("sampler2D roughness_map")), HasSubstr("texture(metallic_map, mapCoordinates(point, 2), ")));
}

}  // namespace
}  // namespace mirrorball
