#include "mirrorball/view/workspace/workspace_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "mirrorball/base/file.h"
#include "mirrorball/base/json_reader.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/view/workspace/asked_map.h"

namespace mirrorball {
namespace {

using Json = nlohmann::ordered_json;

// By CompareBy.
constexpr std::array<std::string_view, 5> kCompareBy{"none", "slider", "flip", "difference", "flip-error"};

constexpr std::size_t kVersion = 1;

// More than a person makes; a file may say anything.
constexpr std::size_t kMostTexts = 10000;
constexpr std::size_t kLargestFile = std::size_t{16} << 20;

Json jsonOf(const GivenTexts& given) {
  Json json = Json::object();
  for (const auto& [name, texts] : given) {
    if (texts.size() == 1)
      json[name] = texts.front();
    else
      json[name] = texts;
  }
  return json;
}

Json jsonOf(const Side& side) {
  Json json = Json::object();
  if (!side.frame.empty()) json["frame"] = jsonOf(side.frame);
  if (side.map) json["map"] = *side.map;
  if (side.is_traced) json["traced"] = true;
  return json;
}

GivenTexts textsOf(const JsonReader& json) {
  GivenTexts given;
  for (const auto& [name, value] : json.members()) {
    std::vector<std::string>& texts = given[name];
    if (value.isArray())
      for (const JsonReader& text : value.elements()) texts.push_back(text.text(""));
    else
      texts.push_back(value.text(""));
    if (texts.size() > kMostTexts) value.refuse("has more texts than can be");
  }
  return given;
}

Side sideOf(const JsonReader& json) {
  Side side{.frame = textsOf(json["frame"]), .is_traced = json["traced"].flag(false)};
  if (json["map"].exists()) side.map = json["map"].size(0);
  return side;
}

/// errors   bad_file
Result<Workspace> fromJson(const nlohmann::json& document) {
  JsonProblem problem;
  const JsonReader json(&document, "", problem);
  if (!json["mirrorball_workspace"].exists())
    return fail(ErrorCode::bad_file, "is no workspace: it has no key mirrorball_workspace");
  if (json["mirrorball_workspace"].size(0) != kVersion)
    return fail(ErrorCode::unsupported, "is a workspace of another version than " + std::to_string(kVersion));
  Workspace workspace;
  workspace.model = json["model"].text(workspace.model);
  if (json["maps"].exists()) {
    workspace.maps.clear();
    for (const JsonReader& map : json["maps"].elements()) workspace.maps.push_back(map.text(""));
    if (workspace.maps.empty() || workspace.maps.size() > kMostTexts) json["maps"].refuse("has none, or too many");
  }
  for (const auto& [name, given] : json["photos"].members()) workspace.photos[name] = textsOf(given);
  workspace.shown_map = json["shown_map"].size(0);
  workspace.stance = textsOf(json["stance"]);
  workspace.plays = json["plays"].flag(false);
  workspace.frame = textsOf(json["frame"]);
  workspace.materials = textsOf(json["materials"]);
  for (const auto& [index, parameters] : json["parameters"].members()) {
    const auto number = parseNumber(index).value_or(-1.0);
    const bool is_number = number >= 0.0 && number <= 1e9 && std::to_string(static_cast<std::size_t>(number)) == index;
    if (!is_number)
      parameters.refuse("is no material's number");
    else
      workspace.parameters[static_cast<std::size_t>(number)] = textsOf(parameters);
  }
  const JsonReader::Elements sides = json["sides"].elements();
  for (std::size_t i = 0; i < std::min(sides.size(), workspace.sides.size()); ++i)
    workspace.sides[i] = sideOf(sides[i]);
  const std::string compare_by = json["compare_by"].text("none");
  const auto found = std::find(kCompareBy.begin(), kCompareBy.end(), compare_by);
  if (found == kCompareBy.end())
    json["compare_by"].refuse("is none of " + join(kCompareBy));
  else
    workspace.compare_by = static_cast<CompareBy>(found - kCompareBy.begin());
  workspace.divider = std::clamp(static_cast<float>(json["divider"].number(0.5)), 0.0f, 1.0f);
  workspace.edited_side = json["edited_side"].size(0);
  if (json["selected_material"].exists()) workspace.selected_material = json["selected_material"].size(0);
  workspace.inspects = json["inspects"].flag(false);
  workspace.shows_map = json["shows_map"].flag(false);
  workspace.map_view = textsOf(json["map_view"]);
  if (problem.any()) return fail(ErrorCode::bad_file, problem.message);
  return workspace;
}

/// errors   bad_file: it points beyond what there is; usage
Result<void> checkWorkspace(const Workspace& workspace) {
  const auto is_map = [&](std::size_t map) { return map < workspace.maps.size(); };
  if (!is_map(workspace.shown_map)) return fail(ErrorCode::bad_file, "shown_map is none of its maps");
  if (workspace.edited_side >= workspace.sides.size())
    return fail(ErrorCode::bad_file, "edited_side is neither 0 nor 1");
  for (std::size_t side = 0; side < workspace.sides.size(); ++side) {
    const Side& each = workspace.sides[side];
    if (each.map && !is_map(*each.map))
      return fail(ErrorCode::bad_file, "sides[" + std::to_string(side) + "].map is none of its maps");
    for (const auto& [name, texts] : each.frame)
      if (isShared(name)) return fail(ErrorCode::bad_file, "sides: " + excerpt(name) + " is of both");
    MIRRORBALL_TRY_VOID(frameOf(each.frame));
    MIRRORBALL_TRY_VOID(qualityOf(each.frame));
  }
  MIRRORBALL_TRY_VOID(frameOf(workspace.frame));
  MIRRORBALL_TRY_VOID(qualityOf(workspace.frame));
  MIRRORBALL_TRY_VOID(stanceOf(workspace.stance));
  MIRRORBALL_TRY_VOID(materialsOf(workspace.materials));
  MIRRORBALL_TRY_VOID(mapViewOf(workspace));
  for (const auto& [name, given] : workspace.photos) {
    if (!contains(workspace.maps, name))
      return fail(ErrorCode::bad_file, "photos: " + excerpt(name) + " is none of its maps");
    MIRRORBALL_TRY_VOID(ballPhotoOf(given));
  }
  Material tried;
  for (const auto& [material, given] : workspace.parameters) MIRRORBALL_TRY_VOID(setParameters(given, tried));
  return {};
}

bool isBuiltin(std::string_view name) { return contains(builtinModelNames(), name) || isBuiltinEnvironment(name); }

std::filesystem::path wholePath(const std::string& name) {
  std::error_code error;
  return std::filesystem::absolute(name, error).lexically_normal();
}

/// The name of a file, seen from the folder of another one if it lies in it, else absolute.
std::string nameBeside(const std::string& other, const std::string& name) {
  const std::filesystem::path whole = wholePath(name);
  const std::filesystem::path within = whole.lexically_relative(wholePath(other).parent_path());
  return (within.empty() || *within.begin() == ".." ? whole : within).string();
}

/// Changes the names of all files that a workspace shows.
template <typename Change>
Workspace withNames(Workspace workspace, const Change& change) {
  const auto changed = [&](const std::string& name) { return isBuiltin(name) || name.empty() ? name : change(name); };
  workspace.model = changed(workspace.model);
  for (std::string& map : workspace.maps) map = changed(map);
  std::map<std::string, GivenTexts> photos;
  for (auto& [name, given] : workspace.photos) photos[changed(name)] = std::move(given);
  workspace.photos = std::move(photos);
  return workspace;
}

}  // namespace

std::string writtenWorkspace(const Workspace& workspace) {
  Json json{{"mirrorball_workspace", kVersion},
            {"model", workspace.model},
            {"maps", workspace.maps},
            {"shown_map", workspace.shown_map}};
  if (!workspace.stance.empty()) json["stance"] = jsonOf(workspace.stance);
  if (workspace.plays) json["plays"] = true;
  for (const auto& [name, given] : workspace.photos) json["photos"][name] = jsonOf(given);
  if (!workspace.frame.empty()) json["frame"] = jsonOf(workspace.frame);
  if (!workspace.materials.empty()) json["materials"] = jsonOf(workspace.materials);
  for (const auto& [material, given] : workspace.parameters)
    json["parameters"][std::to_string(material)] = jsonOf(given);
  if (workspace.sides != std::array<Side, 2>())
    json["sides"] = {jsonOf(workspace.sides[0]), jsonOf(workspace.sides[1])};
  json["compare_by"] = kCompareBy[static_cast<std::size_t>(workspace.compare_by)];
  json["divider"] = workspace.divider;
  json["edited_side"] = workspace.edited_side;
  if (workspace.selected_material) json["selected_material"] = *workspace.selected_material;
  if (workspace.inspects) json["inspects"] = true;
  if (workspace.shows_map) json["shows_map"] = true;
  if (!workspace.map_view.empty()) json["map_view"] = jsonOf(workspace.map_view);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Workspace> readWorkspace(std::string_view json) {
  const auto document = nlohmann::json::parse(json.begin(), json.end(), nullptr, /*allow_exceptions=*/false);
  if (document.is_discarded()) return fail(ErrorCode::bad_file, "is no JSON");
  MIRRORBALL_TRY(workspace, fromJson(document));
  MIRRORBALL_TRY_VOID(checkWorkspace(workspace));
  return workspace;
}

Result<void> refuseInputs(const Workspace& workspace, const std::string& path) {
  std::vector<std::string> inputs = workspace.maps;
  inputs.push_back(workspace.model);
  std::error_code error;
  for (const std::string& input : inputs)
    if (std::filesystem::equivalent(input, path, error) && !error)
      return fail(ErrorCode::usage, path + ": is shown, and would be lost; choose another name");
  return {};
}

Result<void> saveWorkspace(const std::string& path, const Workspace& workspace) {
  MIRRORBALL_TRY_VOID(refuseInputs(workspace, path));
  std::error_code error;
  if (std::filesystem::exists(path, error) && !loadWorkspace(path))
    return fail(ErrorCode::usage, path + ": is there already and no workspace; choose another name");
  const std::string text =
      writtenWorkspace(withNames(workspace, [&](const std::string& name) { return nameBeside(path, name); }));
  return writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

Result<Workspace> loadWorkspace(const std::string& path) {
  MIRRORBALL_TRY(bytes, readFile(path, kLargestFile));
  MIRRORBALL_TRY(read, withName(path, readWorkspace({reinterpret_cast<const char*>(bytes.data()), bytes.size()})));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return withNames(std::move(read), [&](const std::string& name) { return (folder / name).string(); });
}

}  // namespace mirrorball
