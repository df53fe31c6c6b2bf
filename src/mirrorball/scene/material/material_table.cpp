#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

constexpr ChoiceField<Material> kFresnelField{[](const Material& material) { return material.fresnel; },
                                              [](Material& material, int index) { material.fresnel = index; }};

/// A built-in surface is as deep and as dense as it looks best.
constexpr ChoiceField<Material> kHeightField{[](const Material& material) { return static_cast<int>(material.height); },
                                             [](Material& material, int index) {
                                               material.height = static_cast<HeightKind>(index);
                                               material.height_texture = -1;
                                               if (material.height == HeightKind::none) return;
                                               const HeightSize own = ownSize(material.height);
                                               material.height_scale = own.scale;
                                               material.height_frequency = own.frequency;
                                             }};

/// Its picture is loaded into a scene, by setParameter of set_parameter.h.
constexpr ParsedField<Material> kDerivativeField{
    [](const Material& material) { return std::string(material.slope_texture < 0 ? "none" : "a picture"); },
    [](const OptionText& text, std::string_view picture, Material& material) -> Result<void> {
      if (picture == "none") {
        material.slope_texture = -1;
        return {};
      }
      return fail(ErrorCode::usage,
                  "the material parameter " + std::string(text.name) + " needs a picture, and a model to put it on");
    }};

/// Parameters that had another name.
constexpr auto kFormerNames =
    std::to_array<Alias>({{"bump", "height"}, {"bump_height", "height_scale"}, {"bump_frequency", "height_frequency"}});

/// What other programs call parameters, which is suggested and not taken.
constexpr auto kOthersNames = std::to_array<Alias>({{"metalness", "metallic"},
                                                    {"albedo", "base_color"},
                                                    {"color", "base_color"},
                                                    {"colour", "base_color"},
                                                    {"diffuse", "base_color"},
                                                    {"diffuse_color", "base_color"},
                                                    {"rough", "perceptual_roughness"},
                                                    {"roughness", "perceptual_roughness"},
                                                    {"emissive", "emission"},
                                                    {"alpha", "opacity"},
                                                    {"transparency", "opacity"},
                                                    {"eta", "ior"},
                                                    {"coat", "clearcoat"},
                                                    {"sheen", "sheen_color"},
                                                    {"texture", "base_color_map"},
                                                    {"albedo_map", "base_color_map"},
                                                    {"metalness_map", "metallic_map"},
                                                    {"emissive_map", "emission_map"},
                                                    {"ao_map", "occlusion_map"},
                                                    {"bump_map", "height"},
                                                    {"displacement_map", "height"}});

