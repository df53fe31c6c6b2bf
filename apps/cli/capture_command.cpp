#include <array>
#include <memory>
#include <optional>
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
#include "mirrorball/render/frame/cube_capture.h"
#include "mirrorball/render/settings/capture_options.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/model_stance.h"
#include "mirrorball/scene/place_text.h"

namespace mirrorball::cli {
namespace {

/// What `capture` is told beside its scene (scene_inputs.h), its files (map_output.h) and how things look.
struct CaptureOptions {
  std::optional<glm::dvec3> at;  ///< in the coordinates of the scene's file
  std::string to;
  int size = 0;
  float nearest = 0.0f;
};

/// Of a face, where nothing else is said; in other projections as much detail.
constexpr int kUsualSize = 256;

constexpr ParsedField<CaptureOptions> kAt{
    [](const CaptureOptions& options) { return options.at ? writtenPlace(*options.at) : std::string(); },
    [](const OptionText& text, std::string_view written, CaptureOptions& options) -> Result<void> {
      MIRRORBALL_TRY(numbers, parseExactNumbers(text, written));
      options.at = glm::dvec3(numbers[0], numbers[1], numbers[2]);
      return {};
    }};

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
     kAt},
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

Result<Projection> projectionOf(const CaptureRequest& request) {
  if (!request.options.to.empty()) return projectionToWrite(request.options.to);
  return isTexturePath(request.output.output) ? Projection::cube : Projection::equirect;
}

/// Where the light is captured in a scene; says what is doubtful about it.
glm::vec3 placeIn(const Scene& scene, const BoundingSphere& bounds, const CaptureRequest& request) {
  const glm::vec3 place = bounds.inScene(*request.options.at);
  if (const auto doubt = scene.empty() ? std::nullopt : doubtOfPlace(place, bounds)) remark(*doubt);
  return place;
}

Result<void> writeMap(EnvironmentMap map, const CaptureRequest& request, const MapFile& output, StageClock& clock) {
  tellLimited(output.paths().front(), limitLight(map, request.output.file.light), terminalObserver());
  MIRRORBALL_TRY_VOID(clock.time("map: encode and write", [&] { return output.write(std::move(map)); }));
  if (request.scene.timings) clock.print();
  return {};
}

/// Path-traced: what a mirror there would show.
Result<void> captureReference(const CaptureRequest& request, const CaptureSettings& settings, const MapFile& output,
                              StageClock& clock) {
  MIRRORBALL_TRY(inputs, loadSceneFor(request.scene, request.materials, request.look, output.paths(), clock));
  const glm::vec3 place = placeIn(inputs.scene, boundingSphere(inputs.scene), request);
  const TracedCapture capture{place, settings.to, settings.size, settings.nearest.value_or(0.0f)};
  MIRRORBALL_TRY(traced,
                 traceCapture(std::move(inputs), capture, request.look, request.reference, request.given, clock));
  MIRRORBALL_TRY_VOID(writeMap(std::move(traced.map), request, output, clock));
  return tellTraced(traced.state, output.paths().front());
}

/// Drawn.
Result<void> captureDrawn(const CaptureRequest& request, CaptureSettings settings, const MapFile& output,
                          StageClock& clock) {
  MIRRORBALL_TRY(inputs,
                 loadInputs(request.scene, request.materials, settings.frame, request.given, output.paths(), clock));
  remarkOnIdleOptions(inputs.scene, settings.frame, request.given);
  MIRRORBALL_TRY(renderer, rendererOf(std::move(inputs), clock));
  settings.position = placeIn(renderer.scene(), renderer.bounds(), request);
  MIRRORBALL_TRY(map, clock.time("map: draw, read back, convert",
                                 [&] { return captureEnvironment(renderer, settings, progressBar("capture")); }));
  return writeMap(std::move(map), request, output, clock);
}

Result<void> capture(const CaptureRequest& request) {
  StageClock clock;
  const CaptureOptions& options = request.options;
  if (request.output.output.empty()) return fail(ErrorCode::usage, "capture needs an output: -o FILE");
  if (!options.at) return fail(ErrorCode::usage, "capture needs a place: --at X,Y,Z");
  MIRRORBALL_TRY_VOID(checkCapture(request.look, request.given));
  MIRRORBALL_TRY(to, projectionOf(request));
  MIRRORBALL_TRY_VOID(checkFolder(request.output.output));
  MIRRORBALL_TRY(output, mapFileFor(request.output, request.output.output, to));
  CaptureSettings settings{.to = to,
                           .size = options.size > 0 ? options.size : equivalentSize(Projection::cube, kUsualSize, to),
                           .frame = request.look};
  if (options.nearest > 0.0f) settings.nearest = options.nearest;
  MIRRORBALL_TRY_VOID(output.checkLevelOfSize(settings.size));
  MIRRORBALL_TRY_VOID(checkReference(request.reference, request.look, request.given));
  if (request.reference.trace.wants_layers)
    return fail(ErrorCode::usage, "--layers are for pictures; leave it out, or use render");
  return request.reference.is_wanted ? captureReference(request, settings, output, clock)
                                     : captureDrawn(request, std::move(settings), output, clock);
}

}  // namespace

Command captureCommand() {
  auto request = std::make_shared<CaptureRequest>();
  request->scene.wish.quality = Quality::good;
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
  addOptions(command, stanceOptions(), request->scene.stance);
  addOptions(command, qualityOptions(), request->scene.wish, &request->given);
  addOptions(command, kCaptureOptions, request->options);
  addOptions(command, mapPictureOptions(), request->output.file, &request->output.given);
  addMapOutput(command, request->output);
  addOptions(command, captureFrameOptions(), request->look, &request->given);
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
