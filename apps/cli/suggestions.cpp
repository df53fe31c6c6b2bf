#include "cli/suggestions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/files.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/material/material.h"

namespace mirrorball::cli {
namespace {

/// Words for one of our names, without dashes and in small letters.
struct Synonyms {
  std::string_view name;   ///< an option's, or a command's; of an option nothing: the argument that is a file's name
  std::string_view words;  ///< with spaces between
  std::string_view typed = {};  ///< what to type for it, where that is more than the option
};

/// What options are called in cmgen, cmft, toktx, maketx, F3D, Blender and by newcomers. A word that is there twice
/// means the first of those that the command has.
constexpr std::array<Synonyms, 39> kOptionSynonyms{{
    {"at", "cameraposition origin point position"},
    {"background", "backgroundcolor backgroundcolour bg bgcolor nobackground"},
    {"camera", "azimuth cameraazimuthangle cameraelevationangle cameraposition elevation orbit"},
    {"clamp-light", "clamp"},
    {"distribution", "lightingmodel ndf"},
    {"env", "enviroment environment environmentmap envmap hdr hdri hdrifile ibl map panorama skybox"},
    {"env-intensity", "envstrength hdriintensity lightintensity"},
    {"env-rotation", "envangle hdrirotation"},
    {"flip", "mirror"},
    {"for", "engine preset program"},
    {"fov", "cameraviewangle fieldofview viewangle"},
    {"frames", "turntable"},
    {"json", "format outputformat"},
    {"level", "lod miplevel"},
    {"levels", "mipcount miplevels"},
    {"max-memory", "memory"},
    {"mips", "generatemipchain genmipmap mipmap mipmaps"},
    {"orthographic", "cameraorthographic ortho"},
    {"output", "deploy out outfile outputfile"},
    {"quiet", "q silent"},
    {"repair", "fixnan"},
    {"samples", "aa antialiasing numsamples spp"},
    {"set", "albedo basecolor color colour", "--set base_color="},
    {"set", "albedomap basecolortexture texture", "--set base_color_map="},
    {"set", "emissive", "--set emission="},
    {"set", "metalness", "--set metallic="},
    {"set", "rough roughness", "--set perceptual_roughness="},
    {"sh-degree", "sh shorder"},
    {"size", "dstfacesize facesize height res resize resolution s width"},
    {"stand", "catcher contactshadow floor ground onground shadow shadowcatcher shadows"},
    {"target", "camerafocalpoint lookat"},
    {"threads", "cores j jobs numcpuprocessingthreads numthreads"},
    {"to", "outputprojection projection t type"},
    {"from", "inputprojection"},
    {"tone-map", "tonemapper tonemapping"},
    {"up", "cameraviewup upaxis"},
    {"zstd", "compression zcmp"},
    {"", "file i in infile input inputfile mesh model scene"},
    {"", "env enviroment environment environmentmap envmap hdr hdri hdrifile map panorama skybox"},
}};

constexpr std::array<Synonyms, 6> kCommandSynonyms{{
    {"render", "display draw preview show"},
    {"convert", "cubemap reproject resample resize transform"},
    {"bake", "filter ibl irradiance prefilter"},
    {"info", "describe identify inspect"},
    {"compare", "diff difference metric metrics"},
    {"photo", "unwrap"},
}};

/// "env-map", "env_map" and "envMap" are "envmap".
std::string squashed(std::string_view name) {
  std::string result;
  for (const unsigned char letter : name)
    if (letter != '-' && letter != '_') result += static_cast<char>(std::tolower(letter));
  return result;
}

bool hasWord(std::string_view words, const std::string& word) {
  const std::vector<std::string> all = split(words, ' ');
  return std::ranges::find(all, word) != all.end();
}

std::string dashed(std::string_view name) { return "--" + std::string(name); }

bool hasOption(const Command& command, std::string_view name) {
  return std::ranges::any_of(command.options, [&](const CommandOption& option) {
    return option.text.name == name || (!option.text.also.empty() && option.text.also == name);
  });
}

bool takesPath(const Command& command) { return std::ranges::any_of(command.arguments, &Argument::takes_path); }

std::string didYouMean(const std::string& what) { return "did you mean " + what + "?"; }

/// What other programs have options for and this one does not do.
struct AbsentFeature {
  std::string_view words;  ///< with spaces between
  std::string_view hint;
};
constexpr auto kAbsentFeatures = std::to_array<AbsentFeature>({
    {"aperture bokeh depthoffield dof fstop focaldistance focus", "pictures are in focus at all distances"},
    {"motionblur shutter shutterspeed", "motion blur is not simulated"},
});

std::optional<std::string> hintBySynonym(const Command& command, const std::string& word) {
  for (const Synonyms& row : kOptionSynonyms) {
    if (!hasWord(row.words, word)) continue;
    if (row.name.empty() && takesPath(command)) return "name it without an option: mirrorball " + synopsisOf(command);
    if (!row.name.empty() && hasOption(command, row.name))
      return didYouMean(row.typed.empty() ? dashed(row.name) : std::string(row.typed));
  }
  return std::nullopt;
}

/// A parameter of materials that is written as if it were an option.
std::optional<std::string> hintByParameter(const Command& command, const std::string& word) {
  if (!hasOption(command, "set")) return std::nullopt;
  for (const Option<Material>& parameter : materialParameters())
    if (squashed(parameter.text.name) == word) return didYouMean("--set " + std::string(parameter.text.name) + "=");
  return std::nullopt;
}

/// What to type for the parameter of materials that a word may be a slip of the finger for: "--set metallic=". Nothing
/// where one of the options is as near. A parameter of which the word is only a part is not meant: many end in "scale".
///
/// options   with their dashes
std::optional<std::string> settingNearest(const Command& command, std::string_view written,
                                          const std::vector<std::string_view>& options) {
  constexpr std::size_t kMostMissing = 3;
  if (!hasOption(command, "set")) return std::nullopt;
  std::map<std::string, std::string> typed;
  for (const Synonyms& row : kOptionSynonyms)
    if (row.name == "set")
      for (const std::string& word : split(row.words, ' ')) typed.emplace(word, row.typed);
  for (const Option<Material>& parameter : materialParameters())
    typed.emplace(parameter.text.name, "--set " + std::string(parameter.text.name) + "=");
  std::vector<std::string_view> words = options;
  for (const auto& [word, setting] : typed) words.push_back(word);
  const auto nearest = nearestWord(written, words);
  const auto found = nearest ? typed.find(std::string(*nearest)) : typed.end();
  if (found == typed.end() || found->first.size() > squashed(written).size() + kMostMissing) return std::nullopt;
  return found->second;
}

}  // namespace

std::optional<std::string> hintForOption(const Command& command, std::string_view written) {
  const std::string word = squashed(written);
  if (auto hint = hintBySynonym(command, word)) return hint;
  if (auto hint = hintByParameter(command, word)) return hint;
  if (hasOption(command, "exposure"))
    for (const AbsentFeature& feature : kAbsentFeatures)
      if (hasWord(feature.words, word)) return std::string(feature.hint);
  std::vector<std::string> options{"--help", "--version"};
  for (const CommandOption& option : command.options) {
    options.push_back(dashed(option.text.name));
    if (!option.text.also.empty()) options.push_back(dashed(option.text.also));
  }
  const std::vector<std::string_view> names(options.begin(), options.end());
  std::vector<std::string> meant;
  if (auto setting = settingNearest(command, written, names)) meant.push_back(std::move(*setting));
  if (const auto nearest = nearestWord(written, names)) meant.emplace_back(*nearest);
  return meant.empty() ? std::nullopt : std::optional(didYouMean(join(meant, ", ", " or ")));
}

std::optional<std::string> hintForWord(const Command& command, const std::string& word) {
  if (parseNumber(word)) return "numbers of one option have commas between, as in 30,15";
  if (hasOption(command, "material") && indexOfName(word, materialNames())) return didYouMean("--material " + word);
  std::error_code status;
  const bool exists = std::filesystem::exists(word, status);
  const bool may_be_light = isBuiltinEnvironment(word) || (exists && !modelFormatOf(word));
  if (hasOption(command, "env") && may_be_light) return "for its light say -e " + word;
  if (hasOption(command, "env") && (contains(builtinModelNames(), word) || (exists && modelFormatOf(word))))
    return "one model is drawn at a time; a glTF file may hold several";
  if (hasOption(command, "output") && isOutputName(word) && !exists) return "to write it say -o " + word;
  return std::nullopt;
}

std::optional<std::string_view> commandMeantBy(std::string_view word, std::span<const Command> commands) {
  for (const Synonyms& row : kCommandSynonyms)
    if (hasWord(row.words, squashed(word))) return row.name;
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return nearestWord(word, names);
}

}  // namespace mirrorball::cli
