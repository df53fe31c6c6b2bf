#include "mirrorball/view/workspace/arguments.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "mirrorball/base/file.h"
#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/texture/texture_file.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/file/face_files.h"
#include "mirrorball/environment/file/load.h"
#include "mirrorball/photo/likely_photograph.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/view/workspace/asked_map.h"
#include "mirrorball/view/workspace/view_request.h"
#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {
namespace {

/// An option of a table, by either of its names.
struct Known {
  OptionTable table;
  OptionText text;
  bool is_flag;
};

/// All of them.
std::vector<Known> knownOptions() {
  std::vector<Known> known;
  const auto add = [&](OptionTable table, auto options) {
    for (const auto& option : options) known.push_back({table, option.text, option.isFlag()});
  };
  add(OptionTable::stance, stanceOptions());
  add(OptionTable::frame, frameOptions());
  add(OptionTable::frame, qualityOptions());
  add(OptionTable::material, materialOptions());
  return known;
}

std::optional<Known> optionNamed(std::string_view name) {
  for (const Known& each : knownOptions())
    if (each.text.name == name || (!each.text.also.empty() && each.text.also == name)) return each;
  return std::nullopt;
}

/// The error of a word that is no option, with the one that is likely meant.
tl::unexpected<Error> unknownOption(const std::string& word) {
  const std::vector<Known> known = knownOptions();
  std::vector<std::string_view> names{"env", "reference"};
  for (const Known& each : known) names.push_back(each.text.name);
  for (const auto& option : windowOptions()) names.push_back(option.text.name);
  const auto meant = nearestWord(std::string_view(word).substr(word.find_first_not_of('-')), names);
  return fail(ErrorCode::usage,
              "there is no option " + excerpt(word) + (meant ? "; did you mean --" + std::string(*meant) + "?" : ""));
}

/// Words that are read one after the other.
class Words {
 public:
  explicit Words(std::span<const std::string> words) : left_(words) {}

  bool empty() const { return left_.empty(); }
  const std::string& next() {
    const std::string& word = left_.front();
    left_ = left_.subspan(1);
    return word;
  }
  /// The value of an option, which is the next word unless it stands in the same.
  ///
  /// errors   usage: there is none
  Result<std::string> valueOf(std::string_view option, std::optional<std::string> in_same_word) {
    if (in_same_word) return *in_same_word;
    if (empty()) return fail(ErrorCode::usage, std::string(option) + " needs a value");
    return next();
  }

