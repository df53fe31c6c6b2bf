#include "mirrorball/light_edit/lamp_energy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "mirrorball/bake/prefilter/prefilter.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

constexpr int kBlurredSize = 64;  // of the cubes that hold the rest's light, which has no small lamps
constexpr int kCoarseRows = 512;
constexpr int kNormals = 2000;
constexpr int kTurns = 64;
constexpr int kPointsOfDisc = 256;

float greatestOf(glm::vec3 light) { return std::max({light.x, light.y, light.z}); }

const double kGoldenAngle_rad = std::numbers::pi * (3.0 - std::sqrt(5.0));

/// Points spread evenly over a lamp's disc (Vogel's spiral).
std::vector<glm::vec3> discOf(const MapLamp& lamp) {
  const glm::dmat3 frame(centredOn(lamp.direction));
  const double sine = std::sin(double(lamp.angular_size_rad) / 4.0);
  std::vector<glm::vec3> points;
  for (int i = 0; i < kPointsOfDisc; ++i) {
    const double square = sine * sine * (i + 0.5) / kPointsOfDisc;  // sin²(θ/2), even in area
    const double across = 2.0 * std::sqrt(square * (1.0 - square));
    const double turn = kGoldenAngle_rad * i;
    points.emplace_back(frame * glm::dvec3(across * std::cos(turn), across * std::sin(turn), 1.0 - 2.0 * square));
  }
  return points;
}

/// Directions spread evenly over the sphere (Fibonacci's lattice).
std::vector<glm::vec3> directionsAllAround() {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < kNormals; ++i) {
    const double y = 1.0 - 2.0 * (i + 0.5) / kNormals;
    const double radius = std::sqrt(1.0 - y * y);
    directions.emplace_back(radius * std::cos(kGoldenAngle_rad * i), y, radius * std::sin(kGoldenAngle_rad * i));
  }
  return directions;
}

/// Adds directions at an angle from a middle.
void addRing(glm::vec3 middle, float angle_rad, std::vector<glm::vec3>& directions) {
  const glm::mat3 frame = centredOn(middle);
  for (int i = 0; i < kTurns; ++i) {
    const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kTurns;
    directions.push_back(frame * glm::vec3(std::sin(angle_rad) * std::cos(turn), std::sin(angle_rad) * std::sin(turn),
                                           std::cos(angle_rad)));
  }
}

/// The light of a map under a lobe: what is left of it, and its lamps as they lay in it.
class LightUnderLobe {
 public:
  static Result<LightUnderLobe> make(const SplitMap& split, const LightHarmonics& rest, const Lobe& lobe,
                                     const ProgressFunction& progress) {
    MIRRORBALL_TRY(blurred, cubeOf(rest, lobe, kBlurredSize, glm::mat3(1.0f), progress));
    return LightUnderLobe(split, std::move(blurred), lobe);
  }

  /// The whole light in a direction.
  glm::vec3 whole(glm::vec3 direction) const {
    glm::dvec3 sum(rest_.radiance(direction));
    for (const TakenLamp& taken : split_.taken) sum += asItLay(taken, direction);
    return glm::vec3(sum);
  }

  /// By how much a lamp differs that shines evenly from some points.
  float difference(const TakenLamp& taken, const std::vector<glm::vec3>& points, glm::vec3 direction) const {
    double mean = 0.0;
    for (const glm::vec3& point : points) mean += at(point, direction) / double(points.size());
    return greatestOf(glm::abs(glm::vec3(glm::dvec3(taken.lamp.irradiance) * mean - asItLay(taken, direction))));
  }

 private:
  LightUnderLobe(const SplitMap& split, EnvironmentMap rest, const Lobe& lobe)
      : split_(split), rest_(std::move(rest)), lobe_(lobe) {}

  double at(glm::vec3 light, glm::vec3 direction) const {
    const glm::vec3 away = light - direction;
    return double(lobe_.at(std::min(glm::dot(away, away) / 4.0f, 1.0f)));
  }

