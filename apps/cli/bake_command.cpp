#include "cli/bake_command.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/bake_maps.h"
#include "cli/baked_set.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/cube_files.h"
#include "cli/engine_set.h"
#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/map_output.h"
#include "cli/stage_clock.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/cube/preset.h"

namespace mirrorball::cli {
namespace {

const std::string kBakedHelp =
    "required: a folder for all maps and a manifest (with several environments, one folder in it for each), or a " +
    writtenExtensions(Holds::texture, " or ") + " file for the specular mip chain only (-.ktx2 is standard output)";

std::vector<std::string_view> texturesAnd(std::vector<std::string_view> others) {
  std::vector<std::string_view> names = writtenExtensionNames(Holds::texture);
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

const std::vector<std::string_view>& cubeExtensions() {
  static const std::vector<std::string_view> names = texturesAnd(writtenExtensionNames(Holds::light));
  return names;
}

/// A table holds no light, but numbers: .exr keeps them.
const std::vector<std::string_view>& brdfExtensions() {
  static const std::vector<std::string_view> names = texturesAnd({"exr"});
  return names;
}

const std::string kCubeExtensions = join(cubeExtensions(), "|");
const std::string kBrdfExtensions = join(brdfExtensions(), "|");

const std::array<Option<BakeOptions>, 19> kBakeOptions{{
    {{.name = "output", .value = "OUT", .help = kBakedHelp, .letter = "o", .takes_path = true}, &BakeOptions::output},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 1,
      .maximum = 8192,
      .help = "side of a cube face in level 0 of the specular mip chain"},
     &BakeOptions::size},
    {{.name = "levels",
      .value = "N",
      .minimum = 0,
      .maximum = 14,
      .help = "number of mip levels, level 0 included; the last one has roughness 1. 0: down to 4 x 4 texels per face, "
              "for filament down to 16 x 16"},
     &BakeOptions::levels},
    {{.name = "distribution",
      .choices = "ggx|phong|blinn|charlie",
      .help = "microfacet distribution; charlie is for cloth"},
     choiceField<&BakeOptions::distribution>},
    {{.name = "mip-mapping",
      .choices = "auto|filament|linear|unreal|unity|frostbite",
      .help = "the roughness of each mip level, as this engine looks it up; auto goes by --for: unreal and unity have "
              "their own, godot has that of frostbite, all others that of filament"},
     choiceField<&BakeOptions::mip_mapping>},
    {{.name = "irradiance-size",
      .value = "N",
      .unit = "texels",
      .minimum = 1,
      .maximum = 1024,
      .help = "side of a face of the irradiance cube"},
     &BakeOptions::irradiance_size},
    {{.name = "sh-degree", .value = "L", .minimum = 2, .maximum = 4, .help = "highest band of the spherical harmonics"},
     &BakeOptions::harmonics_degree},
    {{.name = "brdf-size",
      .value = "N",
      .unit = "texels",
      .minimum = 2,
      .maximum = kLargestBrdfTable,
      .help = "side of the BRDF table"},
     &BakeOptions::brdf_size},
    {{.name = "brdf-channels",
      .value = "N",
      .minimum = 2,
      .maximum = 3,
      .help = "number of channels in the BRDF table: 2 for scale and bias, 3 with the mean for multiple scattering; "
              "with 2, a .exr gets a third channel of zeros"},
     &BakeOptions::brdf_channels},
    {{.name = "brdf-axes",
      .choices = "linear|warped",
      .help = "axes of the BRDF table: linear in n.v and perceptual roughness, as engines have it, or warped, so that "
              "look-ups near grazing angles are accurate too"},
     choiceField<&BakeOptions::brdf_axes>},
    {{.name = "brdf-extension",
      .value = kBrdfExtensions,
      .help = "extension of the BRDF table's file; without it, that of --extension, but .exr in place of .hdr",
      .names = [] { return std::span<const std::string_view>(brdfExtensions()); }},
     &BakeOptions::brdf_extension},
    {{.name = "skybox", .help = "also write the environment itself, for the background; filament always gets it"},
     &BakeOptions::skybox},
    {{.name = "skybox-size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 8192,
      .help = "side of a face of the skybox; 0: as fine as the environment, but at most 1024"},
     &BakeOptions::skybox_size},
    {{.name = "extension",
      .value = kCubeExtensions,
      .help = "extension of the files in a folder: textures, or pictures of each level and face (m0_px.exr); without "
              "it, ktx2, and for filament ktx",
      .names = [] { return std::span<const std::string_view>(cubeExtensions()); }},
     &BakeOptions::extension},
    {{.name = "from",
      .value = "FORM",
      .help = "form of the environment map, if it is not recognised (see convert --from)",
      .names = projectionNames},
     &BakeOptions::from},
    {kRotateText, &BakeOptions::rotate_deg},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &BakeOptions::repair},
    {{.name = "timings", .help = "print how long each stage took"}, &BakeOptions::timings},
    {kMaxMemoryText, &BakeOptions::max_memory},
}};

