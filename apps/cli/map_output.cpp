#include "cli/map_output.h"

#include "cli/files.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"

namespace mirrorball::cli {
namespace {

const std::string kMapHelp = "required: the output file, " + writtenExtensions(Holds::light) + " (linear radiance), " +
                             writtenExtensions(Holds::texture) + " (textures; a cube as a cube map), " +
                             writtenExtensions(Holds::picture) +
                             " (sRGB, clipped to [0, 1]); -.exr is standard output, likewise with the other extensions";
const Option<MapOutputOptions> kOutput{{.name = "output",
                                        .value = "OUT",
                                        .help = kMapHelp,
                                        .letter = "o",
                                        .group = "Output",
                                        .takes_path = true,
                                        .is_daily = true},
                                       &MapOutputOptions::output};

}  // namespace

std::string_view mapOutputHelp() { return kMapHelp; }

void addMapOutput(Command& command, MapOutputOptions& output, std::string_view help) {
  addOptions(command, std::span(&kOutput, 1), output);
  if (!help.empty()) command.options.back().text.help = help;
  addOptions(command, mapFileOptions(), output.file);
}

Result<Projection> projectionToWrite(const std::string& name) {
  const auto projection = projectionNamed(name);
  if (projection) return projection;
  if (const auto layout = cubeLayoutNamed(name))
    return fail(ErrorCode::usage,
                "--to " + name + ": that is a layout of cubes; say --to cube --layout " + std::string(nameOf(*layout)));
  return projection;
}

Result<void> checkMapOutput(const MapOutputOptions& options, const std::string& output) {
  MIRRORBALL_TRY_VOID(formatToWrite(output, {Holds::light, Holds::texture, Holds::picture}));
  const bool has_levels = options.file.mips || options.file.level;
  if (!has_levels && options.file.mip_source != MipSource::automatic)
    return fail(ErrorCode::usage,
                "--mip says how mip levels are made, and there are none without --mips or --level; add one");
  if (options.file.mips && options.file.level)
    return fail(ErrorCode::usage, "--mips is for all mip levels and --level for one; leave one of them out");
  const float factor = options.file.display.exposure();
  return refusePictureOptions(
      options.given, output,
      factor == 1.0f ? "" : ", or scale the light: --scale-light " + formatNumber(double(factor)));
}

Result<MapFile> mapFileFor(const MapOutputOptions& options, const std::string& output, Projection projection) {
  MIRRORBALL_TRY_VOID(checkMapOutput(options, output));
  MapFileOptions file = options.file;
  file.is_one_file = isStandardOutputTaken();
  return MapFile::resolve(output, file, projection, terminalObserver());
}

}  // namespace mirrorball::cli
