#include "mirrorball/environment/builtin/builtin.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/environment/builtin/studio.h"
#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/environment/builtin/uv_environment.h"

namespace mirrorball {
namespace {

/// Also of what this build has left out.
constexpr std::array<std::string_view, 5> kNames{"studio", "sky", "sunset", "uv", "white"};

const auto kSkyParameters = std::to_array<Option<SkyParameters>>({
    {{.name = "elevation",
      .unit = "degrees",
      .minimum = 0,
      .maximum = 90,
      .help = "height of the sun above the horizon"},
     &SkyParameters::elevation_deg},
    {{.name = "azimuth", .unit = "degrees", .help = "direction of the sun: 0 is over +Z, 90 over +X"},
     &SkyParameters::azimuth_deg},
    {{.name = "turbidity", .minimum = 2, .maximum = 10, .help = "haze: 2 is very clear, 10 is hazy"},
     &SkyParameters::turbidity},
    {{.name = "sun",
      .minimum = 0,
      .maximum = 10,
      .help = "factor on the radiance of the sun's disc; 0 leaves only the sky"},
     &SkyParameters::sun},
    {{.name = "adaptation",
      .minimum = 0,
      .maximum = 1,
      .help = "how far the exposure follows the daylight: with 0, radiance 1 is always 20 kcd/m²; with 1, level ground "
              "is as bright at sunset as at noon"},
     &SkyParameters::adaptation},
});

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

std::span<const std::string_view> builtinEnvironmentNames() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> there(kNames.begin(), kNames.end());
    if (!hasSunset()) std::erase(there, "sunset");
    return there;
  }();
  return names;
}

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
    return fail(ErrorCode::usage, "the environment '" + excerpt(base) + "' takes no parameters; only sky does");
  if (base == "studio") return Environment(studioRadiance, 1024);
  if (base == "sunset") return sunsetEnvironment();
  if (base == "uv") return Environment(uvRadiance, 1024);
  return Environment([](glm::vec3) { return glm::vec3(1.0f); }, 32);
}

Error noSuchEnvironment(std::string_view name) {
  const auto nearest = nearestWord(name.substr(0, name.find(':')), builtinEnvironmentNames());
  const std::string hint = nearest ? "; did you mean '" + std::string(*nearest) + "'?" : "";
  return {ErrorCode::not_found, std::string(name) + ": no such file, and no built-in environment" + hint +
                                    " (there are: " + join(builtinEnvironmentNames()) + ")"};
}

}  // namespace mirrorball
