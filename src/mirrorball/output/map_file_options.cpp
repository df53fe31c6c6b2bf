// The table of how a map goes into its file.

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/output/map_file.h"

namespace mirrorball {
namespace {

/// "float16=half|fp16=half": the other names.
std::string formatAliases() {
  std::string aliases;
  for (const TexelFormatName& format : kTexelFormatNames)
    for (const std::string& also : split(format.also, ' '))
      aliases += (aliases.empty() ? "" : "|") + also + "=" + std::string(format.name);
  return aliases;
}

const std::string kFormatChoices = "auto|" + join(texelFormatNames(), "|");
const std::string kFormatAliases = formatAliases();
const std::string kFormatHelp = "texel format: " + join(texelFormatNames("exr"), ", ", " or ") + " in .exr; " +
                                join(texelFormatNames("dds"), ", ", " or ") + " in " +
                                writtenExtensions(Holds::texture, " and ") +
                                ", in .ktx2 uastc_hdr too; auto is float32 in .exr, half in textures if it holds all "
                                "values, and in what bake makes for filament and three b10g11r11 and uastc_hdr; bc6h "
                                "and uastc_hdr are compressed to one byte per texel";

constexpr ChoiceField<MapFileOptions> kFormatField{
    [](const MapFileOptions& options) { return options.format ? static_cast<int>(*options.format) + 1 : 0; },
    [](MapFileOptions& options, int index) {
      options.format = index > 0 ? std::optional(static_cast<TexelFormat>(index - 1)) : std::nullopt;
    }};

using Field = ParsedField<MapFileOptions>;

constexpr Field kFaceOrderField{
    [](const MapFileOptions& options) { return options.face_order ? textOf(*options.face_order) : std::string(); },
    [](const OptionText& text, std::string_view written, MapFileOptions& options) -> Result<void> {
      auto order = faceOrderNamed(written);
      if (!order) return fail(ErrorCode::usage, std::string(text.name) + ": " + order.error().message);
      options.face_order = *order;
      return {};
    }};

constexpr Field kLayoutField{
    [](const MapFileOptions& options) { return options.layout ? std::string(nameOf(*options.layout)) : std::string(); },
    [](const OptionText& text, std::string_view written, MapFileOptions& options) -> Result<void> {
      auto layout = cubeLayoutNamed(written);
      if (!layout) return fail(ErrorCode::usage, std::string(text.name) + ": " + layout.error().message);
      options.layout = *layout;
      return {};
    }};

/// 0 stands for no limit.
constexpr Field kClampField{
    [](const MapFileOptions& options) {
      return formatNumber(std::isfinite(options.light.max) ? options.light.max : 0.0f);
    },
    [](const OptionText& text, std::string_view written, MapFileOptions& options) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      options.light.max = numbers[0] > 0.0f ? numbers[0] : std::numeric_limits<float>::infinity();
      return {};
    }};

const std::string kProgramHelp = "store the map as this program expects it: " + join(presetNames(), " ");
const std::string kLayoutHelp = "layout of a cube in picture files: " + join(cubeLayoutNames()) +
                                " (faces writes six files); without it, the layout of {option:for}, or hcross";

const std::string kPrimariesHelp = primariesHelp({Holds::light, Holds::picture, Holds::texture});

const std::string kMipsHelp =
    "write all mip levels: " + writtenExtensions(Holds::texture, " and ") +
    " store them as such; a picture shows them on one sheet, the smaller ones beside or below level 0";
// First those that any texture of a cube may be asked for.
constexpr std::size_t kTextureOptions = 8;
const auto kMapFileOptions = std::to_array<Option<MapFileOptions>>({
    {{.name = "for",
      .value = "PROGRAM",
      .help = kProgramHelp,
      .group = "Output",
      .is_daily = true,
      .names = presetNames},
     &MapFileOptions::program},
    {{.name = "as-seen",
      .help = "store cube faces as seen from inside the cube, not by OpenGL's left-handed table",
      .group = "Output"},
     &MapFileOptions::as_seen},
    {{.name = "flip",
      .choices = "none|horizontal|vertical|both",
      .help = "flip each cube face, after {option:for} and {option:as-seen}",
      .group = "Output"},
     choiceField<&MapFileOptions::flip>},
    {{.name = "face-order",
      .value = "ORDER",
      .help = "order in which the six cube faces are stored; the usual one is +x,-x,+y,-y,+z,-z",
      .group = "Output"},
     kFaceOrderField},
    {{.name = "format",
      .value = "FORMAT",
      .choices = kFormatChoices,
      .aliases = kFormatAliases,
      .help = kFormatHelp,
      .group = "Output",
      .is_daily = true},
     kFormatField},
    {{.name = "zstd",
      .value = "LEVEL",
      .minimum = 0,
      .maximum = 22,
      .help = "level of Zstandard compression in .ktx2: 0 none, 1 fastest … 22 smallest",
      .group = "Output"},
     &MapFileOptions::zstandard_level},
    {{.name = "scale-light",
      .value = "FACTOR",
      .minimum = 1e-30,
      .maximum = 1e30,
      .help = "multiply all light by FACTOR, before anything else is done with it",
      .group = "Output",
      .is_number = true},
     numberField<&MapFileOptions::light, &LightLimits::scale>},
    {{.name = "clamp-light",
      .value = "MAX",
      .unit = "radiance",
      .minimum = 0,
      .maximum = 1e38,
      .help = "after {option:scale-light}, scale texels above MAX in any channel down to MAX, keeping their hue; 0: no "
              "limit",
      .group = "Output"},
     kClampField},
    {primariesText(kPrimariesHelp), choiceField<&MapFileOptions::primaries>},
    {{.name = "layout",
      .value = "LAYOUT",
      .help = kLayoutHelp,
      .group = "Output",
      .is_daily = true,
      .names = cubeLayoutNames},
     kLayoutField},
    {{.name = "mips", .help = kMipsHelp, .group = "Output", .is_daily = true}, &MapFileOptions::mips},
    {{.name = "level",
      .value = "N",
      .minimum = 0,
      .maximum = 30,
      .help = "write one mip level instead of the map; 0 is the map itself, and each further level is half as large",
      .group = "Output"},
     &MapFileOptions::level},
    {{.name = "mip",
      .choices = "auto|solid-angle|box",
      .help = "weights of the texels in mip levels: their solid angle, or all equal (plain 2 x 2 boxes); auto is "
              "solid-angle, but keeps the levels of a texture whose map is not changed",
      .group = "Output"},
     choiceField<&MapFileOptions::mip_source>},
});

const auto kMapPictureOptions = std::to_array<Option<MapFileOptions>>({
    {exposureText(), numberField<&MapFileOptions::display, &Display::exposure_ev>},
    {toneMapText(), choiceField<&MapFileOptions::display, &Display::tone_map>},
    {gainMapText(), &MapFileOptions::gain_map},
});

}  // namespace

std::span<const Option<MapFileOptions>> mapPictureOptions() { return kMapPictureOptions; }

std::span<const Option<MapFileOptions>> mapFileOptions() { return kMapFileOptions; }

std::span<const Option<MapFileOptions>> textureFileOptions() { return mapFileOptions().subspan(0, kTextureOptions); }

}  // namespace mirrorball
