#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/formatted.h"
#include "cli/picture_request.h"
#include "cli/render_frames.h"
#include "cli/render_reference.h"
#include "cli/scene_inputs.h"
#include "cli/stage_clock.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/base/option.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/numbered_paths.h"
#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/render/frame/renderer.h"
#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/model_stance.h"

namespace mirrorball::cli {
namespace {

/// The files of `render` beside those of its scene (scene_inputs.h).
struct RenderFiles {
  std::string output = "mirrorball.png";
};

const std::string kPictureHelp = "the picture file, " + writtenExtensions(Holds::picture) + " (tone mapped) or " +
                                 writtenExtensions(Holds::light) +
                                 " (linear radiance); -.png is standard output, likewise with the other extensions";

const auto kRenderFileOptions = std::to_array<Option<RenderFiles>>({
    {{.name = "output",
      .value = "OUT",
      .help = kPictureHelp,
      .letter = "o",
      .group = "Files",
      .takes_path = true,
      .is_daily = true},
     &RenderFiles::output},
});

/// All that `render` was told.
struct RenderRequest : PictureRequest {
  RenderFiles files;
  PictureForm form;
  Turntable turntable;
  ReferenceOptions reference;
};

/// Whether pictures are to go over the length of an animation.
bool playsAnimation(const RenderRequest& request) {
  const AnimationChoice& choice = request.scene.stance.animation;
  return request.turntable.frames > 0 && !choice.name.empty() && !choice.seconds;
}

/// Whether pictures are to make a full turn.
bool turns(const RenderRequest& request) {
  return request.turntable.frames > 0 && (!playsAnimation(request) || request.stated.contains("turn"));
}

/// errors   usage: a film is asked for
Result<void> refuseFilm(const std::string& output) {
  constexpr std::array<std::string_view, 6> kFilms{"mp4", "mov", "webm", "mkv", "avi", "apng"};
  if (std::ranges::find(kFilms, extensionOf(output)) == kFilms.end()) return {};
  const std::string pictures = std::filesystem::path(output).stem().string() + "_%04d.png";
  return fail(ErrorCode::usage, output + ": Mirrorball writes pictures; --frames 90 -o " + pictures +
                                    " makes those of a turn, and ffmpeg -i " + pictures + " " + output + " the film");
}

/// errors   usage: no such object is in the scene
Result<void> checkObject(const Turntable& turntable, const Scene& scene) {
  const int objects = static_cast<int>(scene.instances.size());
  if (turntable.turn != Turn::object || turntable.object <= objects) return {};
  return fail(ErrorCode::usage, "--turn " + std::to_string(turntable.object) + ": the model has " +
                                    counted(std::size_t(objects), "object"));
}

Result<void> checkOutput(const RenderRequest& request, const FrameSettings& settings) {
  const std::string& output = request.files.output;
  MIRRORBALL_TRY_VOID(refuseFilm(output));
  MIRRORBALL_TRY_VOID(checkTurn(request.turntable));
  const bool turns_view = request.turntable.turn == Turn::camera || request.turntable.turn == Turn::model;
  if (turns(request) && turns_view && !settings.camera.name.empty())
    return fail(ErrorCode::usage, "--frames: the camera '" + settings.camera.name +
                                      "' stands still; give --camera AZIMUTH,ELEVATION, or --turn environment");
  if (playsAnimation(request) && request.turntable.turn == Turn::object)
    return fail(ErrorCode::usage, "--turn " + std::to_string(request.turntable.object) +
                                      ": objects go round in a model that stands still; give --animation a time, as "
                                      "in " +
                                      request.scene.stance.animation.name + "@0");
  MIRRORBALL_TRY_VOID(checkFolder(output));
  MIRRORBALL_TRY_VOID(checkWritable(output));
  MIRRORBALL_TRY_VOID(checkStatesPrimaries(output, request.form.primaries, {Holds::light, Holds::picture}));
  if (request.form.gain_map) MIRRORBALL_TRY_VOID(checkHoldsGainMap(output));
  if (request.form.gain_map && request.stated.contains("resolve") && settings.resolve == Resolve::display)
    return fail(ErrorCode::usage,
                "--gain-map holds radiance, and --resolve display averages what a display shows of "
                "it; leave one of them out");
  GivenOptions given = request.stated;
  if (settings.resolve == Resolve::radiance) given.erase("resolve");
  MIRRORBALL_TRY_VOID(refusePictureOptions(given, output, ""));
  if (request.turntable.frames == 0 && hasNumberPlace(output))
    remark(output + ": is one picture under that very name; --frames N makes several, with numbers in their names");
  const std::string extension = extensionOf(output);
  const bool keeps_alpha = extension == "png" || extension == "exr";
  if (settings.background == BackgroundKind::transparent && !keeps_alpha)
    return fail(ErrorCode::usage, output + ": ." + extension + " has no transparency; write .png or .exr");
  return {};
}

/// Draws what is asked for: one picture, or one after the other.
Result<void> renderAll(Renderer& renderer, FrameSettings settings, const RenderRequest& request,
                       const PictureFiles& outputs, StageClock& clock) {
  const Turntable& turntable = request.turntable;
  if (turntable.frames == 0)
    return renderFrame(renderer, settings, outputs.paths.front(), outputs.form, clock, progressBar("samples"));
  settings.camera.ground_light_turns = turns(request) && turnsShadow(turntable.turn);
  if (playsAnimation(request))
    return renderAnimation(renderer, settings, {request.scene, request.materials, turntable, turns(request)}, outputs,
                           clock);
  const float aspect = static_cast<float>(settings.size.x) / static_cast<float>(settings.size.y);
  settings.camera = framed(renderer.scene(), renderer.bounds(), settings.camera, aspect, framingOf(turntable.turn));
  return renderTurntable(renderer, settings, turntable, outputs, clock);
}

Result<void> render(const RenderRequest& request) {
  StageClock clock;
  MIRRORBALL_TRY(settings, checkedFrame(request));
  MIRRORBALL_TRY_VOID(checkReference(request.reference, settings, request.stated));
  MIRRORBALL_TRY_VOID(checkOutput(request, settings));
  if (request.reference.is_wanted)
    return renderReference(request.scene, request.materials, settings, request.reference, request.stated,
                           request.files.output, request.form);
  if (storesLinearLight(request.files.output) || request.form.gain_map) settings.resolve = Resolve::radiance;
  PictureFiles outputs{{request.files.output}, request.form};
  if (request.turntable.frames > 0) {
    MIRRORBALL_TRY(numbered, numberedPaths(request.files.output, request.turntable.frames));
    outputs.paths = std::move(numbered);
  }
  if (isStandardOutputTaken() && request.turntable.frames > 0)
    return fail(ErrorCode::usage, "standard output takes one picture, and --frames makes several; name a file");
  MIRRORBALL_TRY(inputs, loadInputs(request.scene, request.materials, settings, request.stated, outputs.paths, clock));
  MIRRORBALL_TRY(renderer, rendererOf(std::move(inputs), clock));
  MIRRORBALL_TRY_VOID(checkShown(settings, renderer.scene()));
  MIRRORBALL_TRY_VOID(checkObject(request.turntable, renderer.scene()));
  remarkOnIdleOptions(renderer.scene(), settings, request.stated);
  const Result<void> drawn = renderAll(renderer, settings, request, outputs, clock);
  if (request.scene.timings) clock.print();
  if (drawn)
    announce(outputs.paths.size() == 1 ? outputs.paths.front() : outputs.paths.front() + " … " + outputs.paths.back());
  return drawn;
}

}  // namespace

Command renderCommand() {
  auto request = std::make_shared<RenderRequest>();
  Command command{
      .name = "render",
      .help = "Shows a model in an environment",
      .about = "MODEL is a file (" + modelExtensions() +
               "), a built-in, or - for standard input. Without MODEL and --env, the built-in showcase stands " +
               (hasSunset() ? "on the ground of the built-in sunset." : "in the built-in studio."),
      .examples = {
          {"render helmet.glb -e room.hdr --stand -o helmet.png", "a model that stands on the floor of a room"},
          {"render teapot --material gold -e room.hdr -o gold.png", "a gold teapot in a room"}}};
  addModel(command, "MODEL", request->scene);
  addPictureOptions(command, *request);
  addOptions(command, kRenderFileOptions, request->files);
  addPictureForm(command, request->form);
  addOptions(command, turntableOptions(), request->turntable, &request->stated);
  addReference(command, request->reference, request->stated);
  command.action = [request] {
    setTheStage(*request);
    request->scene.objects_move = request->turntable.turn == Turn::object;
    return withStandardStreams({&request->scene.model, &request->scene.environment}, request->files.output,
                               [&] { return render(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
