#include "mirrorball/render/settings/frame_checks.h"

#include <utility>

#include "mirrorball/environment/builtin/sunset.h"
#include "mirrorball/scene/camera/framing.h"
#include "mirrorball/scene/proxy/proxy.h"

namespace mirrorball {
namespace {

/// A model's own camera leaves nothing to them.
Result<void> checkCameraOptions(const CameraOptions& camera, const std::set<std::string_view>& given) {
  if (camera.name.empty()) return {};
  for (const std::string_view name : {"target", "fov", "orthographic"})
    if (given.contains(name))
      return fail(ErrorCode::usage, "{option:" + std::string(name) + "}: the camera '" + camera.name +
                                        "' has its own; leave it out, or give {option:camera} AZIMUTH,ELEVATION");
  return {};
}

Result<void> checkProxyOptions(const ProxyOptions& proxy) {
  if (proxy.ground_roughness < 1.0f && proxy.kind != ProxyKind::ground)
    return fail(ErrorCode::usage,
                "{option:ground-roughness} is of the ground below the model; add {option:proxy} ground");
  if (proxy.kind != ProxyKind::none || !proxy.captured_at) return {};
  return fail(ErrorCode::usage,
              "{option:captured-at} is where the map of a {option:proxy} was captured; add {option:proxy}");
}

}  // namespace

Result<void> checkSettings(const FrameSettings& settings, const std::set<std::string_view>& given) {
  if (settings.stands && given.contains("proxy") && settings.proxy.kind != ProxyKind::ground)
    return fail(ErrorCode::usage, "{option:stand} is on a ground; leave {option:proxy} " +
                                      writtenProxy(settings.proxy) + " out, or say {option:proxy} ground:HEIGHT");
  if (settings.self_reflection && given.contains("occlusion") && settings.occlusion == OcclusionKind::none)
    return fail(ErrorCode::usage,
                "{option:self-reflection} knows what hides the sky; leave {option:occlusion} none out");
  if (settings.texgen == Texgen::light && settings.lights.empty())
    return fail(ErrorCode::usage,
                "{option:texgen} light projects from where the first light is; add {option:light} X,Y,Z,R,G,B");
  MIRRORBALL_TRY_VOID(checkCameraOptions(settings.camera, given));
  FrameSettings standing = settings;
  standOnGround(standing);
  return checkProxyOptions(standing.proxy);
}

Result<std::vector<std::string>> checkFrame(const FrameSettings& settings, const Scene& scene) {
  std::vector<std::string> doubts;
  const ProxyOptions& options = settings.proxy;
  // Triangles hold every place, and are read by who draws.
  if (options.kind == ProxyKind::none || options.kind == ProxyKind::mesh) return doubts;
  MIRRORBALL_TRY(proxy, placedProxy(options, scene));
  MIRRORBALL_TRY(camera, framedCamera(scene, boundingSphere(scene), settings.camera, settings.size));
  const std::string name = writtenProxy(options);
  if (proxy.kind == ProxyKind::ground && camera.position.y < proxy.ground)
    return fail(
        ErrorCode::usage,
        "{option:proxy} " + name + ": the camera is below the ground; raise it by {option:camera} AZIMUTH,ELEVATION");
  if (options.mirrorsScene() && settings.background != BackgroundKind::environment)
    doubts.emplace_back(
        "{option:ground-roughness}: the ground's mirror image is shown with the environment behind the model alone");
  if (!camera.orthographic && !proxy.holds(camera.position))
    doubts.push_back("the camera is outside of the proxy " + name + ", and looks into it as through a window");
  const Box box = boundingBox(scene);
  if (!box.isEmpty() && !(proxy.holds(box.low) && proxy.holds(box.high)))
    doubts.push_back("the proxy " + name +
                     " does not hold all of the model; what is outside sees what its nearest place within sees");
  return doubts;
}

void setShowcase(const std::set<std::string_view>& given, std::string& environment, FrameSettings& settings) {
  if (!given.contains("camera")) settings.camera.elevation_deg = 9.0f;
  if (!hasSunset()) return;
  environment = "sunset";
  if (!given.contains("env-rotation")) settings.env_rotation_deg = glm::vec3(270.0f, 0.0f, 0.0f);
  if (given.contains("proxy")) return;
  settings.proxy.kind = ProxyKind::ground;
  settings.proxy.height = 2.5f;
  if (!given.contains("ground-roughness") && !given.contains("background")) settings.proxy.ground_roughness = 0.3f;
}

}  // namespace mirrorball
