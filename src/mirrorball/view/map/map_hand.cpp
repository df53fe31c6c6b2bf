#include "mirrorball/view/map/map_hand.h"

#include <algorithm>
#include <cmath>

#include "mirrorball/view/control/degrees.h"

namespace mirrorball {
namespace {

/// Looks so that a direction is seen at a pixel. With the ray (x, y, z) through it, x to the right, y up and z ahead,
/// the direction's height is y cos p + z sin p at the pitch p; then the yaw brings it below the pixel.
void lookUntilSeen(glm::vec3 direction, glm::vec2 pixel, const PixelRectangle& place, MapViewSettings& settings) {
  MapViewSettings ahead = settings;
  ahead.yaw_deg = ahead.pitch_deg = 0.0f;
  const MapEye eye = mapEye(ahead, place);
  const glm::vec3 ray = glm::normalize(glm::transpose(eye.world_from_eye) * eye.rayAt(pixel));
  const float reach = std::sqrt(ray.y * ray.y + ray.z * ray.z);
  const float height = std::asin(std::clamp(direction.y / reach, -1.0f, 1.0f));
  settings.pitch_deg = std::clamp(glm::degrees(height - std::atan2(ray.y, ray.z)), -90.0f, 90.0f);
  ahead.pitch_deg = settings.pitch_deg;
  const glm::vec3 seen = mapEye(ahead, place).rayAt(pixel);
  const float yaw_rad = std::atan2(direction.x, direction.z) - std::atan2(seen.x, seen.z);
  settings.yaw_deg = wrappedAngle(glm::degrees(yaw_rad));
}

}  // namespace

MapViewSettings dragged(MapViewSettings settings, const MapCanvas& canvas, glm::vec2 from_px, glm::vec2 to_px) {
  const MapLayout layout = mapLayout(settings, canvas);
  if (!layout.inside) return settings;
  const glm::vec3 held = glm::normalize(mapEye(settings, *layout.inside).rayAt(from_px));
  lookUntilSeen(held, to_px, *layout.inside, settings);
  return settings;
}

MapViewSettings zoomed(MapViewSettings settings, const MapCanvas& canvas, float factor, glm::vec2 pointer_px) {
  const MapLayout layout = mapLayout(settings, canvas);
  if (!layout.inside) return settings;
  const glm::vec3 held = glm::normalize(mapEye(settings, *layout.inside).rayAt(pointer_px));
  const float tangent = factor * std::tan(glm::radians(settings.fov_deg) / 2.0f);
  settings.fov_deg =
      std::clamp(2.0f * glm::degrees(std::atan(tangent)), MapViewSettings::kMinFov_deg, MapViewSettings::kMaxFov_deg);
  lookUntilSeen(held, pointer_px, *layout.inside, settings);
  return settings;
}

MapViewSettings exposedBy(MapViewSettings settings, float stops) {
  const OptionText range = exposureText();
  settings.display.exposure_ev = std::clamp(settings.display.exposure_ev + stops, static_cast<float>(range.minimum),
                                            static_cast<float>(range.maximum));
  return settings;
}

}  // namespace mirrorball