const auto kParameters = std::to_array<MaterialParameter>({
    {{{.name = "base_color",
       .value = "R,G,B",
       .unit = "linear light",
       .minimum = 0,
       .maximum = 1,
       .help = "diffuse albedo, or a metal's reflectance at normal incidence (f0); one number sets all three channels",
       .is_color = true},
      &Material::base_color},
     "pbrMetallicRoughness.baseColorFactor"},
    {{{.name = "metallic", .minimum = 0, .maximum = 1, .help = "0 is a dielectric, 1 is a metal"}, &Material::metallic},
     "pbrMetallicRoughness.metallicFactor"},
    {{{.name = "perceptual_roughness",
       .minimum = 0,
       .maximum = 1,
       .help = "roughness: 0 is a mirror, 1 is chalk; its square is alpha of GGX"},
      &Material::perceptual_roughness},
     "pbrMetallicRoughness.roughnessFactor"},
    {{{.name = "specular",
       .minimum = 0,
       .maximum = 1,
       .help = "strength of a dielectric's reflection; 0 leaves only the diffuse part"},
      &Material::specular},
     "extensions.KHR_materials_specular.specularFactor"},
    {{{.name = "specular_color",
       .value = "R,G,B",
       .unit = "linear light",
       .minimum = 0,
       .maximum = 1e6,
       .help = "factor on a dielectric's reflection at normal incidence (f0), which ends at 1",
       .is_color = true},
      &Material::specular_color},
     "extensions.KHR_materials_specular.specularColorFactor"},
    {{{.name = "ior",
       .minimum = 0.1,
       .maximum = 10,
       .help = "index of refraction, inside relative to outside",
       .soft_minimum = 1,
       .soft_maximum = 3,
       .step = 0.01},
      &Material::ior},
     "extensions.KHR_materials_ior.ior"},
    {{{.name = "dispersion",
       .minimum = 0,
       .maximum = 5,
       .help = "how far refraction separates red and blue: 20 / Abbe number"},
      &Material::dispersion},
     "extensions.KHR_materials_dispersion.dispersion"},
    {{{.name = "transmission",
       .minimum = 0,
       .maximum = 1,
       .help = "share of the non-reflected light that is refracted through the surface"},
      &Material::transmission},
     "extensions.KHR_materials_transmission.transmissionFactor"},
    {{{.name = "attenuation_color",
       .value = "R,G,B",
       .unit = "linear light",
       .minimum = 0,
       .maximum = 1,
       .help = "what a transmitting body leaves of white light over attenuation_distance; where light is traced",
       .is_color = true},
      &Material::attenuation_color},
     "extensions.KHR_materials_volume.attenuationColor"},
    {{{.name = "attenuation_distance",
       .unit = "world units",
       .minimum = 0,
       .maximum = 1e15,
       .help = "distance in a transmitting body over which white light becomes attenuation_color; 0: it stays white"},
      &Material::attenuation_distance},
     "extensions.KHR_materials_volume.attenuationDistance"},
    {{{.name = "thin_walled",
       .help = "yes makes a transmitting surface a thin sheet: light goes straight on, and there is no body behind it"},
      &Material::thin_walled}},
    {{{.name = "priority",
       .value = "N",
       .minimum = -1000,
       .maximum = 1000,
       .help = "where transmitting bodies overlap, that of the greatest priority fills the place, and among equals the "
               "one that light entered last; where light is traced"},
      &Material::priority}},
    {{{.name = "conductor_n",
       .value = "R,G,B",
       .minimum = 0,
       .maximum = 20,
       .help = "real part of a metal's complex index of refraction, per channel"},
      &Material::conductor_n}},
    {{{.name = "conductor_k",
       .value = "R,G,B",
       .minimum = 0,
       .maximum = 20,
       .help = "imaginary part of a metal's complex index of refraction, per channel; 0,0,0 takes f0 from base_color "
               "instead"},
      &Material::conductor_k}},
    {{{.name = "emission",
       .value = "R,G,B",
       .unit = "radiance",
       .minimum = 0,
       .maximum = kBrightestEmission,
       .help = "radiance that the surface emits",
       .is_color = true},
      &Material::emission},
     "emissiveFactor"},
    {{{.name = "unlit", .help = "yes shows base_color as radiance: the surface answers to no light"},
      &Material::unlit}},
    {{{.name = "opacity",
       .minimum = 0,
       .maximum = 1,
       .help = "1 is solid; with less, what is behind the surface shines through without refraction"},
      &Material::opacity}},
    {{{.name = "fresnel",
       .choices = "exact|schlick|empirical|f82",
       .help = "Fresnel formula: how reflection grows towards grazing angles; metals take schlick for empirical"},
      kFresnelField}},
    {{{.name = "fresnel_offset",
       .minimum = 0,
       .maximum = 1,
       .help = "offset of the empirical Fresnel formula, offset + scale (1 + V·N)^power"},
      &Material::fresnel_offset}},
    {{{.name = "fresnel_scale", .minimum = 0, .maximum = 10, .help = "scale of the empirical Fresnel formula"},
      &Material::fresnel_scale}},
    {{{.name = "fresnel_power", .minimum = 0.1, .maximum = 20, .help = "power of the empirical Fresnel formula"},
      &Material::fresnel_power}},
    {{{.name = "f82_tint",
       .value = "R,G,B",
       .minimum = 0,
       .maximum = 1,
       .help = "share of schlick's reflectance that the Fresnel formula f82 leaves at an angle of 82°; 1: all of it"},
      &Material::f82_tint}},
    {{{.name = "clearcoat",
       .minimum = 0,
       .maximum = 1,
       .help = "share of the surface that a clear coat of index 1.5 covers, as on a car"},
      &Material::clearcoat},
     "extensions.KHR_materials_clearcoat.clearcoatFactor"},
    {{{.name = "clearcoat_roughness", .minimum = 0, .maximum = 1, .help = "roughness of the clear coat"},
      &Material::clearcoat_roughness},
     "extensions.KHR_materials_clearcoat.clearcoatRoughnessFactor"},
    {{{.name = "clearcoat_normal_scale",
       .minimum = -10,
       .maximum = 10,
       .help = "strength of the clear coat's normal map; a negative value turns bumps into dents"},
      &Material::clearcoat_normal_scale},
     "extensions.KHR_materials_clearcoat.clearcoatNormalTexture.scale"},
    {{{.name = "clearcoat_normal_zero",
       .minimum = 0,
       .maximum = 128,
       .help = "what stands for 0 in the clear coat's normal map, as normal_zero"},
      &Material::clearcoat_normal_zero}},
    {{{.name = "sheen_color",
       .value = "R,G,B",
       .unit = "linear light",
       .minimum = 0,
       .maximum = 1,
       .help = "reflectance of the fibres of a cloth such as velvet; 0: there are none",
       .is_color = true},
      &Material::sheen_color},
     "extensions.KHR_materials_sheen.sheenColorFactor"},
    {{{.name = "sheen_roughness",
       .minimum = 0,
       .maximum = 1,
       .help = "how far the fibres stand away from the surface's normal: less shows only at its rim"},
      &Material::sheen_roughness},
     "extensions.KHR_materials_sheen.sheenRoughnessFactor"},
    {{{.name = "anisotropy",
       .minimum = 0,
       .maximum = 1,
       .help = "how much rougher the surface is along its tangent than across it, as brushed metal is"},
      &Material::anisotropy},
     "extensions.KHR_materials_anisotropy.anisotropyStrength"},
    {{{.name = "anisotropy_rotation",
       .unit = "rad",
       .minimum = -1000,
       .maximum = 1000,
       .help = "angle from the tangent to the rougher direction, counter-clockwise"},
      &Material::anisotropy_rotation},
     "extensions.KHR_materials_anisotropy.anisotropyRotation"},
    {{{.name = "iridescence",
       .minimum = 0,
       .maximum = 1,
       .help = "share of the surface that a thin film covers, whose colours change with the angle as a soap bubble's"},
      &Material::iridescence},
     "extensions.KHR_materials_iridescence.iridescenceFactor"},
    {{{.name = "iridescence_ior", .minimum = 1, .maximum = 10, .help = "index of refraction of the thin film"},
      &Material::iridescence_ior},
     "extensions.KHR_materials_iridescence.iridescenceIor"},
    {{{.name = "iridescence_thickness_minimum",
       .unit = "nm",
       .minimum = 0,
       .maximum = 1e6,
       .help = "thickness of the thin film where its map is 0"},
      &Material::iridescence_thickness_minimum},
     "extensions.KHR_materials_iridescence.iridescenceThicknessMinimum"},
    {{{.name = "iridescence_thickness",
       .unit = "nm",
       .minimum = 0,
       .maximum = 1e6,
       .help = "thickness of the thin film, or where its map is 1"},
      &Material::iridescence_thickness},
     "extensions.KHR_materials_iridescence.iridescenceThicknessMaximum"},
    {{{.name = "height",
       .choices = "none|orange|brick|cobbles|weave|hammered|waves",
       .help = "heights of the surface, below the mesh, as {option:relief} shows them; or a picture of heights, a name "
               "with a "
               "dot or a folder; each brings its own height_scale and height_frequency, so set those after it"},
      kHeightField}},
    {{{.name = "height_scale",
       .unit = "model units",
       .minimum = -1e6,
       .maximum = 1e6,
       .help = "height of the bumps, from the deepest to the highest; below 0 they point inwards"},
      &Material::height_scale}},
    {{{.name = "height_frequency",
       .minimum = 0.01,
       .maximum = 1000,
       .help = "density of the bumps: tiles of the surface a unit of texture coordinate; of orange pits a model unit"},
      &Material::height_frequency}},
    {{{.name = "alpha_cutoff",
       .minimum = 0,
       .maximum = 1,
       .help = "opacity below which a surface with glTF's alpha mode MASK is cut away"},
      &Material::alpha_cutoff},
     "alphaCutoff"},
    {{{.name = "normal_scale",
       .minimum = -10,
       .maximum = 10,
       .help = "strength of the normal map; a negative value turns bumps into dents"},
      &Material::normal_scale},
     "normalTexture.scale"},
    {{{.name = "normal_zero",
       .minimum = 0,
       .maximum = 128,
       .help = "what stands for 0 in the normal map, of a greatest code of 255: 127.5 by glTF's rule; 128, which is "
               "found where the most frequent texel is (128, 128, 255); 0, which is found where floats are signed. Set "
               "it after the map"},
      &Material::normal_zero}},
    {{{.name = "normal_space",
       .choices = "tangent|object",
       .help = "what normal_map's normals are told in: the directions of the texture on the surface, or the mesh's own "
               "axes, with which it may not bend or repeat; heights and slopes do not show under the latter"},
      choiceField<&Material::normal_space>}},
    {{{.name = "derivative_map",
       .value = "none|FILE",
       .help = "picture of slopes (∂d/∂u, 0, ∂d/∂v) along the surface, as `surface --to derivative` makes it: signed "
               "floats, or integers that stand for ½ + ½ slope; needs no tangents, and shows where heights do not"},
      kDerivativeField}},
    {{{.name = "derivative_scale",
       .minimum = -10,
       .maximum = 10,
       .help = "strength of the derivative map; a negative value turns bumps into dents"},
      &Material::derivative_scale}},
    {{{.name = "occlusion_strength", .minimum = 0, .maximum = 1, .help = "strength of the occlusion map"},
      &Material::occlusion_strength},
     "occlusionTexture.strength"},
    {{{.name = "double_sided", .help = "yes also shows the back of the surface"}, &Material::double_sided},
     "doubleSided"},
});

