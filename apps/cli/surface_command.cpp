#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/standard_streams.h"
#include "cli/surface_ladder.h"
#include "cli/surface_maps.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/picture_layers.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball::cli {
namespace {

/// All that `surface` was told.
struct SurfaceRequest {
  std::string input;
  std::string output;
  SurfaceOptions options;
  LadderOptions ladder = {};
  GivenOptions given;
};

const auto kOutputOptions = std::to_array<Option<SurfaceRequest>>({
    {{.name = "output",
      .value = "OUT",
      .help =
          "required: the map; .exr and textures (.ktx2, .ktx, .dds) hold floats, signed; .png has 8 bits, of which ½ "
          "+ ½ n stands for signed numbers; a pyramid is a texture's mip levels; -.png is standard output, likewise "
          "with the other extensions",
      .letter = "o",
      .group = "Output",
      .takes_path = true},
     &SurfaceRequest::output},
});

constexpr OptionText kToText{
    .name = "to",
    .choices = "normal|derivative|height|cone|pyramid|occlusion|bent-normal|object-normal|tangent-normal",
    .aliases = "normals=normal|slope=derivative|heights=height|cones=cone|maximum=pyramid|ao=occlusion",
    .help =
        "the map: normals in tangent space; slopes (∂d/∂u, 0, ∂d/∂v); the heights of a normal map; √ratio of the "
        "widest cones; maxima as mip levels; the visible share of the sky; where its light comes from; and normals of "
        "--model in the axes of its mesh, or back in tangent space",
    .group = "Output"};

const auto kSurfaceOptions = std::to_array<Option<SurfaceOptions>>({
    {kToText, choiceField<&SurfaceOptions::to>},
    {{.name = "scale",
      .value = "S",
      .unit = "texture widths",
      .help =
          "what a height of 1 is; without it, the heights of a normal map go from 0 to 1, and their scale is printed",
      .group = "Heights"},
     numberField<&SurfaceOptions::field, &HeightFieldSettings::scale>},
    {{.name = "edges",
      .choices = "tiled|clamped",
      .aliases = "repeat=tiled|wrap=tiled|clamp=clamped",
      .help = "what is beyond the edges: the map again, or its outermost texels",
      .group = "Heights"},
     choiceField<&SurfaceOptions::field, &HeightFieldSettings::edges>},
    {{.name = "difference",
      .choices = "backward|forward|central|sobel",
      .help = "between which texels slopes are taken: the one before and this, as in the lecture; this and the next; "
              "the two beside; or these smoothed across",
      .group = "Heights"},
     choiceField<&SurfaceOptions::field, &HeightFieldSettings::difference>},
    {{.name = "directx",
      .help = "normals with green down instead of up, of the normal map that is written or read",
      .group = "Heights"},
     &SurfaceOptions::directx},
    {{.name = "model",
      .value = "MODEL",
      .help = "whose texture coordinates and tangents a normal map has, of object-normal and tangent-normal",
      .group = "Output",
      .takes_path = true,
      .names = builtinModelNames},
     &SurfaceOptions::model},
    {{.name = "cones",
      .choices = "conservative|relaxed",
      .help = "cones without surface in them, or such that a ray enters the surface at most once in them",
      .group = "Heights"},
     choiceField<&SurfaceOptions::cones>},
    {{.name = "azimuths",
      .choices = "8|16|32|64",
      .help = "in how many directions the horizon is looked for, of occlusion and bent-normal",
      .group = "Heights"},
     choiceField<&SurfaceOptions::azimuths>},
    {layerText(), &SurfaceOptions::layer},
    {kInsideOnlyText, &SurfaceOptions::inside_only},
    {kMaxMemoryText, kMemoryLimitField<SurfaceOptions>},
});

/// Options that only some maps heed.
struct OptionOfMaps {
  std::string_view option;
  std::string_view maps;  ///< as --to names them, with spaces around
};
constexpr OptionOfMaps kOptionsOfMaps[]{
    {"scale", " normal derivative height occlusion bent-normal "},
    {"difference", " normal derivative height occlusion bent-normal "},
    {"edges", " normal derivative height cone pyramid occlusion bent-normal "},
    {"directx", " normal height bent-normal object-normal tangent-normal "},
    {"model", " object-normal tangent-normal "},
    {"inside-only", " object-normal tangent-normal "},
    {"cones", " cone "},
    {"azimuths", " occlusion bent-normal "},
};

/// errors   usage: an option has nothing to act on
Result<void> refuseIdleSurfaceOptions(const SurfaceRequest& request) {
  const std::string map(choiceAt(kToText, static_cast<int>(request.options.to)));
  for (const auto& [option, maps] : kOptionsOfMaps)
    if (request.given.contains(option) && maps.find(" " + map + " ") == std::string_view::npos)
      return fail(ErrorCode::usage, changesNothing(std::array{"--" + std::string(option)},
                                                   "--to " + map + " does not use it; leave it out"));
  return {};
}

/// errors   usage; io
Result<void> checkSurfaceFiles(const SurfaceRequest& request) {
  const std::string& output = request.output;
  if (output.empty()) return fail(ErrorCode::usage, "surface needs an output: -o FILE.png, FILE.exr or FILE.ktx2");
  MIRRORBALL_TRY_VOID(numberFormat(output));
  if (request.options.to == SurfaceMap::pyramid && !isTexturePath(output))
    return fail(ErrorCode::usage, output + ": a pyramid is the mip levels of a texture; name it .ktx2, .ktx or .dds");
  const bool is_of_model =
      request.options.to == SurfaceMap::object_normal || request.options.to == SurfaceMap::tangent_normal;
  if (is_of_model && request.options.model.empty())
    return fail(ErrorCode::usage, "these normals are a model's: name it by --model MODEL");
  return refuseOverwriting(std::array{request.input, request.options.model}, {&output, 1});
}

/// errors   usage: an option of maps was given; as drawLadder's
Result<void> ladder(const SurfaceRequest& request) {
  for (const std::string_view option : request.given)
    if (option != "scale" && option != kMaxMemoryText.name)
      return fail(ErrorCode::usage,
                  changesNothing(std::array{"--" + std::string(option)}, "--ladder does not use it; leave it out"));
  if (request.output.empty()) return fail(ErrorCode::usage, "surface needs an output: -o FILE.png");
  MIRRORBALL_TRY_VOID(refuseOverwriting(std::array{request.input}, {&request.output, 1}));
  const float scale = request.given.contains("scale") ? request.options.field.scale : 0.0f;
  return drawLadder(request.input, scale, request.ladder, request.output);
}

Result<void> surface(SurfaceRequest& request) {
  MIRRORBALL_TRY_VOID(checkLadder(request.ladder));
  if (request.ladder.is_wanted) return ladder(request);
  MIRRORBALL_TRY_VOID(refuseIdleSurfaceOptions(request));
  MIRRORBALL_TRY_VOID(checkSurfaceFiles(request));
  request.options.has_scale = request.given.contains("scale");
  auto made = makeSurfaceMap(request.input, request.options);
  // A map is as large as its input: there is no --size.
  if (!made && made.error().fix_hint == FixHint::raise_memory_or_shrink) made.error().fix_hint = FixHint::raise_memory;
  MIRRORBALL_TRY(map, std::move(made));
  MIRRORBALL_TRY_VOID(writeNumbers(map, request.output));
  if (map.scale) tell("scale " + formatNumber(double(*map.scale)));
  return {};
}

}  // namespace

