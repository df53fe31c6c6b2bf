#include "mirrorball/environment/builtin/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "formula/color.h"
#include "formula/constants.h"
#include "formula/sky.h"
#include "mirrorball/base/parallel.h"

namespace mirrorball {
namespace {

/// In steps of 25 nm from 412.5 to 687.5 nm; 80 wavelengths from 380 to 720 nm differ by 1 %.
constexpr int kWavelengths = 12;
using Spectrum = std::array<float, kWavelengths>;
constexpr float wavelengthOf(int i) { return 0.4f + 0.025f * (static_cast<float>(i) + 0.5f); }

/// The sun's illuminance outside of the air.
constexpr float kSunlight_klx = 133.8f;
/// Of the ground, for what it sends back into the air.
constexpr float kGroundAlbedo = 0.2f;

/// What the air is made of: depths of its whole height.
struct Air {
  Spectrum molecules;
  Spectrum haze;
  Spectrum ozone;

  explicit Air(float turbidity) {
    for (int i = 0; i < kWavelengths; ++i) {
      molecules[i] = formula::moleculeDepth(wavelengthOf(i));
      haze[i] = formula::hazeDepth(wavelengthOf(i), turbidity);
      ozone[i] = formula::ozoneDepth(wavelengthOf(i));
    }
  }

  /// The share of the sun's light that comes to a place.
  Spectrum sunlight(float height, float sun_cosine) const {
    Spectrum light{};
    const float visible = formula::sunAboveHorizon(height, sun_cosine);
    if (visible <= 0.0f) return light;
    const glm::vec3 columns = formula::columnsTowardsSun(height, sun_cosine);
    for (int i = 0; i < kWavelengths; ++i)
      light[i] = visible * std::exp(-(columns.x * molecules[i] + columns.y * haze[i] + columns.z * ozone[i]));
    return light;
  }
};

/// A ray through the air: where it begins, and the cosines that it makes with the zenith and the sun there.
struct Ray {
  float height;
  float cosine;
  float sun_cosine;  ///< of the sun with the zenith
  float towards_sun;
};

/// A piece of a ray. Light that is scattered along it by a unit of molecules or haze comes to the ray's beginning as
/// `molecules` and `haze`.
struct Step {
  float height;
  float sun_cosine;  ///< with the zenith that is there
  Spectrum molecules;
  Spectrum haze;
};

/// Calls visit(step) for the pieces of a ray, which grow with the distance, and returns what the air lets through of
/// the light at its end.
template <typename Visit>
Spectrum alongRay(const Air& air, const Ray& ray, float length, int steps, const Visit& visit) {
  Spectrum through;
  through.fill(1.0f);
  float begin = 0.0f;
  for (int i = 1; i <= steps; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(steps);
    const float end = length * part * part;
    const float middle = 0.5f * (begin + end);
    Step step;
    step.height = std::max(formula::heightAlong(ray.height, ray.cosine, middle), 0.0f);
    step.sun_cosine = ((formula::kEarthRadius + ray.height) * ray.sun_cosine + middle * ray.towards_sun) /
                      (formula::kEarthRadius + step.height);
    const float molecules = std::exp(-step.height / formula::kMoleculeScale) / formula::kMoleculeScale;
    const float haze = std::exp(-step.height / formula::kHazeScale) / formula::kHazeScale;
    const float ozone = formula::ozoneDensity(step.height);
    for (int w = 0; w < kWavelengths; ++w) {
      const float stopped = molecules * air.molecules[w] + haze * air.haze[w] + ozone * air.ozone[w];
      const float passed = std::exp(-stopped * (end - begin));
      const float seen = through[w] * (1.0f - passed) / stopped;
      step.molecules[w] = seen * molecules * air.molecules[w];
      step.haze[w] = seen * haze * air.haze[w] * formula::kHazeAlbedo;
      through[w] *= passed;
    }
    visit(step);
    begin = end;
  }
  return through;
}

/// The light that has been scattered at least twice, as the mean over all directions, of a sun of 1: at some heights,
/// and for some heights of the sun there.
class FurtherScattering {
 public:
  FurtherScattering(const Air& air, float sun_elevation_rad)
      : first_elevation_(sun_elevation_rad - 0.5f * kSpan_rad), light_(std::size_t(kHeights * kElevations)) {
    parallelFor(light_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const int row = static_cast<int>(i) / kElevations;
        const float part = static_cast<float>(row) / (kHeights - 1);
        const float elevation =
            first_elevation_ + kSpan_rad * static_cast<float>(static_cast<int>(i) % kElevations) / (kElevations - 1);
        light_[i] = lightAt(air, formula::kTopOfAir * part * part * part, std::sin(elevation));
      }
    });
  }

