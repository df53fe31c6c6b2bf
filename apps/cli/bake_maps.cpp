#include "cli/bake_maps.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/files.h"
#include "cli/map_inputs.h"
#include "cli/terminal.h"
#include "mirrorball/bake/bake.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/output/value_counts.h"

namespace mirrorball::cli {
namespace {

/// Mends what light cannot be, and says what half floats do not hold.
///
/// errors   out_of_range: too bright
Result<void> checkLight(const std::string& name, std::optional<TexelFormat> format, EnvironmentMap& map) {
  ValueCounts counts;
  for (int face = 0; face < map.faces(); ++face) counts.add(map.face(face));
  if (counts.too_bright > 0)
    return fail(ErrorCode::out_of_range, name + ": " + countedAre(counts.too_bright, "value") +
                                             " above 1e36, too bright to be summed; --scale-light 1e-6 makes them fit");
  takeNegativeAsNone(name, map);
  const bool in_halves = format.value_or(TexelFormat::half) == TexelFormat::half;
  if (in_halves && counts.areTooDarkForHalves())
    remark(name + ": is so dark that half floats hold few of its digits; --format float32 holds them all");
  return {};
}

/// The environment, which may not be one of the outputs.
Result<LoadedEnvironment> loadLight(const BakeRequest& request, std::span<const std::string> outputs) {
  MIRRORBALL_TRY(hint, formHintNamed(request.options.from));
  MIRRORBALL_TRY(loaded, loadMap(request.environment,
                                 {.from = hint, .repair = request.options.repair, .light = request.output.file.light},
                                 progressBar("read")));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, outputs));
  tellClamped(loaded.name, loaded.lost);
  EnvironmentMap* map = loaded.environment.map();
  if (map) MIRRORBALL_TRY_VOID(checkLight(loaded.name, request.output.file.format, *map));
  return loaded;
}

/// What is made of the environment, but for what lies beside the chain.
BakeSettings settingsOf(const BakeRequest& request) {
  const BakeOptions& options = request.options;
  return {.size = options.size,
          .levels = levelCount(request),
          .distribution = options.distribution,
          .mip_mapping = mipMappingOf(options.mip_mapping),
          .irradiance_size = 0,
          .harmonics_degree = request.set.files == SetFiles::cmgens ? 2 : 0,
          .source_from_target = sourceFromRotated(options.rotate_deg)};
}

void remarkOnLevels(const BakeRequest& request) {
  const BakeOptions& options = request.options;
  const int last = levelCount(request) - 1;
  if (options.levels == 0 && last == 0)
    remark("a chain of --size " + std::to_string(options.size) +
           " has level 0 only, the environment itself; --levels asks for more");
  constexpr int kLastLevelOfUnity = 6;  // UNITY_SPECCUBE_LOD_STEPS
  if (options.mip_mapping == MipMappingChoice::unity && last != kLastLevelOfUnity)
    remark("Unity looks for roughness 1 in level 6, and this chain has it in level " + std::to_string(last) +
           "; --levels 7 mends it");
}

std::uint64_t bytesOfTable(const BakeOptions& options) {
  return std::uint64_t(options.brdf_size) * std::uint64_t(options.brdf_size) * std::uint64_t(options.brdf_channels) *
         sizeof(float);
}

/// The BRDF table, made on threads of its own. It stops soon when it goes away before it was asked for.
class LaterTable {
 public:
  LaterTable(const BakeOptions& options, StageClock& clock)
      : table_(std::async(besideOthers(), [this, &options, &clock] {
          return clock.time("BRDF table", [&] { return make(options); });
        })) {}
  LaterTable(const LaterTable&) = delete;
  LaterTable& operator=(const LaterTable&) = delete;
  ~LaterTable() { is_wanted_ = false; }

  Result<Image> get() { return table_.get(); }

 private:
  Result<Image> make(const BakeOptions& options) const {
    const BrdfTableOptions table{.size = options.brdf_size,
                                 .channels = options.brdf_channels,
                                 .distribution = options.distribution,
                                 .axes = options.brdf_axes};
    return brdfTable(table, [this, bar = progressBar("BRDF table")](std::size_t done, std::size_t total) {
      return is_wanted_ && bar(done, total);
    });
  }

