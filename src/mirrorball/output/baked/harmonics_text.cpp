#include "mirrorball/output/baked/harmonics_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <vector>

#include <nlohmann/json.hpp>

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHarmonicsConvention =
    "real spherical harmonics of our axes (+Y up, right-handed), orthonormal, without the Condon-Shortley sign; "
    "coefficient l (l + 1) + m, each red, green, blue";

Json jsonOf(const Harmonics& harmonics) {
  Json rows = Json::array();
  for (const glm::vec3& row : harmonics) rows.push_back({row.x, row.y, row.z});
  return rows;
}

/// The four forms of the coefficients, each with its name and what it is.
struct NamedHarmonics {
  const char* name;
  const char* meaning;
  Harmonics coefficients;
};
std::vector<NamedHarmonics> formsOf(const Harmonics& radiance) {
  return {
      {"radiance", "of the light as it arrives", radiance},
      {"irradiance", "irradiance [W/m2] at any normal: each band of radiance times pi, 2 pi / 3, pi / 4, 0, -pi / 24",
       irradianceOf(radiance)},
      {"radiance_windowed", "radiance times Hann's window, which lessens ripples around small lamps",
       windowed(radiance)},
      {"irradiance_windowed", "irradiance times Hann's window", windowed(irradianceOf(radiance))}};
}

}  // namespace

std::string harmonicsJson(const Harmonics& radiance, int degree) {
  Json json;
  json["convention"] = kHarmonicsConvention;
  json["degree"] = degree;
  for (const NamedHarmonics& form : formsOf(radiance)) json[form.name] = jsonOf(form.coefficients);
  return json.dump(2) + "\n";
}

std::string harmonicsHeader(const Harmonics& radiance, const std::string& source) {
  std::string name = source;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return std::iscntrl(letter) != 0 || letter == '\\'; }, '_');
  std::string text = "// Spherical harmonics of " + name + ", made by mirrorball bake:\n// " + kHarmonicsConvention +
                     ".\n#pragma once\n";
  for (const NamedHarmonics& form : formsOf(radiance)) {
    text += "\n// " + std::string(form.meaning) + "\nstatic const float mirrorball_" + form.name + "[" +
            std::to_string(form.coefficients.size()) + "][3] = {\n";
    for (const glm::vec3& row : form.coefficients) {
      char line[96];
      std::snprintf(line, sizeof line, "    {%.9ef, %.9ef, %.9ef},\n", static_cast<double>(row.x),
                    static_cast<double>(row.y), static_cast<double>(row.z));
      text += line;
    }
    text += "};\n";
  }
  return text;
}

std::string cmgensHarmonics(const FilamentHarmonics& harmonics) {
  std::string text;
  for (int band = 0; band <= 2; ++band)
    for (int order = -band; order <= band; ++order) {
      const glm::dvec3 row(harmonics[static_cast<std::size_t>(band * (band + 1) + order)]);
      std::array<char, 256> line;
      std::snprintf(line.data(), line.size(), "(%18.15f, %18.15f, %18.15f); // L%d%d, irradiance, pre-scaled base\n",
                    row.x, row.y, row.z, band, order);
      text += line.data();
    }
  return text;
}

}  // namespace mirrorball