Command surfaceCommand() {
  auto request = std::make_shared<SurfaceRequest>();
  Command command{
      .name = "surface",
      .help = "Makes normal, slope, cone and occlusion maps of a height map, or heights of a normal map",
      .about =
          "IN is a height map, black low and white high, or for `--to height`, `object-normal` and `tangent-normal` a "
          "normal map. Its numbers are taken as they are: integers of 8 or 16 bits are shares of the greatest, without "
          "a colour's curve; floats are heights, or "
          "signed normals. Normal maps have x to the right and y up, as glTF and OpenGL want them. `--output` is "
          "required.",
      .examples = {{"surface brick.png --scale 0.03 -o brick_normal.png", "a normal map of a height map that tiles"},
                   {"surface brick_normal.png --to height -o brick.exr", "the heights again; prints their scale"}}};
  static const std::string formats = "(" + std::string(readExtensions()) + "), or - for standard input";
  addArgument(command,
              {.name = "IN",
               .help = "the height map, or the normal map " + formats +
                       ", or a built-in surface: " + join(builtinHeightNames(), " "),
               .missing = "name a height map",
               .names = builtinHeightNames,
               .takes_path = true},
              request->input);
  addOptions<SurfaceRequest>(command, kOutputOptions, *request);
  addOptions<SurfaceOptions>(command, kSurfaceOptions, request->options, &request->given);
  addLadder(command, request->ladder);
  command.action = [request] {
    return withStandardStreams({&request->input, &request->ladder.scene.environment}, request->output,
                               [&] { return surface(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
