#include "mirrorball/environment/builtin.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/constants.h"
#include "formula/sky.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/uv_environment.h"

namespace mirrorball {
namespace {

constexpr std::array<std::string_view, 4> kNames{"studio", "sky", "uv", "white"};

const std::array<Option<SkyParameters>, 4> kSkyParameters{{
    {{.name = "elevation", .unit = "degrees", .minimum = 0, .maximum = 90, .help = "height of the sun"},
     &SkyParameters::elevation_deg},
    {{.name = "azimuth", .unit = "degrees", .help = "where the sun stands: 0 over +Z, 90 over +X"},
     &SkyParameters::azimuth_deg},
    {{.name = "turbidity", .minimum = 2, .maximum = 10, .help = "haze: 2 very clear, 10 hazy"},
     &SkyParameters::turbidity},
    {{.name = "sun", .minimum = 0, .maximum = 10, .help = "strength of the sun's disc; 0 leaves the sky alone"},
     &SkyParameters::sun},
}};

/// A rectangular lamp on a far sphere, facing the origin.
struct SoftBox {
  glm::vec3 direction;
  glm::vec2 half_extent;  ///< tangents of the half angles, across and up
  glm::vec3 radiance;
};

/// How much of a box's light is seen along d: 1 inside, falling to 0 across a soft edge.
float coverage(const SoftBox& box, glm::vec3 d) {
  const glm::vec3 forward = glm::normalize(box.direction);
  const float depth = glm::dot(d, forward);
  if (depth <= 0.0f) return 0.0f;
  const glm::vec3 up_hint = std::abs(forward.y) > 0.95f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(up_hint, forward));
  const glm::vec3 up = glm::cross(forward, right);
  const glm::vec2 beyond = glm::abs(glm::vec2(glm::dot(d, right), glm::dot(d, up)) / depth) - box.half_extent;
  const float edge = 0.04f;
  return (1.0f - glm::smoothstep(-edge, edge, beyond.x)) * (1.0f - glm::smoothstep(-edge, edge, beyond.y));
}

/// For a camera at azimuth 30°, elevation 15°: a large warm key on the upper left, a softer fill on the right, two
/// strips behind the model that draw its edges, a ceiling box and a grey reflector; a floor that a lamp lights behind the
/// camera, and walls, with a halo on the backdrop. Floor and walls meet in a soft seam, and no two sides are alike, so that
/// a mirror with flat sides stands out from what is behind it.
glm::vec3 studioRadiance(glm::vec3 d) {
  static const std::array<SoftBox, 6> kBoxes{{
      {{-0.45f, 0.62f, 0.95f}, {0.40f, 0.40f}, glm::vec3(9.0f, 8.4f, 7.6f)},
      {{0.95f, 0.22f, 0.45f}, {0.28f, 0.40f}, glm::vec3(2.2f, 2.3f, 2.5f)},
      {{0.62f, 0.15f, -0.78f}, {0.12f, 0.70f}, glm::vec3(7.0f, 7.8f, 9.0f)},
      {{-0.98f, 0.10f, 0.15f}, {0.12f, 0.70f}, glm::vec3(6.0f, 6.2f, 6.6f)},
      {{0.0f, 1.0f, -0.15f}, {0.60f, 0.32f}, glm::vec3(4.5f, 4.5f, 4.5f)},
      {{0.26f, -0.12f, -0.96f}, {0.13f, 0.42f}, glm::vec3(0.42f, 0.44f, 0.48f)},
  }};
  const float behind_camera = glm::smoothstep(-0.4f, 0.9f, glm::dot(d, glm::vec3(0.5f, 0.0f, 0.866f)));
  const glm::vec3 wall =
      glm::mix(glm::vec3(0.150f, 0.156f, 0.168f), glm::vec3(0.060f, 0.068f, 0.082f), glm::smoothstep(0.0f, 0.8f, d.y)) *
      (1.0f + 1.6f * behind_camera);
  const glm::vec3 from_halo = d - glm::normalize(glm::vec3(-0.5f, 0.22f, -0.866f));
  const glm::vec3 halo = glm::vec3(0.26f, 0.27f, 0.29f) * std::exp(-5.0f * glm::dot(from_halo, from_halo));
  const glm::vec3 floor = glm::mix(glm::vec3(0.085f, 0.080f, 0.075f), glm::vec3(0.34f, 0.32f, 0.29f), behind_camera) *
                          glm::mix(1.0f, 0.45f, glm::smoothstep(0.25f, 0.95f, -d.y));
  glm::vec3 light = glm::mix(floor, wall + halo, glm::smoothstep(-0.16f, -0.04f, d.y));
  for (const SoftBox& box : kBoxes) light = glm::mix(light, box.radiance, coverage(box, d));
  return light;
}

/// Transmittance of air for the sun's light at three wavelengths that stand for red, green and blue, after Preetham et
/// al. 1999, appendix A.1: Rayleigh scattering by molecules and Ångström's formula for haze.
glm::vec3 sunTransmittance(float elevation_rad, float turbidity) {
  const float zenith_deg = 90.0f - glm::degrees(elevation_rad);
  const float air_mass = 1.0f / (std::max(std::sin(elevation_rad), 0.0f) +
                                 0.15f * std::pow(93.885f - std::min(zenith_deg, 90.0f), -1.253f));
  const glm::vec3 wavelength_um(0.615f, 0.535f, 0.445f);
  const float haze = 0.04608f * turbidity - 0.04586f;
  glm::vec3 transmittance;
  for (int channel = 0; channel < 3; ++channel) {
    const float rayleigh = 0.008735f * std::pow(wavelength_um[channel], -4.08f);
    const float aerosol = haze * std::pow(wavelength_um[channel], -1.3f);
    transmittance[channel] = std::exp(-(rayleigh + aerosol) * air_mass);
  }
  return transmittance;
}

/// The sun's disc as a share of its radiance. Its edge is as soft as the texels of a map that is sampled from it, with
/// the same flux as the sharp disc: a linear ramp over [r − w, r + w] has the area π (r² + w²/3).
float sunDisc(float angle_rad, float radius_rad) {
  const float soft_rad = 0.6f * radius_rad;
  const float gain = radius_rad * radius_rad / (radius_rad * radius_rad + soft_rad * soft_rad / 3.0f);
  return gain * glm::clamp((radius_rad + soft_rad - angle_rad) / (2.0f * soft_rad), 0.0f, 1.0f);
}

/// The irradiance of a level surface by what is above it: the mean of 32 × 64 directions, even in area and cosine.
template <typename Radiance>
glm::vec3 irradianceFromAbove(const Radiance& radiance) {
  constexpr int kRings = 32;
  constexpr int kPlaces = 64;
  glm::vec3 sum(0.0f);
  for (int ring = 0; ring < kRings; ++ring)
    for (int place = 0; place < kPlaces; ++place) {
      const float squared_sine = (static_cast<float>(ring) + 0.5f) / kRings;
      const float turn = formula::kTwoPi * (static_cast<float>(place) + 0.5f) / kPlaces;
      const float sine = std::sqrt(squared_sine);
      sum += radiance(glm::vec3(sine * std::cos(turn), std::sqrt(1.0f - squared_sine), sine * std::sin(turn)));
    }
  return sum * (formula::kPi / (kRings * kPlaces));
}

/// Rows of a panorama that shows the sun's disc and the ground's grains.
constexpr int kSkyHeight = 1024;

Environment skyEnvironment(const SkyParameters& parameters) {
  constexpr float kKcdPerUnit = 20.0f;
  // 133.8 klx outside the air from a disc of 0.533° across.
  constexpr float kSunRadius_rad = 0.00465f;
  const float kSunLuminance_kcd = 133.8f / (formula::kPi * kSunRadius_rad * kSunRadius_rad);
  const float elevation = glm::radians(parameters.elevation_deg);
  const float azimuth = glm::radians(parameters.azimuth_deg);
  const glm::vec3 sun(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                      std::cos(elevation) * std::cos(azimuth));
  const float turbidity = parameters.turbidity;
  const glm::vec3 sun_radiance =
      sunTransmittance(elevation, turbidity) * (kSunLuminance_kcd / kKcdPerUnit * parameters.sun);
  const float sun_solid_angle = formula::kPi * kSunRadius_rad * kSunRadius_rad;
  const glm::vec3 sun_irradiance = sun_radiance * (sun_solid_angle * std::sin(elevation));
  const auto skyAlong = [=](glm::vec3 d) { return formula::skyLuminance(d, sun, turbidity) / kKcdPerUnit; };
  const glm::vec3 sky_irradiance = irradianceFromAbove(skyAlong);

  const auto radiance = [=](glm::vec3 d) {
    if (d.y >= 0.0f) return skyAlong(d) + sun_radiance * sunDisc(glm::length(d - sun), kSunRadius_rad);
    const glm::vec3 horizon = skyAlong(glm::normalize(glm::vec3(d.x, 0.0f, d.z) + glm::vec3(0, 1e-4f, 0)));
    return formula::groundRadiance(d, sun, sun_irradiance, sky_irradiance, horizon, formula::kPi / kSkyHeight);
  };
  return Environment(radiance, kSkyHeight);
}

/// The parameters written after "sky:".
Result<SkyParameters> parseSky(std::string_view written) {
  SkyParameters parameters;
  if (written.empty()) return parameters;
  for (const std::string& assignment : split(written, ',')) {
    const std::size_t equals = assignment.find('=');
    const std::string key = assignment.substr(0, equals);
    const auto found = std::find_if(kSkyParameters.begin(), kSkyParameters.end(),
                                    [&](const auto& parameter) { return parameter.text.name == key; });
    if (found == kSkyParameters.end() || equals == std::string::npos) {
      std::vector<std::string_view> names;
      for (const auto& parameter : kSkyParameters) names.push_back(parameter.text.name);
      if (found == kSkyParameters.end()) return tl::unexpected<Error>(unknownName("parameter of sky", key, names));
      return fail(ErrorCode::usage,
                  "the sky's " + key + " needs a value: sky:" + key + "=" + ::mirrorball::written(*found, parameters));
    }
    MIRRORBALL_TRY_VOID(assign(*found, parameters, assignment.substr(equals + 1)));
  }
  return parameters;
}

}  // namespace

