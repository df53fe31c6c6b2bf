#include "mirrorball/output/baked/baked_set.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <future>
#include <string_view>
#include <utility>

#include "mirrorball/bake/bake.h"
#include "mirrorball/bake/lobe_row/lobe_row_table.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/folder.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/metadata.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/light_edit/lamp_search.h"
#include "mirrorball/light_edit/lamp_split.h"
#include "mirrorball/output/baked/baked_files.h"
#include "mirrorball/output/baked/baked_manifest.h"
#include "mirrorball/output/baked/harmonics_text.h"
#include "mirrorball/output/baked/light_hash.h"
#include "mirrorball/output/baked/older_set.h"
#include "mirrorball/output/lamps/lamp_files.h"

namespace mirrorball {
namespace {

/// A table that is so small that it may be made beside the reading of an environment whose size is not known yet.
constexpr std::uint64_t kSmallTable_bytes = std::uint64_t{4} << 20;

std::uint64_t bytesOfTable(const BakedSetSettings& settings) {
  return std::uint64_t(settings.brdf_size) * std::uint64_t(settings.brdf_size) * std::uint64_t(settings.brdf_channels) *
         sizeof(float);
}

/// The BRDF table, made on threads of its own. It stops soon when it goes away before it was asked for.
class LaterTable {
 public:
  LaterTable(const BakedSetSettings& settings, const Observer& observer)
      : table_(std::async(besideOthers(), [this, &settings, &observer] {
          return observer.timed("BRDF table", [&] { return make(settings, observer.progressOf("BRDF table")); });
        })) {}
  LaterTable(const LaterTable&) = delete;
  LaterTable& operator=(const LaterTable&) = delete;
  ~LaterTable() { is_wanted_ = false; }

  Result<Image> get() { return table_.get(); }

 private:
  Result<Image> make(const BakedSetSettings& settings, const ProgressFunction& progress) const {
    const BrdfTableOptions table{.size = settings.brdf_size,
                                 .channels = settings.brdf_channels,
                                 .distribution = settings.distribution,
                                 .axes = settings.brdf_axes};
    return brdfTable(table, [this, &progress](std::size_t done, std::size_t total) {
      return is_wanted_ && (!progress || progress(done, total));
    });
  }

