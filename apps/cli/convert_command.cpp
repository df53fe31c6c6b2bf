#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/map_inputs.h"
#include "cli/map_output.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/parallel.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/output/convert_file.h"
#include "mirrorball/photo/heading_in_file.h"

namespace mirrorball::cli {
namespace {

/// What `convert` is told beside its inputs and its files (map_output.h).
struct ConvertOptions {
  std::string to;
  std::string from;
  int size = 0;
  Interpolation filter = Interpolation::bicubic;
  std::vector<float> rotate_deg;
  std::vector<float> centre;
  std::string extension;
  bool repair = false;
  bool mark_north = false;
};

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

const auto kConvertOptions = std::to_array<Option<ConvertOptions>>({
    {{.name = "to", .value = "PROJECTION", .help = kToHelp, .names = projectionNames}, &ConvertOptions::to},
    {formText(
         "form of the input, if it is not recognised: a projection or a cube layout, and after a colon how the "
         "file arranges it, as in cube:for=unity, hcross:as-seen or equirect:for=blender, or which part of a "
         "panorama it shows, as in equirect:fov=360x90; dual-fisheye stitches the two circles of a 360-degree "
         "camera; layer=NAME, alone or with them, is the layer of an OpenEXR "
         "file that is read, and layer=\"NAME\" one whose name has commas; swap=rb, likewise, exchanges red and blue"),
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
    {{.name = "mark-north",
      .help = "draw a line and the letter N into the map where north is, by the compass heading that the file of a "
              "panorama states (see info --north)"},
     &ConvertOptions::mark_north},
    {{.name = "repair", .help = "replace NaN and infinite texels by the mean of their neighbours"},
     &ConvertOptions::repair},
    {kMaxMemoryText, kMemoryLimitField<ConvertOptions>},
});

/// errors   usage: the centre is 0,0,0
Result<Resampling> resamplingOf(const ConvertOptions& options) {
  Resampling resampling{.interpolation = options.filter, .source_from_target = sourceFromRotated(options.rotate_deg)};
  if (options.centre.empty()) return resampling;
  MIRRORBALL_TRY(centre, unitVector("--centre", options.centre));
  resampling.source_from_target = centredOn(centre) * resampling.source_from_target;
  return resampling;
}

/// All that `convert` was told.
struct ConvertRequest {
  ConvertOptions options;
  FileConversion conversion = {};
  MapOutputOptions output = {};
};

/// Settles the conversion by the options.
///
/// errors   usage: what convert cannot do without is missing or wrong
Result<void> settle(ConvertRequest& request) {
  const ConvertOptions& options = request.options;
  if (request.output.output.empty()) return fail(ErrorCode::usage, "convert needs an output: -o FILE");
  FileConversion& conversion = request.conversion;
  request.output.file.is_one_file = isStandardOutputTaken();
  conversion.file = request.output.file;
  conversion.size = options.size;
  MIRRORBALL_TRY(resampling, resamplingOf(options));
  conversion.resampling = resampling;
  conversion.load.repair = options.repair;
  conversion.load.light = conversion.file.light;
  if (!options.to.empty()) {
    MIRRORBALL_TRY(to, projectionToWrite(options.to));
    conversion.to = to;
  }
  if (!options.from.empty()) {
    MIRRORBALL_TRY(hint, formHintNamed(options.from));
    conversion.load.from = hint;
  }
  return {};
}

/// Refuses, before anything is read, what can be refused by then.
Result<void> checkRequest(const std::string& input, const std::string& path, const ConvertRequest& request) {
  MIRRORBALL_TRY_VOID(checkMapOutput(request.output, path));
  return checkConversion(input, path, request.conversion);
}

/// Converts one map, and shows its progress.
Result<void> convertOne(const std::string& input, const std::string& path, const ConvertRequest& request,
                        const Observer& observer) {
  FileConversion conversion = request.conversion;
  if (request.options.mark_north) {
    MIRRORBALL_TRY(heading, withName(shown(input), requiredHeading(input)));
    conversion.marked_north = heading;
  }
  auto converted = convertFile(input, path, conversion, observer);
  if (!converted) return tl::unexpected<Error>(ofMap(input, std::move(converted).error()));
  return {};
}

/// Every input's path in the folder; no two may be the same.
///
/// extension  of the files; empty: each input's own
/// errors     usage: one has no extension that can be written, and none is named
Result<std::vector<std::string>> pathsFor(const std::vector<std::string>& inputs, const std::string& folder,
                                          const std::string& extension) {
  return namesInFolder(inputs, folder, [&](const std::filesystem::path& name) -> Result<std::string> {
    const std::string ending = extension.empty() ? name.extension().string() : "." + withoutDot(extension);
    const std::string path = (std::filesystem::path(folder) / (name.stem().string() + ending)).string();
    if (isTexturePath(path) || checkWritable(path)) return ending;
    return fail(ErrorCode::usage, " would become " + path +
                                      ", which is not a format that Mirrorball writes; --extension names one: " +
                                      writtenExtensions(" or "));
  });
}

/// Converts maps, several at a time, into the folder that the request's output names, which is made if it is not there.
/// A map that cannot be converted is told of, and the others go on; what is wrong with the options is told once, before
/// anything is made.
///
/// errors   usage (the folder is a file's name, two outputs of one name, an output that overwrites its input or cannot
///          be written as asked); io (the folder); interrupted; one input's own error; of several the summary
Result<void> convertMany(const std::vector<std::string>& inputs, const ConvertRequest& request) {
  const std::string& folder = request.output.output;
  if (isOneFile(folder)) {
    Error many = manyForOneFile(folder, inputs);
    // Who has photographs of one ball, or six faces, did not mean a file of each.
    many.message += ", `mirrorball photo` merges exposures of a mirror ball, and six faces are named by their folder";
    return tl::unexpected<Error>(std::move(many));
  }
  MIRRORBALL_TRY(paths, pathsFor(inputs, folder, request.options.extension));
  for (std::size_t index = 0; index < inputs.size(); ++index)
    MIRRORBALL_TRY_VOID(checkRequest(inputs[index], paths[index], request));
  MIRRORBALL_TRY_VOID(makeFolder(folder));
  if (inputs.size() == 1) return convertOne(inputs.front(), paths.front(), request, terminalObserver());

  whenInterrupted(interruptedAmongMany(folder));
  std::atomic<std::size_t> done = 0;
  std::atomic<std::size_t> failed = 0;
  const ProgressFunction bar = progressBar("convert", "files");
  // One bar for all of them.
  Observer observer = terminalObserver();
  observer.progress = [](std::string_view) -> ProgressFunction {
    return [](std::size_t, std::size_t) { return !interrupted(); };
  };
  // Each file's own loops run on all cores too, which keeps them busy while another file is read or written.
  parallelFor(inputs.size(), 1, [&](std::size_t index, std::size_t) {
    if (interrupted()) return;
    const auto converted = convertOne(inputs[index], paths[index], request, observer);
    if (!converted && converted.error().code != ErrorCode::interrupted) {
      ++failed;
      complain(converted.error());
    }
    bar(++done, inputs.size());
  });
  return outcomeOfMany(failed, inputs.size(), "converted", folder);
}

Result<void> convertInputs(const std::vector<std::string>& inputs, ConvertRequest& request) {
  const std::string& output = request.output.output;
  if (output.empty()) MIRRORBALL_TRY_VOID(refuseUnnamedOutput(inputs, isOutputName));
  MIRRORBALL_TRY_VOID(settle(request));
  const std::vector<std::string> maps = withEachCubeOnce(inputs, request.conversion.load.from);
  const bool has_extension = !request.options.extension.empty();
  if (maps.size() > 1 || isFolder(output)) return convertMany(maps, request);
  if (has_extension && std::filesystem::path(output).has_extension())
    return fail(ErrorCode::usage, "--extension is for an output folder; " + output + " has its own");
  if (has_extension) return convertMany(maps, request);
  MIRRORBALL_TRY_VOID(checkFolder(output));
  MIRRORBALL_TRY_VOID(checkRequest(maps.front(), output, request));
  return convertOne(maps.front(), output, request, terminalObserver());
}

}  // namespace

Command convertCommand() {
  struct Request {
    std::vector<std::string> inputs;
    ConvertRequest convert;
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
  MapOutputOptions& output = request->convert.output;
  addOptions(command, kConvertOptions, request->convert.options, &output.given);
  static const std::string of_output = std::string(mapOutputHelp()) + "; for several inputs, a folder";
  addOptions(command, mapPictureOptions(), output.file, &output.given);
  addMapOutput(command, output, of_output);
  command.action = [request] {
    return withStandardStreams(pointersTo(request->inputs), request->convert.output.output,
                               [&] { return convertInputs(request->inputs, request->convert); });
  };
  return command;
}

}  // namespace mirrorball::cli
