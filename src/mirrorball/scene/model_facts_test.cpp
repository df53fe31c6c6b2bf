#include "mirrorball/scene/model_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mirrorball/scene/gltf/gltf_document_material.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/shapes/builtin_shapes.h"

namespace mirrorball {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(ModelFacts, AreWhatDiffersFromGltfsDefaultsAndThePictures) {
  Material material = gltf::defaultMaterial();
  material.name = "paint";
  material.metallic = 0.25f;
  Scene scene = meshScene(sphereMesh(), material);
  scene.textures = {{.image = Image8(8, 4, 4)}, {.image = Image(2, 2, 4)}};
  scene.materials[0].base_color_map.texture = 0;
  scene.materials[0].normal_map.texture = 1;
  const auto facts = materialFacts(scene);
  ASSERT_EQ(facts.size(), 1u);
  EXPECT_EQ(facts[0].name, "paint");
  EXPECT_THAT(facts[0].parameters, ElementsAre(Pair("metallic", "0.25")));
  ASSERT_EQ(facts[0].maps.size(), 2u);
  EXPECT_EQ(facts[0].maps[0].name, "base_color_map");
  EXPECT_EQ(facts[0].maps[0].size, glm::ivec2(8, 4));
  EXPECT_FALSE(facts[0].maps[0].has_floats);
  EXPECT_TRUE(facts[0].maps[1].has_floats);
  EXPECT_THAT(likelyMistakes(scene), IsEmpty());
}

TEST(ModelFacts, MistakesAreTold) {
  Scene scene = meshScene(sphereMesh());
  scene.materials[0].base_color = glm::vec3(0.0f);
  EXPECT_THAT(likelyMistakes(scene), ElementsAre(HasSubstr("all base colours are black")));
  scene.materials[0].base_color = glm::vec3(0.5f);
  scene.materials[0].opacity = 0.0f;
  EXPECT_THAT(likelyMistakes(scene), IsEmpty()) << "opaque";
  scene.materials[0].alpha_mode = AlphaMode::blend;
  EXPECT_THAT(likelyMistakes(scene), Contains(HasSubstr("nothing is seen")));
  scene.materials[0].opacity = 1.0f;
  scene.textures.push_back({.image = Image8(2, 2, 4)});
  scene.materials[0].base_color_map.texture = 0;
  for (Vertex& vertex : scene.meshes[0].edit().vertices) vertex.uv[0] = vertex.uv[1] = glm::vec2(0.0f);
  EXPECT_THAT(likelyMistakes(scene), Contains(HasSubstr("no texture coordinates")));
  for (const float scale : {1e-4f, 1e5f}) {
    Scene sized = meshScene(sphereMesh());
    sized.instances[0].world_from_object = glm::mat4(glm::mat3(scale));
    EXPECT_THAT(likelyMistakes(sized), ElementsAre(HasSubstr(scale < 1.0f ? "a millimetre" : "a kilometre")));
  }
  EXPECT_THAT(likelyMistakes(Scene()), IsEmpty());
}

}  // namespace
}  // namespace mirrorball