  std::atomic<bool> is_wanted_ = true;
  std::future<Result<Image>> table_;  // waits for its threads, and so is the first to go
};

/// The first level of roughness 1 or more in a chain with Babylon.js' mapping, or the last that there is.
int lastLevelOfBabylon(int size) {
  const auto roughness = [size](int level) {
    return roughnessOfLevel(MipMapping::babylon, level, maxLevels(size) - 1, size);
  };
  int level = 0;
  while (level < maxLevels(size) - 1 && roughness(level) < 0.999f) ++level;
  return level;
}

/// What the chain lacks that its reader looks for.
void tellFewLevels(const BakedSetSettings& settings, bool is_counted, const Observer& observer) {
  const int last = settings.levels - 1;
  const auto tell = [&](const std::string& what, int needed) {
    const bool helps = needed <= maxLevels(settings.size) && needed != settings.levels;
    observer.tell(RemarkKind::levels_few, what, helps ? std::to_string(needed) : "");
  };
  if (!is_counted && last == 0)
    tell("a chain of " + counted(std::size_t(settings.size), "texel") +
             " a face has level 0 only, the environment itself",
         maxLevels(settings.size));
  constexpr int kLastLevelOfUnity = 6;  // UNITY_SPECCUBE_LOD_STEPS
  if (settings.mip_mapping == MipMapping::unity && last != kLastLevelOfUnity)
    tell("Unity looks for roughness 1 in level 6, and this chain has it in level " + std::to_string(last),
         kLastLevelOfUnity + 1);
  const int last_of_babylon = lastLevelOfBabylon(settings.size);
  if (settings.mip_mapping == MipMapping::babylon && last < last_of_babylon)
    tell("Babylon.js' mapping has roughness 1 by level " + std::to_string(last_of_babylon) +
             ", and this chain ends with level " + std::to_string(last),
         last_of_babylon + 1);
}

/// How fine a skybox is, as far as it is left to us.
int skyboxSize(const BakedSetSettings& settings, const Environment& environment) {
  constexpr int kMax = 1024;
  return settings.skybox_size > 0 ? settings.skybox_size : std::min(environment.naturalSize(Projection::cube), kMax);
}

/// Which maps the files want of an environment.
BakeSettings bakeSettings(const BakedSetSettings& settings, const BakedFiles& files, const Environment& environment) {
  // cmgen's chain has the harmonics in it.
  const bool needs_harmonics =
      !files.harmonics.empty() || !files.packed.empty() || (files.set.files == SetFiles::cmgens && files.specular);
  const bool needs_chain = files.specular || !files.packed.empty();
  const bool needs_irradiance = files.irradiance || (!files.packed.empty() && files.set.has_irradiance_cube);
  BakeSettings maps{.size = needs_chain ? settings.size : 0,
                    .levels = settings.levels,
                    .distribution = settings.distribution,
                    .mip_mapping = *settings.mip_mapping,
                    .irradiance_size = needs_irradiance ? settings.irradiance_size : 0,
                    .harmonics_degree = needs_harmonics ? settings.harmonics_degree : 0,
                    .skybox_size = files.skybox ? skyboxSize(settings, environment) : 0,
                    .source_from_target = sourceFromRotated(settings.rotate_deg),
                    .memory_meanwhile = files.brdf ? bytesOfTable(settings) : 0};
  const auto takes = [&](std::uint64_t bytes) { maps.memory_after = std::max(maps.memory_after, bytes); };
  const auto packs = [&](const std::optional<CubeFiles>& cube, int size) {
    if (cube) takes(cube->memoryToWrite(size));
  };
  packs(files.specular, maps.size);
  packs(files.irradiance, maps.irradiance_size);
  packs(files.skybox, maps.skybox_size);
  if (!files.packed.empty())
    takes(std::uint64_t(files.set.pack_bytes) * 6 * std::uint64_t(maps.size) * std::uint64_t(maps.size));
  return maps;
}

/// What a chain for a program says of the environment beside its levels: Filament's, the harmonics.
Metadata factsFor(const EngineSet& set, const Harmonics& radiance) {
  if (set.files != SetFiles::cmgens || radiance.empty()) return {};
  return {{kFilamentHarmonicsKey, textOf(filamentHarmonics(radiance))}};
}

/// A file of harmonics, by its name in a set.
std::string harmonicsText(std::string_view name, const Harmonics& radiance, const BakedSetSettings& settings) {
  if (name == "sh.txt") return cmgensHarmonics(filamentHarmonics(radiance));
  if (name == "sh.h") return harmonicsHeader(radiance, settings.source);
  return harmonicsJson(radiance, settings.harmonics_degree);
}

/// Writes a program's own file, and tells what it does not hold.
Result<void> writePackedFile(const BakedFiles& files, const PackedLight& packed, const Observer& observer) {
  MIRRORBALL_TRY_VOID(writeFile(files.packed, packed.bytes));
  if (packed.lost.lost > 0.0)
    observer.tell(RemarkKind::light_too_bright,
                  files.packed + ": the format ends at " + std::to_string(std::lround(packed.brightest)) +
                      ", and what is brighter was lowered to that: " + percentOf(packed.lost) +
                      " of the light is lost");
  observer.tellWritten(files.packed);
  return {};
}

/// Writes the files of a set one after the other, as long as nobody stops it.
class SetWriter {
 public:
  SetWriter(const BakedFiles& files, const Observer& observer, std::string left)
      : files_(files), observer_(observer), progress_(observer.progressOf("write")), left_(std::move(left)) {}

  /// Writes a cube, as far as the set has it.
  ///
  /// returns  its format
  Result<std::string> writeCube(const std::optional<CubeFiles>& cube, ImageSet levels, const Metadata& facts) {
    if (!cube) return std::string();
    MIRRORBALL_TRY_VOID(goOn());
    return ofSet(cube->write(std::move(levels), facts, [this] { return goOn(); }));
  }

