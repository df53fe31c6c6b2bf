// The table of what is baked for an engine.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/output/baked/baked_files.h"
#include "mirrorball/output/baked/baked_set.h"

namespace mirrorball {
namespace {

std::vector<std::string_view> texturesAnd(std::vector<std::string_view> others) {
  std::vector<std::string_view> names = writtenExtensionNames(Holds::texture);
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

const std::string kCubeExtensions = join(bakedCubeExtensions(), "|");
const std::string kBrdfExtensions = join(bakedBrdfExtensions(), "|");

/// The first choice leaves it to the engine.
constexpr ChoiceField<BakedSetSettings> kMipMappingField{
    [](const BakedSetSettings& settings) {
      return settings.mip_mapping ? static_cast<int>(*settings.mip_mapping) + 1 : 0;
    },
    [](BakedSetSettings& settings, int index) {
      settings.mip_mapping = index > 0 ? std::optional(static_cast<MipMapping>(index - 1)) : std::nullopt;
    }};

// As the manifest has them; in the order of BakedPart.
constexpr std::array<std::string_view, 6> kPartNames{"specular", "irradiance", "harmonics",
                                                     "brdf",     "lobe-rows",  "skybox"};

std::span<const std::string_view> partNames() { return kPartNames; }

constexpr ParsedField<BakedSetSettings> kOnlyField{
    [](const BakedSetSettings& settings) {
      std::vector<std::string_view> names;
      for (const BakedPart part : settings.only) names.push_back(kPartNames[static_cast<std::size_t>(part)]);
      return join(names, ",");
    },
    [](const OptionText& text, std::string_view written, BakedSetSettings& settings) -> Result<void> {
      std::vector<BakedPart> parts;
      for (const std::string& name : split(written, ',')) {
        const auto index = indexOfName(name, kPartNames);
        if (!index)
          return withName(std::string(text.name),
                          Result<void>(tl::unexpected<Error>(unknownName("part of a baked set", name, kPartNames))));
        const auto part = static_cast<BakedPart>(*index);
        if (!contains(parts, part)) parts.push_back(part);
      }
      settings.only = std::move(parts);
      return {};
    }};

/// Rows have an even number of lobes.
constexpr ChoiceField<BakedSetSettings> kLobeRowsField{
    [](const BakedSetSettings& settings) { return settings.lobe_rows.value_or(BakedSetSettings::kUsualLobes) / 2; },
    [](BakedSetSettings& settings, int index) { settings.lobe_rows = 2 * index; }};

/// An option with the parts that it describes; none: it concerns the whole set.
struct PartOption {
  Option<BakedSetSettings> option;
  std::vector<BakedPart> parts;
};

const std::vector<BakedPart> kCubeParts{BakedPart::specular, BakedPart::irradiance, BakedPart::skybox};
const std::vector<BakedPart> kLightParts{BakedPart::specular, BakedPart::irradiance, BakedPart::skybox,
                                         BakedPart::harmonics};
const std::vector<BakedPart> kFileParts{BakedPart::specular, BakedPart::irradiance, BakedPart::skybox, BakedPart::brdf};
const std::vector<BakedPart> kTextureParts{BakedPart::specular, BakedPart::irradiance, BakedPart::skybox,
                                           BakedPart::brdf, BakedPart::lobe_rows};

const auto kPartOptions = std::to_array<PartOption>({
    {{{.name = "size",
       .value = "N",
       .unit = "texels",
       .minimum = 1,
       .maximum = 8192,
       .help = "side of a cube face in level 0 of the specular mip chain"},
      &BakedSetSettings::size},
     {BakedPart::specular}},
    {{{.name = "levels",
       .value = "N",
       .minimum = 0,
       .maximum = 14,
       .help = "number of mip levels, level 0 included; the last one has roughness 1, but for {option:mip-mapping} "
               "babylon, which reaches it before its smallest levels. 0: down to 4 x 4 texels per face, for filament "
               "down to 16 x 16, for three 8 x 8, for godot, for babylon and with its mapping 1 x 1; playcanvas has 6"},
      &BakedSetSettings::levels},
     {BakedPart::specular}},
    {{{.name = "distribution",
       .choices = "ggx|phong|blinn|charlie",
       .help = "microfacet distribution; charlie is for cloth"},
      choiceField<&BakedSetSettings::distribution>},
     {BakedPart::specular, BakedPart::brdf, BakedPart::lobe_rows}},
    {{{.name = "mip-mapping",
       .choices = "auto|filament|linear|unreal|unity|frostbite|babylon|gltf",
       .help = "the roughness of each mip level, as this engine looks it up; auto goes by {option:for}: unreal, unity, "
               "babylon and gltf have their own, godot has that of frostbite, playcanvas the linear one, all others "
               "that of filament. With any but their own, {option:for} babylon and playcanvas get separate maps "
               "in place of their own file, and three with any that is named"},
      kMipMappingField},
     {BakedPart::specular}},
    {{{.name = "irradiance-size",
       .value = "N",
       .unit = "texels",
       .minimum = 1,
       .maximum = 1024,
       .help = "side of a face of the irradiance cube"},
      &BakedSetSettings::irradiance_size},
     {BakedPart::irradiance}},
    {{{.name = "sh-degree",
       .value = "L",
       .minimum = 2,
       .maximum = 4,
       .help = "highest band of the spherical harmonics"},
      &BakedSetSettings::harmonics_degree},
     {BakedPart::harmonics}},
    {{{.name = "brdf-size",
       .value = "N",
       .unit = "texels",
       .minimum = 2,
       .maximum = kLargestBrdfTable,
       .help = "side of the BRDF table"},
      &BakedSetSettings::brdf_size},
     {BakedPart::brdf}},
    {{{.name = "brdf-channels",
       .value = "N",
       .minimum = 2,
       .maximum = 3,
       .help = "number of channels in the BRDF table: 2 for scale and bias, 3 with the mean for multiple scattering; "
               "with 2, a .exr gets a third channel of zeros"},
      &BakedSetSettings::brdf_channels},
     {BakedPart::brdf}},
    {{{.name = "brdf-axes",
       .choices = "linear|warped",
       .help = "axes of the BRDF table: linear in n.v and perceptual roughness, as engines have it, or warped, so that "
               "look-ups near grazing angles are accurate too"},
      choiceField<&BakedSetSettings::brdf_axes>},
     {BakedPart::brdf}},
    {{{.name = "brdf-extension",
       .value = kBrdfExtensions,
       .help = "extension of the BRDF table's file; without it, that of {option:extension}, but .exr in place of .hdr",
       .names = bakedBrdfExtensions},
      &BakedSetSettings::brdf_extension},
     {BakedPart::brdf}},
    {{{.name = "lobe-rows",
       .choices = "0|2|4|6",
       .help = "number of look-ups in the chain that the table lobe_rows.ktx2 is for, with which rough reflections are "
               "right at every angle; 0: no such table. Other distributions than ggx have none"},
      kLobeRowsField},
     {BakedPart::lobe_rows}},
    {{{.name = "skybox", .help = "also write the environment itself, for the background; filament always gets it"},
      &BakedSetSettings::skybox},
     {BakedPart::skybox}},
    {{{.name = "skybox-size",
       .value = "N",
       .unit = "texels",
       .minimum = 0,
       .maximum = 8192,
       .help = "side of a face of the skybox; 0: as fine as the environment, but at most 1024"},
      &BakedSetSettings::skybox_size},
     {BakedPart::skybox}},
    {{{.name = "only",
       .value = "PART,…",
       .help = "make and write only these parts of the set: specular (the mip chain), irradiance, harmonics, brdf, "
               "lobe-rows, skybox; for a texture as the output one of its cubes: specular, irradiance or skybox",
       .names = partNames},
      kOnlyField},
     {}},
    {{{.name = "split",
       .help = "take small lamps, such as the sun, out of all maps and write them beside them as directional lights: "
               "lamps.glb, lamps.json and, {option:for} three, babylon, godot and blender, code"},
      &BakedSetSettings::split},
     kLightParts},
    {{{.name = "extension",
       .value = kCubeExtensions,
       .help = "extension of the files in a folder: textures, or pictures of each level and face (m0_px.exr); without "
               "it, ktx2, for unreal, unity and godot dds, for filament ktx and for openexr exr. babylon, playcanvas "
               "and gltf have files of their own",
       .names = bakedCubeExtensions},
      &BakedSetSettings::extension},
     kFileParts},
});

const std::vector<Option<BakedSetSettings>> kBakedSetOptions = [] {
  std::vector<Option<BakedSetSettings>> options;
  for (const PartOption& row : kPartOptions) options.push_back(row.option);
  return options;
}();

/// Options of other tables, of files and of light, with the parts that they describe.
struct OtherOption {
  std::string_view name;
  const std::vector<BakedPart>& parts;
};

const auto kOtherOptions = std::to_array<OtherOption>({{"as-seen", kCubeParts},
                                                       {"flip", kCubeParts},
                                                       {"face-order", kCubeParts},
                                                       {"format", kFileParts},
                                                       {"zstd", kTextureParts},
                                                       {"scale-light", kLightParts},
                                                       {"clamp-light", kLightParts},
                                                       {"rotate", kLightParts},
                                                       {"min-share", kLightParts},
                                                       {"max-size", kLightParts}});

}  // namespace

std::span<const std::string_view> bakedCubeExtensions() {
  static const std::vector<std::string_view> names = texturesAnd(writtenExtensionNames(Holds::light));
  return names;
}

std::span<const std::string_view> bakedBrdfExtensions() {
  // Of the formats of light .hdr is none for a table: its mantissas have 8 bits.
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> of_light = writtenExtensionNames(Holds::light);
    std::erase(of_light, "hdr");
    return texturesAnd(std::move(of_light));
  }();
  return names;
}

std::span<const Option<BakedSetSettings>> bakedSetOptions() { return kBakedSetOptions; }

std::span<const BakedPart> partsDescribedBy(std::string_view option) {
  const auto* const row = findBy(kPartOptions, option, [](const auto& one) { return one.option.text.name; });
  if (row != kPartOptions.end()) return row->parts;
  const auto* const other = findBy(kOtherOptions, option, &OtherOption::name);
  return other != kOtherOptions.end() ? std::span<const BakedPart>(other->parts) : std::span<const BakedPart>();
}

std::string writtenSetting(const BakedSetSettings& settings, std::string_view name) {
  const auto option = findBy(kBakedSetOptions, name, [](const auto& row) { return row.text.name; });
  return written(*option, settings);
}

}  // namespace mirrorball