constexpr auto kMaps = std::to_array<MaterialMap>({
    {"base_color_map", &Material::base_color_map, true, "pbrMetallicRoughness.baseColorTexture",
     "colour picture that multiplies base_color; its alpha multiplies opacity. `stripes` is a built-in one"},
    {"metallic_map", &Material::metallic_map, false, "pbrMetallicRoughness.metallicRoughnessTexture",
     "picture whose blue channel multiplies metallic"},
    {"roughness_map", &Material::roughness_map, false, "pbrMetallicRoughness.metallicRoughnessTexture",
     "picture whose green channel multiplies perceptual_roughness"},
    {"normal_map", &Material::normal_map, false, "normalTexture",
     "picture of normals n, stored as ½ + ½ n, with green up (as in OpenGL); see normal_space and normal_zero",
     glm::vec4(1.0f), &Material::normal_zero},
    {"occlusion_map", &Material::occlusion_map, false, "occlusionTexture",
     "picture whose red channel is the share of the environment that a point sees"},
    {"emission_map", &Material::emission_map, true, "emissiveTexture", "colour picture that multiplies emission"},
    {"specular_map", &Material::specular_map, false, "extensions.KHR_materials_specular.specularTexture",
     "picture whose alpha channel multiplies specular"},
    {"specular_color_map", &Material::specular_color_map, true,
     "extensions.KHR_materials_specular.specularColorTexture", "colour picture that multiplies specular_color"},
    {"transmission_map", &Material::transmission_map, false,
     "extensions.KHR_materials_transmission.transmissionTexture", "picture whose red channel multiplies transmission"},
    {"clearcoat_map", &Material::clearcoat_map, false, "extensions.KHR_materials_clearcoat.clearcoatTexture",
     "picture whose red channel multiplies clearcoat"},
    {"clearcoat_roughness_map", &Material::clearcoat_roughness_map, false,
     "extensions.KHR_materials_clearcoat.clearcoatRoughnessTexture",
     "picture whose green channel multiplies clearcoat_roughness"},
    {"clearcoat_normal_map", &Material::clearcoat_normal_map, false,
     "extensions.KHR_materials_clearcoat.clearcoatNormalTexture",
     "picture of the clear coat's normals, as normal_map; without it the coat is smooth over all bumps",
     glm::vec4(1.0f), &Material::clearcoat_normal_zero},
    {"sheen_color_map", &Material::sheen_color_map, true, "extensions.KHR_materials_sheen.sheenColorTexture",
     "colour picture that multiplies sheen_color"},
    {"sheen_roughness_map", &Material::sheen_roughness_map, false,
     "extensions.KHR_materials_sheen.sheenRoughnessTexture", "picture whose alpha channel multiplies sheen_roughness"},
    {"anisotropy_map", &Material::anisotropy_map, false, "extensions.KHR_materials_anisotropy.anisotropyTexture",
     "picture whose red and green channel are the rougher direction d, stored as ½ + ½ d, and whose blue channel "
     "multiplies anisotropy",
     kAbsentAnisotropyMap},
    {"iridescence_map", &Material::iridescence_map, false, "extensions.KHR_materials_iridescence.iridescenceTexture",
     "picture whose red channel multiplies iridescence"},
    {"iridescence_thickness_map", &Material::iridescence_thickness_map, false,
     "extensions.KHR_materials_iridescence.iridescenceThicknessTexture",
     "picture whose green channel is 0 for iridescence_thickness_minimum, 1 for iridescence_thickness"},
});

}  // namespace

