#include "cli/convert_command.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/convert_files.h"
#include "cli/files.h"
#include "cli/map_inputs.h"
#include "cli/map_output.h"
#include "cli/standard_streams.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"

namespace mirrorball::cli {
namespace {

const std::string kToHelp =
    "projection of the output: " + join(projectionNames(), ", ", " or ") +
    "; ball:distance=20 is the distance of the camera from the ball's centre, in ball radii; without --to, "
    "the input's projection";

const std::string kExtensionHelp =
    "extension of the files in an output folder: " + writtenExtensions(" or ") + "; without it, that of each input";

std::span<const std::string_view> extensionNames() {
  static const std::vector<std::string_view> names = writtenExtensionNames();
  return names;
}

const std::array<Option<ConvertOptions>, 11> kConvertOptions{{
    {{.name = "to", .value = "PROJECTION", .help = kToHelp, .names = projectionNames}, &ConvertOptions::to},
    {{.name = "from",
      .value = "FORM",
      .help = "form of the input, if it is not recognised: a projection or a cube layout, and after a colon how the "
              "file arranges it, as in cube:for=unity, hcross:as-seen or equirect:for=blender",
      .names = projectionNames},
     &ConvertOptions::from},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 32768,
      .help = "size of the output: the side of a cube face or of a square map, the diameter of a disc, or the height "
              "of a panorama; 0 keeps the input's detail"},
     &ConvertOptions::size},
    {{.name = "filter",
      .choices = "bilinear|bicubic",
      .aliases = "linear=bilinear|cubic=bicubic",
      .help = "interpolation between the input's texels; where the output is coarser, each of its texels is the mean "
              "over its area"},
     choiceField<&ConvertOptions::filter>},
    {{.name = "centre",
      .value = "X,Y,Z",
      .min_count = 3,
      .max_count = 3,
      .help = "direction of the input that moves to the centre of the output, +Z, before --rotate; up stays up",
      .also = "center"},
     &ConvertOptions::centre},
    {kRotateText, &ConvertOptions::rotate_deg},
    {{.name = "extension", .value = "EXT", .help = kExtensionHelp, .names = extensionNames},
     &ConvertOptions::extension},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &ConvertOptions::repair},
    {kMaxMemoryText, &ConvertOptions::max_memory},
    {exposureText(), &ConvertOptions::exposure_ev},
    {toneMapText(), choiceField<&ConvertOptions::tone_map>},
}};

Resampling resamplingOf(const ConvertOptions& options) {
  Resampling resampling{.interpolation = options.filter, .source_from_target = sourceFromRotated(options.rotate_deg)};
  if (options.centre.empty()) return resampling;
  const glm::vec3 centre(options.centre[0], options.centre[1], options.centre[2]);
  resampling.source_from_target = centredOn(glm::normalize(centre)) * resampling.source_from_target;
  return resampling;
}

/// errors   usage: what convert cannot do without is missing or wrong
Result<ConvertRequest> requestOf(const ConvertOptions& options, const MapOutputOptions& output) {
  if (output.output.empty()) return fail(ErrorCode::usage, "convert needs an output: -o FILE");
  if (!options.centre.empty() &&
      glm::length(glm::vec3(options.centre[0], options.centre[1], options.centre[2])) == 0.0f)
    return fail(ErrorCode::usage, "--centre takes a vector that has a length");
  ConvertRequest request{std::nullopt,
                         options.size,
                         resamplingOf(options),
                         {.repair = options.repair, .light = output.file.light},
                         output};
  request.output.file.display = {options.exposure_ev, options.tone_map};
  if (!options.to.empty()) {
    MIRRORBALL_TRY(to, projectionToWrite(options.to));
    request.to = to;
  }
  if (!options.from.empty()) {
    MIRRORBALL_TRY(hint, formHintNamed(options.from));
    request.load.from = hint;
  }
  return request;
}

Result<void> convertInputs(const std::vector<std::string>& inputs, const ConvertOptions& options,
                           const MapOutputOptions& output) {
  MIRRORBALL_TRY_VOID(useMemoryLimit(options.max_memory));
  if (output.output.empty()) MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, isOutputName));
  MIRRORBALL_TRY(request, requestOf(options, output));
  const std::vector<std::string> maps = withEachCubeOnce(inputs, request.load.from);
  if (maps.size() > 1 || isFolder(output.output)) return convertMany(maps, options.extension, request);
  if (options.extension.empty()) return convertFile(maps.front(), request);
  if (std::filesystem::path(output.output).has_extension())
    return fail(ErrorCode::usage, "--extension is for an output folder; " + output.output + " has its own");
  return convertMany(maps, options.extension, request);
}

}  // namespace

std::span<const Option<ConvertOptions>> convertOptions() { return kConvertOptions; }

Command convertCommand() {
  struct Request {
    std::vector<std::string> inputs;
    ConvertOptions options;
    MapOutputOptions output;
  };
  auto request = std::make_shared<Request>();
  const std::string maps =
      "(" + std::string(readExtensions()) + "), one of a cube's six files or their folder, a built-in";
  Command command{.name = "convert",
                  .help = "Converts environment maps to another projection, size or format",
                  .about = "IN is a map " + maps + " environment, or - for standard input. `--output` is required.",
                  .examples = {{"convert room.hdr --to cube --size 512 --mips -o room.ktx2",
                                "a panorama as a cube map with all its mip levels"},
                               {"convert maps/*.hdr --to cube --for unity --extension exr -o cubes/",
                                "a folder of panoramas, six faces each, as Unity has them"}}};
  addArgument(command,
              {.name = "IN",
               .help = "maps " + maps + ": " + join(builtinEnvironmentNames(), " ") + ", or - for standard input",
               .missing = "name an input map",
               .names = builtinEnvironmentNames,
               .takes_path = true},
              request->inputs);
  addOptions(command, convertOptions(), request->options, &request->output.given);
  static const std::string of_output = std::string(mapOutputHelp()) + "; for several inputs, a folder";
  addMapOutput(command, request->output, of_output);
  command.action = [request] {
    return withStandardStreams(pointersTo(request->inputs), request->output.output,
                               [&] { return convertInputs(request->inputs, request->options, request->output); });
  };
  return command;
}

}  // namespace mirrorball::cli