  /// Writes a program's own file, as far as the set has it.
  Result<void> writePacked(PackedLight packed) {
    if (files_.packed.empty()) return {};
    MIRRORBALL_TRY_VOID(goOn());
    return writePackedFile(files_, packed, observer_);
  }

  Result<void> writeTable(const std::optional<BrdfFile>& file, Image table) {
    if (!file) return {};
    MIRRORBALL_TRY_VOID(goOn());
    MIRRORBALL_TRY_VOID(ofSet(writeBrdf(std::move(table), *file)));
    observer_.tellWritten(file->path);
    return {};
  }

  Result<void> writeRows(const std::optional<LobeRowFiles>& files) {
    if (!files) return {};
    MIRRORBALL_TRY_VOID(goOn());
    MIRRORBALL_TRY(rows, lobeRowTable(files->lobes));
    MIRRORBALL_TRY_VOID(ofSet(writeLobeRows(rows, *files)));
    observer_.tellWritten(files->texture());
    return files->has_text ? writeText(LobeRowFiles::kTextName, lobeRowText(rows)) : Result<void>();
  }

  Result<void> writeLampFile(const std::string& path, const std::vector<MapLamp>& lamps) {
    MIRRORBALL_TRY_VOID(goOn());
    MIRRORBALL_TRY_VOID(ofSet(writeLamps(path, lamps)));
    observer_.tellWritten(path);
    return {};
  }

  Result<void> writeText(const std::string& name, const std::string& text) {
    MIRRORBALL_TRY_VOID(goOn());
    const std::string path = files_.folder + "/" + name;
    MIRRORBALL_TRY_VOID(writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    observer_.tellWritten(path);
    return {};
  }

 private:
  Result<void> goOn() {
    if (!progress_ || progress_(done_++, files_.paths().size())) return {};
    return fail(ErrorCode::interrupted, "interrupted; " + left_);
  }

  /// What a writer says of an interruption is of its own file.
  template <typename Value>
  Result<Value> ofSet(Result<Value> written) {
    if (written || written.error().code != ErrorCode::interrupted) return written;
    return fail(ErrorCode::interrupted, "interrupted; " + left_);
  }

  const BakedFiles& files_;
  const Observer& observer_;
  ProgressFunction progress_;
  std::string left_;
  std::size_t done_ = 0;
};

}  // namespace

bool BakedSetSettings::makes(BakedPart part) const { return only.empty() || contains(only, part); }

struct BakedSet::Parts {
  BakedSetSettings settings;
  BakedFiles files;
  Observer observer;
  bool is_counted;                         // whether the number of levels was asked for
  std::string light_hash = {};             // of the environment that is saved; "": none of the files needs it
  OlderSet older = {};                     // what the folder held before
  std::unique_ptr<LaterTable> table = {};  // refers to the others, and so goes first