  Spectrum at(float height, float sun_cosine) const {
    const float row = std::cbrt(height / formula::kTopOfAir) * (kHeights - 1);
    const float column =
        (std::asin(std::clamp(sun_cosine, -1.0f, 1.0f)) - first_elevation_) / kSpan_rad * (kElevations - 1);
    const int y = std::clamp(static_cast<int>(row), 0, kHeights - 2);
    const int x = std::clamp(static_cast<int>(column), 0, kElevations - 2);
    const float down = std::clamp(row - static_cast<float>(y), 0.0f, 1.0f);
    const float across = std::clamp(column - static_cast<float>(x), 0.0f, 1.0f);
    const Spectrum* upper = &light_[std::size_t(y * kElevations + x)];
    const Spectrum* lower = upper + kElevations;
    Spectrum light;
    for (int w = 0; w < kWavelengths; ++w)
      light[w] = glm::mix(glm::mix(upper[0][w], upper[1][w], across), glm::mix(lower[0][w], lower[1][w], across), down);
    return light;
  }

 private:
  /// A ray along the horizon has the sun up to 6° higher or lower where it leaves what matters of the air.
  static constexpr float kSpan_rad = 0.21f;
  static constexpr int kHeights = 9;
  static constexpr int kElevations = 9;

  /// Each further scattering sends on the same share of the light as the one before: a geometric series.
  static Spectrum lightAt(const Air& air, float height, float sun_cosine) {
    constexpr int kRings = 8;
    constexpr int kPlaces = 4;
    constexpr int kSteps = 16;
    Spectrum second{};    // scattered twice
    Spectrum transfer{};  // of light from all sides, what is scattered once more
    const float sun_sine = std::sqrt(std::max(1.0f - sun_cosine * sun_cosine, 0.0f));
    for (int ring = 0; ring < kRings; ++ring)
      for (int place = 0; place < kPlaces; ++place) {
        const float cosine = (2.0f * static_cast<float>(ring) + 1.0f) / kRings - 1.0f;
        const float azimuth = formula::kPi * (static_cast<float>(place) + 0.5f) / kPlaces;
        const float towards_sun =
            std::sqrt(1.0f - cosine * cosine) * std::cos(azimuth) * sun_sine + cosine * sun_cosine;
        const float to_ground = formula::distanceToGround(height, cosine);
        const float length = to_ground >= 0.0f ? to_ground : formula::distanceToTop(height, cosine);
        const Ray ray{height, cosine, sun_cosine, towards_sun};
        const Spectrum through = alongRay(air, ray, length, kSteps, [&](const Step& step) {
          const Spectrum sunlight = air.sunlight(step.height, step.sun_cosine);
          for (int w = 0; w < kWavelengths; ++w) {
            const float scattered = step.molecules[w] + step.haze[w];
            second[w] += scattered * sunlight[w] / (4.0f * formula::kPi);
            transfer[w] += scattered;
          }
        });
        if (to_ground < 0.0f) continue;
        const float cosine_there =
            ((formula::kEarthRadius + height) * sun_cosine + length * towards_sun) / formula::kEarthRadius;
        const Spectrum sunlight = air.sunlight(0.0f, cosine_there);
        for (int w = 0; w < kWavelengths; ++w)
          second[w] += through[w] * sunlight[w] * std::max(cosine_there, 0.0f) * kGroundAlbedo / formula::kPi;
      }
    Spectrum light;
    for (int w = 0; w < kWavelengths; ++w)
      light[w] = second[w] / (kRings * kPlaces) / (1.0f - transfer[w] / (kRings * kPlaces));
    return light;
  }

  float first_elevation_;
  std::vector<Spectrum> light_;
};

