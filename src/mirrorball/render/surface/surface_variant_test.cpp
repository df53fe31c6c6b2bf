// Every answer to every question, and every pair of answers, makes shaders that compile: by glslang in tests/parity, which
// needs no driver, and here the names of what the rooms share.

#include "mirrorball/render/surface/surface_variant.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/gl/gl_testing.h"
#include "mirrorball/gl/program.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

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
  material.bump = BumpHeight::orange;
  material.transmission = 0.5f;
  material.roughness_map.texture = 0;
  FrameSettings settings;
  settings.reflect_at = ReflectAt::triangle;
  settings.lights.resize(2);
  const SurfaceVariant variant = surfaceVariant(material, settings);
  EXPECT_TRUE(variant.has(Part::normal, NormalPart::bump));
  EXPECT_TRUE(variant.has(Part::detail, DetailPart::none));
  EXPECT_TRUE(variant.has(Part::look_up, LookUpPart::triangle_reflection));
  EXPECT_TRUE(variant.has(Part::transmission, TransmissionPart::single));
  EXPECT_TRUE(variant.has(Part::lamps, LampsPart::point));
  EXPECT_EQ(variant.lamp_count, 2);
  EXPECT_EQ(materialMaps()[2].name, "roughness_map");
  EXPECT_EQ(variant.maps, 4u);
}

TEST(SurfaceVariant, CompilesOnlyWhatItUses) {
  const auto plain = surfaceShaders(gl::Api::es30, {});
  ASSERT_TRUE(plain);
  for (const char* unused : {"orangeHeight", "sampler2D sphere_map", "normal_map;", "LAMP_COUNT", "#include"})
    EXPECT_THAT(plain->fragment.text, Not(HasSubstr(unused)));
}

}  // namespace
}  // namespace mirrorball
