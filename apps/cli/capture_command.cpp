#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/map_output.h"
#include "cli/render_reference.h"
#include "cli/scene_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/text.h"
#include "mirrorball/codec/image_file.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/convert/convert.h"
#include "mirrorball/environment/projection/texel_geometry.h"
#include "mirrorball/render/frame/cube_capture.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/scene/animation/animation_choice.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

/// What `capture` is told beside its scene (scene_inputs.h), its files (map_output.h) and how things look.
struct CaptureOptions {
  std::vector<float> at;
  std::string to;
  int size = 0;
  float nearest = 0.0f;
};

/// Of a face, where nothing else is said; in other projections as much detail.
constexpr int kUsualSize = 256;

const std::string kProjectionHelp = "projection of the map: " + join(projectionNames(), ", ", " or ") +
                                    "; without it, cube in " + writtenExtensions(Holds::texture, " and ") +
                                    ", equirect in other files";

const auto kCaptureOptions = std::to_array<Option<CaptureOptions>>({
    {{.name = "at",
      .value = "X,Y,Z",
      .unit = "world units",
      .minimum = -1e15,
      .maximum = 1e15,
      .min_count = 3,
      .max_count = 3,
      .help = "required: the point around which the light is captured",
      .group = "Capture",
      .is_daily = true},
     &CaptureOptions::at},
    {{.name = "near",
      .value = "DISTANCE",
      .unit = "world units",
      .minimum = 0,
      .maximum = 1e15,
      .help = "surfaces nearer than this are not drawn; 0: 1/10000 of the distance to the scene's farthest point or, "
              "from outside the scene, the distance at which it begins; with --reference all are drawn",
      .group = "Capture"},
     &CaptureOptions::nearest},
    {{.name = "to",
      .value = "PROJECTION",
      .help = kProjectionHelp,
      .group = "Output",
      .is_daily = true,
      .names = projectionNames},
     &CaptureOptions::to},
    {{.name = "size",
      .value = "N",
      .unit = "texels",
      .minimum = 0,
      .maximum = 32768,
      .help = "size of the map: the side of a cube face or of a square map, the diameter of a disc, or the height of a "
              "panorama; 0: 256 for cube faces, and the same detail in other projections",
      .group = "Output",
      .is_daily = true},
     &CaptureOptions::size},
});

/// What has no meaning for a map of all directions, or a map's own option in its place.
constexpr std::array<std::string_view, 9> kOptionsOfPictures{"size",   "exposure", "tone-map",     "resolve", "camera",
                                                             "target", "fov",      "orthographic", "stand"};

/// All that `capture` was told.
struct CaptureRequest {
  SceneRequest scene;
  CaptureOptions options;
  FrameSettings look;
  MaterialChanges materials;
  MapOutputOptions output;
  ReferenceOptions reference;
  GivenOptions given;
};

/// errors   usage: what a map of all directions cannot show
Result<void> checkLook(const FrameSettings& frame) {
  if (frame.background == BackgroundKind::transparent)
    return fail(ErrorCode::usage, "a map has light for every direction; --background 0,0,0 leaves it dark");
  return {};
}

Result<Projection> projectionOf(const CaptureRequest& request) {
  if (!request.options.to.empty()) return projectionToWrite(request.options.to);
  return isTexturePath(request.output.output) ? Projection::cube : Projection::equirect;
}

/// The side of the faces that are drawn for a map: its own, or what has all the detail that another projection will
/// show.
int faceSideFor(Projection to, int size) { return to == Projection::cube ? size : cubeSideFor(texelDensity(to, size)); }

/// "0,1.25,-3": with as many digits as one would type.
std::string shortText(glm::vec3 place) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.3g,%.3g,%.3g", double(place.x), double(place.y), double(place.z));
  return text.data();
}

/// Says where the scene is if one looks for it in vain: a model's unit is often another than one thinks.
void remarkOnDistance(glm::vec3 place, const BoundingSphere& scene) {
  constexpr float kFar = 10.0f;  // from there it fills less than 0.3 % of all directions
  if (glm::length(place - scene.center) <= kFar * scene.radius) return;
  std::array<char, 32> radius;
  std::snprintf(radius.data(), radius.size(), "%.3g", double(scene.radius));
  remark(shortText(place) + " is far outside of the scene, which lies within " + radius.data() + " units of " +
         shortText(scene.center) + "; the map hardly shows it");
}

Result<EnvironmentMap> captureMap(RenderInputs inputs, Projection to, int size, CaptureSettings settings,
                                  StageClock& clock) {
  settings.size = faceSideFor(to, size);
  MIRRORBALL_TRY(renderer, rendererOf(std::move(inputs), clock));
  if (!renderer.scene().empty()) remarkOnDistance(settings.position, renderer.bounds());
  MIRRORBALL_TRY(cube, clock.time("faces: draw and read back",
                                  [&] { return captureEnvironment(renderer, settings, progressBar("capture")); }));
  if (to == Projection::cube) return cube;
  return clock.time("map: convert",
                    [&] { return convert(Environment(std::move(cube)), to, size, {}, progressBar("convert")); });
}

Result<void> writeMap(EnvironmentMap map, const CaptureRequest& request, const MapFile& output, StageClock& clock) {
  tellLimited(output.paths().front(), limitLight(map, request.output.file.light), terminalObserver());
  MIRRORBALL_TRY_VOID(clock.time("map: encode and write", [&] { return output.write(std::move(map)); }));
  if (request.scene.timings) clock.print();
  return {};
}

