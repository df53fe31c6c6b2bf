// How far the light that rows of lobes reflect is from the sum over all texels of an environment under GGX's own lobe:
// run build/bench/bench/lobe_row_bench [PLOT.svg] ENV…
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "formula/bsdf.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "plot.h"

namespace mirrorball::bench {
namespace {

constexpr std::array<float, 5> kRoughnesses{0.2f, 0.3f, 0.45f, 0.6f, 0.9f};
constexpr std::array<float, 6> kCosines{0.9f, 0.7f, 0.5f, 0.35f, 0.25f, 0.15f};
constexpr std::array<int, 4> kRows{1, 2, 4, 6};
constexpr int kTurns = 48;  // of the surface and the eye, for each of both

/// Texels as points of light.
struct PointOfLight {
  glm::vec3 direction;
  float solid_angle;
  glm::vec3 radiance;
};

/// errors   as loadEnvironment's
Result<std::vector<PointOfLight>> pointsOf(const std::string& environment) {
  constexpr int kHeight = 256;
  MIRRORBALL_TRY(loaded, loadEnvironment(environment));
  MIRRORBALL_TRY(map, convert(loaded.environment, Projection::equirect, kHeight));
  std::vector<PointOfLight> points;
  const Image& image = map.face(0);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec2 place((float(x) + 0.5f) / float(image.width()), (float(y) + 0.5f) / float(image.height()));
      const float colatitude = formula::kPi * place.y;
      const float solid_angle =
          2.0f * formula::kPi * formula::kPi / float(image.width()) / float(image.height()) * std::sin(colatitude);
      points.push_back(
          {directionAt(Projection::equirect, {0, place}), solid_angle, glm::max(rgbAt(image, x, y), glm::vec3(0.0f))});
    }
  return points;
}

/// A mean of light under a weight.
class WeightedMean {
 public:
  void add(const PointOfLight& point, float weight) {
    sum_ += double(weight * point.solid_angle) * glm::dvec3(point.radiance);
    weight_ += double(weight * point.solid_angle);
  }
  glm::dvec3 value() const { return weight_ > 0.0 ? sum_ / weight_ : glm::dvec3(0.0); }