/// The table as the cubes are stored, but for formats that would round it to a percent.
BrdfFile brdfFile(const std::string& stem, std::string_view extension, const BakeOptions& options,
                  const MapFileOptions& output) {
  BrdfFile file{
      .path = stem + "." + std::string(extension),
      .facts = {writtenValue(options, "distribution"), writtenValue(options, "brdf-axes"), options.brdf_channels}};
  // Pictures are in 32-bit floats unless told otherwise, as everywhere.
  const bool in_floats =
      output.format == TexelFormat::float32 || (output.format != TexelFormat::half && !file.isTexture());
  if (file.isTexture() && options.brdf_channels == 2)
    file.format = in_floats ? TexelFormat::rg_float32 : TexelFormat::rg_half;
  else
    file.format = in_floats ? TexelFormat::float32 : TexelFormat::half;
  if (extension == "ktx2") file.zstandard_level = output.zstandard_level;
  return file;
}

Result<std::string_view> extensionNamed(const std::string& name, std::span<const std::string_view> known) {
  if (const auto index = indexOfName(withoutDot(name), known)) return known[*index];
  return tl::unexpected<Error>(unknownName("extension", name, known));
}

/// Refuses options that say something about what there is not.
///
/// why      what to say before and after the option's name
/// errors   usage
Result<void> refuseOptions(const BakeOptions& options, std::span<const std::string_view> names,
                           const std::array<std::string, 2>& why) {
  const BakeOptions defaults;
  for (const Option<BakeOptions>& option : kBakeOptions)
    if (std::ranges::find(names, option.text.name) != names.end() &&
        written(option, options) != written(option, defaults))
      return fail(ErrorCode::usage, why[0] + "--" + std::string(option.text.name) + why[1]);
  return {};
}

/// The extension of a set's textures, or pictures.
///
/// errors   usage: none that there is, or none that the program reads
Result<std::string_view> extensionFor(const BakeRequest& request) {
  const EngineSet& set = request.set;
  if (request.options.extension.empty()) return set.extension;
  MIRRORBALL_TRY(extension, extensionNamed(request.options.extension, cubeExtensions()));
  if (set.files == SetFiles::cmgens && isTexturePath("x." + std::string(extension)) && extension != set.extension)
    return fail(ErrorCode::usage, "--extension: " + std::string(set.program) + " reads ." + std::string(set.extension) +
                                      ", no ." + std::string(extension) + "; leave --extension out");
  return extension;
}