/// The same, path-traced: what a mirror there would show.
Result<EnvironmentMap> traceMap(SceneInputs inputs, Projection to, int size, const CaptureSettings& settings,
                                const CaptureRequest& request, TracedPicture& state, StageClock& clock) {
  if (!inputs.scene.empty()) remarkOnDistance(settings.position, boundingSphere(inputs.scene));
  const TracedCapture capture{settings.position, to, size, settings.nearest.value_or(0.0f)};
  MIRRORBALL_TRY(traced,
                 traceCapture(std::move(inputs), capture, request.look, request.reference, request.given, clock));
  state = std::move(traced.state);
  return std::move(traced.map);
}

Result<void> captureReference(const CaptureRequest& request, const CaptureSettings& settings, Projection to, int size,
                              const MapFile& output, StageClock& clock) {
  MIRRORBALL_TRY(inputs, loadSceneFor(request.scene, request.materials, request.look, output.paths(), clock));
  TracedPicture state;
  MIRRORBALL_TRY(map, traceMap(std::move(inputs), to, size, settings, request, state, clock));
  MIRRORBALL_TRY_VOID(writeMap(std::move(map), request, output, clock));
  return tellTraced(state, output.paths().front());
}

Result<void> capture(const CaptureRequest& request) {
  StageClock clock;
  const CaptureOptions& options = request.options;
  if (request.output.output.empty()) return fail(ErrorCode::usage, "capture needs an output: -o FILE");
  if (options.at.empty()) return fail(ErrorCode::usage, "capture needs a place: --at X,Y,Z");
  CaptureSettings settings{.position = {options.at[0], options.at[1], options.at[2]}};
  if (options.nearest > 0.0f) settings.nearest = options.nearest;
  MIRRORBALL_TRY_VOID(checkLook(request.look));
  settings.frame = request.look;
  MIRRORBALL_TRY_VOID(checkSettings(settings.frame, request.given));
  MIRRORBALL_TRY(to, projectionOf(request));
  MIRRORBALL_TRY_VOID(checkFolder(request.output.output));
  MIRRORBALL_TRY(output, mapFileFor(request.output, request.output.output, to));
  const int size = options.size > 0 ? options.size : equivalentSize(Projection::cube, kUsualSize, to);
  MIRRORBALL_TRY_VOID(output.checkLevelOfSize(size));
  MIRRORBALL_TRY_VOID(checkReference(request.reference, request.look, request.given));
  if (request.reference.trace.wants_layers)
    return fail(ErrorCode::usage, "--layers are for pictures; leave it out, or use render");
  if (request.reference.is_wanted) return captureReference(request, settings, to, size, output, clock);

  MIRRORBALL_TRY(inputs,
                 loadInputs(request.scene, request.materials, settings.frame, request.given, output.paths(), clock));
  remarkOnIdleOptions(inputs.scene, settings.frame, request.given);
  MIRRORBALL_TRY(map, captureMap(std::move(inputs), to, size, std::move(settings), clock));
  return writeMap(std::move(map), request, output, clock);
}

/// The options of `render` that say what a scene looks like, without those that say how a picture of it is taken.
std::span<const Option<FrameSettings>> captureLookOptions() {
  static const std::vector<Option<FrameSettings>> look = [] {
    std::vector<Option<FrameSettings>> kept;
    std::ranges::copy_if(frameOptions(), std::back_inserter(kept), [](const Option<FrameSettings>& option) {
      return std::ranges::find(kOptionsOfPictures, option.text.name) == kOptionsOfPictures.end();
    });
    for (Option<FrameSettings>& option : kept) {
      // A sphere map is right for one viewing direction, and a capture looks into all. The mappings that are left are
      // the first of the enumeration.
      if (option.text.name == "mapping") {
        option.text.choices = "reflection|normal";
        option.text.help = "what addresses the environment map: the reflected ray, or the surface normal";
      }
      if (option.text.name == "background") option.text.value = "env|blur|COLOR";
    }
    return kept;
  }();
  return look;
}

}  // namespace

Command captureCommand() {
  auto request = std::make_shared<CaptureRequest>();
  request->scene.quality = Quality::good;
  Command command{
      .name = "capture",
      .help = "Makes an environment map of the light around a point in a scene",
      .about = "SCENE is a file (" + modelExtensions() +
               "), a built-in, or - for standard input. `--at` and `--output` are required.",
      .examples = {{"capture room.glb --at 0,1.5,0 -e sky -o probe.exr", "a panorama of a room, from eye height"},
                   {"capture room.glb --at 0,1.5,0 --to cube --size 256 --mips -o probe.ktx2",
                    "the same as a cube map for an engine"}}};
  addModel(command, "SCENE", request->scene);
  addOptions(command, sceneOptions(), request->scene);
  addOptions(command, qualityOptions(), request->scene, &request->given);
  addOptions(command, kCaptureOptions, request->options);
  addMapOutput(command, request->output);
  addOptions(command, captureLookOptions(), request->look, &request->given);
  addOptions(command, animationOptions(), request->scene.animation);
  addReference(command, request->reference, request->given);
  addOptions(command, materialOptions(), request->materials);
  command.action = [request] {
    request->look.proxy.load.inside_only = request->scene.inside_only;
    return withStandardStreams({&request->scene.model, &request->scene.environment}, request->output.output,
                               [&] { return capture(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
