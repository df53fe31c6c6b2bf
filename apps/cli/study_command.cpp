#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interruption.h"
#include "cli/scene_inputs.h"
#include "cli/stage_clock.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/text.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/study/page/page.h"
#include "mirrorball/study/study.h"

namespace mirrorball::cli {
namespace {

struct StudyFiles {
  std::string output = "study.html";
};

const auto kStudyFileOptions = std::to_array<Option<StudyFiles>>({
    {{.name = "output",
      .value = "OUT",
      .help = "the page, .html; -.html is standard output",
      .letter = "o",
      .group = "Files",
      .takes_path = true},
     &StudyFiles::output},
});

/// All that `study` was told.
struct StudyRequest {
  SceneRequest scene = {.model = ""};
  StudyFiles files;
  StudySettings settings;
  MaterialChanges materials;
  GivenOptions given;

  bool isBuiltIn() const { return scene.model.empty(); }
};

/// errors   usage
Result<void> check(const StudyRequest& request) {
  const std::string& output = request.files.output;
  if (extensionOf(output) != "html") return fail(ErrorCode::usage, output + ": a study is a page, .html");
  if (request.scene.model == "none") return fail(ErrorCode::usage, "none has no surface to study; name a model");
  MIRRORBALL_TRY_VOID(checkFolder(output));
  if (!request.isBuiltIn()) return {};
  constexpr std::array<std::string_view, 9> kOfScene{"material", "set",    "fresnel", "up",          "animation",
                                                     "camera",   "target", "fov",     "orthographic"};
  for (const std::string_view name : kOfScene)
    if (request.given.contains(name))
      return fail(ErrorCode::usage, "--" + std::string(name) +
                                        " is for a scene; name one, as in `mirrorball study sphere --" +
                                        std::string(name) + " …`");
  return {};
}

/// A word as a shell takes it: in single quotes where it has more than letters, digits and a path's marks.
std::string shellWord(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// " --name value" for each option that is not as it was.
template <typename Target>
std::string changesOf(std::type_identity_t<std::span<const Option<Target>>> table, const Target& target,
                      const Target& usual) {
  std::string changes;
  for (const Option<Target>& option : table)
    if (const std::string value = written(option, target); value != written(option, usual))
      changes += " --" + std::string(option.text.name) + (option.isFlag() ? "" : " " + shellWord(value));
  return changes;
}

/// The command line that makes the page again.
std::string commandOf(const StudyRequest& request) {
  const StudyRequest usual;
  std::string command = "mirrorball study" + (request.isBuiltIn() ? "" : " " + shellWord(request.scene.model));
  command += changesOf(materialOptions(), request.materials, usual.materials);
  for (const std::string& assignment : request.materials.set) command += " --set " + shellWord(assignment);
  return command + changesOf(sceneOptions(), request.scene, usual.scene) +
         changesOf(stanceOptions(), request.scene.stance, usual.scene.stance) +
         changesOf(studyFrameOptions(), request.settings.frame, usual.settings.frame) +
         changesOf(studyOptions(), request.settings, usual.settings) + " --output " + shellWord(request.files.output);
}

/// "sphere of rough-metal in room.hdr"
std::string titleOf(const StudyRequest& request) {
  const auto nameOf = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  const std::string place = " in " + nameOf(request.scene.environment);
  if (request.isBuiltIn()) return "Environment mapping against the truth" + place;
  const std::string& material = request.materials.material;
  return nameOf(request.scene.model) + (material.empty() ? "" : " of " + material) + place;
}

/// A progress bar. From the first whole subject on, an interruption waits for the page so far to be written, however
/// long the step takes that it comes in.
StudyObserver observerUntilInterrupted() {
  return {.progress = progressBar("study", "steps"), .section_done = claimEnd};
}

Result<void> studyAndWrite(const StudyRequest& request, const std::string& command) {
  StageClock clock;
  const std::string& output = request.files.output;
  SceneRequest scene = request.scene;
  if (request.isBuiltIn()) scene.model = "none";
  FrameSettings look = request.settings.frame;
  MIRRORBALL_TRY(inputs, loadInputs(scene, request.materials, look, {}, {&output, 1}, clock));
  MIRRORBALL_TRY(made, clock.time("pictures: draw, trace, compare", [&] {
    return study(std::move(inputs), request.isBuiltIn(), request.settings, observerUntilInterrupted());
  }));
  MIRRORBALL_TRY(
      page, clock.time("page: encode", [&] { return pageOf(made, {.title = titleOf(request), .made_by = command}); }));
  MIRRORBALL_TRY_VOID(clock.time("page: write", [&] {
    return writeFile(output, {reinterpret_cast<const std::uint8_t*>(page.data()), page.size()});
  }));
  if (request.scene.timings) clock.print();
  announce(output);
  if (made.isInterrupted())
    return fail(ErrorCode::interrupted, "interrupted; " + output + " has " + std::to_string(made.sections.size()) +
                                            " of " + counted(made.planned, "subject"));
  return {};
}

}  // namespace

Command studyCommand() {
  auto request = std::make_shared<StudyRequest>();
  Command command{
      .name = "study",
      .help = "Shows every technique beside the path-traced reference, on one page with pictures, errors and costs",
      .about = "SCENE is a file (" + modelExtensions() +
               "), a built-in, or - for standard input. Without it, the page has all subjects, each with a built-in "
               "scene that shows it. The page needs no network.",
      .examples = {{"study -o page.html", "all subjects, in the built-in studio; some minutes"},
                   {"study sphere --material rough-metal -e room.hdr -o page.html", "what applies to one scene"}}};
  addArgument(command,
              {.name = "SCENE",
               .help = "the scene to study; without it, the built-in scenes of all subjects",
               .names = builtinModelNames,
               .takes_path = true},
              request->scene.model);
  addOptions(command, sceneOptions(), request->scene, &request->given);
  addOptions(command, stanceOptions(), request->scene.stance, &request->given);
  addOptions(command, kStudyFileOptions, request->files);
  addOptions(command, studyFrameOptions(), request->settings.frame, &request->given);
  addOptions(command, studyOptions(), request->settings);
  addOptions(command, materialOptions(), request->materials, &request->given);
  command.action = [request]() -> Result<void> {
    MIRRORBALL_TRY_VOID(check(*request));
    const std::string line = commandOf(*request);
    request->settings.frame.proxy.load.inside_only = request->scene.inside_only;
    return withStandardStreams({&request->scene.model, &request->scene.environment}, request->files.output,
                               [&] { return studyAndWrite(*request, line); });
  };
  return command;
}

}  // namespace mirrorball::cli