/// A folder's own name, also of "." and "..".
std::string nameOfFolder(const std::string& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// The files of irradiance and of the BRDF table, which a program may have none of.
Result<void> addOurFiles(const BakeRequest& request, std::string_view extension, BakedFiles& files) {
  const BakeOptions& options = request.options;
  MIRRORBALL_TRY(irradiance, CubeFiles::resolve(request.output.file, files.folder, {"irradiance", "i"}, extension, 1,
                                                terminalObserver()));
  files.irradiance = std::move(irradiance);
  const std::string brdf =
      options.brdf_extension.empty() ? std::string(extension == "hdr" ? "exr" : extension) : options.brdf_extension;
  MIRRORBALL_TRY(brdf_extension, extensionNamed(brdf, brdfExtensions()));
  files.brdf = brdfFile(files.folder + "/brdf", brdf_extension, options, request.output.file);
  return {};
}

/// errors   usage: no such folder can be, or no such files
Result<BakedFiles> filesOf(const BakeRequest& request) {
  namespace fs = std::filesystem;
  constexpr std::array<std::string_view, 6> kOfOurs{"irradiance-size", "sh-degree", "brdf-size",
                                                    "brdf-channels",   "brdf-axes", "brdf-extension"};
  const BakeOptions& options = request.options;
  const bool is_cmgens = request.set.files == SetFiles::cmgens;
  if (is_cmgens)
    MIRRORBALL_TRY_VOID(refuseOptions(options, kOfOurs,
                                      {"",
                                       ": Filament has a BRDF table of its own, and irradiance from harmonics of "
                                       "three bands; leave it out"}));
  MIRRORBALL_TRY(extension, extensionFor(request));
  std::string folder = options.output;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  std::error_code status;
  if (fs::exists(folder, status) && !fs::is_directory(folder, status))
    return fail(ErrorCode::usage, folder + ": is a file; name a folder, or a " +
                                      writtenExtensions(Holds::texture, " or ") + " file for the chain only");
  const std::string prefix = is_cmgens ? nameOfFolder(folder) + "_" : "";
  const CubeNames chain{is_cmgens ? prefix + "ibl" : "specular", "m", true};
  MIRRORBALL_TRY(specular, CubeFiles::resolve(request.output.file, folder, chain, extension, levelCount(request),
                                              terminalObserver()));
  BakedFiles files{
      .source = request.environment, .folder = folder, .set = request.set, .specular = std::move(specular)};
  if (is_cmgens || options.skybox || options.skybox_size > 0) {
    MIRRORBALL_TRY(skybox, CubeFiles::resolve(request.output.file, folder, {prefix + "skybox", "skybox"}, extension, 1,
                                              terminalObserver()));
    files.skybox = std::move(skybox);
  }
  if (!is_cmgens) MIRRORBALL_TRY_VOID(addOurFiles(request, extension, files));
  return files;
}

/// errors   usage: an option that says something about what only a folder has
Result<void> refuseOptionsOfFolders(const BakeOptions& options) {
  constexpr std::array<std::string_view, 9> kOfFolders{"irradiance-size", "sh-degree",   "brdf-size",
                                                       "brdf-channels",   "brdf-axes",   "brdf-extension",
                                                       "skybox",          "skybox-size", "extension"};
  return refuseOptions(options, kOfFolders,
                       {options.output + ": holds the specular chain only, and ",
                        " is for what lies beside it; name a folder, without an extension"});
}

Result<void> bakeFile(const BakeRequest& request, StageClock& clock) {
  const std::string& path = request.options.output;
  if (!isTexturePath(path))
    return fail(ErrorCode::usage, path + ": a prefiltered chain goes into " +
                                      writtenExtensions(Holds::texture, " or ") +
                                      "; or name a folder, without an extension");
  MIRRORBALL_TRY_VOID(refuseOptionsOfFolders(request.options));
  MIRRORBALL_TRY(output, mapFileFor(request.output, path, Projection::cube));
  MIRRORBALL_TRY_VOID(checkFolder(path));
  MIRRORBALL_TRY(chain, bakeChain(request, output, clock));
  MIRRORBALL_TRY_VOID(
      clock.time("files: write", [&] { return output.writeLevels(std::move(chain.levels), chain.facts); }));
  output.remarkOnForm();
  return {};
}

Result<void> bakeFolder(const BakeRequest& request, StageClock& clock) {
  MIRRORBALL_TRY(files, filesOf(request));
  MIRRORBALL_TRY(set, bakeSet(request, files, clock));
  return clock.time("files: write", [&] { return writeSet(std::move(set), files, request.options); });
}

/// Whether an output is one file rather than a folder.
bool isFile(const std::string& output) { return !isFolder(output) && std::filesystem::path(output).has_extension(); }

Result<void> bakeOne(const BakeRequest& request) {
  StageClock clock;
  const Result<void> done = isFile(request.options.output) ? bakeFile(request, clock) : bakeFolder(request, clock);
  if (request.options.timings) clock.print();
  return done;
}

/// One after the other, since each keeps all cores busy and may need all memory.
Result<void> bakeMany(const std::vector<std::string>& inputs, BakeRequest request) {
  const std::string parent = request.options.output;
  if (isFile(parent)) return tl::unexpected<Error>(manyForOneFile(parent, inputs));
  MIRRORBALL_TRY(folders, namesInFolder(inputs, parent, [](const auto&) { return Result<std::string>(""); }));
  request.options.output = folders.front();
  // What is wrong with the options is told once, before anything is made.
  MIRRORBALL_TRY_VOID(filesOf(request));
  MIRRORBALL_TRY_VOID(makeFolder(parent));
  std::size_t failed = 0;
  for (std::size_t index = 0; index < inputs.size() && !interrupted(); ++index) {
    whenInterrupted(interruptedAmongMany(parent));
    request.environment = inputs[index];
    request.options.output = folders[index];
    const Result<void> done = bakeOne(request);
    if (done || done.error().code == ErrorCode::interrupted) continue;
    ++failed;
    complain(done.error());
  }
  return outcomeOfMany(failed, inputs.size(), "baked", parent);
}

/// Settles what the command line leaves to the program that the maps are for.
///
/// errors   usage: there is no such program, or there are not so many levels
Result<void> settleBy(BakeRequest& request) {
  BakeOptions& options = request.options;
  MIRRORBALL_TRY(set, engineSetFor(request.output.file.program));
  request.set = set;
  if (options.mip_mapping == MipMappingChoice::as_for) options.mip_mapping = set.mip_mapping;
  if (options.levels > maxLevels(options.size))
    return fail(ErrorCode::usage, "--levels: --size " + std::to_string(options.size) + " has at most " +
                                      std::to_string(maxLevels(options.size)) +
                                      ", the last of one texel a face; ask for no more");
  const std::string extension = isFile(options.output) ? extensionOf(options.output) : options.extension;
  if (!extension.empty() && !indexOfName(extension, {&set.extension, 1})) return {};
  std::optional<TexelFormat>& format = request.output.file.format;
  if (!format) format = set.format;
  if (!set.format || format == set.format) return {};
  if (std::ranges::find(set.other_formats, *format) != set.other_formats.end()) return {};
  const auto nameOf = [](TexelFormat one) { return kTexelFormatNames[static_cast<std::size_t>(one)].name; };
  std::vector<std::string_view> known{nameOf(*set.format)};
  for (const TexelFormat one : set.other_formats) known.push_back(nameOf(one));
  return fail(ErrorCode::usage, "--format: " + std::string(set.program) + " reads " + join(known) + ", no " +
                                    std::string(nameOf(*format)) + "; leave --format out");
}

Result<void> bake(const std::vector<std::string>& inputs, BakeRequest request) {
  const std::string& output = request.options.output;
  if (output.empty()) {
    MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, [](const std::string& name) {
      return isTexturePath(name) || name.ends_with('/') || !std::filesystem::path(name).has_extension();
    }));
    return fail(ErrorCode::usage,
                "bake needs an output: -o FOLDER, or a " + writtenExtensions(Holds::texture, " or ") + " file");
  }
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.options.max_memory));
  MIRRORBALL_TRY_VOID(settleBy(request));
  if (inputs.size() > 1) return bakeMany(inputs, std::move(request));
  request.environment = inputs.front();
  // Of a folder that is new nothing stays, whichever of its files are finished.
  if (!isFile(request.options.output)) whenInterrupted("interrupted; nothing was written");
  return bakeOne(request);
}

}  // namespace

