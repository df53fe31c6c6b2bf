#include "cli/baked_set.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/files.h"
#include "cli/terminal.h"
#include "formula/bsdf.h"
#include "mirrorball/base/file.h"
#include "mirrorball/codec/stored_format.h"
#include "mirrorball/environment/cube_arrangement.h"

namespace mirrorball::cli {
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

Json harmonicsJson(const Harmonics& radiance, const BakeOptions& options) {
  Json json;
  json["convention"] = kHarmonicsConvention;
  json["degree"] = options.harmonics_degree;
  for (const NamedHarmonics& form : formsOf(radiance)) json[form.name] = jsonOf(form.coefficients);
  return json;
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

std::string nameOf(TexelFormat format) { return nameOf(storedFormat(format)); }

/// Where a shader finds a roughness r, M being the last level.
constexpr std::string_view lookUpOf(MipMapping mapping) {
  switch (mapping) {
    case MipMapping::linear:
      return "lod = M r";
    case MipMapping::unreal:
      return "lod = M + 1.2 log2(r)";
    case MipMapping::unity:
      return "lod = M r (1.7 - 0.7 r)";
    case MipMapping::frostbite:
      return "lod = M sqrt(r)";
    case MipMapping::filament:
      break;
  }
  return "lod = M r (2 - r)";
}

Json specularJson(const BakedSet& set, const BakedFiles& files, const BakeOptions& options, TexelFormat format) {
  Json json;
  json["file"] = std::filesystem::path(files.specular.paths().front()).filename();
  json["format"] = nameOf(format);
  json["what"] =
      "radiance, prefiltered with n = v = r: the mean under the lobe of each level; level 0 is the environment";
  json["distribution"] = writtenValue(options, "distribution");
  json["mip_mapping"] = writtenValue(options, "mip-mapping");
  json["look_up"] = std::string(lookUpOf(mipMappingOf(options.mip_mapping))) +
                    ", r the perceptual roughness, M = " + std::to_string(set.levels.size() - 1);
  for (const PrefilterLevel& level : set.levels)
    json["levels"].push_back({{"size", level.size},
                              {"perceptual_roughness", level.perceptual_roughness},
                              {"alpha", formula::alphaFromPerceptualRoughness(level.perceptual_roughness)},
                              {"prefiltered", level.lobe.has_value()}});
  return json;
}

Json brdfJson(const BakedFiles& files, const BakeOptions& options) {
  Json json;
  json["file"] = std::filesystem::path(files.brdf.path).filename();
  json["format"] = files.brdf.isTexture()                   ? nameOf(files.brdf.format)
                   : files.brdf.format == TexelFormat::half ? "three channels of half floats"
                                                            : "three channels of 32-bit floats";
  json["size"] = options.brdf_size;
  json["distribution"] = files.brdf.facts.distribution;
  json["channels"] = {"scale of f0", "bias of f0"};
  if (options.brdf_channels == 3) json["channels"].push_back("mean over all directions, for multiple scattering");
  json["axes"] = options.brdf_axes == BrdfAxes::linear
                     ? "linear: n.v = u to the right, perceptual roughness = v downwards, at texel centres"
                     : "warped: see brdfTableCoordinates in formula/";
  return json;
}

Json manifestOf(const BakedSet& set, const BakedFiles& files, const BakeOptions& options, TexelFormat specular,
                TexelFormat irradiance) {
  Json json;
  json["made_by"] = std::string("mirrorball ") + MIRRORBALL_VERSION + " bake";
  json["source"] = shown(files.source);
  if (!options.rotate_deg.empty()) json["rotate_deg"] = options.rotate_deg;
  const std::string arrangement = textOf(files.specular.form().arrangement);
  json["faces"] = arrangement.empty() ? "+X -X +Y -Y +Z -Z by OpenGL's table" : arrangement;
  json["specular"] = specularJson(set, files, options, specular);
  json["irradiance"] = {{"file", std::filesystem::path(files.irradiance.paths().front()).filename()},
                        {"format", nameOf(irradiance)},
                        {"size", options.irradiance_size},
                        {"what", "irradiance / pi: the radiance of a white matt surface of that normal"}};
  json["brdf"] = brdfJson(files, options);
  json["harmonics"] = {{"file", "sh.json"}, {"header", "sh.h"}, {"degree", options.harmonics_degree}};
  return json;
}

/// File names need not be UTF-8, which JSON is.
std::string textOf(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Result<void> writeText(const std::string& path, const std::string& text) {
  const std::string_view view(text);
  MIRRORBALL_TRY_VOID(writeFile(path, {reinterpret_cast<const std::uint8_t*>(view.data()), view.size()}));
  announce(path);
  return {};
}

/// The file of one map that a manifest names, if it is such as bake writes: nothing else in a folder is ours.
std::filesystem::path fileIn(const Json& manifest, const char* map) {
  if (!manifest.is_object() || !manifest.contains(map) || !manifest[map].is_object()) return {};
  const Json file = manifest[map].value("file", Json());
  const std::filesystem::path name = file.is_string() ? file.get<std::string>() : "";
  return name == name.filename() && name.stem() == map ? name : std::filesystem::path();
}

/// Removes an older set's manifest, which would tell of other maps than those that now take their places, and those of
/// its maps whose extension is another now, but for the environment itself.
void removeOlderSet(const BakedFiles& files, const std::vector<std::string>& inputs) {
  const std::filesystem::path folder = files.folder;
  const auto text = readFile(folder / "manifest.json");
  std::error_code status;
  std::filesystem::remove(folder / "manifest.json", status);
  if (!text) return;
  const Json manifest = Json::parse(text->begin(), text->end(), nullptr, false);
  for (const auto& [map, path] :
       {std::pair<const char*, std::filesystem::path>{"specular", files.specular.paths().front()},
        {"irradiance", files.irradiance.paths().front()},
        {"brdf", files.brdf.path}}) {
    const std::filesystem::path older = fileIn(manifest, map);
    if (older.empty() || older == path.filename()) continue;
    const std::string lies_at = (folder / older).string();
    if (refuseOverwriting(inputs, {&lies_at, 1})) std::filesystem::remove(lies_at, status);
  }
}

}  // namespace

std::vector<std::string> BakedFiles::paths() const {
  return {specular.paths().front(), irradiance.paths().front(), brdf.path,
          folder + "/sh.json",      folder + "/sh.h",           folder + "/manifest.json"};
}

Result<void> writeSet(BakedSet set, const BakedFiles& files, const BakeOptions& options) {
  const auto go_on = [](const std::string& what_is_left) -> Result<void> {
    if (!interrupted()) return {};
    return fail(ErrorCode::interrupted, "interrupted; " + what_is_left);
  };
  const std::string nothing = "nothing was written";
  MIRRORBALL_TRY_VOID(go_on(nothing));
  MIRRORBALL_TRY(folder, OutputFolder::make(files.folder));
  const std::string some = folder.isNew() ? nothing : files.folder + " has only some of the new files, and no manifest";
  removeOlderSet(files, set.inputs);
  MIRRORBALL_TRY(specular, files.specular.writeLevels(std::move(set.specular)));
  MIRRORBALL_TRY_VOID(go_on(some));
  MIRRORBALL_TRY(irradiance, files.irradiance.writeLevels(std::move(set.irradiance).takeImages()));
  MIRRORBALL_TRY_VOID(go_on(some));
  MIRRORBALL_TRY_VOID(writeBrdf(std::move(set.brdf), files.brdf));
  MIRRORBALL_TRY_VOID(go_on(some));
  const std::string path = files.folder + "/";
  MIRRORBALL_TRY_VOID(writeText(path + "sh.json", textOf(harmonicsJson(set.radiance, options))));
  MIRRORBALL_TRY_VOID(writeText(path + "sh.h", harmonicsHeader(set.radiance, shown(files.source))));
  MIRRORBALL_TRY_VOID(writeText(path + "manifest.json", textOf(manifestOf(set, files, options, specular, irradiance))));
  folder.keep();
  return {};
}

}  // namespace mirrorball::cli
