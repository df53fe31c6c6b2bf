#include "mirrorball/scene/material/material.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

TEST(Material, EveryListedNameIsMade) {
  for (const std::string_view name : materialNames()) {
    const auto material = materialNamed(name);
    ASSERT_TRUE(material) << name;
    EXPECT_EQ(material->name, name);
  }
}

TEST(Material, WrongNameListsTheRightOnes) {
  const auto material = materialNamed("miror");
  ASSERT_FALSE(material);
  EXPECT_EQ(material.error().code, ErrorCode::usage);
  EXPECT_THAT(material.error().message, HasSubstr("did you mean 'mirror'"));
  EXPECT_THAT(material.error().message, HasSubstr("rough-metal"));
}

TEST(Material, EveryParameterTakesItsOwnDefaultBack) {
  for (const Option<Material>& parameter : materialParameters()) {
    Material material;
    const std::string value = written(parameter, material);
    EXPECT_TRUE(setParameter(material, std::string(parameter.text.name) + "=" + value)) << parameter.text.name;
    EXPECT_EQ(written(parameter, material), value);
    EXPECT_FALSE(parameter.text.help.empty());
  }
}

TEST(Material, ParametersAreNamedOnce) {
  std::set<std::string_view> names;
  for (const auto& parameter : materialParameters()) EXPECT_TRUE(names.insert(parameter.text.name).second);
}

TEST(Material, SetParameterSetsOneFieldOrTellsWhatIsWrong) {
  Material material;
  ASSERT_TRUE(setParameter(material, "base_color=1,0.5,0.2"));
  EXPECT_EQ(material.base_color, glm::vec3(1.0f, 0.5f, 0.2f));
  ASSERT_TRUE(setParameter(material, "base_color=0.25"));
  EXPECT_EQ(material.base_color, glm::vec3(0.25f));
  ASSERT_TRUE(setParameter(material, "fresnel=empirical"));
  EXPECT_EQ(material.fresnel, formula::kFresnelEmpirical);

  EXPECT_THAT(setParameter(material, "roughness=1").error().message, HasSubstr("perceptual_roughness"));
  EXPECT_THAT(setParameter(material, "metallic").error().message, HasSubstr("metallic=0"));
  EXPECT_THAT(setParameter(material, "metallic=2").error().message, HasSubstr("0 … 1"));
}

}  // namespace
}  // namespace mirrorball
