#include <array>
#include <string>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball {
namespace {

constexpr ChoiceField<Material> kFresnelField{[](const Material& material) { return material.fresnel; },
                                              [](Material& material, int index) { material.fresnel = index; }};

const std::array<MaterialParameter, 22> kParameters{{
    {{{.name = "base_color",
       .value = "R,G,B",
       .unit = "linear light",
       .minimum = 0,
       .maximum = 1,
       .help = "diffuse albedo, or a metal's reflectance head-on; one number sets all three channels"},
      &Material::base_color},
     "pbrMetallicRoughness.baseColorFactor"},
    {{{.name = "metallic", .minimum = 0, .maximum = 1, .help = "0 dielectric, 1 metal"}, &Material::metallic},
     "pbrMetallicRoughness.metallicFactor"},
    {{{.name = "perceptual_roughness",
       .minimum = 0,
       .maximum = 1,
       .help = "0 mirror, 1 chalk; its square is GGX's alpha"},
      &Material::perceptual_roughness},
     "pbrMetallicRoughness.roughnessFactor"},
    {{{.name = "specular",
       .minimum = 0,
       .maximum = 1,
       .help = "strength of a dielectric's reflection; 0 leaves pure diffuse"},
      &Material::specular},
     "extensions.KHR_materials_specular.specularFactor"},
    {{{.name = "ior", .minimum = 0.1, .maximum = 10, .help = "index of refraction, inside over outside"},
      &Material::ior},
     "extensions.KHR_materials_ior.ior"},
    {{{.name = "dispersion", .minimum = 0, .maximum = 5, .help = "20 over Abbe's number: how far red and blue part"},
      &Material::dispersion},
     "extensions.KHR_materials_dispersion.dispersion"},
    {{{.name = "transmission",
       .minimum = 0,
       .maximum = 1,
       .help = "share of the light not reflected that is refracted through"},
      &Material::transmission},
     "extensions.KHR_materials_transmission.transmissionFactor"},
    {{{.name = "conductor_n",
       .value = "R,G,B",
       .minimum = 0,
       .maximum = 20,
       .help = "real part of a metal's complex index, per channel"},
      &Material::conductor_n}},
    {{{.name = "conductor_k",
       .value = "R,G,B",
       .minimum = 0,
       .maximum = 20,
       .help = "imaginary part; 0,0,0 takes the metal's reflectance from base_color"},
      &Material::conductor_k}},
    {{{.name = "emission",
       .value = "R,G,B",
       .unit = "radiance",
       .minimum = 0,
       .maximum = 1e6,
       .help = "light that the surface gives off itself"},
      &Material::emission},
     "emissiveFactor"},
    {{{.name = "opacity", .minimum = 0, .maximum = 1, .help = "1 solid; less lets what is behind shine through unbent"},
      &Material::opacity}},
    {{{.name = "fresnel",
       .choices = "exact|schlick|empirical",
       .help = "how reflection grows towards grazing angles; metals know exact and Schlick's form only"},
      kFresnelField}},
    {{{.name = "fresnel_offset",
       .minimum = 0,
       .maximum = 1,
       .help = "of the empirical form offset + scale (1 + V·N)^power"},
      &Material::fresnel_offset}},
    {{{.name = "fresnel_scale", .minimum = 0, .maximum = 10, .help = "of the empirical form"},
      &Material::fresnel_scale}},
    {{{.name = "fresnel_power", .minimum = 0.1, .maximum = 20, .help = "of the empirical form"},
      &Material::fresnel_power}},
    {{{.name = "bump", .choices = "none|orange", .help = "height function that bends the normals"},
      choiceField<&Material::bump>}},
    {{{.name = "bump_height", .unit = "model units", .minimum = -1, .maximum = 1, .help = "depth of the bumps"},
      &Material::bump_height}},
    {{{.name = "bump_frequency",
       .unit = "bumps a model unit",
       .minimum = 0.01,
       .maximum = 1000,
       .help = "how close they stand"},
      &Material::bump_frequency}},
    {{{.name = "alpha_cutoff",
       .minimum = 0,
       .maximum = 1,
       .help = "opacity below which a model's surface with alpha mode MASK is cut away"},
      &Material::alpha_cutoff},
     "alphaCutoff"},
    {{{.name = "normal_scale",
       .minimum = -10,
       .maximum = 10,
       .help = "strength of a normal map; negative turns its bumps to dents"},
      &Material::normal_scale},
     "normalTexture.scale"},
    {{{.name = "occlusion_strength", .minimum = 0, .maximum = 1, .help = "strength of an occlusion map"},
      &Material::occlusion_strength},
     "occlusionTexture.strength"},
    {{{.name = "double_sided", .help = "yes shows the back of the surface too"}, &Material::double_sided},
     "doubleSided"},
}};

constexpr std::array<MaterialMap, 6> kMaps{{
    {"base_color_map", &Material::base_color_map, true, "pbrMetallicRoughness.baseColorTexture",
     "colour picture that multiplies base_color, its alpha the opacity"},
    {"metallic_map", &Material::metallic_map, false, "pbrMetallicRoughness.metallicRoughnessTexture",
     "picture whose blue channel multiplies metallic"},
    {"roughness_map", &Material::roughness_map, false, "pbrMetallicRoughness.metallicRoughnessTexture",
     "picture whose green channel multiplies perceptual_roughness"},
    {"normal_map", &Material::normal_map, false, "normalTexture",
     "tangent-space normals as ½ + ½ n, green upwards (OpenGL's)"},
    {"occlusion_map", &Material::occlusion_map, false, "occlusionTexture",
     "picture whose red channel is how much of the environment a place sees"},
    {"emission_map", &Material::emission_map, true, "emissiveTexture", "colour picture that multiplies emission"},
}};

}  // namespace

std::span<const MaterialParameter> materialParameters() { return kParameters; }

std::span<const MaterialMap> materialMaps() { return kMaps; }

Result<void> setParameter(Material& material, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view key = assignment.substr(0, equals);
  std::vector<std::string_view> names;
  for (const auto& parameter : kParameters) names.push_back(parameter.text.name);
  for (const MaterialMap& map : kMaps) names.push_back(map.name);
  const auto index = indexOfName(key, names);
  if (!index || *index >= kParameters.size())
    return tl::unexpected<Error>(unknownName("material parameter", key, names));
  const MaterialParameter& parameter = kParameters[*index];
  const std::string name(parameter.text.name);
  if (equals == std::string_view::npos)
    return fail(ErrorCode::usage,
                "the material parameter " + name + " needs a value: " + name + "=" + written(parameter, material));
  MIRRORBALL_TRY_VOID(assign(parameter, material, assignment.substr(equals + 1)));
  // Who asks for an opacity wants to look through.
  if (material.opacity < 1.0f && material.alpha_mode == AlphaMode::opaque) material.alpha_mode = AlphaMode::blend;
  return {};
}

}  // namespace mirrorball
