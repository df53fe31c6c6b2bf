#include "mirrorball/output/baked/baked_manifest.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "formula/bsdf.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/environment/cube/cube_arrangement.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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
    case MipMapping::babylon:
      return "lod = 0.8 log2(w r r)";
    case MipMapping::gltf:
      return "lod = M (1 + 2 log2(r) / log2(w))";
    case MipMapping::filament:
      break;
  }
  return "lod = M r (2 - r)";
}

/// A texture's name, or those of six pictures.
void addFiles(std::span<const std::string> paths, Json& json) {
  if (paths.size() == 1) json["file"] = fs::path(paths.front()).filename();
  for (std::size_t i = 0; paths.size() > 1 && i < paths.size(); ++i)
    json["files"].push_back(fs::path(paths[i]).filename());
}

Json specularJson(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings) {
  const std::vector<std::string> paths = files.specular ? files.specular->paths() : std::vector<std::string>();
  const bool is_texture = paths.size() == 1;
  Json json;
  if (is_texture) addFiles(paths, json);
  if (files.specular) json["format"] = facts.formats.specular;
  json["what"] =
      "radiance, prefiltered with n = v = r: the mean under the lobe of each level; level 0 is the environment";
  json["distribution"] = writtenSetting(settings, "distribution");
  json["mip_mapping"] = writtenSetting(settings, "mip-mapping");
  const MipMapping mapping = *settings.mip_mapping;
  std::string look_up =
      std::string(lookUpOf(mapping)) + ", r the perceptual roughness, M = " + std::to_string(facts.levels.size() - 1);
  if (mapping == MipMapping::babylon || mapping == MipMapping::gltf)
    look_up += ", w = " + std::to_string(settings.size) + ", the side of level 0";
  json["look_up"] = look_up;
  for (std::size_t i = 0; i < facts.levels.size(); ++i) {
    const PrefilterLevel& level = facts.levels[i];
    Json row{{"size", level.size},
             {"perceptual_roughness", level.perceptual_roughness},
             {"alpha", formula::alphaFromPerceptualRoughness(level.perceptual_roughness)},
             {"prefiltered", level.lobe.has_value()}};
    if (files.specular && !is_texture) addFiles(std::span(paths).subspan(6 * i, 6), row);
    json["levels"].push_back(std::move(row));
  }
  return json;
}

/// A cube of one level.
Json cubeJson(const CubeFiles& files, const std::string& format, int size, const char* what) {
  Json json;
  addFiles(files.paths(), json);
  json["format"] = format;
  json["size"] = size;
  json["what"] = what;
  return json;
}

Json brdfJson(const BrdfFile& file, const BakedSetSettings& settings) {
  Json json;
  json["file"] = fs::path(file.path).filename();
  json["format"] = file.isTexture()                   ? formatName(storedFormat(file.format))
                   : file.format == TexelFormat::half ? "three channels of half floats"
                                                      : "three channels of 32-bit floats";
  json["size"] = settings.brdf_size;
  json["distribution"] = file.facts.distribution;
  json["channels"] = {"scale of f0", "bias of f0"};
  if (settings.brdf_channels == 3) json["channels"].push_back("mean over all directions, for multiple scattering");
  json["axes"] = settings.brdf_axes == BrdfAxes::linear
                     ? "linear: n.v = u to the right, perceptual roughness = v downwards, at texel centres"
                     : "warped: see brdfTableCoordinates in formula/";
  return json;
}

Json lobeRowsJson(const LobeRowFiles& files) {
  Json json{{"file", LobeRowFiles::kTextureName}};
  if (files.has_text) json["json"] = LobeRowFiles::kTextName;
  json["format"] = formatName(storedFormat(TexelFormat::half));
  json.update(lobeRowFacts(files.lobes));
  return json;
}

Json lampsJson(const std::vector<std::string>& paths, std::size_t count) {
  Json json;
  addFiles(paths, json);
  json["count"] = count;
  json["what"] = "directional lights that were taken out of all maps: add both";
  return json;
}

Json harmonicsJson(const EngineSet& set, const BakedSetSettings& settings) {
  if (set.files == SetFiles::cmgens)
    return {{"file", "sh.txt"}, {"degree", 2}, {"what", "irradiance / pi, as coefficients of Filament's polynomial"}};
  return {{"file", "sh.json"}, {"header", "sh.h"}, {"degree", settings.harmonics_degree}};
}

/// What a manifest states of all parts of a set. Tables describe no light, and are of no environment.
Json manifestHead(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings) {
  Json json{{"made_by", settings.made_by}};
  if (files.hasLight()) {
    json["source"] = settings.source;
    json["light_hash"] = facts.light_hash;
    if (!settings.rotate_deg.empty()) json["rotate_deg"] = settings.rotate_deg;
  }
  if (files.anyCube() != nullptr) json["faces"] = writtenFaces(files);
  return json;
}

}  // namespace

std::string writtenFaces(const BakedFiles& files) {
  const CubeFiles* const cube = files.anyCube();
  if (cube == nullptr) return "";
  const std::string arrangement = textOf(cube->form().arrangement);
  return arrangement.empty() ? "+X -X +Y -Y +Z -Z by OpenGL's table" : arrangement;
}

std::string makeManifest(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings,
                         const OlderSet& older) {
  Json json = manifestHead(facts, files, settings);
  if (!files.packed.empty())
    json["packed"] = {{"file", fs::path(files.packed).filename()},
                      {"what", "all that the program needs, in its own kind of file"}};
  if (!facts.levels.empty()) json["specular"] = specularJson(facts, files, settings);
  if (files.irradiance)
    json["irradiance"] = cubeJson(*files.irradiance, facts.formats.irradiance, settings.irradiance_size,
                                  "irradiance / pi: the radiance of a white matt surface of that normal");
  if (files.skybox)
    json["skybox"] =
        cubeJson(*files.skybox, facts.formats.skybox, facts.skybox_size, "radiance: the environment as it is");
  if (files.brdf) json["brdf"] = brdfJson(*files.brdf, settings);
  if (files.lobe_rows) json["lobe_rows"] = lobeRowsJson(*files.lobe_rows);
  if (!files.lamps.empty()) json["lamps"] = lampsJson(files.lamps, facts.lamps);
  if (!files.harmonics.empty()) json["harmonics"] = harmonicsJson(files.set, settings);
  for (const auto& [key, value] : older.remains().items())
    if (!json.contains(key)) json[key] = value;
  return manifestText(json);
}

}  // namespace mirrorball
