#include "formula/sun.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "formula/surface.h"

namespace mirrorball::formula {
namespace {

constexpr float kDegree = 0.0174532925f;

/// The mean of a function over even points of a disc of directions.
template <typename Function>
auto meanOverDisc(vec3 middle, float radius, Function function) {
  constexpr int kPoints = 4000;
  const vec3 t = anyTangent(middle);
  const vec3 b = cross(middle, t);
  decltype(function(middle)) sum(0.0f);
  for (int i = 0; i < kPoints; ++i) {
    const vec2 at = radius * shadowTap(i, kPoints, 0.0f);
    sum += function(normalize(middle + at.x * t + at.y * b));
  }
  return sum / float(kPoints);
}

vec3 towardsAt(float angle) { return {std::sin(angle), 0.0f, std::cos(angle)}; }

TEST(Sun, AShareOfALobeIsItsIntegralOverTheDisc) {
  for (const float width : {0.3f, 1.0f, 3.0f})
    for (const float distance : {0.0f, 0.5f, 0.9f, 1.1f, 3.0f}) {
      double sum = 0.0;
      constexpr int kPoints = 20000;
      for (int i = 0; i < kPoints; ++i) {
        const vec2 at = vec2(distance, 0.0f) + shadowTap(i, kPoints, 0.0f);
        const double spread = double(width * width + dot(at, at));
        sum += double(width * width) / (3.14159265 * spread * spread);
      }
      const double integral = sum / kPoints * 3.14159265;
      EXPECT_NEAR(shareInDisc(distance * distance, 1.0f, width, 0.0f), integral, 1e-3) << width << " " << distance;
    }
}

TEST(Sun, AShareOfALobeInAnEllipseIsItsIntegral) {
  for (const vec2 axes : {vec2(0.3f, 0.3f), vec2(0.1f, 2.0f), vec2(5.0f, 0.4f), vec2(6.0f, 9.0f)})
    for (const float turn : {0.0f, 0.5f, 2.0f})
      for (const vec2 middle : {vec2(0.0f), vec2(0.2f, 0.1f), vec2(3.0f, 0.0f), vec2(1.0f, 7.0f)}) {
        const vec2 along = vec2(std::cos(turn), std::sin(turn));
        const vec2 across = vec2(-along.y, along.x);
        double sum = 0.0;
        constexpr int kPoints = 40000;
        for (int i = 0; i < kPoints; ++i) {
          const vec2 at = axes * shadowTap(i, kPoints, 0.0f);
          const vec2 place = middle + at.x * along + at.y * across;
          sum += 1.0 / std::pow(1.0 + double(dot(place, place)), 2.0);
        }
        const double integral = sum / kPoints * double(axes.x * axes.y);
        const vec2 squared = axes * axes;
        const vec3 spread(squared.x * along.x * along.x + squared.y * across.x * across.x,
                          squared.x * along.x * along.y + squared.y * across.x * across.y,
                          squared.x * along.y * along.y + squared.y * across.y * across.y);
        EXPECT_NEAR(shareInEllipse(middle, spread, axes.x * axes.y), integral, 2e-3)
            << axes.x << " " << axes.y << " turned " << turn << " at " << middle.x << " " << middle.y;
      }
}

/// Ends of its axes are where few steps leave most. The integral is along the longer axis: across it, ∫ dy / (a² + y²)²
/// is y / (2 a² (a² + y²)) + atan(y / a) / (2 a³).
TEST(Sun, AShareOfALobeInAStretchedEllipseIsItsIntegral) {
  for (const vec2 axes : {vec2(0.3f, 30.0f), vec2(10.0f, 200.0f), vec2(67.0f, 653.0f), vec2(1.34f, 928.0f)})
    for (const vec2 place : {vec2(0.0f), vec2(0.0f, 0.5f), vec2(0.0f, 0.985f), vec2(0.0f, 1.0f), vec2(0.69f, 0.985f),
                             vec2(1.0f, 0.1f), vec2(0.6f, 0.7f), vec2(0.0f, 1.1f)})
      for (const float turn : {0.0f, 0.7f}) {
        const vec2 middle = axes * place;
        double integral = 0.0;
        const double farthest = double(middle.y + axes.y);
        const double nearest = double(middle.y - axes.y);
        // Steps are even in asinh of the place.
        constexpr int kSteps = 20000;
        const double from = std::asinh(nearest);
        const double step = (std::asinh(farthest) - from) / kSteps;
        for (int i = 0; i < kSteps; ++i) {
          const double y = std::sinh(from + (i + 0.5) * step);
          const double width =
              double(axes.x) * std::sqrt(std::max(0.0, 1.0 - std::pow((y - double(middle.y)) / double(axes.y), 2.0)));
          const double a = std::sqrt(1.0 + y * y);
          const auto until = [&](double x) {
            return x / (2.0 * a * a * (a * a + x * x)) + std::atan(x / a) / (2.0 * a * a * a);
          };
          integral += (until(double(middle.x) + width) - until(double(middle.x) - width)) / 3.14159265 * a * step;
        }
        const vec2 x_axis = vec2(std::cos(turn), std::sin(turn));
        const vec2 y_axis = vec2(-x_axis.y, x_axis.x);
        const vec2 squared = axes * axes;
        const vec3 spread(squared.x * x_axis.x * x_axis.x + squared.y * y_axis.x * y_axis.x,
                          squared.x * x_axis.x * x_axis.y + squared.y * y_axis.x * y_axis.y,
                          squared.x * x_axis.y * x_axis.y + squared.y * y_axis.y * y_axis.y);
        const float share = shareInEllipse(middle.x * x_axis + middle.y * y_axis, spread, axes.x * axes.y);
        EXPECT_NEAR(share, integral, 2e-3)
            << axes.x << " " << axes.y << " at " << place.x << " " << place.y << " of them";
      }
}

TEST(Sun, WithoutALobeItIsTheDisc) {
  EXPECT_EQ(shareInDisc(0.99f, 1.0f, 0.0f, 0.0f), 1.0f);
  EXPECT_EQ(shareInDisc(1.01f, 1.0f, 0.0f, 0.0f), 0.0f);
  // The edge is as wide as a sample sees.
  EXPECT_NEAR(shareInDisc(1.0f, 1.0f, 0.0f, 0.2f), 0.5f, 1e-6f);
  EXPECT_GT(shareInDisc(1.05f * 1.05f, 1.0f, 0.0f, 0.2f), 0.0f);
  EXPECT_EQ(shareInDisc(1.2f * 1.2f, 1.0f, 0.0f, 0.2f), 0.0f);
}

/// However coarsely a mirror is sampled, the samples together see all of the sun's light.
TEST(Sun, NoSampleMissesIt) {
  Sun sun;
  sun.towards = normalize(vec3(0.003f, 0.001f, 1.0f));
  sun.irradiance = vec3(2.0f);
  for (const float pixel : {0.002f, 0.02f, 0.1f}) {
    double sum = 0.0;
    for (int y = -40; y <= 40; ++y)
      for (int x = -40; x <= 40; ++x) {
        const vec3 d = normalize(vec3(pixel * float(x), pixel * float(y), 1.0f));
        const double solid_angle = double(pixel * pixel * d.z * d.z * d.z);
        sum += double(sunInLobe(sun, d, 0.0f, pixel * pixel).x) * solid_angle;
      }
    EXPECT_NEAR(sum, 2.0, 0.1) << pixel;
  }
}

TEST(Sun, ARoughLookUpSeesWhatALobeReflectsOfIt) {
  Sun sun;
  sun.radius = 0.5f * kDegree;
  sun.irradiance = vec3(1.0f);
  for (const float roughness : {0.2f, 0.4f, 0.7f}) {
    const float alpha = roughness * roughness;
    // The lobe's density over its mean cosine, by the formulas of sampling.
    double cosines = 0.0;
    constexpr int kSamples = 4000;
    for (int i = 0; i < kSamples; ++i) cosines += std::max(0.0, double(coneRay(alpha, i, kSamples).z)) / kSamples;
    EXPECT_NEAR(meanCosineOfLobe(alpha), cosines, 2e-3) << roughness;
    for (const float angle : {0.0f, 0.05f, 0.3f, 1.0f}) {
      sun.towards = towardsAt(angle);
      const float seen = meanOverDisc(sun.towards, sun.radius, [&](vec3 l) {
        const float cosine = std::max(l.z, 0.0f);
        return ggxDistribution(vec2(alpha), normalize(l + vec3(0, 0, 1))) / 4.0f * cosine / float(cosines);
      });
      EXPECT_NEAR(sunInLobe(sun, vec3(0, 0, 1), roughness, 0.0f).x, seen, 0.01f * seen) << roughness << " " << angle;
    }
  }
}

TEST(Sun, OfADiscAtTheHorizonAPartShines) {
  EXPECT_EQ(facingDisc(0.5f, 0.01f), 0.5f);
  EXPECT_EQ(facingDisc(-0.01f, 0.01f), 0.0f);
  const float half = meanOverDisc(vec3(1, 0, 0), 0.01f, [](vec3 l) { return std::max(l.z, 0.0f); });
  EXPECT_NEAR(facingDisc(0.0f, 0.01f), half, 0.2f * half);
}

Surface surfaceOf(float roughness, float cosine) {
  Surface s;
  s.material = coreMaterial(Material(), vec3(0.9f, 0.6f, 0.3f), 0.5f, roughness, vec3(0.0f));
  s.normal = vec3(0, 0, 1);
  s.tangent = vec3(1, 0, 0);
  s.occlusion = 1.0f;
  s.environment_brdf = vec3(0.05f, 0.3f, 0.2f);
  return seenAlong(s, -towardsAt(std::acos(cosine)));
}

/// Beside the mean over the disc of what light from one direction shows, also where the eye nearly grazes: the image of
/// the disc among slopes is then many times longer than wide.
TEST(Sun, ASurfaceAnswersToEachPartOfIt) {
  Sun sun;
  sun.irradiance = vec3(3.0f);
  for (const float radius_deg : {0.1f, 0.265f, 1.0f})
    for (const float roughness : {0.1f, 0.15f, 0.2f, 0.3f, 0.6f, 1.0f})
      for (const float cosine : {1.0f, 0.7f, 0.3f, 0.1f, 0.05f}) {
        sun.radius = radius_deg * kDegree;
        const Surface s = surfaceOf(roughness, cosine);
        const vec3 ray = -towardsAt(std::acos(cosine));
        const auto at = [&](float beside) {
          sun.towards = normalize(reflect(ray, s.normal) + beside * vec3(0.4f, 0.6f, 0.3f));
          return meanOverDisc(sun.towards, sun.radius,
                              [&](vec3 l) { return shadedByPunctualLight(s, ray, l, sun.irradiance).x; });
        };
        const float brightest = at(0.0f);
        // What masks the light changes over a disc that is as wide as it is high above the horizon.
        const float wide = 0.02f + 0.3f * sun.radius / cosine;
        for (const float beside : {0.0f, 0.01f, 0.05f, 0.2f, 0.6f}) {
          const float truth = at(beside);
          EXPECT_NEAR(shadedBySun(s, ray, sun, 0.0f).x, truth, wide * truth + 0.01f * brightest)
              << radius_deg << " degrees, roughness " << roughness << ", cosine " << cosine << ", beside " << beside;
        }
      }
}

vec3 directionAt(float height, float azimuth) {
  const float across = std::sqrt(1.0f - height * height);
  return {across * std::cos(azimuth), across * std::sin(azimuth), height};
}

/// The mean of D G / (4 v.z) over the part of a disc that is above the horizon.
float meanInFacets(vec2 alpha, vec3 v, vec3 l, float radius) {
  return meanOverDisc(l, radius, [&](vec3 d) { return d.z > 0.0f ? evalGgx(alpha, v, d) * d.z : 0.0f; });
}

/// Bumps turn their normals away from the eye until it grazes them, and from the sun: together they shine as they
/// should, and each does nearly.
TEST(Sun, GrazedFacetsDoNotShineTooMuch) {
  for (const float radius : {0.0046f, 0.0175f, 0.05f})
    for (const float cosine : {0.3f, 0.1f, 0.05f, 0.02f, 0.005f}) {
      const vec3 v = directionAt(cosine, kPi);
      double drawn = 0.0;
      double right = 0.0;
      for (const vec2 alpha : {vec2(0.04f), vec2(0.12f), vec2(0.25f), vec2(0.25f, 0.03f)}) {
        struct Entry {
          vec3 l;
          float mean;
        };
        std::vector<Entry> entries;
        float brightest = 0.0f;
        for (const float height : {-0.003f, 0.003f, 0.01f, 0.03f, 0.06f, 0.1f, 0.3f, 0.8f})
          for (const float beside : {0.0f, 0.02f, 0.1f, 0.3f, 1.0f}) {
            const vec3 l = directionAt(height, beside);
            entries.push_back({l, meanInFacets(alpha, v, l, radius)});
            brightest = std::max(brightest, entries.back().mean);
          }
        for (const auto& [l, mean] : entries) {
          const float light = discInFacets(alpha, v, l, radius, 0.0f);
          drawn += double(light);
          right += double(mean);
          if (mean < 0.05f * brightest) continue;
          EXPECT_GT(light / mean, 0.5f) << radius << " " << cosine << " " << alpha.x << " " << l.y << " " << l.z;
          EXPECT_LT(light / mean, 2.0f) << radius << " " << cosine << " " << alpha.x << " " << l.y << " " << l.z;
        }
      }
      EXPECT_NEAR(drawn / right, 1.0, 0.06) << radius << " " << cosine;
    }
}

/// A disc of 6 degrees, as a pixel of a small ball sees a sun, of which a part is below the horizon.
TEST(Sun, AWideDiscAtTheHorizonShinesOnGrazedFacets) {
  for (const float beside : {0.0f, 0.1f, 0.3f}) {
    const vec3 v = directionAt(0.03f, kPi);
    const vec3 l = directionAt(0.03f, beside);
    const float mean = meanInFacets(vec2(0.25f), v, l, 0.1f);
    const float light = discInFacets(vec2(0.25f), v, l, 0.1f, 0.0f);
    EXPECT_GT(light, 0.6f * mean) << beside;
    EXPECT_LT(light, 1.8f * mean) << beside;
  }
}

/// Brushed metal, whose lobe a wide disc fills across its grooves.
TEST(Sun, BrushedMetalShowsAllOfAWideDisc) {
  const vec2 alpha(0.25f, 0.0025f);
  for (const float cosine : {1.0f, 0.7f, 0.4f}) {
    const vec3 v = directionAt(cosine, kPi);
    for (const float height : {0.4f, 0.7f, 0.9f}) {
      const vec3 l = directionAt(height, 0.0f);
      const float mean = meanInFacets(alpha, v, l, 0.05f);
      EXPECT_NEAR(discInFacets(alpha, v, l, 0.05f, 0.0f), mean, 0.06f * mean) << cosine << " " << height;
    }
  }
}

/// It sets without a jump.
TEST(Sun, ASettingDiscFades) {
  const vec3 v = directionAt(0.2f, kPi);
  float last = discInFacets(vec2(0.2f), v, directionAt(0.02f, 0.1f), 0.01f, 0.0f);
  const float above = last;
  for (float height = 0.019f; height > -0.01f; height -= 0.001f) {
    const float light = discInFacets(vec2(0.2f), v, directionAt(height, 0.1f), 0.01f, 0.0f);
    EXPECT_LE(light, last * 1.001f) << height;
    EXPECT_LT(last - light, 0.1f * above) << height;
    last = light;
  }
  EXPECT_EQ(discInFacets(vec2(0.2f), v, directionAt(-0.011f, 0.1f), 0.01f, 0.0f), 0.0f);
}

/// Mirrors and mattness, eyes and suns at the horizon, discs of any size.
TEST(Sun, IsANumberEverywhere) {
  for (const float alpha : {2e-5f, 1e-3f, 1.0f})
    for (const float eye : {1e-4f, 1e-2f, 1.0f})
      for (const float height : {-1e-2f, -1e-7f, 1e-4f, 2e-4f, 1e-2f, 1.0f})
        for (const float beside : {0.0f, 1e-4f, 0.1f, 3.0f})
          for (const float turn : {0.0f, 0.3f, 1.0f, 1.9f, 2.6f, 4.4f})
            for (const float radius : {1e-6f, 0.0046f, 0.1f, 0.7f}) {
              const vec3 l = directionAt(height, turn + beside);
              const float light = discInFacets(vec2(alpha), directionAt(eye, turn + kPi), l, radius, 1e-3f);
              EXPECT_TRUE(std::isfinite(light) && light >= 0.0f)
                  << alpha << " " << eye << " " << height << " " << beside << " " << turn << " " << radius << ": "
                  << light;
            }
}

TEST(Sun, AMirrorShowsItsDisc) {
  Sun sun;
  sun.irradiance = vec3(1.0f);
  sun.radius = 0.3f * kDegree;
  const float radiance = 1.0f / (kPi * sun.radius * sun.radius);
  for (const float cosine : {1.0f, 0.5f, 0.1f, 0.02f}) {
    Surface s = surfaceOf(0.0f, cosine);
    s.environment_brdf = vec3(0.0f);  // a mirror has no facets that light could go between
    s.material.metallic = 1.0f;
    s.material.base_color = vec3(1.0f);
    s = seenAlong(s, -towardsAt(std::acos(cosine)));
    const vec3 ray = -towardsAt(std::acos(cosine));
    const auto at = [&](float share) {
      const vec3 mirrored = reflect(ray, s.normal);
      sun.towards = normalize(mirrored + share * sun.radius * normalize(cross(mirrored, vec3(0.2f, 1.0f, 0.1f))));
      return shadedBySun(s, ray, sun, 0.0f).x;
    };
    // The cosine at the facets is that of the disc's middle.
    const float tolerance = 0.02f + 0.4f * sun.radius / cosine;
    for (const float share : {0.0f, 0.5f, 0.9f}) EXPECT_NEAR(at(share), radiance, tolerance * radiance) << cosine;
    for (const float share : {1.1f, 2.0f, 10.0f}) EXPECT_LT(at(share), 0.02f * radiance) << cosine;
  }
}

TEST(Sun, ShadowsFollowThePlaneTheyFallOn) {
  // 45 degrees towards +x, seen along +z: it becomes deeper by as much as it goes to −x.
  const vec2 slope = slopeInShadow(normalize(vec3(1.0f, 0.0f, -1.0f)));
  EXPECT_NEAR(slope.x, 1.0f, 1e-5f);
  EXPECT_NEAR(slope.y, 0.0f, 1e-6f);
  EXPECT_LE(length(slopeInShadow(vec3(1.0f, 0.0f, 0.0f))), 4.001f);
}

}  // namespace
}  // namespace mirrorball::formula
