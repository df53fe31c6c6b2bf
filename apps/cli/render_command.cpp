#include "cli/render_command.h"

#include <array>
#include <cstdio>
#include <future>
#include <optional>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/stage_clock.h"
#include "cli/terminal.h"
#include "mirrorball/codec/codec.h"
#include "mirrorball/environment/load.h"
#include "mirrorball/render/renderer.h"
#include "mirrorball/scene/load_model.h"

namespace mirrorball::cli {
namespace {

const std::array<Option<RenderFiles>, 6> kFileOptions{{
    {{.name = "env",
      .value = "ENV",
      .help = "the environment: a panorama, sphere map or cube (.hdr .exr .png .jpg .ktx2 .dds), or studio, "
              "sky[:elevation=20,…], "
              "uv, white",
      .letter = "e",
      .group = "Files"},
     &RenderFiles::environment},
    {{.name = "output",
      .value = "OUT",
      .help = ".png .jpg (tone mapped) or .exr .hdr (linear radiance)",
      .letter = "o",
      .group = "Files"},
     &RenderFiles::output},
    {{.name = "from",
      .value = "FORM",
      .help = "the environment's form, where it is not recognised: a projection (see convert --to), "
              "or a cube's layout",
      .group = "Files"},
     &RenderFiles::from},
    {{.name = "repair",
      .help = "replace NaN and infinite texels of the environment by their neighbours",
      .group = "Files"},
     &RenderFiles::repair},
    {{.name = "timings", .help = "print how long each stage took", .group = "Files"}, &RenderFiles::timings},
    {kMaxMemoryText, &RenderFiles::max_memory},
}};

/// All that `render` was told.
struct RenderRequest {
  std::string model = "showcase";
  RenderFiles files;
  RenderOptions options;
};

/// What there is to draw: made on other threads while the GL driver starts.
struct Inputs {
  Scene scene;
  LoadedEnvironment environment;
  PreparedEnvironment prepared;
};

Result<FormHint> hintFrom(const std::string& from) {
  if (from.empty()) return FormHint{};
  return formHintNamed(from);
}

Result<Scene> loadScene(const RenderRequest& request) {
  MIRRORBALL_TRY(scene, loadModel(request.model));
  MIRRORBALL_TRY_VOID(applyMaterialOptions(request.options, scene));
  return scene;
}

/// Driver, model and environment at the same time: none needs the others.
Result<Inputs> loadInputs(const RenderRequest& request, const EnvironmentLoadOptions& how, StageClock& clock,
                          std::optional<Result<gl::Context>>& context) {
  auto scene =
      std::async(std::launch::async, [&] { return clock.time("model: read", [&] { return loadScene(request); }); });
  auto environment = std::async(std::launch::async, [&]() -> Result<std::pair<LoadedEnvironment, PreparedEnvironment>> {
    MIRRORBALL_TRY(loaded,
                   clock.time("environment: read", [&] { return loadEnvironment(request.files.environment, how); }));
    MIRRORBALL_TRY(prepared, clock.time("environment: cube, mips, harmonics",
                                        [&] { return prepareEnvironment(loaded.environment); }));
    return std::pair(std::move(loaded), std::move(prepared));
  });
  context.emplace(clock.time("GL: start the driver", [] { return gl::Context::createHeadless(); }));
  // Both are waited for before any error returns, since they refer to this frame.
  auto scene_result = scene.get();
  auto environment_result = environment.get();
  if (!scene_result) return fail(std::move(scene_result));
  if (!environment_result) return fail(std::move(environment_result));
  if (!*context) return tl::unexpected<Error>(context->error());
  return Inputs{std::move(*scene_result), std::move(environment_result->first), std::move(environment_result->second)};
}

Result<void> renderFrame(Renderer& renderer, const FrameSettings& settings, const std::string& output,
                         StageClock& clock, const ProgressFunction& progress) {
  MIRRORBALL_TRY_VOID(clock.time("frame: draw", [&] { return renderer.draw(settings, progress); }));
  if (storesLinearLight(output)) {
    const Image radiance = clock.time("frame: finish and read back", [&] { return renderer.radiance(); });
    return clock.time("picture: encode and write", [&] { return writeImage(output, radiance); });
  }
  MIRRORBALL_TRY(picture, clock.time("frame: finish, tone map, read back", [&] { return renderer.picture(settings); }));
  return clock.time("picture: encode and write", [&] { return writePicture(output, picture); });
}

/// The pictures that are written: one, or a turntable's with their numbers.
std::vector<std::string> outputPaths(const RenderRequest& request) {
  const std::string& output = request.files.output;
  const int frames = request.options.frames;
  if (frames == 0) return {output};
  const int digits = std::max(3, static_cast<int>(std::to_string(frames - 1).size()));
  std::vector<std::string> paths;
  for (int frame = 0; frame < frames; ++frame) {
    std::string number = std::to_string(frame);
    number.insert(0, static_cast<std::size_t>(digits) - number.size(), '0');
    paths.push_back(suffixed(output, "_" + number));
  }
  return paths;
}

Result<void> renderTurntable(Renderer& renderer, FrameSettings settings, const std::vector<std::string>& paths,
                             StageClock& clock) {
  const ProgressFunction progress = progressBar("turntable");
  const ProgressFunction untilInterrupted = [](std::size_t, std::size_t) { return !interrupted(); };
  const float start_deg = settings.camera.azimuth_deg;
  const std::size_t frames = paths.size();
  for (std::size_t frame = 0; frame < frames; ++frame) {
    settings.camera.azimuth_deg = start_deg + 360.0f * static_cast<float>(frame) / static_cast<float>(frames);
    const Result<void> drawn = renderFrame(renderer, settings, paths[frame], clock, untilInterrupted);
    if (!drawn && drawn.error().code != ErrorCode::interrupted) return drawn;
    const std::size_t whole = drawn ? frame + 1 : frame;
    if (!drawn || !progress(whole, frames))
      return fail(ErrorCode::interrupted, "interrupted after " + std::to_string(whole) + " of " +
                                              std::to_string(frames) + " pictures; those are whole");
  }
  return {};
}

Result<void> checkOutput(const RenderRequest& request, const FrameSettings& settings) {
  const std::string& output = request.files.output;
  MIRRORBALL_TRY_VOID(checkFolder(output));
  MIRRORBALL_TRY_VOID(checkWritable(output));
  const std::string extension = extensionOf(output);
  const bool keeps_alpha = extension == "png" || extension == "exr";
  if (settings.background == BackgroundKind::transparent && !keeps_alpha)
    return fail(ErrorCode::usage, output + ": ." + extension + " has no transparency; write .png or .exr");
  return {};
}

Result<void> render(const RenderRequest& request) {
  StageClock clock;
  MIRRORBALL_TRY(settings, frameSettings(request.options));
  MIRRORBALL_TRY_VOID(checkOutput(request, settings));
  MIRRORBALL_TRY_VOID(useMemoryLimit(request.files.max_memory));
  MIRRORBALL_TRY(hint, hintFrom(request.files.from));
  // A wrong name among the materials is told before anything is loaded.
  Scene no_scene;
  MIRRORBALL_TRY_VOID(applyMaterialOptions(request.options, no_scene));

  std::optional<Result<gl::Context>> context;
  MIRRORBALL_TRY(inputs, loadInputs(request, {.from = hint, .repair = request.files.repair}, clock, context));
  const std::vector<std::string> outputs = outputPaths(request);
  MIRRORBALL_TRY_VOID(refuseOverwriting(inputs.environment.files, outputs));
  MIRRORBALL_TRY_VOID(refuseOverwriting(inputs.scene.files, outputs));
  MIRRORBALL_TRY_VOID(refuseOverwriting(std::span(&request.model, 1), outputs));
  for (const std::string& warning : inputs.scene.warnings)
    std::fprintf(stderr, "mirrorball: note: %s\n", warning.c_str());

  MIRRORBALL_TRY(renderer, clock.time("GL: upload, compile", [&] {
    return Renderer::make(**context, inputs.scene, inputs.environment.environment, inputs.prepared);
  }));
  Result<void> drawn = request.options.frames > 0
                           ? renderTurntable(renderer, settings, outputs, clock)
                           : renderFrame(renderer, settings, outputs.front(), clock, progressBar("samples"));
  if (request.files.timings) clock.print();
  if (drawn) announce(outputs.size() == 1 ? outputs.front() : outputs.front() + " … " + outputs.back());
  return drawn;
}

}  // namespace

std::span<const Option<RenderFiles>> renderFileOptions() { return kFileOptions; }

Action addRenderCommand(CLI::App& program) {
  auto request = std::make_shared<RenderRequest>();
  CLI::App* command = program.add_subcommand("render", "Shows a model in an environment");
  command->add_option("MODEL", request->model,
                      "a file (.glb .gltf .obj .ply .stl) or a built-in: none sphere torus knot teapot plane cube "
                      "showcase (default showcase)");
  addOptions(*command, renderFileOptions(), request->files);
  addOptions(*command, renderOptions(), request->options);
  return [request] { return render(*request); };
}

}  // namespace mirrorball::cli
