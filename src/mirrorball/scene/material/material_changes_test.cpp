#include "mirrorball/scene/material/material_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

TEST(MaterialChanges, ReachEverySurface) {
  Scene scene;
  scene.materials.resize(2);
  scene.meshes.resize(2);
  scene.meshes[1].edit().material = 1;
  scene.meshes[1].edit().vertices.resize(1);
  scene.meshes[1].edit().vertices[0].color = glm::vec4(0.5f);
  ASSERT_TRUE(changeMaterials(scene, {.set = {"metallic=0.25"}}));
  EXPECT_EQ(scene.materials[1].metallic, 0.25f);

  ASSERT_TRUE(changeMaterials(scene, {.material = "gold", .fresnel = FresnelOverride::empirical}));
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].fresnel, formula::kFresnelEmpirical);
  EXPECT_EQ(scene.meshes[1]->material, 0);
  EXPECT_EQ(scene.meshes[1]->vertices[0].color, glm::vec4(1.0f));

  EXPECT_THAT(changeMaterials(scene, {.material = "godl"}).error().message,
              ::testing::HasSubstr("did you mean 'gold'"));
}

}  // namespace
}  // namespace mirrorball
