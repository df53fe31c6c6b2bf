#include "cli/bake_command.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/bake_maps.h"
#include "cli/baked_set.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/map_output.h"
#include "cli/stage_clock.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"

namespace mirrorball::cli {
namespace {

const std::string kBakedHelp = "needed: a folder, for all maps and a manifest; or a " +
                               writtenExtensions(Holds::texture, " or ") + " file, for the specular chain only";

const std::array<Option<BakeOptions>, 17> kBakeOptions{{
    {{.name = "output", .value = "OUT", .help = kBakedHelp, .letter = "o"}, &BakeOptions::output},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 1,
      .maximum = 8192,
      .help = "of the chain's level 0, a face's side"},
     &BakeOptions::size},
    {{.name = "levels",
      .value = "N",
      .minimum = 0,
      .maximum = 14,
      .help = "of the chain, level 0 among them; the last is for roughness 1. 0: down to 4 x 4 texels a face"},
     &BakeOptions::levels},
    {{.name = "distribution", .choices = "ggx|phong|blinn|charlie", .help = "of the microfacets; charlie is for cloth"},
     choiceField<&BakeOptions::distribution>},
    {{.name = "mip-mapping",
      .choices = "auto|filament|linear|unreal|unity|frostbite",
      .help =
          "which level is for which roughness, as that engine looks it up; auto goes by --for: unreal and unity have "
          "their own, godot has frostbite's, for all others it is filament"},
     choiceField<&BakeOptions::mip_mapping>},
    {{.name = "irradiance-size",
      .value = "N",
      .unit = "texels",
      .minimum = 1,
      .maximum = 1024,
      .help = "of the irradiance cube, a face's side"},
     &BakeOptions::irradiance_size},
    {{.name = "sh-degree",
      .value = "L",
      .minimum = 2,
      .maximum = 4,
      .help = "the last band of the spherical harmonics"},
     &BakeOptions::harmonics_degree},
    {{.name = "brdf-size",
      .value = "N",
      .unit = "texels",
      .minimum = 2,
      .maximum = kLargestBrdfTable,
      .help = "of the BRDF table, a side"},
     &BakeOptions::brdf_size},
    {{.name = "brdf-channels",
      .value = "N",
      .minimum = 2,
      .maximum = 3,
      .help = "2: scale and bias; 3: also the mean for multiple scattering; .exr has a third of 0"},
     &BakeOptions::brdf_channels},
    {{.name = "brdf-axes",
      .choices = "linear|warped",
      .help = "linear in n.v and perceptual roughness as engines have it, or warped so that look-ups are right near "
              "grazing angles too"},
     choiceField<&BakeOptions::brdf_axes>},
    {{.name = "brdf-extension", .value = "ktx2|dds|exr", .help = "of the BRDF table's file"},
     &BakeOptions::brdf_extension},
    {{.name = "extension", .value = "ktx2|dds", .help = "of the cubes' files in a folder"}, &BakeOptions::extension},
    {{.name = "from",
      .value = "FORM",
      .help = "the environment's form, where it is not recognised: see convert --from"},
     &BakeOptions::from},
    {kRotateText, &BakeOptions::rotate_deg},
    {{.name = "repair", .help = "replace NaN and infinite texels by their neighbours"}, &BakeOptions::repair},
    {{.name = "timings", .help = "print how long each stage took"}, &BakeOptions::timings},
    {kMaxMemoryText, &BakeOptions::max_memory},
}};

/// The table as the cubes are stored, but for formats that would round it to a percent.
BrdfFile brdfFile(const std::string& path, const BakeOptions& options, const MapOutputOptions& output) {
  BrdfFile file{path};
  // Pictures are in 32-bit floats unless told otherwise, as everywhere.
  const bool in_floats = output.format == "float32" || (output.format != "half" && !file.isTexture());
  if (file.isTexture() && options.brdf_channels == 2)
    file.format = in_floats ? TexelFormat::rg_float32 : TexelFormat::rg_half;
  else
    file.format = in_floats ? TexelFormat::float32 : TexelFormat::half;
  if (options.brdf_extension == "ktx2") file.zstandard_level = output.zstandard_level;
  return file;
}

