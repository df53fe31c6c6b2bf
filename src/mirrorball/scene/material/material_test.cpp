#include "mirrorball/scene/material/material.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/surface.h"

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

// Schott's data sheet of SF11: n_C, n_F and n_g.
TEST(Material, AGlassHasItsMeasuredIndexUntilAnotherOneIsSet) {
  const auto iorAt = [](const Material& material, float wavelength) {
    return formula::atWavelength(material, wavelength).ior;
  };
  const Material sf11 = *materialNamed("sf11");
  EXPECT_NEAR(iorAt(sf11, 0.65627f), 1.77599f, 1e-5f);
  EXPECT_NEAR(iorAt(sf11, 0.48613f), 1.80645f, 1e-5f);
  EXPECT_NEAR(iorAt(sf11, 0.43583f), 1.82518f, 1e-5f);
  EXPECT_EQ(iorAt(sf11, 0.0f), sf11.ior) << "of no wavelength";

  Material clear = sf11;
  ASSERT_TRUE(setParameter(clear, "dispersion=0"));
  EXPECT_EQ(iorAt(clear, 0.43583f), sf11.ior);
  Material denser = sf11;
  ASSERT_TRUE(setParameter(denser, "ior=1.9"));
  EXPECT_NEAR(iorAt(denser, 0.58756f), 1.9f, 1e-5f);
  // With the same Abbe number.
  EXPECT_NEAR((1.9f - 1.0f) / (iorAt(denser, 0.48613f) - iorAt(denser, 0.65627f)), 25.76f, 0.05f);
  Material smooth = sf11;
  ASSERT_TRUE(setParameter(smooth, "specular=0.5"));
  EXPECT_EQ(iorAt(smooth, 0.43583f), iorAt(sf11, 0.43583f)) << "other parameters leave it";
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
