#include "mirrorball/view/viewer/picture_job.h"

#include <functional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/codec/numbered_paths.h"
#include "mirrorball/render/frame/animation_frames.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/frame/turntable.h"
#include "mirrorball/render/stage/scene_preparation.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/study/traced_frame.h"
#include "mirrorball/trace/path_tracer.h"
#include "mirrorball/view/control/gesture.h"
#include "mirrorball/view/map/map_picture.h"
#include "mirrorball/view/viewer/map_loading.h"
#include "mirrorball/view/workspace/workspace_file.h"

namespace mirrorball {
namespace {

Result<void> checkPath(const Workspace& workspace, const PictureRequest& request, const FrameSettings& frame) {
  MIRRORBALL_TRY_VOID(refuseInputs(workspace, request.path));
  MIRRORBALL_TRY_VOID(checkWritable(request.path));
  const std::string extension = extensionOf(request.path);
  if (frame.background == BackgroundKind::transparent && extension != "png" && extension != "exr")
    return fail(ErrorCode::usage, request.path + ": ." + extension + " has no transparency; write .png or .exr");
  return {};
}

/// What loads a map, be it a photograph.
std::function<Result<LoadedEnvironment>(const ProgressFunction&)> loaderOf(AskedMap source) {
  return [source = std::move(source)](const ProgressFunction& progress) -> Result<LoadedEnvironment> {
    MIRRORBALL_TRY(map, loadMap(source, {}, progress));
    return std::move(map.loaded);
  };
}

/// What is loaded for it.
Result<RenderInputNames> namesOf(const Workspace& workspace, const PictureRequest& request, bool inside_only,
                                 const std::optional<CacheFolder>& cache) {
  const GivenTexts given = givenFrame(workspace, request.side);
  MIRRORBALL_TRY(frame, frameOf(given));
  MIRRORBALL_TRY(quality, qualityOf(given));
  MIRRORBALL_TRY(materials, materialsOf(workspace.materials));
  MIRRORBALL_TRY(stance, stanceOf(workspace.stance));
  frame.proxy.load.inside_only = inside_only;
  frame.size = request.size_px;
  standOnGround(frame);
  // As it is seen (Viewer::State::standInView); while a camera goes round, the light stays.
  frame.camera.ground_light_turns = request.frames == 0 || request.plays;
  if (storesLinearLight(request.path)) frame.resolve = Resolve::radiance;
  RenderInputNames names{.model = workspace.model,
                         .load_model = {.inside_only = inside_only, .animation = std::move(stance.animation)},
                         .up = stance.up,
                         .materials = std::move(materials),
                         .frame = std::move(frame),
                         .environment = mapOf(workspace, request.side),
                         .load_environment = loaderOf(askedMap(workspace, request.side)),
                         .cache = cache};
  if (isTraced(workspace, request.side)) return names;
  names.wishes = TechniqueWishes{.quality = quality};
  for (const auto& option : frameOptions())
    if (given.contains(option.text.name)) names.wishes->given.insert(option.text.name);
  return names;
}

Result<void> write(const std::string& path, const FrameSettings& frame, Image radiance) {
  if (!storesLinearLight(path))
    return savePicture(path, displayedPicture(frame.display, std::move(radiance), backdropOf(frame)));
  if (frame.background == BackgroundKind::display_color) layOver(radiance, backdropOf(frame));
  return writeImage(path, radiance);
}

Result<void> trace(const Workspace& workspace, const PictureRequest& request, const RenderInputNames& names,
                   const ProgressFunction& progress) {
  MIRRORBALL_TRY(inputs, loadSceneInputs(names));
  MIRRORBALL_TRY_VOID(changeParameters(inputs.scene, workspace));
  MIRRORBALL_TRY(camera,
                 framedCamera(inputs.scene, boundingSphere(inputs.scene), inputs.frame.camera, inputs.frame.size));
  MIRRORBALL_TRY(tracer, PathTracer::make(std::move(inputs.scene), std::move(inputs.environment), progress));
  TraceSettings settings;
  if (givenFrame(workspace, request.side).contains("samples")) settings.samples = names.frame.samples;
  MIRRORBALL_TRY(picture, tracer.render(camera, tracedFrame(names.frame, settings), {.progress = progress}));
  if (picture.is_interrupted) return fail(ErrorCode::interrupted, "interrupted");
  return write(request.path, names.frame, std::move(picture.radiance));
}

Result<void> draw(Renderer& renderer, const FrameSettings& frame, const std::string& path,
                  const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(renderer.draw(frame, progress));
  if (storesLinearLight(path)) {
    MIRRORBALL_TRY(radiance, renderer.radiance());
    return writeImage(path, radiance);
  }
  MIRRORBALL_TRY(picture, renderer.picture());
  return savePicture(path, picture);
}

/// The map alone, as it is looked at.
Result<void> drawMap(const Workspace& workspace, const PictureRequest& request, const std::optional<CacheFolder>& cache,
                     const ProgressFunction& progress) {
  if (request.frames > 0 || storesLinearLight(request.path))
    return fail(ErrorCode::usage, request.path + ": the map alone is one picture, as .png or .jpg");
  MIRRORBALL_TRY(settings, mapViewOf(workspace));
  MIRRORBALL_TRY(viewed, viewedMap(askedMap(workspace, request.side), cache, progress));
  MapCanvas canvas = mapCanvas(request.size_px);
  if (viewed.ball) canvas.photograph_px = viewed.ball->size_px;
  MapViewer viewer(std::move(viewed.map));
  MIRRORBALL_TRY(picture, viewer.picture(settings, canvas, progress));
  return savePicture(request.path, picture);
}

/// Each sample of each picture is a step.
ProgressFunction ofPicture(std::size_t picture, std::size_t pictures, const ProgressFunction& progress) {
  return [=, &progress](std::size_t done, std::size_t total) {
    return !progress || progress(picture * total + done, pictures * total);
  };
}

Result<void> drawTurn(Renderer& renderer, FrameSettings frame, const std::vector<std::string>& paths,
                      const ProgressFunction& progress) {
  const float aspect = static_cast<float>(frame.size.x) / static_cast<float>(frame.size.y);
  frame.camera = framed(renderer.scene(), renderer.bounds(), frame.camera, aspect, FramingOf::whole_turn);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const float angle_deg = 360.0f * static_cast<float>(i) / static_cast<float>(paths.size());
    MIRRORBALL_TRY_VOID(draw(renderer, turned(frame, Turn::camera, angle_deg, renderer.bounds()), paths[i],
                             ofPicture(i, paths.size(), progress)));
  }
  return {};
}

Result<void> drawAnimation(Renderer& renderer, const Workspace& workspace, const RenderInputNames& names,
                           const FrameSettings& frame, const std::vector<std::string>& paths,
                           const ProgressFunction& progress) {
  MIRRORBALL_TRY(rest, loadModel(names.model, {.inside_only = names.load_model.inside_only}));
  const ModelStance stance{names.up, names.load_model.animation};
  MIRRORBALL_TRY(frames, AnimationFrames::make(std::move(rest), stance, frame, paths.size(), FramingOf::still));
  for (std::size_t i = 0; i < paths.size(); ++i) {
    MIRRORBALL_TRY(pose, frames.pose(i));
    MIRRORBALL_TRY_VOID(changeMaterials(pose, names.materials));
    MIRRORBALL_TRY_VOID(changeParameters(pose, workspace));
    MIRRORBALL_TRY_VOID(prepareScene(pose, preparationFor(frame), {}));
    MIRRORBALL_TRY_VOID(renderer.setScene(std::move(pose)));
    MIRRORBALL_TRY(of_picture, frames.standingStill(frames.settings(), renderer.bounds()));
    MIRRORBALL_TRY_VOID(draw(renderer, of_picture, paths[i], ofPicture(i, paths.size(), progress)));
  }
  return {};
}

}  // namespace

