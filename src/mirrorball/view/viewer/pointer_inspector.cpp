#include "mirrorball/view/viewer/pointer_inspector.h"

#include <utility>

#include "mirrorball/render/stage/stage_state.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/relief/relief.h"
#include "mirrorball/view/inspect/screen_lines.h"

namespace mirrorball {

void PointerInspector::follow(const LitStage& stage, const FrameSettings& frame) {
  if (!isOf(stage, frame)) {
    begun_version_ = stage.version();
    begun_relief_ = frame.relief;
    inspector_.reset();
    problem_.clear();
    sorting_.begin([scene = stage.stage().scene(), relief = frame.relief](
                       const ProgressFunction& progress) -> Result<std::shared_ptr<const Inspector>> {
      auto prepared = std::make_shared<Scene>(scene);
      MIRRORBALL_TRY_VOID(prepareRelief(*prepared, relief));
      MIRRORBALL_TRY(made, Inspector::make(std::move(prepared), {.relief = relief}, progress));
      return std::make_shared<const Inspector>(std::move(made));
    });
  }
  auto ready = sorting_.take();
  if (!ready) return;
  if (*ready)
    inspector_ = std::move(**ready);
  else
    problem_ = ready->error().message;
}

Result<std::optional<Inspection>> PointerInspector::at(const LitStage& stage, const FrameSettings& frame,
                                                       glm::vec2 place_px) const {
  if (!inspector_) return std::optional<Inspection>();
  const Scene& scene = inspector_->scene();
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), frame.camera, frame.size));
  MIRRORBALL_TRY(proxy, placedProxy(frame.proxy, scene));
  const LightAround around{.environment = stage.stage().state().light.sharedEnvironment(),
                           .environment_from_world = frame.environmentFromWorld(),
                           .intensity = frame.env_intensity,
                           .proxy = std::move(proxy)};
  return inspector_->inspectedAt(camera, frame.size, place_px, around);
}

namespace {

void addLines(const RayPath& path, glm::vec3 color, const Camera& camera, glm::ivec2 size_px, UnderPointer& drawn) {
  for (const ScreenLine& line : projected(path, camera, size_px)) drawn.lines.push_back({{line.from, line.to}, color});
}

DrawnPlot plotOf(const FresnelCurve& curve) {
  const auto placed = [](float angle_deg, float reflectance) {
    return glm::vec2(angle_deg / 90.0f, 1.0f - reflectance);
  };
  DrawnPlot plot{.title = "Fresnel: what is reflected, from 0 to 90 degrees"};
  for (int channel = 0; channel < 3; ++channel) {
    DrawnLine& line = plot.lines.emplace_back();
    line.color = glm::vec3(0.35f);
    line.color[channel] = 1.0f;
    for (const FresnelSample& sample : curve.samples)
      line.places.push_back(placed(sample.angle_deg, sample.reflectance[channel]));
  }
  plot.dot = placed(curve.here.angle_deg, curve.here.reflectance.g);
  return plot;
}

}  // namespace

UnderPointer drawnInspection(const Inspection& inspection, const Camera& camera, glm::ivec2 size_px) {
  UnderPointer drawn{.rows = inspection.rows};
  if (!inspection.surface) return drawn;
  const InspectedSurface& surface = *inspection.surface;
  if (surface.reflected) addLines(*surface.reflected, kReflectedColor, camera, size_px, drawn);
  if (surface.refracted) addLines(*surface.refracted, kRefractedColor, camera, size_px, drawn);
  drawn.plots.push_back(plotOf(surface.fresnel));
  return drawn;
}

}  // namespace mirrorball
