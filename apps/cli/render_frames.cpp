#include "cli/render_frames.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "cli/formatted.h"
#include "cli/interruption.h"
#include "cli/terminal.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/render/frame/animation_frames.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/study/traced_frame.h"

namespace mirrorball::cli {
namespace {

const std::string kPrimariesHelp = primariesHelp({Holds::light, Holds::picture});

OptionText ofPicture(OptionText text) {
  text.group = "Picture";
  return text;
}

const auto kPictureFormOptions = std::to_array<Option<PictureForm>>({
    {ofPicture(primariesText(kPrimariesHelp)), choiceField<&PictureForm::primaries>},
    {gainMapText(), &PictureForm::gain_map},
});

/// Draws pictures one after the other.
///
/// prepare   makes the renderer ready for a picture, and returns its settings
Result<void> renderEach(Renderer& renderer, const char* what, const PictureFiles& files, StageClock& clock,
                        const std::function<Result<FrameSettings>(std::size_t frame)>& prepare) {
  const ProgressFunction progress = progressBar(what, "pictures");
  const ProgressFunction untilInterrupted = [](std::size_t, std::size_t) { return !interrupted(); };
  const std::size_t frames = files.paths.size();
  for (std::size_t frame = 0; frame < frames; ++frame) {
    MIRRORBALL_TRY(settings, prepare(frame));
    const Result<void> drawn = renderFrame(renderer, settings, files.paths[frame], files.form, clock, untilInterrupted);
    if (!drawn && drawn.error().code != ErrorCode::interrupted) return drawn;
    const std::size_t whole = drawn ? frame + 1 : frame;
    whenInterrupted(interruptedAfter(whole, frames));
    if (!drawn || !progress(whole, frames)) return fail(ErrorCode::interrupted, interruptedAfter(whole, frames));
  }
  return {};
}

/// Writes light in the file's primaries: radiance, or what a display sends of it.
Result<void> writeLight(const std::string& output, Image light, const PictureForm& form, Dither dither) {
  convertFromRec709(light, form.primaries);
  return writeImage(output, light, {.metadata = {}, .primaries = form.primaries, .dither = dither});
}

float angleOf(std::size_t frame, std::size_t frames) {
  return 360.0f * static_cast<float>(frame) / static_cast<float>(frames);
}

}  // namespace

void addPictureForm(Command& command, PictureForm& form) { addOptions(command, kPictureFormOptions, form); }

FrameSettings settingsForGainMap(FrameSettings settings) {
  settings.resolve = Resolve::radiance;
  if (settings.background == BackgroundKind::display_color) settings.background = BackgroundKind::transparent;
  return settings;
}

Result<void> checkTurn(const Turntable& turntable) {
  if (turntable.frames > 0 || turntable.turn == Turn::camera) return {};
  return fail(ErrorCode::usage, "--turn says what goes round in a turntable, and one picture is none; add --frames N");
}

Result<void> writeShown(const std::string& output, Image radiance, const FrameSettings& frame,
                        const PictureForm& form) {
  const glm::vec4 backdrop = backdropOf(frame);
  if (form.gain_map) {
    const Image light = lightOnDisplay(frame.display, radiance, backdrop);
    return savePictureWithGainMap(output, displayedPicture(frame.display, std::move(radiance), backdrop), light);
  }
  return writeLight(output, displayedLight(frame.display, std::move(radiance), backdrop), form, frame.display.dither);
}

Result<void> renderFrame(Renderer& renderer, const FrameSettings& settings, const std::string& output,
                         const PictureForm& form, StageClock& clock, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(clock.time("scene: trees, shadows", [&] { return renderer.stage().prepare(settings); }));
  if (form.gain_map) {
    const FrameSettings of_radiance = settingsForGainMap(settings);
    MIRRORBALL_TRY_VOID(clock.time("frame: draw", [&] { return renderer.draw(of_radiance, progress); }));
    MIRRORBALL_TRY(radiance, clock.time("frame: finish and read back", [&] { return renderer.radiance(); }));
    return clock.time("picture: encode and write",
                      [&] { return writeShown(output, std::move(radiance), settings, form); });
  }
  MIRRORBALL_TRY_VOID(clock.time("frame: draw", [&] { return renderer.draw(settings, progress); }));
  if (storesLinearLight(output)) {
    MIRRORBALL_TRY(radiance, clock.time("frame: finish and read back", [&] { return renderer.radiance(); }));
    return clock.time("picture: encode and write",
                      [&] { return writeLight(output, std::move(radiance), form, settings.display.dither); });
  }
  if (form.primaries != OutputPrimaries::rec709) {
    MIRRORBALL_TRY(light, clock.time("frame: finish, tone map, read back", [&] { return renderer.displayedLight(); }));
    return clock.time("picture: encode and write",
                      [&] { return writeLight(output, std::move(light), form, settings.display.dither); });
  }
  MIRRORBALL_TRY(picture, clock.time("frame: finish, tone map, read back", [&] { return renderer.picture(); }));
  return clock.time("picture: encode and write", [&] { return savePicture(output, picture); });
}

FramingOf framingOf(Turn turn) { return turn == Turn::environment ? FramingOf::still : FramingOf::whole_turn; }

Result<void> renderTurntable(Renderer& renderer, const FrameSettings& settings, const Turntable& turntable,
                             const PictureFiles& files, StageClock& clock) {
  const Scene still = turntable.turn == Turn::object ? renderer.scene() : Scene{};
  const BoundingSphere still_bounds = renderer.bounds();
  const glm::vec3 axis = settings.camera.target ? still_bounds.inScene(*settings.camera.target) : still_bounds.center;
  return renderEach(renderer, "turntable", files, clock, [&](std::size_t frame) -> Result<FrameSettings> {
    const float angle_deg = angleOf(frame, files.paths.size());
    const FrameSettings of_frame = turned(settings, turntable.turn, angle_deg, still_bounds);
    if (turntable.turn != Turn::object) return of_frame;
    MIRRORBALL_TRY_VOID(renderer.moveInstances(orbited(still, turntable.object - 1, axis, angle_deg)));
    return standingStill(of_frame, still, still_bounds, renderer.bounds());
  });
}

Result<void> renderAnimation(Renderer& renderer, const FrameSettings& settings, const AnimationRequest& request,
                             const PictureFiles& files, StageClock& clock) {
  // The renderer's scene is a moment, of which there are no others.
  MIRRORBALL_TRY(rest, loadModel(request.scene.model, {.inside_only = request.scene.inside_only}));
  auto made = AnimationFrames::make(std::move(rest), request.scene.stance, settings, files.paths.size(),
                                    request.turns ? framingOf(request.turntable.turn) : FramingOf::still);
  MIRRORBALL_TRY(frames, withName(request.scene.model, std::move(made)));
  return renderEach(renderer, "animation", files, clock, [&](std::size_t frame) -> Result<FrameSettings> {
    MIRRORBALL_TRY(pose, withName(request.scene.model, frames.pose(frame)));
    MIRRORBALL_TRY(scene, preparedPose(std::move(pose), request.materials, settings, clock));
    MIRRORBALL_TRY_VOID(clock.time("GL: upload, compile", [&] { return renderer.setScene(std::move(scene)); }));
    const FrameSettings of_frame = request.turns ? turned(frames.settings(), request.turntable.turn,
                                                          angleOf(frame, files.paths.size()), frames.bounds())
                                                 : frames.settings();
    return frames.standingStill(of_frame, renderer.bounds());
  });
}

}  // namespace mirrorball::cli
