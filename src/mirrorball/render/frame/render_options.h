#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/base/result.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/material/material.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

enum class Mapping { reflection, normal, sphere };
enum class ReflectAt { vertex, fragment, triangle };
enum class FresnelOverride { material, exact, schlick, empirical };
enum class BlurKind { exact, gpu, mip, cone };
enum class Turn { camera, model, environment };  ///< what goes round in a turntable
enum class BackgroundKind { environment, blur, radiance, display_color, transparent };

/// What is averaged over the samples of a pixel.
enum class Resolve {
  display,   ///< the light that a display sends, after the tone map: what is beyond a display's white counts as white
  radiance,  ///< radiance, which is tone mapped afterwards
};

/// A point light, for Phong's model.
struct PointLight {
  glm::vec3 position{0.0f};  ///< world
  glm::vec3 color{1.0f};     ///< the radiance that a white diffuse surface facing it shows
};

/// Everything that one picture needs to be told, as the user says it: the fields that the table of render options sets.
struct RenderOptions {
  std::string size = "1280x720";
  std::vector<float> camera{30.0f, 15.0f};
  std::vector<float> target;
  float fov_deg = 35.0f;
  std::vector<float> orthographic;
  float exposure_ev = 0.0f;
  ToneMap tone_map = ToneMap::neutral;
  std::vector<float> env_rotation_deg{0.0f};  ///< yaw, pitch and roll
  float env_intensity = 1.0f;
  std::string background = "env";
  int samples = 4;
  Resolve resolve = Resolve::display;
  std::string material;
  std::vector<std::string> set;
  FresnelOverride fresnel = FresnelOverride::material;
  BlurKind blur = BlurKind::exact;
  Mapping mapping = Mapping::reflection;
  ReflectAt reflect_at = ReflectAt::fragment;
  std::vector<std::string> lights;
  int frames = 0;
  Turn turn = Turn::camera;
};

/// The table of them.
std::span<const Option<RenderOptions>> renderOptions();

/// The options in the form that the renderer takes, checked.
struct FrameSettings {
  glm::ivec2 size{1280, 720};
  CameraOptions camera;
  Display display{.tone_map = ToneMap::neutral};
  float env_rotation_rad = 0.0f;  ///< about +Y, +Z towards +X
  glm::mat3 env_tilt{1.0f};       ///< pitch and roll, which turn it before that: world from environment
  float env_intensity = 1.0f;
  BackgroundKind background = BackgroundKind::environment;
  glm::vec3 background_color{0.0f};  ///< linear: radiance, or a display's light in [0, 1]
  int samples = 4;
  Resolve resolve = Resolve::display;
  BlurKind blur = BlurKind::exact;
  Mapping mapping = Mapping::reflection;
  ReflectAt reflect_at = ReflectAt::fragment;
  std::vector<PointLight> lights;
};

/// errors   usage: names the option and what it takes
Result<FrameSettings> frameSettings(const RenderOptions& options);

/// Gives every surface of a scene the material that the options name, sets the parameters and the Fresnel form that
/// they name on all materials.
///
/// errors   usage
Result<void> applyMaterialOptions(const RenderOptions& options, Scene& scene);

}  // namespace mirrorball
