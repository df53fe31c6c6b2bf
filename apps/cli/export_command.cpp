#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/scene_inputs.h"
#include "cli/standard_streams.h"
#include "cli/terminal.h"
#include "mirrorball/base/file.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/render/settings/frame_settings.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/gltf/gltf_writer.h"
#include "mirrorball/scene/load_model.h"
#include "mirrorball/scene/model_stance.h"

namespace mirrorball::cli {
namespace {

/// All that `export` was told.
struct ExportRequest {
  SceneRequest scene;
  std::string output;
  FrameSettings frame;
  MaterialChanges materials;
  GivenOptions given;
};

const auto kExportOptions = std::to_array<Option<ExportRequest>>({
    {{.name = "output",
      .value = "OUT",
      .help = "required: the file, .glb; -.glb is standard output",
      .letter = "o",
      .group = "Files",
      .takes_path = true},
     &ExportRequest::output},
});

/// errors   usage
Result<void> checkExport(const std::string& output) {
  if (output.empty()) return fail(ErrorCode::usage, "export needs an output: -o FILE.glb");
  if (extensionOf(output) != "glb")
    return fail(ErrorCode::usage, output + ": export writes binary glTF; name the file FILE.glb");
  return checkFolder(output);
}

Result<void> exportScene(const ExportRequest& request) {
  const std::string& output = request.output;
  MIRRORBALL_TRY_VOID(checkExport(output));
  MIRRORBALL_TRY_VOID(checkSettings(request.frame, request.given));
  MIRRORBALL_TRY(scene, loadModelFor(request.scene, request.materials, request.frame, {&output, 1}));
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), request.frame.camera, request.frame.size));
  MIRRORBALL_TRY(encoded, encodeGlb(scene, camera));
  MIRRORBALL_TRY_VOID(writeFile(output, encoded.bytes));
  announce(output);
  for (const std::string& line : encoded.left_out) remark(output + ": " + line);
  return {};
}

}  // namespace

Command exportCommand() {
  constexpr std::array<std::string_view, 2> kOfScene{"inside-only", "max-memory"};
  constexpr std::array<std::string_view, 5> kOfFrame{"size", "camera", "target", "fov", "orthographic"};
  static const std::vector<Option<SceneRequest>> scene_options = rowsNamed(sceneOptions(), kOfScene);
  static const std::vector<Option<FrameSettings>> frame_options = rowsNamed(frameOptions(), kOfFrame);
  auto request = std::make_shared<ExportRequest>();
  Command command{
      .name = "export",
      .help = "Writes a model for other programs, with the camera of its picture",
      .about = "MODEL is a file (" + modelExtensions() +
               "), a built-in, or - for standard input. The file is binary glTF 2.0. What glTF cannot say is left out, "
               "and a note says so.",
      .examples = {{"export teapot --material gold -o teapot.glb", "a gold teapot for other programs"},
                   {"export part.stl --up z --camera 60,20 --size 800x800 -o part.glb",
                    "a part that stands upright, seen as `render` with the same options shows it"}}};
  addModel(command, "MODEL", request->scene);
  addOptions(command, scene_options, request->scene);
  addOptions(command, stanceOptions(), request->scene.stance);
  addOptions(command, kExportOptions, *request);
  addOptions(command, frame_options, request->frame, &request->given);
  addOptions(command, materialOptions(), request->materials);
  command.action = [request] {
    return withStandardStreams({&request->scene.model}, request->output, [&] { return exportScene(*request); });
  };
  return command;
}

}  // namespace mirrorball::cli
