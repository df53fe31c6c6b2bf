#include "mirrorball/bake/brdf/directional_albedo.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/surface.h"
#include "mirrorball/bake/harmonics/gauss_legendre.h"

namespace mirrorball {
namespace {

constexpr double kPi = std::numbers::pi;

/// What half vector, masking and visibility make of a pair of directions: D V at (1 − (n·h)², n·v, n·l). The first is
/// exact for half vectors close to the normal, where n·h is not.
using Brdf = std::function<double(double sine2, double eye, double light)>;

double square(double x) { return x * x; }

Brdf ggx(double alpha) {
  return [a2 = alpha * alpha](double sine2, double eye, double light) {
    const auto lambda = [&](double c) { return (std::sqrt(1.0 + a2 * (1.0 / square(c) - 1.0)) - 1.0) / 2.0; };
    const double d = a2 / (kPi * square(a2 + (1.0 - a2) * sine2));
    return d / (1.0 + lambda(eye) + lambda(light)) / (4.0 * eye * light);
  };
}

Brdf blinn(double alpha) {
  const double exponent = 2.0 / square(alpha) - 2.0;
  return [exponent](double sine2, double eye, double light) {
    const auto lambda = [&](double c) {
      const double a = std::sqrt(0.5 * exponent + 1.0) / (std::sqrt(1.0 - square(c)) / c);
      const double g1 = a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a) : 1.0;
      return (1.0 - g1) / g1;
    };
    const double d = (exponent + 2.0) / (2.0 * kPi) * std::exp(exponent / 2.0 * std::log1p(-sine2));
    return d / (1.0 + lambda(eye) + lambda(light)) / (4.0 * eye * light);
  };
}

Brdf charlie(double alpha) {
  return [alpha](double sine2, double eye, double light) {
    const double d = (2.0 + 1.0 / alpha) * std::pow(sine2, 0.5 / alpha) / (2.0 * kPi);
    return d / (4.0 * (light + eye - light * eye));
  };
}

/// Begins and ends of panels over [low, high] that double in width away from each centre, the smallest being `finest`.
std::vector<double> gradedPanels(double low, double high, const std::vector<double>& centres, double finest) {
  std::vector<double> ends{low, high};
  for (const double centre : centres) {
    ends.push_back(centre);
    for (double step = finest; step < high - low; step *= 2.0) {
      ends.push_back(centre - step);
      ends.push_back(centre + step);
    }
  }
  std::erase_if(ends, [&](double end) { return end < low || end > high; });
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

double overPanels(const std::vector<double>& ends, const std::function<double(double)>& f) {
  static const QuadratureRule kRule = gaussLegendre(8);
  double sum = 0.0;
  for (std::size_t panel = 0; panel + 1 < ends.size(); ++panel) {
    const double half = (ends[panel + 1] - ends[panel]) / 2.0;
    for (std::size_t i = 0; i < kRule.places.size(); ++i)
      sum += half * kRule.weights[i] * f(ends[panel] + half * (1.0 + kRule.places[i]));
  }
  return sum;
}

struct Reference {
  double whole;
  double bias;
  double tilt;
};

/// The same in double, over the direction of the light: its angle from the normal, in panels that are finest at the
/// mirror direction and at the horizon, and around, in panels finest in the plane of n and v, where a lobe is alpha n·v
/// wide.
Reference integrated(const Brdf& brdf, double alpha, double eye) {
  const double eye_angle = std::acos(eye);
  const double eye_sine = std::sqrt(1.0 - eye * eye);
  const std::vector<double> along = gradedPanels(0.0, kPi / 2, {eye_angle, kPi / 2}, alpha / 8.0);
  const std::vector<double> around = gradedPanels(0.0, kPi, {0.0, kPi}, alpha * eye / 8.0);
  // Of (1 − v·h) to that power.
  const auto integrate = [&](double power) {
    return overPanels(along, [&](double angle) {
      const double light = std::cos(angle);
      const double light_sine = std::sin(angle);
      return 2.0 * light * light_sine * overPanels(around, [&](double turn) {
               // (v·h)² and what v + l has across the normal, as sums of squares: exact where v and l are nearly
               // mirrored or nearly opposite.
               const double turned = eye_sine * light_sine * square(std::sin(turn / 2));
               const double middle2 = square(std::cos((eye_angle + angle) / 2));
               const double eye_half2 = middle2 + turned;
               const double sine2 = (middle2 * square(std::sin((eye_angle - angle) / 2)) + turned) / eye_half2;
               return brdf(std::min(sine2, 1.0), eye, light) *
                      std::pow(std::max(1.0 - std::sqrt(eye_half2), 0.0), power);
             });
    });
  };
  return {integrate(0.0), integrate(5.0), integrate(1.0)};
}

constexpr float kRoughnesses[] = {1.0f / 256, 0.03f, 0.1f, 0.3f, 0.6f, 1.0f};
constexpr float kCosines[] = {0.5f / 128, 0.02f, 0.1f, 0.4f, 0.8f, 1.0f};

template <typename MakeBrdf>
void expectTheIntegral(Distribution distribution, const MakeBrdf& make, double tolerance) {
  for (const float perceptual_roughness : kRoughnesses)
    for (const float cosine : kCosines) {
      const double alpha = square(perceptual_roughness);
      const Reference expected = integrated(make(alpha), alpha, cosine);
      const DirectionalAlbedo share = directionalAlbedo(distribution, perceptual_roughness, cosine);
      EXPECT_NEAR(share.total(), expected.whole, tolerance * std::max(1.0, expected.whole))
          << "perceptual roughness " << perceptual_roughness << ", n·v " << cosine;
      if (distribution != Distribution::charlie) {
        EXPECT_NEAR(share.bias, expected.bias, tolerance)
            << "perceptual roughness " << perceptual_roughness << ", n·v " << cosine;
        EXPECT_NEAR(share.tilt, expected.tilt, tolerance)
            << "perceptual roughness " << perceptual_roughness << ", n·v " << cosine;
      }
    }
}

TEST(DirectionalAlbedo, OfGgxIsTheIntegralOverTheLight) { expectTheIntegral(Distribution::ggx, ggx, 5e-5); }

TEST(DirectionalAlbedo, OfBlinnIsTheIntegralOverTheLight) { expectTheIntegral(Distribution::blinn, blinn, 5e-5); }

TEST(DirectionalAlbedo, OfCharlieIsTheIntegralOverTheLight) { expectTheIntegral(Distribution::charlie, charlie, 5e-5); }

/// Calls visit(weight, v·h) for facets as an eye at that cosine sees them, of which as many stand along u.x as across.
/// The weights of those that reflect upwards add up to what white facets reflect.
void forEachFacet(float perceptual_roughness, float cosine, glm::ivec2 count,
                  const std::function<void(double weight, float facet_cosine)>& visit) {
  const float alpha = formula::alphaFromPerceptualRoughness(perceptual_roughness);
  const glm::vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  for (int i = 0; i < count.x * count.y; ++i) {
    const glm::vec2 u = (glm::vec2(i / count.y, i % count.y) + 0.5f) / glm::vec2(count);
    const glm::vec3 l = formula::sampleGgx(glm::vec2(alpha), v, u);
    if (l.z <= 0.0f) continue;
    const double weight = formula::evalGgx(glm::vec2(alpha), v, l) * l.z / formula::pdfGgx(glm::vec2(alpha), v, l);
    visit(weight / (count.x * count.y), dot(v, normalize(v + l)));
  }
}

// The table's integral is of the same BSDF that a path tracer evaluates and samples: the mean of the weight
// BSDF · cosine / density over even places, closer along u.x, whose end is the long tail of the lobe.
TEST(DirectionalAlbedo, IsWhatTheSampledBsdfReflects) {
  for (const float perceptual_roughness : {0.2f, 0.5f, 0.8f, 1.0f})
    for (const float cosine : {0.05f, 0.3f, 0.7f, 1.0f}) {
      double scale = 0.0;
      double bias = 0.0;
      double tilt = 0.0;
      forEachFacet(perceptual_roughness, cosine, {2048, 128}, [&](double weight, float facet_cosine) {
        const double grazing = std::pow(1.0 - double(facet_cosine), 5.0);
        scale += weight * (1.0 - grazing);
        bias += weight * grazing;
        tilt += weight * (1.0 - double(facet_cosine));
      });
      const DirectionalAlbedo share = directionalAlbedo(Distribution::ggx, perceptual_roughness, cosine);
      EXPECT_NEAR(share.scale, scale, 5e-4) << perceptual_roughness << " at " << cosine;
      EXPECT_NEAR(share.bias, bias, 5e-4) << perceptual_roughness << " at " << cosine;
      EXPECT_NEAR(share.tilt, tilt, 5e-4) << perceptual_roughness << " at " << cosine;
    }
}

// With alpha 1, D = 1 / π, and at normal incidence V = 1 / (2 + 2 n·l): what is left is the integral of c / (1 + c)
// from 0 to 1.
TEST(DirectionalAlbedo, OfTheRoughestGgxAtNormalIncidenceIsOneMinusLogTwo) {
  EXPECT_NEAR(directionalAlbedo(Distribution::ggx, 1.0f, 1.0f).total(), 1.0 - std::log(2.0), 1e-6);
}

// From the horizon only facets that face the eye are seen, and those send its ray upwards, where with height-correlated
// shadowing all that is seen is also lit.
TEST(DirectionalAlbedo, OfGgxAtGrazingAnglesIsAll) {
  for (const float perceptual_roughness : {0.01f, 0.1f, 0.5f, 1.0f})
    EXPECT_NEAR(directionalAlbedo(Distribution::ggx, perceptual_roughness, 0.0f).total(), 1.0f, 5e-5f);
}

TEST(DirectionalAlbedo, OfASmoothSurfaceIsSchlicks) {
  for (const float cosine : {0.0f, 0.3f, 1.0f}) {
    const DirectionalAlbedo smooth = directionalAlbedo(Distribution::ggx, 0.0f, cosine);
    EXPECT_FLOAT_EQ(smooth.total(), 1.0f);
    EXPECT_FLOAT_EQ(smooth.bias, std::pow(1.0f - cosine, 5.0f));
    if (cosine > 0.1f) {
      EXPECT_NEAR(directionalAlbedo(Distribution::ggx, 0.01f, cosine).bias, smooth.bias, 1e-4f)
          << "and is reached steadily";
    }
  }
  EXPECT_EQ(directionalAlbedo(Distribution::charlie, 0.0f, 0.5f).total(), 0.0f);
}

TEST(DirectionalAlbedo, OfPhongIsThatOfTheBlinnLobeAsWide) {
  EXPECT_EQ(directionalAlbedo(Distribution::phong, 0.4f, 0.3f).scale,
            directionalAlbedo(Distribution::blinn, 0.4f, 0.3f).scale);
}

/// What facets reflect, as a share of what white ones do, by the formula that takes two kinds of them for all.
float reflectedByTwoKinds(const DirectionalAlbedo& albedo, float perceptual_roughness, float cosine,
                          const std::function<float(float)>& fresnel) {
  formula::Surface surface;
  surface.material.perceptual_roughness = perceptual_roughness;
  surface.environment_brdf = {1.0f - albedo.total(), albedo.grazing(), albedo.meanTilt()};
  const glm::vec2 seen = formula::facetsSeen(surface, cosine);
  return glm::mix(fresnel(1.0f), fresnel(seen.x), seen.y);
}

// Schlick's form, and one that is a line, are their means over all facets. Other forms are, nearly: their greatest
// errors are at grazing angles, where the facets differ most.
TEST(DirectionalAlbedo, TwoKindsOfFacetsStandForAll) {
  struct Form {
    const char* name;
    std::function<float(float)> fresnel;
    double tolerance;
    double mean_tolerance;  // over angles
  };
  const std::vector<Form> forms = {
      {"Schlick", [](float c) { return formula::fresnelSchlick(c, glm::vec3(0.04f)).x; }, 1e-3, 2e-4},
      {"glass", [](float c) { return formula::fresnelDielectric(c, 1.5f); }, 0.01, 0.002},
      {"diamond", [](float c) { return formula::fresnelDielectric(c, 2.417f); }, 0.018, 0.0025},
      {"chromium", [](float c) { return formula::fresnelConductor1(c, 3.107f, 3.331f); }, 0.035, 0.006},
      {"F82", [](float c) { return formula::fresnelF82(c, glm::vec3(0.9f), glm::vec3(0.5f)).x; }, 0.09, 0.018},
      {"a power of 2", [](float c) { return formula::fresnelEmpirical(c, 0.1f, 0.9f, 2.0f); }, 0.035, 0.016},
      {"a line", [](float c) { return formula::fresnelEmpirical(c, 0.0f, 1.0f, 1.0f); }, 1e-3, 3e-4}};
  for (const Form& form : forms)
    for (const float perceptual_roughness : {0.05f, 0.2f, 0.45f, 1.0f}) {
      double sum = 0.0;
      for (float cosine = 0.025f; cosine < 1.0f; cosine += 0.05f) {
        const DirectionalAlbedo albedo = directionalAlbedo(Distribution::ggx, perceptual_roughness, cosine);
        double reflected = 0.0;
        forEachFacet(perceptual_roughness, cosine, {128, 128}, [&](double weight, float facet_cosine) {
          reflected += weight * double(form.fresnel(facet_cosine));
        });
        const double error =
            double(albedo.total() * reflectedByTwoKinds(albedo, perceptual_roughness, cosine, form.fresnel)) -
            reflected;
        EXPECT_NEAR(error, 0.0, form.tolerance) << form.name << ", " << perceptual_roughness << " at " << cosine;
        sum += std::abs(error) / 20.0;
      }
      EXPECT_LT(sum, form.mean_tolerance) << form.name << ", " << perceptual_roughness;
    }
}

TEST(DirectionalAlbedo, MeanIsTheAlbedoUnderWhiteLight) {
  for (const float perceptual_roughness : {0.05f, 0.3f, 1.0f}) {
    constexpr int kSteps = 4000;
    double mean = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
      mean += 2.0 * double(cosine) / kSteps *
              double(directionalAlbedo(Distribution::ggx, perceptual_roughness, cosine).total());
    }
    EXPECT_NEAR(averageAlbedo(Distribution::ggx, perceptual_roughness), mean, 2e-5);
  }
}

}  // namespace
}  // namespace mirrorball