 private:
  std::span<const std::string> left_;
};

/// The first bytes of a file.
///
/// errors   as FileReader::open's
Result<Bytes> beginOf(const std::string& path) {
  MIRRORBALL_TRY(file, FileReader::open(path));
  Bytes bytes(64);
  MIRRORBALL_TRY(count, file.readAt(0, bytes));
  bytes.resize(count);
  return bytes;
}

/// What is said in one or two words of a command line: a file to open, or an option.
struct Said {
  bool is_file = false;
  bool is_environment = false;  ///< a file that -e names
  std::string word;             ///< the file, or the option as it is written
  std::optional<Known> option = {};
  std::string text = {};  ///< the option's
};

/// errors   usage
Result<Said> saidNext(Words& words) {
  const std::string& word = words.next();
  const bool is_long = word.starts_with("--");
  if (!is_long && (word.size() < 2 || word.front() != '-')) return Said{.is_file = true, .word = word};
  const std::size_t equals = is_long ? word.find('=') : std::string::npos;
  const std::string name = word.substr(is_long ? 2 : 1, equals == std::string::npos ? equals : equals - 2);
  std::optional<std::string> value;
  if (equals != std::string::npos) value = word.substr(equals + 1);
  if (name == (is_long ? "env" : "e")) {
    MIRRORBALL_TRY(map, words.valueOf(word, std::move(value)));
    return Said{.is_file = true, .is_environment = true, .word = std::move(map)};
  }
  if (name == "reference" && is_long && !value) return Said{.word = word};
  const auto known = is_long ? optionNamed(name) : std::nullopt;
  if (!known) return unknownOption(word.substr(0, equals));
  if (known->is_flag && !value) value = "yes";
  MIRRORBALL_TRY(text, words.valueOf(word, std::move(value)));
  return Said{.word = word, .option = known, .text = std::move(text)};
}

/// Where a command writes the panorama of a photograph: "ball.jpg" becomes "ball_unwrapped.exr".
std::string unwrappedName(const std::string& photograph) {
  const std::filesystem::path path(photograph);
  return (path.parent_path() / (path.stem().string() + "_unwrapped.exr")).string();
}

/// A word as a shell reads it.
std::string quotedForShell(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:,=%+@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

void addOptions(const GivenTexts& given, std::vector<std::string>& words) {
  for (const auto& [name, texts] : given)
    for (const std::string& text : texts) words.push_back("--" + name + "=" + text);
}

/// The words after `mirrorball photo` that unwrap a photograph.
std::vector<std::string> photoArguments(const AskedMap& map) {
  std::vector<std::string> words{map.name};
  addOptions(*map.photo, words);
  words.insert(words.end(), {"-o", unwrappedName(map.name)});
  return words;
}

/// A line for a shell.
std::string lineOf(const std::string& command, const std::vector<std::string>& words) {
  std::string line = "mirrorball " + command;
  for (const std::string& word : words) line += " " + quotedForShell(word);
  return line;
}

}  // namespace

Result<Workspace> workspaceOf(std::span<const std::string> arguments) {
  std::vector<Said> all;
  for (Words words(arguments); !words.empty();) {
    MIRRORBALL_TRY(said, saidNext(words));
    all.push_back(std::move(said));
  }
  const Workspace start;
  Workspace workspace = start;
  bool names_environment = false, is_builtin = true;
  // Another model forgets what was said of the one before, so files come first.
  for (const Said& said : all) {
    if (!said.is_file) continue;
    names_environment = names_environment || said.is_environment;
    is_builtin = is_builtin && (said.is_environment || contains(builtinModelNames(), said.word));
    MIRRORBALL_TRY(next, said.is_environment ? Result<Workspace>(withOnlyMap(std::move(workspace), said.word))
                                             : withFile(std::move(workspace), said.word));
    workspace = std::move(next);
    // The first panorama that is opened takes the place of the one that nobody has asked for.
    if (!names_environment && workspace.maps.size() == 2 && workspace.maps.front() == start.maps.front()) {
      const std::string opened = workspace.maps.back();
      workspace = withOnlyMap(std::move(workspace), opened);
    }
  }
  bool wants_truth = false;
  for (const Said& said : all) {
    wants_truth = wants_truth || (!said.is_file && !said.option);
    if (!said.option) continue;
    MIRRORBALL_TRY(next, withOption(std::move(workspace), said.option->table, said.option->text.name, said.text));
    workspace = std::move(next);
  }
  if (wants_truth && !isTraced(workspace, 0) && !isTraced(workspace, 1)) workspace = withTruth(std::move(workspace));
  if (is_builtin && !names_environment && workspace.model == start.model) return withShowcase(std::move(workspace));
  return workspace;
}

std::string typedPath(const std::string& text) {
  const char* const home = std::getenv("HOME");
  const bool is_in_home = text == "~" || text.rfind("~/", 0) == 0;
  return is_in_home && home != nullptr ? home + text.substr(1) : text;
}

Result<std::vector<std::string>> renderArguments(const Workspace& workspace, std::size_t side) {
  if (!workspace.parameters.empty())
    return fail(ErrorCode::unsupported,
                "single materials were changed, which no option of render says; save a workspace instead");
  const AskedMap map = askedMap(workspace, side);
  std::vector<std::string> words{workspace.model, "-e", map.photo ? unwrappedName(map.name) : map.name};
  if (isTraced(workspace, side)) words.emplace_back("--reference");
  addOptions(workspace.stance, words);
  addOptions(givenFrame(workspace, side), words);
  addOptions(workspace.materials, words);
  return words;
}

Result<std::string> renderCommandLine(const Workspace& workspace, std::size_t side) {
  MIRRORBALL_TRY(words, renderArguments(workspace, side));
  std::string line;
  if (const AskedMap map = askedMap(workspace, side); map.photo) line = lineOf("photo", photoArguments(map)) + " && ";
  return line + lineOf("render", words);
}

Result<Workspace> withFile(Workspace workspace, const std::string& path) {
  if (contains(builtinModelNames(), path)) return withModel(std::move(workspace), path);
  if (isBuiltinEnvironment(path)) return withMap(std::move(workspace), path);
  if (std::filesystem::is_directory(path)) {
    MIRRORBALL_TRY_VOID(faceFilesIn(path));
    return withMap(std::move(workspace), path);
  }
  if (modelFormatOf(path)) return withModel(std::move(workspace), path);
  MIRRORBALL_TRY(begin, beginOf(path));
  if (isImage(begin) || isImageSet(begin)) {
    // What cannot be read is told when it is loaded.
    const bool is_photograph = isImage(begin) && !cubeFilesOf(path, {}) && isLikelyPhotograph(path).value_or(false);
    workspace = withMap(std::move(workspace), path);
    if (is_photograph) workspace.photos.try_emplace(path);
    return workspace;
  }
  if (!begin.empty() && begin.front() == '{') return loadWorkspace(path);
  return fail(ErrorCode::unsupported,
              path + ": is no model (" + modelExtensions() + "), no picture of an environment and no workspace");
}

std::vector<std::string> filesToOpen(std::span<const std::string> paths) {
  std::vector<std::string> files;
  std::set<std::filesystem::path> stood_for;
  for (const std::string& path : paths) {
    if (stood_for.contains(path)) continue;
    files.push_back(path);
    if (const auto faces = cubeFilesOf(path, {})) stood_for.insert(faces->paths.begin(), faces->paths.end());
  }
  return files;
}

}  // namespace mirrorball
