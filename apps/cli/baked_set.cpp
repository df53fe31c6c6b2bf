#include "cli/baked_set.h"

#include <functional>
#include <string_view>
#include <utility>

#include "cli/baked_manifest.h"
#include "cli/files.h"
#include "cli/harmonics_text.h"
#include "cli/interruption.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/metadata.h"

namespace mirrorball::cli {
namespace {

Result<void> writeText(const std::string& path, const std::string& text) {
  const std::string_view view(text);
  MIRRORBALL_TRY_VOID(writeFile(path, {reinterpret_cast<const std::uint8_t*>(view.data()), view.size()}));
  announce(path);
  return {};
}

Result<void> writeHarmonics(const Harmonics& radiance, const BakedFiles& files, const BakeOptions& options) {
  const std::string path = files.folder + "/sh.";
  if (files.set.files == SetFiles::cmgens) return writeText(path + "txt", cmgensHarmonics(filamentHarmonics(radiance)));
  MIRRORBALL_TRY_VOID(writeText(path + "json", harmonicsJson(radiance, options.harmonics_degree)));
  return writeText(path + "h", harmonicsHeader(radiance, shown(files.source)));
}

}  // namespace

std::vector<std::string> BakedFiles::paths() const {
  std::vector<std::string> all = specular.paths();
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (irradiance) add(irradiance->paths());
  if (skybox) add(skybox->paths());
  if (brdf) add({brdf->path});
  if (set.files == SetFiles::cmgens)
    add({folder + "/sh.txt"});
  else
    add({folder + "/sh.json", folder + "/sh.h"});
  add({folder + "/manifest.json"});
  return all;
}

Metadata factsFor(const EngineSet& set, const Harmonics& radiance) {
  if (set.files != SetFiles::cmgens) return {};
  return {{kFilamentHarmonicsKey, textOf(filamentHarmonics(radiance))}};
}

Result<void> writeSet(BakedSet set, const BakedFiles& files, const BakeOptions& options) {
  std::string left = "nothing was written";
  const std::function<Result<void>()> go_on = [&]() -> Result<void> {
    if (!interrupted()) return {};
    return fail(ErrorCode::interrupted, "interrupted; " + left);
  };
  MIRRORBALL_TRY_VOID(go_on());
  MIRRORBALL_TRY(folder, OutputFolder::make(files.folder));
  if (!folder.isNew()) left = files.folder + " has only some of the new files, and no manifest";
  if (!folder.isNew()) whenInterrupted("interrupted; " + left);
  // What a writer says is of its own file.
  const auto of_set = [&](auto written) {
    const bool is_interrupted = written ? interrupted() : written.error().code == ErrorCode::interrupted;
    return is_interrupted ? decltype(written)(fail(ErrorCode::interrupted, "interrupted; " + left)) : written;
  };
  removeOlderSet(files, set.inputs);
  WrittenFormats formats;
  MIRRORBALL_TRY(specular, of_set(files.specular.write(std::move(set.maps.specular),
                                                       factsFor(files.set, set.maps.radiance), go_on)));
  formats.specular = specular;
  const auto writeCube = [&](const std::optional<CubeFiles>& cube, EnvironmentMap map,
                             std::string& format) -> Result<void> {
    if (!cube) return {};
    MIRRORBALL_TRY_VOID(go_on());
    MIRRORBALL_TRY(written, of_set(cube->write(std::move(map).takeImages(), {}, go_on)));
    format = written;
    return {};
  };
  MIRRORBALL_TRY_VOID(writeCube(files.irradiance, std::move(set.maps.irradiance), formats.irradiance));
  MIRRORBALL_TRY_VOID(writeCube(files.skybox, std::move(set.maps.skybox), formats.skybox));
  MIRRORBALL_TRY_VOID(go_on());
  if (files.brdf) MIRRORBALL_TRY_VOID(of_set(writeBrdf(std::move(set.brdf), *files.brdf)));
  MIRRORBALL_TRY_VOID(go_on());
  MIRRORBALL_TRY_VOID(writeHarmonics(set.maps.radiance, files, options));
  MIRRORBALL_TRY_VOID(writeText(files.folder + "/manifest.json", manifestOf(set, files, options, formats)));
  folder.keep();
  return {};
}

}  // namespace mirrorball::cli
