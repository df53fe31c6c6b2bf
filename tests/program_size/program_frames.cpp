#include "program_size/program_frames.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "mirrorball/base/text.h"
#include "mirrorball/render/frame/render_inputs.h"
#include "mirrorball/render/render_testing.h"
#include "mirrorball/render/settings/frame_checks.h"
#include "mirrorball/render/stage/device_state.h"
#include "mirrorball/render/surface/surface_shaders.h"

namespace mirrorball::testing {
namespace {

/// What `mirrorball render` loads for the frame's command line.
RenderInputNames parseFrame(const ProgramFrame& frame) {
  FrameSettings settings;
  std::set<std::string_view> stated;
  for (const auto& [name, value] : frame.options) {
    set(settings, name, value);
    stated.insert(name);
  }
  std::string environment = "studio";
  if (frame.model == "showcase") setShowcase(stated, environment, settings);
  standOnGround(settings);
  return {std::string(frame.model),
          {},
          UpAxis::y,
          {.material = std::string(frame.material), .set = frame.set},
          settings,
          environment,
          {},
          {},
          {},
          TechniqueWishes{Quality::good, stated}};
}

/// The name of an instance's material.
const std::string& nameMaterial(const Scene& scene, std::size_t instance) {
  const Mesh& mesh = *scene.meshes[std::size_t(scene.instances[instance].mesh)];
  return scene.materials[std::size_t(mesh.material)].name;
}

}  // namespace

std::span<const ProgramFrame> programFrames() {
  static const std::vector<ProgramFrame> frames{
      {.name = "showcase", .model = "showcase"},
      {.name = "sphere", .model = "sphere"},
      {.name = "traced glass", .model = "sphere", .material = "glass", .options = {{"refraction", "traced"}}},
      {.name = "brushed metal", .model = "sphere", .material = "brushed-metal"},
      {.name = "clear coat", .model = "sphere", .material = "car-paint"},
      {.name = "self-reflection", .model = "teapot", .material = "mirror"},
      {.name = "probes", .model = "sphere", .material = "glass", .options = {{"probes", "1"}}},
      {.name = "normal map", .model = "sphere", .material = "plastic", .set = {"normal_map=stripes"}},
  };
  return frames;
}

Result<std::vector<SurfaceProgram>> findPrograms(const ProgramFrame& frame) {
  MIRRORBALL_TRY(inputs, loadRenderInputs(parseFrame(frame)));
  const FrameSettings settings = inputs.frame;
  MIRRORBALL_TRY(renderer, Renderer::on(std::move(inputs.context)));
  MIRRORBALL_TRY_VOID(renderer.setEnvironment(std::move(inputs.environment), inputs.prepared));
  MIRRORBALL_TRY_VOID(renderer.setScene(std::move(inputs.scene)));
  MIRRORBALL_TRY_VOID(renderer.begin(settings));
  MIRRORBALL_TRY(variants, renderer.surfaceVariants());
  std::map<SurfaceVariant, std::vector<std::string>> materials;
  for (std::size_t instance = 0; instance < variants.size(); ++instance) {
    std::vector<std::string>& names = materials[variants[instance]];
    const std::string& name = nameMaterial(renderer.scene(), instance);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  // Faces of probes are drawn when a frame begins. Its mirror image in the ground has no further programs
  // (GroundMirrorTest).
  for (const auto& [variant, program] : renderer.stage().device().state().surfaces().programs())
    if (std::vector<std::string>& names = materials[variant]; names.empty()) names.push_back("faces of probes");
  std::vector<SurfaceProgram> programs;
  for (const auto& [variant, names] : materials) {
    MIRRORBALL_TRY(shaders, surfaceShaders(gl::Api::desktop43, variant));
    std::string name(frame.name);
    if (materials.size() > 1) name += ": " + join(names, ", ", " and ");
    programs.push_back({std::move(name), std::move(shaders.fragment.text)});
  }
  return programs;
}

}  // namespace mirrorball::testing
