#include "mirrorball/study/traced_frame.h"

namespace mirrorball {

TraceSettings tracedFrame(const FrameSettings& frame, TraceSettings settings) {
  constexpr int kManySamples = 1 << 20;
  if (settings.noise > 0.0f || settings.time_s > 0.0f) settings.samples = kManySamples;
  settings.size = frame.size;
  settings.display = frame.display;
  settings.environment_from_world = frame.environmentFromWorld();
  settings.environment_intensity = frame.env_intensity;
  settings.proxy = frame.proxy;
  settings.shows_environment = frame.background == BackgroundKind::environment;
  if (frame.background == BackgroundKind::radiance) settings.background = frame.background_color;
  settings.wavelength_nm = frame.wavelength_nm;
  settings.relief = frame.relief;
  settings.lights = frame.lights;
  settings.light_intensity = frame.light_intensity;
  if (frame.refraction == RefractionKind::traced || frame.refraction == RefractionKind::automatic)
    settings.inner_bounces = frame.inner_bounces;
  if (frame.refraction == RefractionKind::image_space) settings.inner_bounces = 1;
  return settings;
}

glm::vec4 backdropOf(const FrameSettings& frame) {
  return frame.background == BackgroundKind::display_color ? glm::vec4(frame.background_color, 1.0f) : glm::vec4(0.0f);
}

}  // namespace mirrorball
