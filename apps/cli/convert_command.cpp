#include "cli/convert_command.h"

#include <array>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/map_files.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/convert.h"
#include "mirrorball/environment/load.h"

namespace mirrorball::cli {
namespace {

const std::array<Option<ConvertOptions>, 7> kOptions{{
    {{.name = "output",
      .value = "OUT",
      .help = ".exr .hdr (linear radiance), .png .jpg (sRGB, clipped to [0, 1])",
      .letter = "o"},
     &ConvertOptions::output},
    {{.name = "to",
      .value = "PROJECTION",
      .help = "equirect, sphere, angular, cube, ball, paraboloid, octahedral, hemioctahedral, equal-area or eac; "
              "ball:distance=20 says how many ball radii the camera stands from the ball"},
     &ConvertOptions::to},
    {{.name = "from",
      .value = "FORM",
      .help = "the input's form, where it is not recognised: a projection, or a cube's "
              "layout"},
     &ConvertOptions::from},
    {{.name = "layout", .value = "LAYOUT", .help = "of a cube: faces (six files), hcross, vcross, hstrip, vstrip, 3x2"},
     &ConvertOptions::layout},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 32768,
      .help =
          "a cube face's side, a disc's diameter, a square's side or a panorama's height; 0 keeps the input's detail"},
     &ConvertOptions::size},
    {{.name = "half", .help = "16-bit instead of 32-bit floats in .exr"}, &ConvertOptions::half},
    {{.name = "repair", .help = "replace NaN and infinite texels by their neighbours"}, &ConvertOptions::repair},
}};

Result<void> convertFile(const std::string& input, const ConvertOptions& options) {
  if (options.output.empty()) return fail(ErrorCode::usage, "convert needs an output: -o FILE");
  if (options.to.empty())
    return fail(ErrorCode::usage, "convert needs a projection: --to " + join(projectionNames(), "|"));
  MIRRORBALL_TRY(to, projectionNamed(options.to));
  MIRRORBALL_TRY(layout, cubeLayoutNamed(options.layout));
  MIRRORBALL_TRY_VOID(checkFolder(options.output));
  MIRRORBALL_TRY_VOID(checkWritable(options.output));
  EnvironmentLoadOptions how{.repair = options.repair};
  if (!options.from.empty()) {
    MIRRORBALL_TRY(hint, formHintNamed(options.from));
    how.from = hint;
  }
  MIRRORBALL_TRY(loaded, loadEnvironment(input, how));
  MIRRORBALL_TRY_VOID(refuseOverwriting(loaded.files, mapPaths(options.output, to, layout)));
  const int size = options.size > 0 ? options.size : loaded.environment.naturalSize(to);
  MIRRORBALL_TRY(map, convert(loaded.environment, to, size, {}, progressBar("convert")));
  return writeMap(map, layout, options.half, options.output);
}

}  // namespace

std::span<const Option<ConvertOptions>> convertOptions() { return kOptions; }

Action addConvertCommand(CLI::App& program) {
  struct Request {
    std::string input;
    ConvertOptions options;
  };
  auto request = std::make_shared<Request>();
  CLI::App* command = program.add_subcommand("convert", "Lays an environment map out in another projection");
  command->add_option("IN", request->input, "a map (.hdr .exr .png .jpg) or a built-in: studio sky uv white")
      ->required();
  addOptions(*command, convertOptions(), request->options);
  return [request] { return convertFile(request->input, request->options); };
}

}  // namespace mirrorball::cli