  std::atomic<bool> is_wanted_ = true;
  std::future<Result<Image>> table_;  // waits for its threads, and so is the first to go
};

/// A table that is so small that it may be made beside the reading of an environment whose size is not known yet.
constexpr std::uint64_t kSmallTable_bytes = std::uint64_t{4} << 20;

std::uint64_t bytesOfChain(const std::vector<PrefilterLevel>& levels) {
  std::uint64_t bytes = 0;
  for (const PrefilterLevel& level : levels) bytes += cubeBytes(level.size);
  return bytes;
}

/// How fine a skybox is, as far as it is left to us.
int skyboxSize(const BakeOptions& options, const Environment& environment) {
  constexpr int kMax = 1024;
  return options.skybox_size > 0 ? options.skybox_size : std::min(environment.naturalSize(Projection::cube), kMax);
}

/// The most memory that is needed at a time, beside the BRDF table.
std::uint64_t memoryFor(const BakedFiles& files, const BakeSettings& settings, const Environment& environment) {
  std::uint64_t packed = files.specular.memoryToWrite(settings.size);
  if (files.irradiance) packed = std::max(packed, files.irradiance->memoryToWrite(settings.irradiance_size));
  if (files.skybox) packed = std::max(packed, files.skybox->memoryToWrite(settings.skybox_size));
  const std::uint64_t written =
      bytesOfChain(levelsOf(settings)) + cubeBytes(settings.irradiance_size) + cubeBytes(settings.skybox_size) + packed;
  return std::max(memoryToBake(environment, settings), written);
}

}  // namespace

Result<BakedChain> bakeChain(const BakeRequest& request, const MapFile& output, StageClock& clock) {
  MIRRORBALL_TRY(loaded, clock.time("environment: read", [&] { return loadLight(request, output.paths()); }));
  remarkOnLevels(request);
  const BakeSettings settings = settingsOf(request);
  const std::uint64_t written = bytesOfChain(levelsOf(settings)) + output.memoryToWrite(settings.size);
  MIRRORBALL_TRY_VOID(withName("the chain of " + loaded.name,
                               checkMemory(std::max(memoryToBake(loaded.environment, settings), written))));
  MIRRORBALL_TRY(maps, bake(std::move(loaded.environment), settings, clock.observing(terminalObserver())));
  return BakedChain{std::move(maps.specular), factsFor(request.set, maps.radiance)};
}

Result<BakedSet> bakeSet(const BakeRequest& request, const BakedFiles& files, StageClock& clock) {
  const BakeOptions& options = request.options;
  const std::uint64_t table_bytes = files.brdf ? bytesOfTable(options) : 0;
  MIRRORBALL_TRY_VOID(withName("the BRDF table", checkMemory(table_bytes)));
  // The table needs no environment; reading one leaves cores idle.
  std::optional<LaterTable> table;
  if (files.brdf && table_bytes <= kSmallTable_bytes) table.emplace(options, clock);
  MIRRORBALL_TRY(loaded, clock.time("environment: read", [&] { return loadLight(request, files.paths()); }));
  remarkOnLevels(request);

  BakeSettings settings = settingsOf(request);
  if (files.irradiance) settings.irradiance_size = options.irradiance_size;
  settings.harmonics_degree = options.harmonics_degree;
  if (files.skybox) settings.skybox_size = skyboxSize(options, loaded.environment);
  MIRRORBALL_TRY_VOID(
      withName("baking " + loaded.name, checkMemory(table_bytes + memoryFor(files, settings, loaded.environment))));

  BakedSet set;
  set.inputs = loaded.files;
  set.skybox_size = settings.skybox_size;
  if (files.brdf) {
    if (!table) table.emplace(options, clock);
    MIRRORBALL_TRY(brdf, table->get());
    set.brdf = std::move(brdf);
  }
  MIRRORBALL_TRY(maps, bake(std::move(loaded.environment), settings, clock.observing(terminalObserver())));
  set.maps = std::move(maps);
  return set;
}

}  // namespace mirrorball::cli