  glm::dvec3 asItLay(const TakenLamp& taken, glm::vec3 direction) const {
    glm::dvec3 sum(0.0);
    for (const PointOfLight& point : taken.light) sum += glm::dvec3(point.flux) * at(point.direction, direction);
    return sum;
  }

  const SplitMap& split_;
  EnvironmentMap rest_;
  Lobe lobe_;
};

/// A map with as much detail as wide lobes show, in which no light is lost.
Result<Environment> coarseOf(const EnvironmentMap& map, const ProgressFunction& progress) {
  Environment whole(map);
  if (whole.naturalSize(Projection::equirect) <= kCoarseRows) return whole;
  MIRRORBALL_TRY(coarse, convert(whole, Projection::equirect, kCoarseRows, {}, progress));
  return Environment(std::move(coarse));
}

/// Calls `measure(direction)` for many on all cores.
///
/// returns  its results, in their order
template <typename Measure>
std::vector<float> measured(const std::vector<glm::vec3>& directions, const Measure& measure) {
  std::vector<float> results(directions.size());
  parallelFor(directions.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) results[i] = measure(directions[i]);
  });
  return results;
}

float largest(const std::vector<float>& values) { return *std::max_element(values.begin(), values.end()); }

/// Of the irradiance: most where a lamp rises above a surface's horizon.
///
/// points   that the lamp shines from
float irradianceError(const LightUnderLobe& light, const TakenLamp& taken, const std::vector<glm::vec3>& points,
                      std::vector<glm::vec3> normals) {
  constexpr float kSquare_rad = std::numbers::pi_v<float> / 2.0f;
  for (const float beyond : {-0.5f, 0.0f, 0.5f})
    addRing(taken.lamp.direction, kSquare_rad + beyond * taken.lamp.reach_rad(), normals);
  return largest(measured(normals, [&](glm::vec3 normal) {
    const float before = greatestOf(light.whole(normal));
    const float difference = light.difference(taken, points, normal);
    return difference > 0.0f ? difference / before : 0.0f;
  }));
}

/// Of a rough sphere: most in the lamp's highlight, which is about `width` wide.
float sphereError(const LightUnderLobe& light, const TakenLamp& taken, std::vector<glm::vec3> places, float width_rad) {
  places.push_back(taken.lamp.direction);
  for (const float beyond : {0.25f, 0.5f, 1.0f}) addRing(taken.lamp.direction, beyond * width_rad, places);
  const float peak = largest(measured(places, [&](glm::vec3 place) { return greatestOf(light.whole(place)); }));
  const float most = largest(
      measured(places, [&](glm::vec3 place) { return light.difference(taken, {taken.lamp.direction}, place); }));
  return most > 0.0f ? most / peak : 0.0f;
}

}  // namespace

Result<std::vector<LampError>> lampErrors(const SplitMap& split, const ProgressFunction& progress) {
  std::vector<LampError> errors;
  if (split.taken.empty()) return errors;
  const Lobe cosine = Lobe::cosine();
  const Lobe rough = Lobe::reflection(Distribution::ggx, LampError::kRoughness);
  constexpr std::size_t kSteps = 5;
  MIRRORBALL_TRY(coarse, coarseOf(split.rest, partOf(progress, 0, 2, kSteps)));
  MIRRORBALL_TRY(rest, LightHarmonics::make(coarse, {cosine, rough}, partOf(progress, 2, 1, kSteps)));
  MIRRORBALL_TRY(irradiance, LightUnderLobe::make(split, rest, cosine, partOf(progress, 3, 1, kSteps)));
  MIRRORBALL_TRY(reflected, LightUnderLobe::make(split, rest, rough, partOf(progress, 4, 1, kSteps)));
  const std::vector<glm::vec3> around = directionsAllAround();
  for (const TakenLamp& taken : split.taken)
    errors.push_back({irradianceError(irradiance, taken, discOf(taken.lamp), around),
                      irradianceError(irradiance, taken, {taken.lamp.direction}, around),
                      sphereError(reflected, taken, around, rough.width())});
  return errors;
}

}  // namespace mirrorball
