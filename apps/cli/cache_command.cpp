#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/interruption.h"
#include "cli/picture_request.h"
#include "cli/render_frames.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/cache_folder.h"
#include "mirrorball/base/memory.h"
#include "mirrorball/base/text.h"
#include "mirrorball/gl/context.h"
#include "mirrorball/gl/driver_cache.h"
#include "mirrorball/render/frame/warm_up.h"

namespace mirrorball::cli {
namespace {

constexpr std::array<std::string_view, 3> kActions{"show", "clear", "warm"};
std::span<const std::string_view> cacheActionNames() { return kActions; }

constexpr const char* kNoCache = "there is no cache: MIRRORBALL_CACHE is empty, or there is no home folder";

std::string contentsText(const CacheFolder::Contents& contents) {
  if (contents.files == 0) return "nothing";
  return counted(contents.files, "file") + ", " + textOfBytes(contents.bytes);
}

std::string folderRow(const std::filesystem::path& folder) {
  return "folder       " + printable(folder.string()) + "\n";
}

/// The driver's own cache, which is only looked at.
void showDriversCache() {
  const auto context = gl::Context::createHeadless();
  if (!context) return print("driver       none: " + context.error().message + "\n");
  print("driver       " + context->renderer() + "\n");
  const auto cache = gl::findDriverCache(context->version());
  if (!cache) return print("folder       where this driver keeps compiled shaders, if it does, is not known\n");
  for (const std::filesystem::path& folder : cache->folders) print(folderRow(folder));
  const std::string state = !cache->is_on   ? "by the driver's version: older ones keep nothing for root unless it is 1"
                            : *cache->is_on ? "on"
                                            : "off";
  print("is           " + state + " (" + cache->switch_name + ")\n");
  print("holds        " + contentsText(cache->contents()) +
        ": compiled shaders of all programs; without them first pictures are slow again, and `cache clear` leaves "
        "them\n");
}

Result<void> show() {
  MIRRORBALL_TRY(cache, CacheFolder::ofUser());
  if (cache) {
    print(folderRow(cache->folder()));
    if (const auto usable = cache->check(); !usable) remark(usable.error().message);
    print("holds        " + contentsText(cache->contents()) + "\n");
    print("at most      " + (cache->maxBytes() == 0 ? "nothing" : textOfBytes(cache->maxBytes())) +
          " (MIRRORBALL_CACHE_SIZE); what was not used for longest goes first\n");
  } else {
    print(std::string(kNoCache) + "\n");
  }
  print("\n");
  showDriversCache();
  return {};
}

Result<void> clear() {
  MIRRORBALL_TRY(cache, CacheFolder::ofUser());
  if (!cache) {
    print(std::string(kNoCache) + "\n");
    return {};
  }
  print(folderRow(cache->folder()));
  MIRRORBALL_TRY(removed, cache->clear());
  print("removed      " + contentsText(removed) + "\n");
  return {};
}

/// What decides about the programs of pictures.
struct WarmRequest : PictureRequest {
  PictureForm form = {};
  Turntable turntable = {};
};

/// Prepares what `render` of one model prepares.
///
/// is_first   the driver's cache has not been reported on yet
Result<void> warmModel(WarmRequest request, bool is_first) {
  StageClock clock;
  setTheStage(request);
  request.scene.objects_move = request.turntable.turn == Turn::object;
  MIRRORBALL_TRY(settings, checkedFrame(request));
  if (request.form.gain_map) settings = settingsForGainMap(std::move(settings));
  MIRRORBALL_TRY(inputs, loadInputs(request.scene, request.materials, settings, request.stated, {}, clock));
  MIRRORBALL_TRY_VOID(checkShown(settings, inputs.scene));
  remarkOnIdleOptions(inputs.scene, settings, request.stated);
  const auto drivers = gl::findDriverCache(inputs.context.version());
  if (is_first && drivers && drivers->is_on == false)
    remark("the driver's cache is off (" + drivers->switch_name + "), so that it keeps no compiled shaders");
  const std::string& model = request.scene.model;
  const Shown shown = request.form.primaries == OutputPrimaries::rec709 ? Shown::picture : Shown::light;
  MIRRORBALL_TRY_VOID(clock.time(
      "programs", [&] { return warmUp(std::move(inputs), settings, progressBar(model, "programs"), shown); }));
  if (request.scene.timings) clock.print();
  tell("ready        " + model);
  return {};
}

Result<void> warm(WarmRequest request, std::vector<std::string> models) {
  constexpr const char* kInterrupted = "interrupted; what was prepared until now stays in the caches";
  if (request.scene.is_uncached)
    return fail(ErrorCode::usage,
                "--no-cache leaves the cache as it is, and `cache warm` fills it; leave one of them out");
  MIRRORBALL_TRY_VOID(checkTurn(request.turntable));
  MIRRORBALL_TRY(cache, CacheFolder::ofUser());
  if (!cache || cache->maxBytes() == 0) remark("prefiltered environments and occlusion are not kept; see `cache show`");
  if (models.empty()) models.push_back(request.scene.model);
  std::vector<std::string*> inputs = pointersTo(models);
  inputs.push_back(&request.scene.environment);
  MIRRORBALL_TRY_VOID(readStandardInput(inputs));
  whenInterrupted(kInterrupted);
  for (const std::string& model : models) {
    request.scene.model = model;
    const Result<void> warmed = warmModel(request, &model == &models.front());
    if (!warmed && warmed.error().code == ErrorCode::interrupted) return fail(ErrorCode::interrupted, kInterrupted);
    MIRRORBALL_TRY_VOID(warmed);
  }
  return {};
}

/// All that `cache` was asked for.
struct CacheRequest {
  std::string action = "show";
  std::vector<std::string> models = {};
  WarmRequest picture = {};
  std::string picture_option = {};  ///< the first on the command line
};

/// errors   usage: an action that prepares no picture has a model or one of its options
Result<void> refusePicture(const CacheRequest& request) {
  if (request.models.empty() && request.picture_option.empty()) return {};
  const std::string unused =
      request.models.empty() ? "--" + request.picture_option : "'" + request.models.front() + "'";
  return fail(ErrorCode::usage, unused + " is for `cache warm`, and `cache " + request.action + "` takes none");
}

Result<void> act(const CacheRequest& request) {
  const auto action = indexOfName(request.action, kActions);
  if (!action) return tl::unexpected<Error>(unknownName("action of cache", request.action, kActions));
  if (kActions[*action] == "warm") return warm(request.picture, request.models);
  MIRRORBALL_TRY_VOID(refusePicture(request));
  return kActions[*action] == "clear" ? clear() : show();
}

}  // namespace

Command cacheCommand() {
  auto request = std::make_shared<CacheRequest>();
  Command command{
      .name = "cache",
      .help = "Shows, clears or fills the cache of prefiltered environments and of the occlusion of models",
      .about =
          "ACTION is `show` (the default), which shows the graphics driver's cache of compiled shaders, too; "
          "`clear`, which leaves the driver's as it is; or `warm`, which prepares all that `render` of each MODEL "
          "with the same options waits for before its first picture, the driver's shaders among it, and writes no "
          "picture. The options below MODEL are those of `render`, for `warm` alone; where `render` writes radiance, "
          "to "
          "a file such as .exr, they are with --resolve radiance.",
      .examples = {{"cache show", "where the caches are, and how large"},
                   {"cache warm helmet.glb -e garden.hdr --stand",
                    "the next `render` with these options starts its picture at once"}}};
  addArgument(command, {.name = "ACTION", .help = "show, clear or warm (default show)", .names = cacheActionNames},
              request->action);
  addArgument(command, modelArgument("MODEL", request->picture.scene.model), request->models);
  addPictureOptions(command, request->picture);
  addPictureForm(command, request->picture.form);
  addOptions(command, turntableOptions(), request->picture.turntable, &request->picture.stated);
  for (CommandOption& option : command.options)
    option.set = [set = std::move(option.set), request,
                  name = std::string(option.text.name)](const std::string& value) {
      if (request->picture_option.empty()) request->picture_option = name;
      return set(value);
    };
  command.action = [request] { return act(*request); };
  return command;
}

}  // namespace mirrorball::cli
