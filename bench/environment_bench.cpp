// What it costs to make an environment ready for rendering: run build/bench/bench/environment_bench.
#include <benchmark/benchmark.h>

#include "mirrorball/bake/prefilter/mip_chain.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/convert/convert.h"

namespace mirrorball {
namespace {

const Environment& panorama() {
  static const Environment environment(*convert(*builtinEnvironment("studio"), Projection::equirect, 1024));
  return environment;
}

/// Texels written a second, for a target of that projection and size.
void convertPanorama(benchmark::State& state) {
  const auto to = static_cast<Projection::Kind>(state.range(0));
  const int size = static_cast<int>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(*convert(panorama(), to, size));
  const glm::ivec2 extent = imageSize(to, size);
  state.SetItemsProcessed(state.iterations() * extent.x * extent.y * faceCount(to));
  state.SetLabel("2048x1024 to " + std::string(nameOf(to)));
}
BENCHMARK(convertPanorama)
    ->Args({static_cast<int>(Projection::cube), 704})
    ->Args({static_cast<int>(Projection::sphere), 1024})
    ->Args({static_cast<int>(Projection::angular), 1024})
    ->Args({static_cast<int>(Projection::equirect), 1024})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void cubeMipChain(benchmark::State& state) {
  const EnvironmentMap cube = *convert(panorama(), Projection::cube, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(mipChain(cube));
}
BENCHMARK(cubeMipChain)->Arg(512)->Arg(704)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace mirrorball
