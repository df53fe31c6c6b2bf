#include "mirrorball/scene/material.h"

#include <algorithm>
#include <array>
#include <vector>

#include "formula/bsdf.h"
#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

const std::array<Option<Material>, 21> kParameters{{
    {{.name = "base_color",
      .value = "R,G,B",
      .unit = "linear light",
      .minimum = 0,
      .maximum = 1,
      .help = "diffuse albedo, or a metal's reflectance head-on; one number sets all three channels"},
     &Material::base_color},
    {{.name = "metallic", .minimum = 0, .maximum = 1, .help = "0 dielectric, 1 metal"}, &Material::metallic},
    {{.name = "perceptual_roughness",
      .minimum = 0,
      .maximum = 1,
      .help = "0 mirror, 1 chalk; its square is GGX's alpha"},
     &Material::perceptual_roughness},
    {{.name = "specular",
      .minimum = 0,
      .maximum = 1,
      .help = "strength of a dielectric's reflection; 0 leaves pure diffuse"},
     &Material::specular},
    {{.name = "ior", .minimum = 0.1, .maximum = 10, .help = "index of refraction, inside over outside"},
     &Material::ior},
    {{.name = "dispersion", .minimum = 0, .maximum = 5, .help = "20 over Abbe's number: how far red and blue part"},
     &Material::dispersion},
    {{.name = "transmission",
      .minimum = 0,
      .maximum = 1,
      .help = "share of the light not reflected that is refracted through"},
     &Material::transmission},
    {{.name = "conductor_n",
      .value = "R,G,B",
      .minimum = 0,
      .maximum = 20,
      .help = "real part of a metal's complex index, per channel"},
     &Material::conductor_n},
    {{.name = "conductor_k",
      .value = "R,G,B",
      .minimum = 0,
      .maximum = 20,
      .help = "imaginary part; 0,0,0 takes the metal's reflectance from base_color"},
     &Material::conductor_k},
    {{.name = "emission",
      .value = "R,G,B",
      .unit = "radiance",
      .minimum = 0,
      .maximum = 1e6,
      .help = "light that the surface gives off itself"},
     &Material::emission},
    {{.name = "opacity", .minimum = 0, .maximum = 1, .help = "1 solid; less lets what is behind shine through unbent"},
     &Material::opacity},
    {{.name = "fresnel",
      .choices = "exact|schlick|empirical",
      .help = "how reflection grows towards grazing angles; metals know exact and Schlick's form only"},
     choiceField<&Material::fresnel>},
    {{.name = "fresnel_offset",
      .minimum = 0,
      .maximum = 1,
      .help = "of the empirical form offset + scale (1 + V·N)^power"},
     &Material::fresnel_offset},
    {{.name = "fresnel_scale", .minimum = 0, .maximum = 10, .help = "of the empirical form"}, &Material::fresnel_scale},
    {{.name = "fresnel_power", .minimum = 0.1, .maximum = 20, .help = "of the empirical form"},
     &Material::fresnel_power},
    {{.name = "bump", .choices = "none|orange", .help = "height function that bends the normals"},
     choiceField<&Material::bump>},
    {{.name = "bump_height", .unit = "model units", .minimum = -1, .maximum = 1, .help = "depth of the bumps"},
     &Material::bump_height},
    {{.name = "bump_frequency",
      .unit = "bumps a model unit",
      .minimum = 0.01,
      .maximum = 1000,
      .help = "how close they stand"},
     &Material::bump_frequency},
    {{.name = "normal_scale", .minimum = 0, .maximum = 10, .help = "strength of a normal map"},
     &Material::normal_scale},
    {{.name = "occlusion_strength", .minimum = 0, .maximum = 1, .help = "strength of an occlusion map"},
     &Material::occlusion_strength},
    {{.name = "double_sided", .help = "yes shows the back of the surface too"}, &Material::double_sided},
}};

Material metal(glm::vec3 color, float perceptual_roughness) {
  Material material;
  material.base_color = color;
  material.metallic = 1.0f;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

/// A metal by its complex index at 650, 550 and 450 nm; its base colour is for the other forms of Fresnel's law.
Material conductor(glm::vec3 n, glm::vec3 k) {
  Material material = metal(formula::fresnelConductor(1.0f, n, k), 0.0f);
  material.conductor_n = n;
  material.conductor_k = k;
  return material;
}

Material clear(float ior, float abbe_number) {
  Material material;
  material.base_color = glm::vec3(1.0f);
  material.perceptual_roughness = 0.0f;
  material.ior = ior;
  material.dispersion = 20.0f / abbe_number;
  material.transmission = 1.0f;
  return material;
}

Material coloured(glm::vec3 color, float perceptual_roughness) {
  Material material;
  material.base_color = color;
  material.perceptual_roughness = perceptual_roughness;
  return material;
}

Material orange() {
  Material material = coloured({0.90f, 0.33f, 0.02f}, 0.32f);
  material.bump = BumpHeight::orange;
  material.bump_height = 0.008f;
  material.bump_frequency = 20.0f;
  return material;
}

/// A material of the list, made when it is asked for.
struct NamedMaterial {
  std::string_view name;
  Material (*make)();
};

// Gold and chromium: Johnson & Christy 1972 and 1974. Glass BK7, water and diamond: index at 588 nm and Abbe's number
// from the usual tables (Schott's catalogue; Hale & Querry 1973; Peter 1923).
constexpr std::array<NamedMaterial, 9> kMaterials{{
    {"mirror", [] { return metal(glm::vec3(1.0f), 0.0f); }},
    {"chrome",
     [] {
       return conductor({3.107f, 3.181f, 2.323f}, {3.331f, 3.329f, 3.135f});
     }},
    {"gold",
     [] {
       return conductor({0.156f, 0.424f, 1.383f}, {3.602f, 2.472f, 1.916f});
     }},
    {"glass", [] { return clear(1.517f, 64.2f); }},
    {"water", [] { return clear(1.333f, 55.8f); }},
    {"diamond", [] { return clear(2.417f, 55.3f); }},
    {"rough-metal",
     [] {
       return metal({0.56f, 0.57f, 0.58f}, 0.45f);
     }},
    {"plastic",
     [] {
       return coloured({0.70f, 0.03f, 0.03f}, 0.15f);
     }},
    {"orange", orange},
}};

constexpr std::array<Alias, 2> kAliases{{{"chromium", "chrome"}, {"mirror-ball", "mirror"}}};

constexpr auto kNames = [] {
  std::array<std::string_view, kMaterials.size()> names;
  for (std::size_t index = 0; index < names.size(); ++index) names[index] = kMaterials[index].name;
  return names;
}();

}  // namespace

std::span<const Option<Material>> materialParameters() { return kParameters; }

std::span<const std::string_view> materialNames() { return kNames; }

Result<Material> materialNamed(std::string_view name) {
  const auto index = indexOfName(name, kNames, kAliases);
  if (!index) return tl::unexpected<Error>(unknownName("material", name, kNames));
  Material material = kMaterials[*index].make();
  material.name = kNames[*index];
  return material;
}

Result<void> setParameter(Material& material, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view key = assignment.substr(0, equals);
  std::vector<std::string_view> names;
  for (const auto& parameter : kParameters) names.push_back(parameter.text.name);
  const auto index = indexOfName(key, names);
  if (!index) return tl::unexpected<Error>(unknownName("material parameter", key, names));
  const Option<Material>& parameter = kParameters[*index];
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