  Result<void> findOlder(const LoadedEnvironment& environment);
  Result<std::vector<MapLamp>> takeLamps(LoadedEnvironment& environment) const;
  Result<BakedMaps> bakeMaps(LoadedEnvironment& environment) const;
  Result<PackedLight> packMaps(const BakedMaps& maps) const;
  Result<void> writeTexture(BakedMaps maps) const;
  Result<void> writeFolder(BakedMaps maps, PackedLight packed, Image brdf, const std::vector<MapLamp>& lamps,
                           const LoadedEnvironment& of);
};

BakedSet::BakedSet(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
BakedSet::BakedSet(BakedSet&&) noexcept = default;
BakedSet& BakedSet::operator=(BakedSet&&) noexcept = default;
BakedSet::~BakedSet() = default;

Result<BakedSet> BakedSet::resolve(const std::string& output, const BakedSetSettings& settings, Observer observer) {
  MIRRORBALL_TRY(set, engineSetFor(settings.file.program, settings.mip_mapping));
  if (settings.file.primaries != OutputPrimaries::rec709)
    return fail(ErrorCode::usage,
                "baked maps have Rec.709's primaries, as their harmonics have and as engines read them; leave the "
                "primaries as they are");
  if (settings.levels > maxLevels(settings.size))
    return fail(ErrorCode::usage, std::to_string(settings.levels) + " levels: a cube of " +
                                      counted(std::size_t(settings.size), "texel") + " a face has at most " +
                                      std::to_string(maxLevels(settings.size)) +
                                      ", the last of one texel a face; ask for no more");
  MIRRORBALL_TRY_VOID(checkChain(set, settings.size, settings.levels));
  BakedSetSettings settled = settings;
  const bool is_counted = settings.levels > 0;
  if (!settled.mip_mapping) settled.mip_mapping = set.mip_mapping;
  if (!is_counted) settled.levels = levelCountFor(set, *settled.mip_mapping, settings.size);
  MIRRORBALL_TRY(format, settledFormat(set, settings, isOneFile(output) ? extensionOf(output) : settings.extension));
  settled.file.format = format;
  MIRRORBALL_TRY(files, BakedFiles::resolve(output, settled, set, observer));
  return BakedSet(
      std::unique_ptr<Parts>(new Parts{std::move(settled), std::move(files), std::move(observer), is_counted}));
}

std::vector<std::string> BakedSet::paths() const { return parts_->files.paths(); }

Result<void> BakedSet::begin() {
  if (!parts_->files.brdf) return {};
  const std::uint64_t bytes = bytesOfTable(parts_->settings);
  MIRRORBALL_TRY_VOID(withName("the BRDF table", checkMemory(bytes)));
  if (bytes <= kSmallTable_bytes) parts_->table = std::make_unique<LaterTable>(parts_->settings, parts_->observer);
  return {};
}

/// Finds out, before anything is made, what the folder holds and whether the new parts belong beside it.
Result<void> BakedSet::Parts::findOlder(const LoadedEnvironment& environment) {
  if (files.folder.empty()) return {};
  if (files.hasLight()) {
    MIRRORBALL_TRY(hash, withName(environment.name, lightHash(environment.environment, settings)));
    light_hash = std::move(hash);
  }
  MIRRORBALL_TRY(found, OlderSet::find(files, settings, light_hash));
  older = std::move(found);
  return {};
}

/// Leaves an environment without its small lamps.
///
/// returns  those, turned as the maps are
Result<std::vector<MapLamp>> BakedSet::Parts::takeLamps(LoadedEnvironment& environment) const {
  std::vector<MapLamp> lamps;
  if (files.lamps.empty()) return lamps;
  MIRRORBALL_TRY(map, searchedMap(std::move(environment.environment), observer.progressOf("lamps")));
  MIRRORBALL_TRY_VOID(withName(environment.name, checkLight(map, observer.named(environment.name))));
  SplitMap split = splitMap(std::move(map), settings.lamps);
  environment.environment = Environment(std::move(split.rest));
  const glm::mat3 target_from_source = glm::transpose(sourceFromRotated(settings.rotate_deg));
  for (const MapLamp& lamp : takenLamps(split)) lamps.push_back(turned(lamp, target_from_source));
  return lamps;
}

Result<BakedMaps> BakedSet::Parts::bakeMaps(LoadedEnvironment& environment) const {
  const std::string name = environment.name;
  const BakeSettings which = bakeSettings(settings, files, environment.environment);
  auto maps = withName(name, bake(std::move(environment.environment), which, observer.named(name)));
  const bool in_floats = files.anyCube() == nullptr || settings.file.format == TexelFormat::float32;
  if (maps && !in_floats && maps->values.areTooDarkForHalves())
    observer.tell(RemarkKind::digits_lost, name + ": is so dark that half floats hold few of its digits");
  return maps;
}

/// The program's own file, made before anything is written, so that an older set stays whole until then.
Result<PackedLight> BakedSet::Parts::packMaps(const BakedMaps& maps) const {
  if (files.packed.empty()) return PackedLight{};
  return observer.timed("files: pack",
                        [&] { return withName(files.packed, files.set.pack(maps, observer.progressOf("pack"))); });
}

Result<void> BakedSet::save(LoadedEnvironment environment) {
  Parts& parts = *parts_;
  MIRRORBALL_TRY_VOID(parts.findOlder(environment));
  if (parts.files.specular || !parts.files.packed.empty())
    tellFewLevels(parts.settings, parts.is_counted, parts.observer);
  Image table;
  if (parts.files.brdf && parts.table) {
    MIRRORBALL_TRY(made, std::exchange(parts.table, nullptr)->get());
    table = std::move(made);
  }
  MIRRORBALL_TRY(lamps, parts.observer.timed("lamps: split", [&] { return parts.takeLamps(environment); }));
  MIRRORBALL_TRY(maps, parts.bakeMaps(environment));
  if (parts.files.brdf && table.empty()) {
    MIRRORBALL_TRY(made, LaterTable(parts.settings, parts.observer).get());
    table = std::move(made);
  }
  MIRRORBALL_TRY(packed, parts.packMaps(maps));
  return parts.observer.timed("files: write", [&]() -> Result<void> {
    if (!parts.files.folder.empty())
      return parts.writeFolder(std::move(maps), std::move(packed), std::move(table), lamps, environment);
    if (!parts.files.packed.empty()) return writePackedFile(parts.files, packed, parts.observer);
    return parts.writeTexture(std::move(maps));
  });
}

Result<void> BakedSet::Parts::writeTexture(BakedMaps maps) const {
  const Metadata facts = factsFor(files.set, maps.radiance);
  ImageSet images = files.specular     ? std::move(maps.specular)
                    : files.irradiance ? std::move(maps.irradiance).takeImages()
                                       : std::move(maps.skybox).takeImages();
  MIRRORBALL_TRY_VOID(files.anyCube()->write(std::move(images), facts, [] { return Result<void>(); }));
  files.anyCube()->remarkOnForm();
  return {};
}

Result<void> BakedSet::Parts::writeFolder(BakedMaps maps, PackedLight packed, Image brdf,
                                          const std::vector<MapLamp>& lamps, const LoadedEnvironment& of) {
  MIRRORBALL_TRY(folder, OutputFolder::make(files.folder));
  SetWriter writer(files, observer,
                   folder.isNew() ? "nothing was written"
                                  : files.folder + " has only some of the new files, and no manifest of them");
  BakedSetSettings named = settings;
  if (named.source.empty()) named.source = of.name;
  MIRRORBALL_TRY_VOID(older.makeWay(files, of.files));
  const int skybox_size = maps.skybox.size();
  WrittenFormats formats;
  MIRRORBALL_TRY_VOID(writer.writePacked(std::move(packed)));
  MIRRORBALL_TRY(specular,
                 writer.writeCube(files.specular, std::move(maps.specular), factsFor(files.set, maps.radiance)));
  formats.specular = specular;
  MIRRORBALL_TRY(irradiance, writer.writeCube(files.irradiance, std::move(maps.irradiance).takeImages(), {}));
  formats.irradiance = irradiance;
  MIRRORBALL_TRY(skybox, writer.writeCube(files.skybox, std::move(maps.skybox).takeImages(), {}));
  formats.skybox = skybox;
  MIRRORBALL_TRY_VOID(writer.writeTable(files.brdf, std::move(brdf)));
  MIRRORBALL_TRY_VOID(writer.writeRows(files.lobe_rows));
  for (const std::string& file : files.lamps) MIRRORBALL_TRY_VOID(writer.writeLampFile(file, lamps));
  for (const std::string& name : files.harmonics)
    MIRRORBALL_TRY_VOID(writer.writeText(name, harmonicsText(name, maps.radiance, named)));
  MIRRORBALL_TRY_VOID(writer.writeText(
      kManifestName, makeManifest({maps.levels, skybox_size, formats, lamps.size(), light_hash}, files, named, older)));
  folder.keep();
  return {};
}

Result<SavedMap> saveBakedSet(const std::string& output, LoadedEnvironment environment,
                              const BakedSetSettings& settings, const Observer& observer) {
  SavedMap saved;
  MIRRORBALL_TRY(set, BakedSet::resolve(output, settings, observer.keeping(saved.remarks)));
  MIRRORBALL_TRY_VOID(set.begin());
  MIRRORBALL_TRY_VOID(set.save(std::move(environment)));
  saved.paths = set.paths();
  return saved;
}

}  // namespace mirrorball