/// What a share of the sun's light at each wavelength is in Rec.709 with the white of D55, in klx.
std::array<glm::vec3, kWavelengths> rec709OfSunlight() {
  std::array<glm::vec3, kWavelengths> xyz;
  float luminous = 0.0f;
  for (int w = 0; w < kWavelengths; ++w) {
    xyz[w] = formula::xyzOfWavelength(wavelengthOf(w)) * formula::sunSpectrum(wavelengthOf(w));
    luminous += xyz[w].y;
  }
  for (glm::vec3& color : xyz)
    color = formula::rec709FromXyz(formula::xyzD65FromD55(color * (kSunlight_klx / luminous)));
  return xyz;
}

/// The table's rows: row / last = y (1 + k) / (y + k) for the sine y of the elevation,
/// so that they are close at the horizon.
constexpr int kRows = 64;
constexpr int kColumns = 16;
constexpr float kRowBend = 0.25f;
float rowOf(float y) { return (kRows - 1) * y * (1.0f + kRowBend) / (y + kRowBend); }
float sineOfRow(int row) {
  const float part = static_cast<float>(row) / (kRows - 1);
  return part * kRowBend / (1.0f + kRowBend - part);
}

}  // namespace

SkyLight::SkyLight(glm::vec3 sun, float turbidity) : sun_(sun), table_(std::size_t(kRows * kColumns)) {
  const float sun_sine = std::sqrt(sun.x * sun.x + sun.z * sun.z);
  towards_sun_ = sun_sine > 0.0f ? glm::vec2(sun.x, sun.z) / sun_sine : glm::vec2(0.0f, 1.0f);
  const Air air(turbidity);
  const std::array<glm::vec3, kWavelengths> rec709 = rec709OfSunlight();
  const Spectrum sunlight = air.sunlight(0.0f, sun.y);
  for (int w = 0; w < kWavelengths; ++w) sun_irradiance_ += sunlight[w] * rec709[w];
  sun_irradiance_ = glm::max(sun_irradiance_, glm::vec3(0.0f));

  const FurtherScattering further(air, std::asin(std::clamp(sun.y, 0.0f, 1.0f)));
  parallelFor(kRows, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * kColumns; i < end * kColumns; ++i) {
      const float y = sineOfRow(static_cast<int>(i) / kColumns);
      const float azimuth_cosine = 1.0f - 2.0f * static_cast<float>(i % kColumns) / (kColumns - 1);
      const float towards_sun = std::sqrt(1.0f - y * y) * azimuth_cosine * sun_sine + y * sun.y;
      const Ray ray{0.0f, y, sun.y, towards_sun};
      alongRay(air, ray, formula::distanceToTop(0.0f, y), 32, [&](const Step& step) {
        const Spectrum direct = air.sunlight(step.height, step.sun_cosine);
        const Spectrum again = further.at(step.height, step.sun_cosine);
        for (int w = 0; w < kWavelengths; ++w) {
          table_[i].by_molecules += step.molecules[w] * direct[w] * rec709[w];
          table_[i].by_haze += step.haze[w] * direct[w] * rec709[w];
          table_[i].again += (step.molecules[w] + step.haze[w]) * again[w] * rec709[w];
        }
      });
    }
  });
}

glm::vec3 SkyLight::radiance(glm::vec3 d) const {
  const float y = std::clamp(d.y, 0.0f, 1.0f);
  const float level = std::sqrt(d.x * d.x + d.z * d.z);
  const float azimuth_cosine =
      level > 0.0f ? std::clamp((d.x * towards_sun_.x + d.z * towards_sun_.y) / level, -1.0f, 1.0f) : 1.0f;
  const float row = rowOf(y);
  const float column = 0.5f * (kColumns - 1) * (1.0f - azimuth_cosine);
  const int i = std::min(static_cast<int>(row), kRows - 2);
  const int j = std::min(static_cast<int>(column), kColumns - 2);
  const float up = row - static_cast<float>(i);
  const float across = column - static_cast<float>(j);
  const Scattered* lower = &table_[std::size_t(i * kColumns + j)];
  const Scattered* upper = lower + kColumns;
  const auto read = [&](glm::vec3 Scattered::*part) {
    return glm::mix(glm::mix(lower[0].*part, lower[1].*part, across), glm::mix(upper[0].*part, upper[1].*part, across),
                    up);
  };
  const float turn = glm::dot(d, sun_);
  const glm::vec3 light = read(&Scattered::by_molecules) * formula::moleculePhase(turn) +
                          read(&Scattered::by_haze) * formula::hazePhase(turn) + read(&Scattered::again);
  return glm::max(light, glm::vec3(0.0f));
}

}  // namespace mirrorball
