#include "mirrorball/render/frame/render_options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "formula/color.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/scene/material/set_parameter.h"

namespace mirrorball {
namespace {

constexpr int kMaxLights = 8;
constexpr int kLongestSide = 16384;

const std::string kMaterialHelp = "gives every surface this material: " + join(materialNames(), " ");

const std::array<Option<RenderOptions>, 21> kOptions{{
    {{.name = "size", .value = "WxH", .unit = "pixels", .help = "size of the picture", .group = "Picture"},
     &RenderOptions::size},
    {{.name = "samples",
      .value = "N",
      .minimum = 1,
      .maximum = 4096,
      .help = "samples of each pixel, evenly spread over its area",
      .group = "Picture"},
     &RenderOptions::samples},
    {{.name = "resolve",
      .choices = "display|radiance",
      .help =
          "what is averaged over the samples: the light that a display shows of each, so that outlines of what is far "
          "brighter than white are smooth, or radiance, which is then tone mapped; .exr and .hdr hold radiance",
      .group = "Picture"},
     choiceField<&RenderOptions::resolve>},
    {{.name = "frames",
      .value = "N",
      .minimum = 0,
      .maximum = 100000,
      .help =
          "a turntable of N numbered pictures, once round; %04d or #### in the output's name stands for the number, "
          "else it comes at the end",
      .group = "Picture"},
     &RenderOptions::frames},
    {{.name = "turn",
      .choices = "camera|model|environment",
      .help =
          "what goes round in a turntable, +Z towards +X; a turning model has its lights and background stand still",
      .group = "Picture"},
     choiceField<&RenderOptions::turn>},
    {exposureText(), &RenderOptions::exposure_ev},
    {toneMapText(), choiceField<&RenderOptions::tone_map>},
    {{.name = "background",
      .value = "env|blur|COLOR|transparent",
      .help = "what is behind the model; COLOR is #rrggbb, which the picture shows as it is (a map or a picture of "
              "radiance holds its linear light), or R,G,B, radiance that is exposed and tone mapped",
      .group = "Picture"},
     &RenderOptions::background},

    {{.name = "camera",
      .value = "AZIMUTH,ELEVATION[,DISTANCE]",
      .unit = "degrees and model radii",
      .min_count = 2,
      .max_count = 3,
      .help = "azimuth 0 stands on +Z and looks along -Z, 90 on +X; elevation 90 on +Y; without a distance the model "
              "fills the picture and is in its middle",
      .group = "Camera"},
     &RenderOptions::camera},
    {{.name = "target",
      .value = "X,Y,Z",
      .unit = "world units",
      .min_count = 3,
      .max_count = 3,
      .help = "the point that the camera looks at; without it the model's centre, or the middle of what is seen of it",
      .group = "Camera"},
     &RenderOptions::target},
    {{.name = "fov",
      .value = "DEG",
      .unit = "degrees",
      .minimum = 1,
      .maximum = 170,
      .help = "vertical angle of view",
      .group = "Camera"},
     &RenderOptions::fov_deg},
    {{.name = "orthographic",
      .value = "HEIGHT",
      .unit = "model radii",
      .minimum = 0,
      .maximum = 1e4,
      .help = "parallel projection of that height; 2 inscribes a sphere; 0: the model fills the picture",
      .implied = "0",
      .group = "Camera"},
     &RenderOptions::orthographic},

    {{.name = "env-rotation",
      .value = "YAW[,PITCH[,ROLL]]",
      .unit = "degrees",
      .max_count = 3,
      .help = "turns the environment about +Z by ROLL, then about +X by PITCH, then about +Y by YAW, +Z towards +X",
      .group = "Environment",
      .also = "rotate"},
     &RenderOptions::env_rotation_deg},
    {{.name = "env-intensity",
      .value = "FACTOR",
      .minimum = 0,
      .maximum = 1e6,
      .help = "strength of its light",
      .group = "Environment"},
     &RenderOptions::env_intensity},
    {{.name = "blur",
      .choices = "exact|gpu|mip|cone",
      .help = "how rough surfaces blur the environment: prefiltered exactly, prefiltered on the GPU in a few "
              "milliseconds, by a "
              "coarser mip level, or by the mean of 64 rays in a cone",
      .group = "Look"},
     choiceField<&RenderOptions::blur>},
    {{.name = "mapping",
      .choices = "reflection|normal|sphere",
      .help = "what looks the map up: the reflected ray, the surface normal, or the normal as texture coordinates of a "
              "sphere map, which is always sharp",
      .group = "Environment"},
     choiceField<&RenderOptions::mapping>},
    {{.name = "reflect-at",
      .choices = "vertex|fragment|triangle",
      .help = "where the ray is reflected: at vertices, the result interpolated, at each fragment, or once a triangle, "
              "as a mirror made of tiles",
      .group = "Environment"},
     choiceField<&RenderOptions::reflect_at>},
    {{.name = "light",
      .value = "X,Y,Z,R,G,B",
      .unit = "world units and radiance",
      .help = "a point light after Phong; may be repeated",
      .group = "Environment"},
     &RenderOptions::lights},

    {{.name = "material", .value = "NAME", .help = kMaterialHelp, .group = "Material", .names = materialNames},
     &RenderOptions::material},
    {{.name = "set",
      .value = "KEY=VALUE",
      .help = "sets one parameter of every material; may be repeated. `mirrorball reference` lists the parameters",
      .group = "Material"},
     &RenderOptions::set},
    {{.name = "fresnel",
      .choices = "material|exact|schlick|empirical",
      .help = "form of Fresnel's law for every material; empirical is offset + scale (1 + V·N)^power",
      .group = "Material"},
     choiceField<&RenderOptions::fresnel>},
}};

tl::unexpected<Error> misused(std::string_view option, std::string_view wants, std::string_view given) {
  return fail(ErrorCode::usage, "--" + std::string(option) + " takes " + std::string(wants) + "; it was given '" +
                                    std::string(given) + "'");
}

Result<glm::ivec2> parseSize(const std::string& text) {
  const auto sides = split(text, text.find('X') == std::string::npos ? 'x' : 'X');
  std::array<int, 2> size{};
  for (std::size_t side = 0; side < sides.size() && side < 2; ++side) {
    const auto number = parseNumber(sides[side]);
    if (number && *number == std::floor(*number) && *number >= 1 && *number <= kLongestSide)
      size[side] = static_cast<int>(*number);
  }
  if (sides.size() != 2 || size[0] == 0 || size[1] == 0)
    return misused("size", "WIDTHxHEIGHT in pixels (1 … " + std::to_string(kLongestSide) + ")", text);
  return glm::ivec2(size[0], size[1]);
}

/// "#rrggbb" as linear light.
std::optional<glm::vec3> parseHexColor(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned bits = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, bits, 16);
  if (error != std::errc{} || end != text.data() + 7) return std::nullopt;
  const glm::vec3 encoded((bits >> 16) & 255u, (bits >> 8) & 255u, bits & 255u);
  return formula::linearFromSrgb(encoded / 255.0f);
}

/// "336699", which is a number too.
bool lacksHash(const std::string& text) {
  return text.size() == 6 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

Result<void> parseBackground(const std::string& text, FrameSettings& settings) {
  if (lacksHash(text))
    return fail(ErrorCode::usage, "--background " + text + ": a colour begins with #, in quotes: '#" + text + "'");
  constexpr std::array<std::string_view, 3> kNames{"env", "blur", "transparent"};
  constexpr std::array<BackgroundKind, 3> kKinds{BackgroundKind::environment, BackgroundKind::blur,
                                                 BackgroundKind::transparent};
  if (const auto index = indexOfName(text, kNames)) {
    settings.background = kKinds[*index];
    return {};
  }
  settings.background = BackgroundKind::radiance;
  if (const auto color = parseHexColor(text)) {
    settings.background = BackgroundKind::display_color;
    settings.background_color = *color;
    return {};
  }
  constexpr OptionText kRadiance{.name = "--background", .minimum = 0, .maximum = 1e6};
  if (const auto numbers = parseVector(kRadiance, text)) {
    settings.background_color = *numbers;
    return {};
  }
  const auto meant = nearestWord(text, kNames);
  return fail(ErrorCode::usage, "--background takes " + join(kNames) + ", #rrggbb or R,G,B (" + rangeText(kRadiance) +
                                    "); it was given '" + text + "'" +
                                    (meant ? "; did you mean '" + std::string(*meant) + "'?" : ""));
}

Result<PointLight> parseLight(const std::string& text) {
  constexpr OptionText kLight{.name = "--light", .unit = "world units and radiance", .min_count = 6, .max_count = 6};
  MIRRORBALL_TRY(numbers, parseNumbers(kLight, text));
  return PointLight{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

CameraOptions cameraOptions(const RenderOptions& options) {
  CameraOptions camera;
  camera.azimuth_deg = options.camera[0];
  camera.elevation_deg = options.camera[1];
  if (options.camera.size() > 2) camera.distance = options.camera[2];
  if (!options.target.empty()) camera.target = glm::vec3(options.target[0], options.target[1], options.target[2]);
  camera.fov_deg = options.fov_deg;
  if (!options.orthographic.empty()) camera.orthographic_height = options.orthographic[0];
  return camera;
}

/// One material for every surface.
void replaceMaterials(Scene& scene, const Material& material) {
  scene.materials = {material};
  for (Mesh& mesh : scene.meshes) {
    mesh.material = 0;
    for (Vertex& vertex : mesh.vertices) vertex.color = glm::vec4(1.0f);
  }
}

}  // namespace

std::span<const Option<RenderOptions>> renderOptions() { return kOptions; }

Result<FrameSettings> frameSettings(const RenderOptions& options) {
  FrameSettings settings;
  MIRRORBALL_TRY(size, parseSize(options.size));
  settings.size = size;
  settings.camera = cameraOptions(options);
  if (settings.camera.elevation_deg < -90.0f || settings.camera.elevation_deg > 90.0f)
    return misused("camera", "an elevation from -90 to 90 degrees", formatNumber(settings.camera.elevation_deg));
  if (settings.camera.distance && *settings.camera.distance <= 0.0f)
    return misused("camera", "a distance above 0, in model radii", formatNumber(*settings.camera.distance));
  settings.display = {options.exposure_ev, options.tone_map};
  const std::vector<float>& turn_deg = options.env_rotation_deg;
  settings.env_rotation_rad = glm::radians(turn_deg[0]);
  settings.env_tilt = turnedBy(0.0f, turn_deg.size() > 1 ? glm::radians(turn_deg[1]) : 0.0f,
                               turn_deg.size() > 2 ? glm::radians(turn_deg[2]) : 0.0f);
  settings.env_intensity = options.env_intensity;
  MIRRORBALL_TRY_VOID(parseBackground(options.background, settings));
  settings.samples = options.samples;
  settings.resolve = options.resolve;
  settings.blur = options.blur;
  settings.mapping = options.mapping;
  settings.reflect_at = options.reflect_at;
  for (const std::string& text : options.lights) {
    MIRRORBALL_TRY(light, parseLight(text));
    settings.lights.push_back(light);
  }
  if (settings.lights.size() > kMaxLights)
    return fail(ErrorCode::usage, "--light may be given " + std::to_string(kMaxLights) + " times at most");
  return settings;
}

Result<void> applyMaterialOptions(const RenderOptions& options, Scene& scene) {
  if (!options.material.empty()) {
    MIRRORBALL_TRY(material, materialNamed(options.material));
    replaceMaterials(scene, material);
  }
  if (scene.materials.empty()) scene.materials.emplace_back();
  if (options.fresnel != FresnelOverride::material)
    for (Material& material : scene.materials) material.fresnel = static_cast<int>(options.fresnel) - 1;
  for (const std::string& assignment : options.set) MIRRORBALL_TRY_VOID(setParameter(scene, assignment));
  return {};
}

}  // namespace mirrorball