Result<std::string> makePicture(const Workspace& workspace, const PictureRequest& request, bool inside_only,
                                const std::optional<CacheFolder>& cache, const ProgressFunction& progress) {
  MIRRORBALL_TRY(names, namesOf(workspace, request, inside_only, cache));
  MIRRORBALL_TRY_VOID(checkPath(workspace, request, names.frame));
  if (workspace.shows_map) {
    MIRRORBALL_TRY_VOID(drawMap(workspace, request, cache, progress));
    return request.path;
  }
  if (isTraced(workspace, request.side)) {
    if (request.frames > 0) return fail(ErrorCode::usage, "the reference makes one picture, and not several");
    MIRRORBALL_TRY_VOID(trace(workspace, request, names, progress));
    return request.path;
  }
  MIRRORBALL_TRY(inputs, loadRenderInputs(names));
  MIRRORBALL_TRY_VOID(changeParameters(inputs.scene, workspace));
  const FrameSettings frame = inputs.frame;
  MIRRORBALL_TRY(renderer, rendererOf(std::move(inputs)));
  if (request.frames == 0) {
    MIRRORBALL_TRY_VOID(draw(renderer, frame, request.path, progress));
    return request.path;
  }
  MIRRORBALL_TRY(paths, numberedPaths(request.path, request.frames));
  const std::string written = paths.front() + " … " + paths.back();
  if (request.plays) {
    MIRRORBALL_TRY_VOID(drawAnimation(renderer, workspace, names, frame, paths, progress));
    return written;
  }
  if (!frame.camera.name.empty())
    return fail(ErrorCode::usage, "the camera '" + frame.camera.name + "' stands still; choose another for a turn");
  MIRRORBALL_TRY_VOID(drawTurn(renderer, frame, paths, progress));
  return written;
}

}  // namespace mirrorball
