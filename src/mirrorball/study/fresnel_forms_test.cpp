#include "mirrorball/study/fresnel_forms.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/bsdf.h"

namespace mirrorball {
namespace {

using ::testing::HasSubstr;

FresnelCurves curvesOfIndex(float ior) {
  Material material;
  material.ior = ior;
  return fresnelCurves(material).value().at(0);
}

/// The greatest error of an empirical form over angles between those that a fit looks at.
float greatestErrorOf(float ior, float offset, float scale, float power) {
  float greatest = 0.0f;
  for (float cosine = 0.0f; cosine <= 1.0f; cosine += 1.0f / 3001.0f)
    greatest = std::max(greatest, std::abs(formula::fresnelEmpirical(cosine, offset, scale, power) -
                                           formula::fresnelDielectric(cosine, ior)));
  return greatest;
}

// docs/techniques/materials.md, "Fresnel".
TEST(FresnelForms, FitsAreThoseOfTheDocumentation) {
  struct Known {
    float ior, schlick, fitted, offset, scale, power;
  };
  for (const Known& known :
       {Known{1.333f, 0.059f, 0.014f, 0.034f, 0.952f, 5.756f}, Known{1.5f, 0.036f, 0.015f, 0.055f, 0.929f, 5.305f},
        Known{2.417f, 0.075f, 0.020f, 0.192f, 0.789f, 6.175f}}) {
    const FresnelCurves curves = curvesOfIndex(known.ior);
    EXPECT_NEAR(curves.schlick_error, known.schlick, 0.0006f) << known.ior;
    EXPECT_NEAR(curves.empirical.greatest_error, known.fitted, 0.0006f) << known.ior;
    EXPECT_NEAR(curves.empirical.offset, known.offset, 0.001f) << known.ior;
    EXPECT_NEAR(curves.empirical.scale, known.scale, 0.001f) << known.ior;
    EXPECT_NEAR(curves.empirical.power, known.power, 0.02f) << known.ior;
  }
}

// Whatever is changed a little makes it worse, and it has the error that it says.
TEST(FresnelForms, NoEmpiricalFormNearTheFitIsBetter) {
  for (const float ior : {1.1f, 1.333f, 2.417f, 4.0f}) {
    const EmpiricalFit fit = curvesOfIndex(ior).empirical;
    const float error = greatestErrorOf(ior, fit.offset, fit.scale, fit.power);
    EXPECT_NEAR(error, fit.greatest_error, 3e-4f) << ior;
    for (const float sign : {-1.0f, 1.0f}) {
      EXPECT_GT(greatestErrorOf(ior, fit.offset + sign * 0.004f, fit.scale, fit.power), error) << ior;
      EXPECT_GT(greatestErrorOf(ior, fit.offset, fit.scale + sign * 0.004f, fit.power), error) << ior;
      EXPECT_GT(greatestErrorOf(ior, fit.offset, fit.scale, fit.power * (1.0f + sign * 0.04f)), error) << ior;
    }
  }
}

TEST(FresnelForms, AnEmpiricalCurveIsItsOwnFit) {
  const EmpiricalFit fit =
      fitEmpirical([](float cosine) { return formula::fresnelEmpirical(cosine, 0.1f, 0.8f, 3.0f); });
  EXPECT_NEAR(fit.offset, 0.1f, 1e-3f);
  EXPECT_NEAR(fit.scale, 0.8f, 1e-3f);
  EXPECT_NEAR(fit.power, 3.0f, 1e-2f);
  EXPECT_LT(fit.greatest_error, 1e-4f);
}

TEST(FresnelForms, StaySaneForEveryIndex) {
  for (const float ior : {0.1f, 0.75f, 1.0f, 1.0001f, 10.0f}) {
    const FresnelCurves curves = curvesOfIndex(ior);
    for (std::size_t form = 0; form < kFresnelFormNames.size(); ++form)
      for (const float cosine : {0.0f, 0.1f, 0.5f, 1.0f}) {
        const float reflectance = curves.reflectance(FresnelForm(form), cosine);
        EXPECT_GE(reflectance, 0.0f) << ior << " " << kFresnelFormNames[form];
        EXPECT_LE(reflectance, 1.0f) << ior << " " << kFresnelFormNames[form];
      }
    EXPECT_GE(curves.empirical.offset, 0.0f);
    EXPECT_GE(curves.empirical.power, 0.1f);
    EXPECT_LE(curves.empirical.power, 20.0f);
  }
  EXPECT_EQ(curvesOfIndex(1.0f).f0, 0.0f);
}

// A metal is told for each channel; F82 meets its curve at its dip, which Schlick's form lacks.
TEST(FresnelForms, OfAMetalAreThoseOfItsChannels) {
  const auto curves = fresnelCurves(*materialNamed("aluminium"));
  ASSERT_TRUE(curves);
  ASSERT_EQ(curves->size(), 3u);
  const Material aluminium = *materialNamed("aluminium");
  for (int channel = 0; channel < 3; ++channel) {
    const FresnelCurves& each = curves->at(std::size_t(channel));
    EXPECT_EQ(each.n, aluminium.conductor_n[channel]);
    EXPECT_FLOAT_EQ(each.f0, aluminium.base_color[channel]);
    EXPECT_NEAR(each.reflectance(FresnelForm::f82, 1.0f / 7.0f), each.reflectance(FresnelForm::exact, 1.0f / 7.0f),
                1e-5f);
    EXPECT_LT(each.f82_error, each.schlick_error / 2.0f) << each.name;
  }
  EXPECT_EQ(fresnelCurves(*materialNamed("water"))->size(), 1u);
}

TEST(FresnelForms, NeedAnIndex) {
  for (const char* name : {"mirror", "rough-metal"}) {
    const auto curves = fresnelCurves(*materialNamed(name));
    ASSERT_FALSE(curves) << name;
    EXPECT_EQ(curves.error().code, ErrorCode::usage);
    EXPECT_THAT(curves.error().message, HasSubstr(name));
  }
}

TEST(FresnelForms, ArePlottedInAFileOfItsOwn) {
  const std::string svg = fresnelPlotOf(*fresnelCurves(*materialNamed("gold")), "gold <au>");
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, HasSubstr("<style>"));
  EXPECT_THAT(svg, HasSubstr("gold &lt;au&gt;, blue"));
  EXPECT_THAT(svg, HasSubstr(">90</text>"));
  EXPECT_EQ(svg.find("<circle"), std::string::npos) << "ninety points would hide their line";
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace mirrorball