/// errors   usage: no such folder can be, or no such files
Result<BakedFiles> filesOf(const BakeRequest& request) {
  namespace fs = std::filesystem;
  const BakeOptions& options = request.options;
  for (const auto& [extension, known] :
       {std::pair(options.extension, std::vector<std::string_view>{"ktx2", "dds"}),
        std::pair(options.brdf_extension, std::vector<std::string_view>{"ktx2", "dds", "exr"})})
    if (std::find(known.begin(), known.end(), extension) == known.end())
      return tl::unexpected<Error>(unknownName("extension", extension, known));
  std::string folder = options.output;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  std::error_code status;
  if (fs::exists(folder, status) && !fs::is_directory(folder, status))
    return fail(ErrorCode::usage, folder + ": is a file; name a folder, or a " +
                                      writtenExtensions(Holds::texture, " or ") + " file for the chain only");
  MapOutputOptions output = request.output;
  output.output = folder + "/specular." + options.extension;
  MIRRORBALL_TRY(specular, MapOutput::resolve(output, Projection::cube));
  output.output = folder + "/irradiance." + options.extension;
  MIRRORBALL_TRY(irradiance, MapOutput::resolve(output, Projection::cube));
  return BakedFiles{request.environment, folder, std::move(specular), std::move(irradiance),
                    brdfFile(folder + "/brdf." + options.brdf_extension, options, request.output)};
}

/// errors   usage: an option that says something about what only a folder has
Result<void> refuseOptionsOfFolders(const BakeOptions& options) {
  constexpr std::array<std::string_view, 7> kOfFolders{"irradiance-size", "sh-degree", "brdf-size",     "brdf-channels",
                                                       "brdf-axes",       "extension", "brdf-extension"};
  const BakeOptions defaults;
  for (const Option<BakeOptions>& option : kBakeOptions)
    if (std::ranges::find(kOfFolders, option.text.name) != kOfFolders.end() &&
        written(option, options) != written(option, defaults))
      return fail(ErrorCode::usage, options.output + ": holds the specular chain only, and --" +
                                        std::string(option.text.name) +
                                        " is for what lies beside it; name a folder, without an extension");
  return {};
}

Result<void> bakeFile(const BakeRequest& request, StageClock& clock) {
  MapOutputOptions to_file = request.output;
  to_file.output = request.options.output;
  if (!isTexturePath(to_file.output))
    return fail(ErrorCode::usage, to_file.output + ": a prefiltered chain goes into " +
                                      writtenExtensions(Holds::texture, " or ") +
                                      "; or name a folder, without an extension");
  MIRRORBALL_TRY_VOID(refuseOptionsOfFolders(request.options));
  MIRRORBALL_TRY(output, MapOutput::resolve(to_file, Projection::cube));
  MIRRORBALL_TRY_VOID(checkFolder(to_file.output));
  MIRRORBALL_TRY(chain, bakeChain(request, output, clock));
  MIRRORBALL_TRY_VOID(clock.time("files: write", [&] { return output.writeLevels(std::move(chain)); }));
  return {};
}

Result<void> bakeFolder(const BakeRequest& request, StageClock& clock) {
  MIRRORBALL_TRY(files, filesOf(request));
  MIRRORBALL_TRY(set, bakeSet(request, files, clock));
  return clock.time("files: write", [&] { return writeSet(std::move(set), files, request.options); });
}

/// The way in which a program looks levels up; docs/prefiltering.md has the sources.
MipMappingChoice mipMappingFor(std::string_view program) {
  if (program == "unreal") return MipMappingChoice::unreal;
  if (program == "unity") return MipMappingChoice::unity;
  if (program == "godot") return MipMappingChoice::frostbite;
  return MipMappingChoice::filament;
}

Result<void> bake(BakeRequest request) {
  const std::string& output = request.options.output;
  if (output.empty())
    return fail(ErrorCode::usage,
                "bake needs an output: -o FOLDER, or a " + writtenExtensions(Holds::texture, " or ") + " file");
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.options.max_memory));
  if (request.options.mip_mapping == MipMappingChoice::as_for)
    request.options.mip_mapping = mipMappingFor(request.output.program);
  if (request.options.levels > mostLevels(request.options.size))
    return fail(ErrorCode::usage, "--levels: --size " + std::to_string(request.options.size) + " has at most " +
                                      std::to_string(mostLevels(request.options.size)) +
                                      ", the last of one texel a face; ask for no more");
  StageClock clock;
  const bool is_file = !isFolder(output) && std::filesystem::path(output).has_extension();
  const Result<void> done = is_file ? bakeFile(request, clock) : bakeFolder(request, clock);
  if (request.options.timings) clock.print();
  return done;
}

}  // namespace

std::span<const Option<BakeOptions>> bakeOptions() { return kBakeOptions; }

Action addBakeCommand(CLI::App& program) {
  auto request = std::make_shared<BakeRequest>();
  CLI::App& command = addCommand(
      program, "bake", "Prefilters an environment for an engine: rough reflections, irradiance, harmonics, BRDF table");
  addArgument(command, "ENV", request->environment, "a map, as convert takes it, or a built-in: studio sky uv white");
  addOptions(command, bakeOptions(), request->options);
  addOptions(command, textureOutputOptions(), request->output);
  return [request] { return bake(*request); };
}

}  // namespace mirrorball::cli
