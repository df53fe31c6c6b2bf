#include "mirrorball/output/baked/baked_manifest.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "formula/bsdf.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/texture/stored_format.h"
#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/output/lamps/lamp_files.h"

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
  json["format"] = file.isTexture()                   ? nameOf(storedFormat(file.format))
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
  json["format"] = nameOf(storedFormat(TexelFormat::half));
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

/// All names of files that a manifest has, whatever it is.
void collectFiles(const Json& json, std::vector<std::string>& names) {
  if (json.is_array())
    for (const Json& element : json) collectFiles(element, names);
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (value.is_string() && (key == "file" || key == "header" || key == "json"))
      names.push_back(value.get<std::string>());
    if (value.is_array() && key == "files")
      for (const Json& name : value)
        if (name.is_string()) names.push_back(name.get<std::string>());
    collectFiles(value, names);
  }
}

/// Whether a name is one that bake gives a file: nothing else in a folder is ours, whatever a manifest says.
bool isOurs(const fs::path& name) {
  if (name != name.filename()) return false;
  const std::string stem = name.stem().string();
  const std::string extension = extensionOf(name);
  if (stem == "sh") return extension == "json" || extension == "h" || extension == "txt";
  if (name.string().starts_with(kLampStem) && checkLampFile(name.string())) return true;
  if (stem == kPackedStem && (isTexturePath(name) || extension == "env" || extension == "png" || extension == "glb"))
    return true;
  if (name == LobeRowFiles::kTextureName || name == LobeRowFiles::kTextName) return true;
  if (!formatToWrite(name, {Holds::light, Holds::texture})) return false;
  if (isTexturePath(name) && (stem.ends_with("_ibl") || stem.ends_with("_skybox"))) return true;
  if (stem == "specular" || stem == "irradiance" || stem == "skybox" || stem == "brdf") return true;
  const std::size_t end = stem.rfind('_');
  if (end == std::string::npos) return false;
  const auto hasEnding = [&](FaceNaming naming) { return contains(endingsOf(naming), stem.substr(end + 1)); };
  const std::string cube = stem.substr(0, end);
  const bool is_level = cube.size() > 1 && cube[0] == 'm' &&
                        std::all_of(cube.begin() + 1, cube.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return (is_level || cube == "i" || cube == "skybox") && (hasEnding(FaceNaming::px) || hasEnding(FaceNaming::signs));
}

/// What a manifest states of all cubes of a set.
Json manifestHead(const BakedFiles& files, const BakedSetSettings& settings) {
  Json json{{"made_by", settings.made_by}, {"source", settings.source}};
  if (!settings.rotate_deg.empty()) json["rotate_deg"] = settings.rotate_deg;
  if (const CubeFiles* const cube = files.anyCube()) {
    const std::string arrangement = textOf(cube->form().arrangement);
    json["faces"] = arrangement.empty() ? "+X -X +Y -Y +Z -Z by OpenGL's table" : arrangement;
  }
  return json;
}

/// The parts of an older set that describe the light of the new one, which lacks them; with the arrangement of their
/// cubes where the new set has no cube.
Json remainingParts(const Json& older, const BakedFiles& files, const BakedSetSettings& settings) {
  Json parts = Json::object();
  // As it is read again: with the replacements of what is not UTF-8.
  const Json head = Json::parse(manifestHead(files, settings).dump(-1, ' ', false, Json::error_handler_t::replace));
  const auto differs = [&](const char* key) { return older.value(key, Json()) != head.value(key, Json()); };
  if (!older.is_object() || older.contains("packed") || older.contains("lamps") || !files.lamps.empty() ||
      differs("source") || differs("rotate_deg"))
    return parts;
  const bool has_cubes = older.contains("faces");
  if (has_cubes && head.contains("faces") && differs("faces")) return parts;
  const auto keep = [&](const char* key, bool is_replaced) {
    if (older.contains(key) && !is_replaced) parts[key] = older[key];
  };
  keep("faces", false);
  keep("specular", files.specular.has_value());
  keep("irradiance", files.irradiance.has_value());
  keep("skybox", files.skybox.has_value());
  keep("brdf", files.brdf.has_value());
  keep("lobe_rows", files.lobe_rows.has_value());
  keep("harmonics", !files.harmonics.empty());
  return parts;
}

}  // namespace

std::string makeManifest(const BakedFacts& facts, const BakedFiles& files, const BakedSetSettings& settings,
                         const OlderSet& older) {
  Json json = manifestHead(files, settings);
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
  for (const auto& [key, part] : older.parts().items()) json[key] = part;
  // File names need not be UTF-8, which JSON is.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

OlderSet OlderSet::takeFrom(const BakedFiles& files, const BakedSetSettings& settings,
                            const std::vector<std::string>& inputs) {
  OlderSet older;
  const fs::path folder = files.folder;
  const auto text = readFile(folder / "manifest.json");
  std::error_code status;
  fs::remove(folder / "manifest.json", status);
  if (!text) return older;
  const Json manifest = Json::parse(text->begin(), text->end(), nullptr, false);
  if (!settings.only.empty()) older.parts_ = remainingParts(manifest, files, settings);
  std::vector<std::string> names;
  collectFiles(manifest, names);
  std::vector<std::string> remaining;
  collectFiles(older.parts_, remaining);
  std::vector<fs::path> newer(remaining.begin(), remaining.end());
  for (const std::string& path : files.paths()) newer.push_back(fs::path(path).filename());
  for (const std::string& name : names) {
    if (!isOurs(name) || contains(newer, fs::path(name))) continue;
    const std::string lies_at = (folder / name).string();
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
      std::error_code missing;
      return fs::equivalent(input, lies_at, missing);
    });
    if (!is_input) fs::remove(lies_at, status);
  }
  return older;
}

}  // namespace mirrorball
