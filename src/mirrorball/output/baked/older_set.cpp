#include "mirrorball/output/baked/older_set.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/output/baked/baked_manifest.h"
#include "mirrorball/output/lamps/lamp_files.h"

namespace mirrorball {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Manifests of ours are 20 kB with a picture for each face and level.
constexpr std::uintmax_t kLargestManifest_bytes = std::uintmax_t{1} << 20;
/// Theirs is 4: the names of a level's pictures. Functions that call themselves go no deeper.
constexpr int kDeepestManifest = 16;

/// errors   as readFile's; bad_file: it is another file of that name
Result<Json> readManifest(const fs::path& path) {
  MIRRORBALL_TRY(text, readFile(path, kLargestManifest_bytes));
  bool is_too_deep = false;
  const auto stayAbove = [&](int depth, Json::parse_event_t, Json&) {
    is_too_deep = is_too_deep || depth > kDeepestManifest;
    return !is_too_deep;
  };
  Json manifest = Json::parse(text.begin(), text.end(), stayAbove, false);
  if (is_too_deep || !manifest.is_object())
    return fail(ErrorCode::bad_file, path.string() + ": does not describe a set of baked maps");
  return manifest;
}

/// All names of files that a manifest has, whatever it is; of the depth that readManifest passes.
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

// What a manifest has, by what it depends on.
constexpr std::array<std::string_view, 3> kCubeKeys{"specular", "irradiance", "skybox"};
constexpr std::array<std::string_view, 3> kOtherLightKeys{"harmonics", "lamps", "packed"};
constexpr std::array<std::string_view, 2> kTableKeys{"brdf", "lobe_rows"};
constexpr std::array<std::string_view, 1> kAboutAllKeys{"made_by"};
constexpr std::array<std::string_view, 3> kAboutLightKeys{"source", "light_hash", "rotate_deg"};
constexpr std::array<std::string_view, 1> kAboutCubeKeys{"faces"};

using Keys = std::span<const std::string_view>;

bool hasAny(const Json& manifest, Keys keys) {
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return manifest.contains(key); });
}

/// Some of a manifest, as far as it is there.
Json copied(const Json& manifest, Keys keys) {
  Json copy = Json::object();
  for (const std::string_view key : keys)
    if (const auto found = manifest.find(std::string(key)); found != manifest.end()) copy[found.key()] = *found;
  return copy;
}

/// Whether a set has the part that a key is for.
bool hasPart(const BakedFiles& files, std::string_view key) {
  if (key == "specular") return files.specular.has_value();
  if (key == "irradiance") return files.irradiance.has_value();
  if (key == "skybox") return files.skybox.has_value();
  if (key == "harmonics") return !files.harmonics.empty();
  if (key == "lamps") return !files.lamps.empty();
  if (key == "packed") return !files.packed.empty();
  if (key == "brdf") return files.brdf.has_value();
  return files.lobe_rows.has_value();
}

/// A manifest of those parts that the new set lacks; an empty object where there are none.
Json remainingManifest(const Json& older, const BakedFiles& files) {
  Json parts = Json::object();
  for (const Keys keys : {Keys(kCubeKeys), Keys(kOtherLightKeys), Keys(kTableKeys)})
    for (const std::string_view key : keys)
      if (!hasPart(files, key)) parts.update(copied(older, {&key, 1}));
  if (parts.empty()) return parts;
  Json manifest = copied(older, kAboutAllKeys);
  if (hasAny(parts, kCubeKeys) || hasAny(parts, kOtherLightKeys)) manifest.update(copied(older, kAboutLightKeys));
  if (hasAny(parts, kCubeKeys)) manifest.update(copied(older, kAboutCubeKeys));
  manifest.update(parts);
  return manifest;
}

/// Refuses new parts that do not belong beside those that remain.
///
/// errors   usage
Result<void> checkMatch(const Json& remains, const BakedFiles& files, const std::string& light_hash) {
  const bool has_cubes = hasAny(remains, kCubeKeys);
  const bool has_light = has_cubes || hasAny(remains, kOtherLightKeys);
  const auto refuse = [&](const std::string& what) {
    return fail(ErrorCode::usage, files.folder + ": holds " + what +
                                      "; bake all of it again without {option:only}, or name another folder");
  };
  if (has_light && files.hasLight() && remains.value("light_hash", Json()) != Json(light_hash))
    return refuse("parts of another light");
  if (has_cubes && files.anyCube() != nullptr && remains.value("faces", Json()) != Json(writtenFaces(files)))
    return refuse("cubes whose faces are arranged in another way");
  return {};
}

}  // namespace

std::string manifestText(const Json& manifest) {
  // File names need not be UTF-8, which JSON is.
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<OlderSet> OlderSet::find(const BakedFiles& files, const BakedSetSettings& settings,
                                const std::string& light_hash) {
  OlderSet older;
  if (files.folder.empty()) return older;
  const bool is_whole = settings.only.empty();
  const Result<Json> manifest = readManifest(fs::path(files.folder) / kManifestName);
  if (!manifest) {
    if (is_whole || manifest.error().code == ErrorCode::not_found) return older;
    return fail(manifest.error().code, manifest.error().message +
                                           ", so that it is not known what else the folder holds; bake all of it "
                                           "again without {option:only}, or name another folder");
  }
  collectFiles(*manifest, older.names_);
  if (is_whole) return older;
  older.remains_ = remainingManifest(*manifest, files);
  MIRRORBALL_TRY_VOID(checkMatch(older.remains_, files, light_hash));
  return older;
}

Result<void> OlderSet::makeWay(const BakedFiles& files, const std::vector<std::string>& inputs) const {
  const fs::path folder = files.folder;
  std::error_code status;
  if (remains_.empty()) {
    fs::remove(folder / kManifestName, status);
  } else {
    const std::string text = manifestText(remains_);
    MIRRORBALL_TRY_VOID(
        writeFile(folder / kManifestName, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  }
  std::vector<std::string> remaining;
  collectFiles(remains_, remaining);
  std::vector<fs::path> newer(remaining.begin(), remaining.end());
  for (const std::string& path : files.paths()) newer.push_back(fs::path(path).filename());
  for (const std::string& name : names_) {
    if (!isOurs(name) || contains(newer, fs::path(name))) continue;
    const std::string lies_at = (folder / name).string();
    const bool is_input = std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
      std::error_code missing;
      return fs::equivalent(input, lies_at, missing);
    });
    if (!is_input) fs::remove(lies_at, status);
  }
  return {};
}

}  // namespace mirrorball