std::span<const MaterialParameter> materialParameters() { return kParameters; }

std::span<const MaterialMap> materialMaps() { return kMaps; }

std::size_t gltfNumbers(const MaterialParameter& parameter) {
  const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field);
  if (color == nullptr) return 1;
  return *color == &Material::base_color ? 4 : 3;
}

void setGltfNumbers(const MaterialParameter& parameter, std::span<const double> numbers, Material& material) {
  const auto inRange = [&](double number) {
    return static_cast<float>(std::clamp(number, parameter.text.minimum, parameter.text.maximum));
  };
  if (const auto* number = std::get_if<float Material::*>(&parameter.field)) {
    material.** number = inRange(numbers[0]);
  } else if (const auto* flag = std::get_if<bool Material::*>(&parameter.field)) {
    material.** flag = numbers[0] != 0.0;
  } else if (const auto* color = std::get_if<glm::vec3 Material::*>(&parameter.field)) {
    material.** color = {inRange(numbers[0]), inRange(numbers[1]), inRange(numbers[2])};
    if (numbers.size() == 4 && material.alpha_mode != AlphaMode::opaque)
      material.opacity = static_cast<float>(std::clamp(numbers[3], 0.0, 1.0));
  }
}

Result<void> setParameter(Material& material, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view key = assignment.substr(0, equals);
  std::vector<std::string_view> names;
  for (const auto& parameter : kParameters) names.push_back(parameter.text.name);
  for (const MaterialMap& map : kMaps) names.push_back(map.name);
  const auto index = indexOfName(key, names, kFormerNames);
  if (!index || *index >= kParameters.size()) {
    if (const auto meant = indexOfName(key, names, kOthersNames))
      return tl::unexpected<Error>(unknownName("material parameter", key, names, std::optional(names[*meant])));
    return tl::unexpected<Error>(unknownName("material parameter", key, names));
  }
  const MaterialParameter& parameter = kParameters[*index];
  const std::string name(parameter.text.name);
  if (equals == std::string_view::npos)
    return fail(ErrorCode::usage,
                "the material parameter " + name + " needs a value: " + name + "=" + written(parameter, material));
  MIRRORBALL_TRY_VOID(assign(parameter, material, assignment.substr(equals + 1)));
  // A measured substance of another index or dispersion is another substance, of which only these numbers are known.
  if (name == "ior" || name == "dispersion") material.sellmeier_b = material.sellmeier_c = glm::vec4(0.0f);
  // Who asks for an opacity wants to look through.
  if (material.opacity < 1.0f && material.alpha_mode == AlphaMode::opaque) material.alpha_mode = AlphaMode::blend;
  return {};
}

}  // namespace mirrorball
