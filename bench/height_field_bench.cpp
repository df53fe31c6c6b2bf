// What maps of heights cost, in memory: run build/bench/bench/height_field_bench.
#include <cmath>
#include <cstdint>
#include <numbers>

#include <benchmark/benchmark.h>

#include "mirrorball/base/parallel.h"
#include "mirrorball/height_field/cone_map.h"
#include "mirrorball/height_field/heights_from_normals.h"
#include "mirrorball/height_field/maximum_pyramid.h"
#include "mirrorball/height_field/occlusion.h"
#include "mirrorball/height_field/slopes.h"

namespace mirrorball {
namespace {

/// Waves of all lengths, and grain: in [0, 1].
Image ground(int side) {
  Image heights = Image::withoutValues(side, side, 1);
  parallelFor(std::size_t(side), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < side; ++x) {
        float sum = 0.0f;
        float size = 0.25f;
        for (int waves = 3; waves < side / 4; waves *= 3, size *= 0.5f) {
          const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(waves) / static_cast<float>(side);
          sum += size * std::sin(turn * (float(x) + 0.5f * float(waves))) * std::sin(turn * float(y) + size);
        }
        const auto grain = (std::uint32_t(x) * 0x9e3779b9u ^ std::uint32_t(y) * 0x85ebca6bu) * 0xc2b2ae35u >> 16;
        heights.texel(x, int(y))[0] = 0.5f + sum + static_cast<float>(grain) / 6.5536e6f;
      }
  });
  return heights;
}

void heightsToNormals(benchmark::State& state) {
  const Image heights = ground(int(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(*normalsFromHeights(heights, {.scale = 0.05f}));
}
BENCHMARK(heightsToNormals)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void heightsToPyramid(benchmark::State& state) {
  const Image heights = ground(int(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(*maximumPyramid(heights));
}
BENCHMARK(heightsToPyramid)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void normalsToHeights(benchmark::State& state) {
  const HeightFieldSettings settings{.edges = state.range(1) == 0 ? MapEdges::tiled : MapEdges::clamped,
                                     .scale = 0.05f};
  const Image normals = *normalsFromHeights(ground(int(state.range(0))), settings);
  for (auto _ : state) benchmark::DoNotOptimize(*heightsFromNormals(normals, settings));
  state.SetLabel(state.range(1) == 0 ? "tiled" : "clamped");
}
BENCHMARK(normalsToHeights)->Args({4096, 0})->Args({4096, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

void heightsToCones(benchmark::State& state) {
  const Image heights = ground(int(state.range(0)));
  const auto kind = static_cast<ConeKind>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(*coneMap(heights, kind));
  state.SetLabel(kind == ConeKind::conservative ? "conservative" : "relaxed");
}
BENCHMARK(heightsToCones)->Args({1024, 0})->Args({1024, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

void heightsToOcclusion(benchmark::State& state) {
  const Image heights = ground(int(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(*occlusionOf(heights, {.scale = 0.05f}));
}
BENCHMARK(heightsToOcclusion)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace mirrorball
