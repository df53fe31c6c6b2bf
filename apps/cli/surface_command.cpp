#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/standard_streams.h"
#include "cli/surface_maps.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/scene/relief/height_texture.h"

namespace mirrorball::cli {
namespace {

/// All that `surface` was told.
struct SurfaceRequest {
  std::string input;
  std::string output;
  SurfaceOptions options;
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
    .choices = "normal|derivative|height|cone|pyramid|occlusion|bent-normal",
    .aliases = "normals=normal|slope=derivative|heights=height|cones=cone|maximum=pyramid|ao=occlusion",
    .help =
        "the map: normals in tangent space; slopes (∂d/∂u, 0, ∂d/∂v); the heights of a normal map; √ratio of the "
        "widest cones; maxima as mip levels; the visible share of the sky; and where its light comes from",
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
    {kMaxMemoryText, &SurfaceOptions::max_memory},
});

/// Options that only some maps heed.
struct OptionOfMaps {
  std::string_view option;
  std::string_view maps;  ///< as --to names them, with spaces around
};
constexpr OptionOfMaps kOptionsOfMaps[]{
    {"scale", " normal derivative height occlusion bent-normal "},
    {"difference", " normal derivative height occlusion bent-normal "},
    {"directx", " normal height bent-normal "},
    {"cones", " cone "},
    {"azimuths", " occlusion bent-normal "},
};

/// errors   usage: an option has nothing to act on
Result<void> refuseIdleOptions(const SurfaceRequest& request) {
  const std::string map(choiceAt(kToText, static_cast<int>(request.options.to)));
  for (const auto& [option, maps] : kOptionsOfMaps)
    if (request.given.contains(option) && maps.find(" " + map + " ") == std::string_view::npos)
      return fail(ErrorCode::usage, "--" + std::string(option) + " changes nothing of --to " + map + "; leave it out");
  return {};
}

/// errors   usage; io
Result<ImageFormatId> checkOutput(const SurfaceRequest& request) {
  const std::string& output = request.output;
  if (output.empty()) return fail(ErrorCode::usage, "surface needs an output: -o FILE.png, FILE.exr or FILE.ktx2");
  MIRRORBALL_TRY(format, formatToWrite(output, {Holds::light, Holds::picture, Holds::texture}));
  if (format == ImageFormatId::hdr || format == ImageFormatId::jpeg)
    return fail(ErrorCode::usage, output + ": that format changes the numbers of a map; name it .exr or .png");
  if (request.options.to == SurfaceMap::pyramid && !isTexturePath(output))
    return fail(ErrorCode::usage, output + ": a pyramid is the mip levels of a texture; name it .ktx2, .ktx or .dds");
  MIRRORBALL_TRY_VOID(checkFolder(output));
  MIRRORBALL_TRY_VOID(refuseOverwriting({&request.input, 1}, {&output, 1}));
  return format;
}

/// The codes of 8 bits nearest to a map's numbers; says where some do not fit.
Image8 pictureOf(const MadeMap& map, const std::string& output) {
  const Image& numbers = map.images.at(0, 0);
  Image8 picture = Image8::withoutValues(numbers.width(), numbers.height(), numbers.channels());
  std::size_t clipped = 0;
  std::ranges::transform(numbers.samples(), picture.samples().begin(), [&](float number) {
    const float share = map.is_signed ? 0.5f + 0.5f * number : number;
    constexpr float kRounding = 1e-5f;
    if (share < -kRounding || share > 1.0f + kRounding) ++clipped;
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
  });
  if (clipped > 0)
    remark(
        output + ": " + std::to_string(clipped) + " of " + std::to_string(numbers.samples().size()) +
        " numbers are beyond what .png holds, and became its least or greatest; .exr holds them, or a smaller --scale");
  return picture;
}

Result<void> writeMap(const MadeMap& map, const std::string& output, ImageFormatId format) {
  if (format == ImageFormatId::png) return savePicture(output, pictureOf(map, output));
  if (format == ImageFormatId::exr) return writeImage(output, map.images.at(0, 0));
  return writeImageSet(output, map.images,
                       {.format = TexelFormat::float32, .progress = progressBar("writing " + shown(output))});
}

Result<void> surface(SurfaceRequest& request) {
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.options.max_memory));
  MIRRORBALL_TRY_VOID(refuseIdleOptions(request));
  MIRRORBALL_TRY(format, checkOutput(request));
  request.options.has_scale = request.given.contains("scale");
  auto made = makeSurfaceMap(request.input, request.options);
  // A map is as large as its input: there is no --size.
  if (!made && made.error().remedy == Remedy::raise_memory_or_shrink) made.error().remedy = Remedy::raise_memory;
  MIRRORBALL_TRY(map, std::move(made));
  MIRRORBALL_TRY_VOID(writeMap(map, request.output, format));
  announce(request.output);
  if (request.options.to == SurfaceMap::height && !request.options.has_scale)
    tell("scale " + formatNumber(double(map.scale)));
  return {};
}

}  // namespace

Command surfaceCommand() {
  auto request = std::make_shared<SurfaceRequest>();
  Command command{
      .name = "surface",
      .help = "Makes normal, slope, cone and occlusion maps of a height map, or heights of a normal map",
      .about =
          "IN is a height map, black low and white high, or for `--to height` a normal map. Its numbers are taken as "
          "they "
          "are: integers of 8 or 16 bits are shares of the greatest, without a colour's curve; floats are heights, or "
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
  command.action = [request] {
    return withStandardStreams({&request->input}, request->output, [&] { return surface(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
