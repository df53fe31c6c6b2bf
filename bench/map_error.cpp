// How far prefiltered maps that any program wrote are from the sum over all texels of their environment: run
// build/bench/bench/map_error ENV FILE=ROUGHNESS FILE=irradiance…
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "blur_methods.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/environment/file/load.h"
#include "truth.h"

namespace mirrorball::bench {
namespace {

/// The 48 ways to name the axes of a cube map: whichever a program has, its texel centres are directions of ours.
std::vector<glm::mat3> axisChanges() {
  std::vector<glm::mat3> changes;
  constexpr std::array<std::array<int, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& order : kOrders)
    for (unsigned signs = 0; signs < 8; ++signs) {
      glm::mat3 change(0.0f);
      for (int i = 0; i < 3; ++i) change[i][order[std::size_t(i)]] = (signs >> i & 1u) != 0 ? -1.0f : 1.0f;
      changes.push_back(change);
    }
  return changes;
}

std::vector<glm::dvec3> lookedUp(const Environment& map, const std::vector<glm::vec3>& directions, glm::mat3 change) {
  std::vector<glm::dvec3> values;
  for (const glm::vec3& direction : directions) values.emplace_back(map.radiance(change * direction));
  return values;
}

/// Against the truth, in the axes in which the map fits best.
///
/// errors   as loadEnvironment's
Result<Error> errorOfMap(const Environment& map, const EnvironmentMap& panorama, const BlurTarget& target) {
  std::vector<glm::vec3> directions;
  for (const MapPosition& place : pickedTexels(target.size)) directions.push_back(directionAt(Projection::cube, place));
  const TexelSums sums(panorama);
  std::vector<glm::dvec3> truth(directions.size());
  parallelFor(truth.size(), 1,
              [&](std::size_t begin, std::size_t) { truth[begin] = sums.mean(target, directions[begin]); });
  Error best{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (const glm::mat3& change : axisChanges()) {
    const Error error = errorOf(lookedUp(map, directions, change), truth);
    if (error.relative_rms < best.relative_rms) best = error;
  }
  return best;
}

/// argument   FILE=ROUGHNESS or FILE=irradiance
Result<void> printError(const std::string& environment, const std::string& argument) {
  const std::size_t sign = argument.rfind('=');
  if (sign == std::string::npos) return fail(ErrorCode::usage, argument + ": FILE=ROUGHNESS or FILE=irradiance");
  const std::string what = argument.substr(sign + 1);
  const bool is_irradiance = what == "irradiance";
  const float roughness = is_irradiance ? 1.0f : std::strtof(what.c_str(), nullptr);
  if (roughness < 0.05f || roughness > 1.0f)
    return fail(ErrorCode::usage, what + ": a perceptual roughness is 0.05 to 1");
  MIRRORBALL_TRY(map, loadEnvironment(argument.substr(0, sign)));
  const BlurTarget target{what, map.environment.naturalSize(Projection::cube), roughness, is_irradiance,
                          is_irradiance ? Lobe::cosine() : Lobe::reflection(Distribution::ggx, roughness)};
  MIRRORBALL_TRY(panorama, panoramaFor(environment, {target}));
  MIRRORBALL_TRY(error, errorOfMap(map.environment, panorama, target));
  std::printf("%-40s relRMSE %9.4f %%   mean %9.4f %%   greatest %10.4f %%\n", argument.c_str(),
              100.0 * error.relative_rms, 100.0 * error.mean, 100.0 * error.max);
  return {};
}

}  // namespace
}  // namespace mirrorball::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s ENV MAP…, where MAP is FILE=ROUGHNESS (perceptual, GGX) or FILE=irradiance\n",
                 argv[0]);
    return 2;
  }
  for (int i = 2; i < argc; ++i)
    if (const auto printed = mirrorball::bench::printError(argv[1], argv[i]); !printed) {
      std::fprintf(stderr, "%s\n", printed.error().message.c_str());
      return 1;
    }
}