std::span<const Option<BakeOptions>> bakeOptions() { return kBakeOptions; }

std::string writtenValue(const BakeOptions& options, std::string_view name) {
  const auto* const option = std::ranges::find(kBakeOptions, name, [](const auto& row) { return row.text.name; });
  return written(*option, options);
}

Command bakeCommand() {
  struct Request {
    std::vector<std::string> inputs;
    BakeRequest bake;
  };
  auto request = std::make_shared<Request>();
  Command command{
      .name = "bake",
      .help = "Prefilters environments for an engine: rough reflections, irradiance, harmonics, BRDF table",
      .about =
          "ENV is a map, a built-in environment, or - for standard input. OUT is a folder for all maps (with several "
          "environments, one folder in it for each), or a " +
          writtenExtensions(Holds::texture, " or ") + " file for the specular mip chain only.",
      .examples = {{"bake room.hdr -o room/", "all maps of an environment, and a manifest that says what is what"},
                   {"bake maps/*.hdr --for unreal --size 512 -o baked/",
                    "a folder for each panorama, with Unreal's faces and levels"}}};
  addArgument(command,
              {.name = "ENV",
               .help = "maps, as convert takes them, a built-in: " + join(builtinEnvironmentNames(), " ") +
                       ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->inputs);
  addOptions(command, bakeOptions(), request->bake.options);
  addOptions(command, textureFileOptions(), request->bake.output.file);
  command.action = [request] {
    return withStandardStreams(pointersTo(request->inputs), request->bake.options.output,
                               [&] { return bake(request->inputs, request->bake); });
  };
  return command;
}

}  // namespace mirrorball::cli
