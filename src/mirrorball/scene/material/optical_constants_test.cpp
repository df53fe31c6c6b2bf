#include "mirrorball/scene/material/optical_constants.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

const MeasuredGlass& glassNamed(std::string_view name) {
  for (const MeasuredGlass& glass : measuredGlasses())
    if (glass.name == name) return glass;
  ADD_FAILURE() << "no glass is named " << name;
  return measuredGlasses()[0];
}

struct Catalogued {
  std::string_view name;
  float ior;          // n_d
  float abbe_number;  // V_d
};

// Schott's data sheets of N-BK7, F2 and SF11; Hellma's of calcium fluoride; for fused silica and diamond the figures
// that go with their formulas.
TEST(MeasuredGlass, HasTheIndexAndAbbesNumberOfItsCatalogue) {
  for (const Catalogued& known : {Catalogued{"bk7", 1.51680f, 64.17f}, Catalogued{"f2", 1.62004f, 36.37f},
                                  Catalogued{"sf11", 1.78472f, 25.76f}, Catalogued{"fused-silica", 1.45846f, 67.82f},
                                  Catalogued{"fluorite", 1.43384f, 95.23f}, Catalogued{"diamond", 2.4175f, 55.30f}}) {
    EXPECT_NEAR(iorOf(glassNamed(known.name)), known.ior, 1e-4f) << known.name;
    EXPECT_NEAR(abbeNumberOf(glassNamed(known.name)), known.abbe_number, 0.1f) << known.name;
  }
}

// Sapphire's ordinary ray as measured; water at 20 °C by IAPWS 1997, 1.33299 against air, which has 1.000272.
TEST(MeasuredGlass, HasTheIndexThatWasMeasuredAtOtherWavelengths) {
  const MeasuredGlass& sapphire = glassNamed("sapphire");
  EXPECT_NEAR(formula::iorOfSellmeier(sapphire.b, sapphire.c, 0.488f), 1.7753f, 1e-4f);
  EXPECT_NEAR(formula::iorOfSellmeier(sapphire.b, sapphire.c, 0.590f), 1.76804f, 1e-4f);
  EXPECT_NEAR(formula::iorOfSellmeier(sapphire.b, sapphire.c, 0.670f), 1.76433f, 1e-4f);
  const MeasuredGlass& water = glassNamed("water");
  EXPECT_NEAR(formula::iorOfSellmeier(water.b, water.c, 0.5893f), 1.33299f * 1.000272f, 1e-4f);
}

// Nothing here absorbs visible light, and so its index falls from blue to red ("normal dispersion").
TEST(MeasuredGlass, DispersesNormally) {
  for (const MeasuredGlass& glass : measuredGlasses()) {
    float last = 10.0f;
    for (float wavelength = 0.36f; wavelength <= 0.83f; wavelength += 0.01f) {
      const float ior = formula::iorOfSellmeier(glass.b, glass.c, wavelength);
      EXPECT_LT(ior, last) << glass.name << " at " << wavelength;
      EXPECT_GT(ior, 1.0f) << glass.name << " at " << wavelength;
      last = ior;
    }
    EXPECT_FALSE(glass.source.empty());
  }
}

// F0 = ((n − 1)² + k²) / ((n + 1)² + k²). The colours are those that everyone knows: gold and copper are the only two
// that reflect much less blue than red; iron, titanium, chromium and tungsten reflect about half of the light.
TEST(MeasuredMetal, ReflectsWhatItIsKnownFor) {
  const auto colorOf = [](std::string_view name) { return materialNamed(name)->base_color; };
  for (const MeasuredMetal& metal : measuredMetals()) {
    const glm::vec3 above = (metal.n - 1.0f) * (metal.n - 1.0f) + metal.k * metal.k;
    const glm::vec3 below = (metal.n + 1.0f) * (metal.n + 1.0f) + metal.k * metal.k;
    const glm::vec3 color = colorOf(metal.name);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(color[channel], above[channel] / below[channel], 1e-4f) << metal.name;
    const bool is_coloured = metal.name == "gold" || metal.name == "copper";
    EXPECT_EQ(color.z / color.x < 0.75f, is_coloured) << metal.name;
    EXPECT_FALSE(metal.source.empty());
  }
  EXPECT_GT(colorOf("silver").y, 0.97f);
  EXPECT_NEAR(colorOf("aluminium").y, 0.915f, 0.005f);
  for (const std::string_view name : {"chromium", "iron", "titanium", "tungsten"})
    EXPECT_NEAR(colorOf(name).y, 0.54f, 0.05f) << name;
}

TEST(Material, IsAMeasuredSubstanceByItsNameOrItsTradeName) {
  const auto glass = materialNamed("glass");
  ASSERT_TRUE(glass);
  EXPECT_EQ(glass->ior, iorOf(glassNamed("bk7")));
  EXPECT_EQ(glass->ior, materialNamed("n-bk7")->ior);
  EXPECT_EQ(glass->dispersion, 20.0f / abbeNumberOf(glassNamed("bk7")));
  EXPECT_EQ(materialNamed("chrome")->conductor_k, materialNamed("chromium")->conductor_k);
  EXPECT_EQ(materialNamed("Aluminum")->name, "aluminium");
  EXPECT_EQ(materialNamed("fused_silica")->transmission, 1.0f);
}

}  // namespace
}  // namespace mirrorball
