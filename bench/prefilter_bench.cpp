// Time, error and memory of ways to prefilter an environment, each method beside the sum over all texels: run
// build/bench/bench/prefilter_bench --help. docs/performance.md shows what it prints and draws.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "blur_methods.h"
#include "in_child.h"
#include "mirrorball/bake/brdf/brdf_table.h"
#include "mirrorball/base/parallel.h"
#include "plot.h"
#include "truth.h"

namespace mirrorball::bench {
namespace {

/// What takes longer runs once.
constexpr double kSlow = 3000.0;  // ms

struct Request {
  std::string environment = "sky";
  int size = 256;
  int runs = 3;
  std::string plots;
  std::string family;
};

EnvironmentMap panoramaOrExit(const Request& request, const std::vector<BlurTarget>& targets) {
  auto panorama = panoramaFor(request.environment, targets);
  if (panorama) return std::move(*panorama);
  std::fprintf(stderr, "%s\n", panorama.error().message.c_str());
  std::exit(1);
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// [ms] What a clock on the wall shows, and what the processor's cores worked together: the second says more on a
/// machine that does other things too.
struct Duration {
  double wall = 0.0;
  double processor = 0.0;
};

double processorMilliseconds() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Duration durationOf(const std::function<void()>& work) {
  const double processor = processorMilliseconds();
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
  return {wall.count(), processorMilliseconds() - processor};
}

/// Each by itself.
Duration medianOf(const std::vector<Duration>& durations) {
  std::vector<double> wall;
  std::vector<double> processor;
  for (const Duration& duration : durations) {
    wall.push_back(duration.wall);
    processor.push_back(duration.processor);
  }
  return {medianOf(wall), medianOf(processor)};
}

/// What one method did.
struct Outcome {
  std::string method;
  std::string family;
  double memory_mb = 0.0;
  Duration shared;  ///< by all levels
  std::vector<BlurTarget> targets;
  std::vector<Duration> durations;              ///< of each
  std::vector<std::vector<glm::dvec3>> values;  ///< at the picked texels of each
};

std::vector<BlurTarget> targetsOf(const BlurMethod& method, const std::vector<BlurTarget>& all) {
  std::vector<BlurTarget> made;
  for (const BlurTarget& target : all)
    if (target.is_irradiance ? method.makes_irradiance : method.makes_levels) made.push_back(target);
  return made;
}

/// Runs a method, the first time for its memory too; in a process of its own.
///
/// returns  memory, the durations of what all levels share and of each target, then all values
std::vector<double> measured(const BlurMethod& method, const Request& request) {
  const std::vector<BlurTarget> targets = blurTargets(request.size);
  const EnvironmentMap panorama = panoramaOrExit(request, targets);
  const std::vector<BlurTarget> made = targetsOf(method, targets);
  std::vector<EnvironmentMap> cubes(made.size());
  std::vector<std::vector<Duration>> durations(made.size() + 1);
  const auto run = [&] {
    Blur blur;
    durations[0].push_back(durationOf([&] { blur = method.prepare(panorama, made); }));
    for (std::size_t i = 0; i < made.size(); ++i)
      durations[i + 1].push_back(durationOf([&] { cubes[i] = blur(made[i]); }));
  };
  std::vector<double> numbers;
  const double first_run_ms = durationOf([&] { numbers.push_back(memoryTakenBy(run)); }).wall;
  if (first_run_ms < kSlow)
    for (int i = 1; i < request.runs; ++i) run();
  for (const std::vector<Duration>& all : durations) {
    numbers.push_back(medianOf(all).wall);
    numbers.push_back(medianOf(all).processor);
  }
  for (std::size_t i = 0; i < made.size(); ++i)
    for (const MapPosition& place : pickedTexels(made[i].size)) {
      const glm::ivec2 texel(place.uv * static_cast<float>(made[i].size));
      const glm::vec3 value = rgbAt(cubes[i].face(place.face), texel.x, texel.y);
      for (int c = 0; c < 3; ++c) numbers.push_back(static_cast<double>(value[c]));
    }
  return numbers;
}

/// What `measured` returned.
Outcome outcomeOf(const BlurMethod& method, const std::vector<BlurTarget>& targets,
                  const std::vector<double>& numbers) {
  auto next = numbers.begin();
  const auto duration = [&next] {
    const Duration read{next[0], next[1]};
    next += 2;
    return read;
  };
  Outcome outcome{method.name, method.family, *next++, {}, targetsOf(method, targets), {}, {}};
  outcome.shared = duration();
  for (std::size_t i = 0; i < outcome.targets.size(); ++i) outcome.durations.push_back(duration());
  for (const BlurTarget& target : outcome.targets) {
    std::vector<glm::dvec3>& values = outcome.values.emplace_back();
    for (std::size_t i = 0; i < pickedTexels(target.size).size(); ++i, next += 3)
      values.emplace_back(next[0], next[1], next[2]);
  }
  return outcome;
}

/// Brute force: the truth at the picked texels, and from the time for those that for all.
Outcome bruteForce(const EnvironmentMap& panorama, const std::vector<BlurTarget>& targets) {
  Outcome outcome{"brute force", "brute force", 0.0, {}, targets, {}, {}};
  const TexelSums sums(panorama);
  for (const BlurTarget& target : targets) {
    const std::vector<MapPosition> places = pickedTexels(target.size);
    std::vector<glm::dvec3> values(places.size());
    const Duration duration = durationOf([&] {
      parallelFor(places.size(), 1, [&](std::size_t begin, std::size_t) {
        values[begin] = sums.mean(target, directionAt(Projection::cube, places[begin]));
      });
    });
    const double share = 6.0 * target.size * target.size / static_cast<double>(places.size());
    outcome.durations.push_back({duration.wall * share, duration.processor * share});
    outcome.values.push_back(std::move(values));
  }
  return outcome;
}

/// The processor's for a whole chain.
double chainMilliseconds(const Outcome& outcome) {
  double milliseconds = outcome.shared.processor;
  for (std::size_t i = 0; i < outcome.targets.size(); ++i)
    if (!outcome.targets[i].is_irradiance) milliseconds += outcome.durations[i].processor;
  return milliseconds;
}

/// The truth of a target, which all targets have.
const std::vector<glm::dvec3>& truthOf(const Outcome& truth, const BlurTarget& target) {
  std::size_t i = 0;
  while (truth.targets[i].name != target.name) ++i;
  return truth.values[i];
}

void print(const Outcome& outcome, const Outcome& truth) {
  const bool is_truth = &outcome == &truth;
  std::printf("\n%s\n", outcome.method.c_str());
  if (!is_truth)
    std::printf("  memory %.1f MB; shared by all levels %.1f ms, of the processor %.1f ms\n", outcome.memory_mb,
                outcome.shared.wall, outcome.shared.processor);
  for (std::size_t i = 0; i < outcome.targets.size(); ++i) {
    const BlurTarget& target = outcome.targets[i];
    std::printf("  %-10s  %4d²  r %.3f  %10.2f ms, of the processor %10.2f ms", target.name.c_str(), target.size,
                static_cast<double>(target.perceptual_roughness), outcome.durations[i].wall,
                outcome.durations[i].processor);
    if (!is_truth) {
      const Error error = errorOf(outcome.values[i], truthOf(truth, target));
      std::printf("   relRMSE %9.5f %%   mean %9.5f %%   greatest %10.5f %%", 100.0 * error.relative_rms,
                  100.0 * error.mean, 100.0 * error.max);
    }
    std::printf("\n");
  }
}

/// relRMSE of a level in percent; at least what a plot's logarithmic axis can show.
double drawnError(const Outcome& outcome, const Outcome& truth, std::size_t i) {
  return std::max(100.0 * errorOf(outcome.values[i], truthOf(truth, outcome.targets[i])).relative_rms, 1e-6);
}

double worstDrawnError(const Outcome& outcome, const Outcome& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < outcome.targets.size(); ++i)
    if (!outcome.targets[i].is_irradiance) worst = std::max(worst, drawnError(outcome, truth, i));
  return worst;
}

void printBrdfTime(const Request& request) {
  std::vector<Duration> durations;
  for (int i = 0; i < request.runs; ++i)
    durations.push_back(durationOf([] { (void)brdfTable({.size = 128, .channels = 3}); }));
  const Duration median = medianOf(durations);
  std::printf("\nBRDF table, 128² of 3 channels: %.1f ms, of the processor %.1f ms\n", median.wall, median.processor);
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
  std::fprintf(stderr, "%s\n", path.c_str());
}

/// One curve a family, a point for each number of samples.
void plotErrorOverTime(const std::vector<Outcome>& outcomes, const Outcome& truth, const std::string& path) {
  std::vector<Curve> curves;
  for (const Outcome& outcome : outcomes) {
    if (outcome.targets.front().is_irradiance) continue;
    if (curves.empty() || curves.back().name != outcome.family) curves.push_back({outcome.family, {}});
    curves.back().points.emplace_back(chainMilliseconds(outcome), worstDrawnError(outcome, truth));
    const std::size_t end = outcome.method.find(' ');
    if (outcome.method != outcome.family) curves.back().labels.push_back(outcome.method.substr(0, end));
  }
  write(path, svgPlot("Error of the worst level over the time for a chain", {"processor time for all levels, ms", true},
                      {"relRMSE of the worst level, %", true}, curves));
}

void plotErrorByLevel(const std::vector<Outcome>& outcomes, const Outcome& truth, const std::string& path) {
  std::vector<Curve> curves;
  for (const Outcome& outcome : outcomes) {
    Curve curve{outcome.method, {}};
    for (std::size_t i = 0; i < outcome.targets.size(); ++i)
      if (!outcome.targets[i].is_irradiance)
        curve.points.emplace_back(static_cast<double>(i + 1), drawnError(outcome, truth, i));
    if (!curve.points.empty()) curves.push_back(std::move(curve));
  }
  write(path, svgPlot("Error by level", {"level of the chain, the last of roughness 1", false}, {"relRMSE, %", true},
                      curves));
}

void run(const Request& request) {
  // The children come first: a process that has threads must not fork.
  std::vector<BlurMethod> methods = blurMethods();
  if (!request.family.empty())
    std::erase_if(methods, [&](const BlurMethod& method) { return method.family != request.family; });
  std::vector<std::vector<double>> numbers;
  for (const BlurMethod& method : methods) {
    std::fprintf(stderr, "%s …\n", method.name.c_str());
    numbers.push_back(inChild([&] { return measured(method, request); }));
    if (numbers.back().empty()) std::exit(1);
  }
  const std::vector<BlurTarget> targets = blurTargets(request.size);
  const EnvironmentMap panorama = panoramaOrExit(request, targets);
  std::printf("%s as %d x %d texels, a chain of %d²\n", request.environment.c_str(), panorama.extent().x,
              panorama.extent().y, request.size);
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < methods.size(); ++i) outcomes.push_back(outcomeOf(methods[i], targets, numbers[i]));
  const Outcome truth = bruteForce(panorama, targets);
  for (const Outcome& outcome : outcomes) print(outcome, truth);
  print(truth, truth);
  printBrdfTime(request);
  if (request.plots.empty()) return;
  plotErrorOverTime(outcomes, truth, request.plots + "_over_time.svg");
  plotErrorByLevel(outcomes, truth, request.plots + "_by_level.svg");
}

}  // namespace
}  // namespace mirrorball::bench

int main(int argc, char** argv) {
  mirrorball::bench::Request request;
  CLI::App program("Time, error and memory of ways to prefilter an environment");
  program.add_option("ENV", request.environment, "a map or a built-in; the sky unless told");
  program.add_option("--size", request.size, "of the chain's level 0, a face's side; 256 unless told")
      ->check(CLI::Range(8, 4096));
  program.add_option("--runs", request.runs, "of which the median time counts; 3 unless told")
      ->check(CLI::Range(1, 1000));
  program.add_option("--plots", request.plots, "writes this_over_time.svg and this_by_level.svg");
  program.add_option("--only", request.family,
                     "one family of methods, as \"mirrorball bake\", \"samples of mip levels\"");
  CLI11_PARSE(program, argc, argv);
  mirrorball::bench::run(request);
}
