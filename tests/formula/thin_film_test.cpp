// A thin film's colours against all wavelengths, one by one, by complex amplitudes.

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "formula/bsdf.h"
#include "formula/color.h"

namespace mirrorball::formula {
namespace {

using Complex = std::complex<double>;

/// Airy's sum for one polarisation at one wavelength [µm]; n is the index below the film.
double airy(double cosine, double film, double thickness, Complex n, double wavelength, bool is_parallel) {
  const double sine2 = 1.0 - cosine * cosine;
  const Complex in_film = std::sqrt(Complex(film * film - sine2)), below = std::sqrt(n * n - sine2);
  const auto amplitude = [&](Complex index_a, Complex a, Complex index_b, Complex b) {
    if (!is_parallel) return (a - b) / (a + b);
    const Complex forth = index_b * index_b * a, back = index_a * index_a * b;
    return (forth - back) / (forth + back);
  };
  const Complex upper = amplitude(1.0, cosine, film, in_film), lower = amplitude(film, in_film, n, below);
  const Complex round = std::exp(Complex(0.0, 4.0 * M_PI * thickness / wavelength) * in_film);
  return std::norm((upper + lower * round) / (1.0 + upper * lower * round));
}

/// What red, green and blue see of it in white light.
glm::dvec3 spectral(double cosine, double film, double thickness, glm::vec3 n, glm::vec3 k) {
  constexpr int kSteps = 400;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    const double wavelength = double(kShortestWavelength) + share * double(kLongestWavelength - kShortestWavelength);
    const glm::dvec3 weight(wavelengthWeight(static_cast<float>(wavelength)));
    for (int channel = 0; channel < 3; ++channel) {
      const Complex index{double(n[channel]), double(k[channel])};
      sum[channel] += weight[channel] * 0.5 / kSteps *
                      (airy(cosine, film, thickness, index, wavelength, false) +
                       airy(cosine, film, thickness, index, wavelength, true));
    }
  }
  return sum;
}

struct Base {
  const char* name;
  vec3 n, k;
};
const Base kBases[] = {{"air", vec3(1.0f), vec3(0.0f)},
                       {"glass", vec3(1.5f), vec3(0.0f)},
                       {"diamond", vec3(2.4f), vec3(0.0f)},
                       {"gold", {0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.916f}},
                       {"titanium", {2.741f, 2.542f, 2.267f}, {3.814f, 3.435f, 3.038f}}};

// The bells over the wave number are within a few percent of the matching functions' fit over the wavelength. What lies
// outside of Rec.709 is cut off.
TEST(ThinFilm, IsTheMeanOverAllWavelengths) {
  double squares = 0.0;
  int count = 0;
  for (const Base& base : kBases)
    for (const float film : {1.2f, 1.333f, 2.0f})
      for (const float thickness : {0.0f, 0.1f, 0.25f, 0.4f, 0.8f, 1.5f})
        for (const float cosine : {0.2f, 0.6f, 1.0f}) {
          const vec3 reflected = filmReflectance(cosine, film, thickness, base.n, base.k);
          const glm::dvec3 expected =
              glm::clamp(spectral(cosine, film, thickness, base.n, base.k), glm::dvec3(0.0), glm::dvec3(1.0));
          for (int channel = 0; channel < 3; ++channel) {
            const double error = double(reflected[channel]) - expected[channel];
            EXPECT_NEAR(error, 0.0, 0.04) << base.name << ", index " << film << ", " << thickness << " µm, cosine "
                                          << cosine << ", channel " << channel;
            squares += error * error;
            ++count;
          }
        }
  EXPECT_LT(std::sqrt(squares / count), 0.01);
}

// Without a thickness there is no film.
TEST(ThinFilm, OfNoThicknessIsNotThere) {
  for (const Base& base : kBases)
    for (const float cosine : {0.1f, 0.5f, 1.0f}) {
      const vec3 reflected = filmReflectance(cosine, 1.333f, 0.0f, base.n, base.k);
      for (int channel = 0; channel < 3; ++channel) {
        const float n = base.n[channel], k = base.k[channel];
        const float bare = k > 0.0f ? fresnelConductor1(cosine, n, k) : fresnelDielectric(cosine, n);
        EXPECT_NEAR(reflected[channel], bare, 0.01f) << base.name << ", " << cosine;
      }
    }
}

// A very thick film has no colours left: as many reflections to and fro as there are, without phases.
TEST(ThinFilm, OfGreatThicknessIsColourless) {
  const vec3 reflected = filmReflectance(0.8f, 1.333f, 20.0f, vec3(1.0f), vec3(0.0f));
  EXPECT_NEAR(reflected.x, reflected.y, 1e-4f);
  EXPECT_NEAR(reflected.x, reflected.z, 1e-4f);
  const float one = fresnelDielectric(0.8f, 1.333f);
  EXPECT_NEAR(reflected.x, 2.0f * one / (1.0f + one), 2e-3f) << "of two equal surfaces";
}

TEST(ThinFilm, IsANumberAlongTheSurface) {
  for (const float film : {1.0f, 1.5f})
    for (const Base& base : kBases) {
      const vec3 reflected = filmReflectance(0.0f, film, 0.3f, base.n, base.k);
      EXPECT_TRUE(std::isfinite(reflected.x + reflected.y + reflected.z)) << base.name << ", index " << film;
    }
}

// What all light goes through reflects none of it, and a perfect mirror all.
TEST(ThinFilm, KeepsEnergy) {
  for (const float thickness : {0.05f, 0.3f, 0.9f})
    for (const float cosine : {0.05f, 0.4f, 0.9f}) {
      const vec3 none = filmReflectance(cosine, 1.0f, thickness, vec3(1.0f), vec3(0.0f));
      EXPECT_LT(length(none), 1e-5f);
      const vec3 all = filmReflectance(cosine, 1.5f, thickness, vec3(0.0f), vec3(3.0f));
      EXPECT_LT(distance(all, vec3(1.0f)), 1e-4f);
    }
}

}  // namespace
}  // namespace mirrorball::formula