std::span<const Option<SkyParameters>> skyParameters() { return kSkyParameters; }

std::span<const std::string_view> builtinEnvironmentNames() { return kNames; }

bool isBuiltinEnvironment(std::string_view name) {
  return indexOfName(name.substr(0, name.find(':')), kNames).has_value();
}

Result<Environment> builtinEnvironment(std::string_view name) {
  const std::size_t colon = name.find(':');
  const auto index = indexOfName(name.substr(0, colon), kNames);
  if (!index) return tl::unexpected<Error>(noSuchEnvironment(name));
  const std::string_view base = kNames[*index];
  const std::string_view written = colon == std::string_view::npos ? std::string_view{} : name.substr(colon + 1);
  if (base == "sky") {
    MIRRORBALL_TRY(parameters, parseSky(written));
    return skyEnvironment(parameters);
  }
  if (!written.empty())
    return fail(ErrorCode::usage, "the environment '" + std::string(base) + "' takes no parameters; only sky does");
  if (base == "studio") return Environment(studioRadiance, 1024);
  if (base == "uv") return Environment(uvRadiance, 1024);
  return Environment([](glm::vec3) { return glm::vec3(1.0f); }, 32);
}

Error noSuchEnvironment(std::string_view name) {
  const auto nearest = nearestWord(name.substr(0, name.find(':')), kNames);
  const std::string hint = nearest ? "; did you mean '" + std::string(*nearest) + "'?" : "";
  return {ErrorCode::not_found, std::string(name) + ": no such file, and no built-in environment" + hint +
                                    " (there are: " + join(kNames) + ")"};
}

}  // namespace mirrorball