 private:
  glm::dvec3 sum_{0.0};
  double weight_ = 0.0;
};

/// A rotation for each number, spread over all (Shoemake 1992).
glm::mat3 turned(int number) {
  const auto part = [number](double step) {
    const double product = (number + 0.5) * step;
    return float(product - std::floor(product));
  };
  const float u = part(0.8191725134);
  const float a = 2.0f * formula::kPi * part(0.6710436067);
  const float b = 2.0f * formula::kPi * part(0.5497004779);
  const float v = std::sqrt(1.0f - u);
  const float w = std::sqrt(u);
  return glm::mat3_cast(glm::quat(w * std::cos(b), v * std::sin(a), v * std::cos(a), w * std::sin(b)));
}

std::vector<formula::RoundLobe> lobesOf(const Image& table, int count, float roughness, glm::vec3 n, glm::vec3 r) {
  if (count == 1) return {{r, roughness, 1.0f, 1.0f}};
  std::vector<formula::RoundLobe> lobes;
  for (const glm::vec4& texel : lobeRowIn(table, formula::firstOfRow(count), count, roughness, glm::dot(n, r)))
    lobes.push_back(formula::lobeOfRow(texel, roughness, n, r));
  return lobes;
}

/// What a surface reflects: the truth, and by each count of lobes.
struct Reflected {
  glm::dvec3 truth;
  std::array<glm::dvec3, kRows.size()> by_row;
};

Reflected reflected(const std::vector<PointOfLight>& points, const Image& table, float roughness, float cosine,
                    const glm::mat3& world_from_surface) {
  const float alpha = formula::alphaFromPerceptualRoughness(roughness);
  const glm::vec3 v(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  const glm::vec3 r(-v.x, 0.0f, v.z);
  std::vector<formula::RoundLobe> lobes;
  for (const int count : kRows)
    for (const formula::RoundLobe& lobe : lobesOf(table, count, roughness, glm::vec3(0, 0, 1), r))
      lobes.push_back(lobe);
  WeightedMean truth;
  std::vector<WeightedMean> means(lobes.size());
  for (const PointOfLight& point : points) {
    const glm::vec3 l = glm::transpose(world_from_surface) * point.direction;
    if (l.z > 0.0f) truth.add(point, formula::evalGgx(glm::vec2(alpha), v, l) * l.z);
    for (std::size_t i = 0; i < lobes.size(); ++i) {
      const glm::vec3 between = l - lobes[i].direction;
      const float s = glm::dot(between, between) / 4.0f;
      const float width = formula::alphaFromPerceptualRoughness(lobes[i].perceptual_roughness);
      if (s < 0.5f) means[i].add(point, formula::ggxLobe(width, s));
    }
  }
  Reflected result{truth.value(), {}};
  std::size_t lobe = 0;
  for (std::size_t row = 0; row < kRows.size(); ++row)
    for (int i = 0; i < kRows[row]; ++i, ++lobe) result.by_row[row] += double(lobes[lobe].weight) * means[lobe].value();
  return result;
}

/// Relative root mean square errors by the count of lobes.
using Errors = std::array<double, kRows.size()>;

Errors errorsAt(const std::vector<PointOfLight>& points, const Image& table, float roughness, float cosine) {
  std::vector<Reflected> all(kTurns);
  parallelFor(kTurns, 1, [&](std::size_t begin, std::size_t) {
    all[begin] = reflected(points, table, roughness, cosine, turned(static_cast<int>(begin)));
  });
  Errors squares{};
  double truth = 0.0;
  for (const Reflected& one : all) {
    truth += glm::dot(one.truth, one.truth);
    for (std::size_t row = 0; row < kRows.size(); ++row) {
      const glm::dvec3 apart = one.by_row[row] - one.truth;
      squares[row] += glm::dot(apart, apart);
    }
  }
  for (double& square : squares) square = std::sqrt(square / truth);
  return squares;
}

/// Of some angles, what rows are wrong by over what one lobe is.
void printShares(const char* angles, const std::vector<Errors>& errors) {
  Errors sum{};
  for (const Errors& one : errors)
    for (std::size_t row = 0; row < kRows.size(); ++row) sum[row] += one[row] * one[row];
  std::printf("%-24s", angles);
  for (std::size_t row = 1; row < kRows.size(); ++row)
    std::printf(" %d lobes %.2f", kRows[row], std::sqrt(sum[row] / sum[0]));
  std::printf("\n");
}

/// The curves over n·v, for the root mean square over the roughnesses.
std::string plotOf(const std::string& environment, const std::vector<std::vector<Errors>>& by_roughness) {
  std::vector<Curve> curves;
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    Curve curve{.name = kRows[row] == 1 ? "one look-up" : std::to_string(kRows[row]) + " lobes", .points = {}};
    for (std::size_t angle = 0; angle < kCosines.size(); ++angle) {
      double sum = 0.0;
      for (const std::vector<Errors>& errors : by_roughness) sum += errors[angle][row] * errors[angle][row];
      curve.points.emplace_back(kCosines[angle], std::sqrt(sum / double(by_roughness.size())));
    }
    curves.push_back(std::move(curve));
  }
  const std::string file = environment.substr(environment.rfind('/') + 1);
  return svgPlot("Reflected light in " + file + ", roughness 0.2 to 0.9", {"n·v", false}, {"relative RMS error", true},
                 curves);
}

Result<void> printErrors(const std::string& environment, const std::string& plot) {
  MIRRORBALL_TRY(points, pointsOf(environment));
  MIRRORBALL_TRY(table, lobeRowTable());
  std::printf("%s: relative RMS error with 1, 2, 4 and 6 lobes\nroughness", environment.c_str());
  for (const float cosine : kCosines) std::printf("  n.v %-21.2f", cosine);
  std::printf("\n");
  std::vector<Errors> steep, flat;
  std::vector<std::vector<Errors>> by_roughness;
  for (const float roughness : kRoughnesses) {
    std::printf("%-9.2f", roughness);
    by_roughness.emplace_back();
    for (const float cosine : kCosines) {
      const Errors errors = errorsAt(points, table, roughness, cosine);
      (cosine >= 0.5f ? steep : flat).push_back(errors);
      by_roughness.back().push_back(errors);
      std::printf("  %.3f %.3f %.3f %.3f  ", errors[0], errors[1], errors[2], errors[3]);
    }
    std::printf("\n");
  }
  printShares("n.v from 0.5 on:", steep);
  printShares("n.v from 0.15 to 0.35:", flat);
  if (plot.empty()) return {};
  const std::string text = plotOf(environment, by_roughness);
  return writeFile(plot, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace
}  // namespace mirrorball::bench

int main(int count, char** arguments) {
  const bool has_plot = count > 1 && std::string(arguments[1]).ends_with(".svg");
  for (int i = has_plot ? 2 : 1; i < count; ++i)
    if (const auto printed = mirrorball::bench::printErrors(arguments[i], has_plot ? arguments[1] : ""); !printed) {
      std::fprintf(stderr, "%s\n", printed.error().message.c_str());
      return EXIT_FAILURE;
    }
  return EXIT_SUCCESS;
}
