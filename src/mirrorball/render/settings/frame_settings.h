#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/scene/camera/camera.h"
#include "mirrorball/scene/point_light.h"
#include "mirrorball/scene/proxy/proxy.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {

enum class Mapping { reflection, normal, sphere };

/// What generates texture coordinates, as OpenGL's glTexGen does (formula/surface/texgen.glsl).
enum class Texgen { none, object_linear, eye_linear, sphere, reflection, normal, light };

enum class ReflectAt { vertex, fragment, triangle };

/// How a shader finds the light of a direction.
enum class LightLookUp {
  cube,          ///< a cube sampler does
  flat,          ///< it finds the face and the texels in a picture of six faces, and weighs four of them
  flat_nearest,  ///< and takes the nearest
};

/// How textures and the mirrored environment are read (formula/surface/filter_kind.glsl).
enum class TextureFilter { nearest, bilinear, trilinear, anisotropic };

enum class BlurKind { exact, gpu, mip, cone };
enum class LobeTaps { one, two, four, six };
enum class RefractionKind {
  single,
  image_space,
  traced,
  automatic,  ///< traced through bodies of few triangles, image_space through others: refractionOf()
};

/// How the environment's small and bright lamps light a scene.
enum class SunKind {
  map,    ///< by the map that they are in
  split,  ///< as discs that are taken out of it, which the scene shadows (light_edit/sun_split.h)
};

/// What hides the environment from surfaces, beside their own relief and textures.
enum class OcclusionKind {
  none,
  vertex,  ///< the scene itself, as far as its vertices know: Instance::occlusion
};

/// Which kinds of light go their own ways through glass that disperses.
enum class DispersionKind {
  channels,  ///< red, green and blue, each with one index
  spectral,  ///< FrameSettings::wavelengths, each with its own index
};

/// What is seen through glass and other surfaces that let light through.
enum class BehindKind {
  far,     ///< the environment, even if the surface has a probe
  probes,  ///< what it reflects, too: its probe's light, or without one the environment
  screen,  ///< opaque surfaces that are in the picture, and that light where the ray meets none
};

enum class BackgroundKind { environment, blur, radiance, display_color, transparent };

/// What is averaged over the samples of a pixel.
enum class Resolve {
  display,   ///< the light that a display sends, after the tone map: light above the display's white counts as white
  radiance,  ///< radiance, which is tone mapped afterwards
};

/// Of which pixels a frame's samples are drawn.
enum class Sampling {
  adaptive,  ///< after the first ones, of those that are still seen to change; of Resolve::display alone
  all,
};

/// All settings of one picture of a scene in an environment.
struct FrameSettings {
  static constexpr std::size_t kMaxLights = 8;
  static constexpr int kMostProbes = 64;
  static constexpr int kAutoProbes = -1;  ///< at most kSomeProbes
  static constexpr int kSomeProbes = 8;

  glm::ivec2 size{1280, 720};  ///< pixels
  CameraOptions camera = {};
  Display display{.tone_map = ToneMap::neutral, .dither = Dither::pattern};
  glm::vec3 env_rotation_deg{
      0.0f};  ///< yaw about +Y, +Z towards +X; before it pitch about +X, before that roll about +Z
  float env_intensity = 1.0f;
  SunKind sun = SunKind::map;
  bool stands = false;      ///< on the ground that the environment shows: standOnGround()
  ProxyOptions proxy = {};  ///< what the environment's light comes from
  int probes = 0;           ///< that are captured at reflective objects at most, 0 … kMostProbes or kAutoProbes
  int probe_size = 0;       ///< side of their faces [texels], 8 … 1024; 0: by the picture's height
  int probe_bounces = 2;    ///< how often light goes from object to object in what they capture, 1 … 8
  BehindKind behind = BehindKind::probes;
  BackgroundKind background = BackgroundKind::environment;
  glm::vec3 background_color{0.0f};  ///< linear: radiance, or a display's light in [0, 1]
  int samples = 4;                   ///< of each pixel, 1 … 4096
  Sampling sampling = Sampling::adaptive;
  Resolve resolve = Resolve::display;
  BlurKind blur = BlurKind::exact;
  LobeTaps lobe_taps = LobeTaps::four;  ///< that make up what a rough surface reflects
  Mapping mapping = Mapping::reflection;
  ReflectAt reflect_at = ReflectAt::fragment;
  ReliefKind relief = ReliefKind::bump;
  int relief_steps = 64;  ///< of those kinds that go in steps, 4 … 1024
  RefractionKind refraction = RefractionKind::single;
  int inner_bounces = 4;  ///< surfaces that light meets after the one drawn, where bodies are traced, 1 … 32
  DispersionKind dispersion = DispersionKind::channels;
  int wavelengths = 12;        ///< that a sample of a pixel is drawn of where dispersion is spectral, 8 … 16
  float wavelength_nm = 0.0f;  ///< TraceSettings::wavelength_nm, 380 … 780; 0: none
  OcclusionKind occlusion = OcclusionKind::none;
  bool self_reflection =
      false;  ///< surfaces reflect the scene by a ray; with OcclusionKind::vertex, where looks are known
  LightLookUp look_up = LightLookUp::cube;
  TextureFilter texture_filter = TextureFilter::trilinear;
  Texgen texgen = Texgen::none;         ///< for base_color_map where the scene has one, else for the environment
  glm::mat4 texture_matrix{1.0f};       ///< of these coordinates, or of those that there are without them
  std::vector<PointLight> lights = {};  ///< at most kMaxLights, beside the scene's own
  float light_intensity = 1.0f;         ///< scales the scene's own lights

  bool operator==(const FrameSettings&) const = default;

  /// Directions of the environment from those of the world.
  glm::mat3 environmentFromWorld() const;
  /// Whether suns may stand apart: on a near proxy they are no directions, and other coordinates than those of the
  /// reflected ray show them elsewhere.
  bool canSplitSuns() const;
  /// Where they are.
  SunKind sunShown() const { return canSplitSuns() ? sun : SunKind::map; }
  /// Whether the environment is seen behind everything, sharp or blurred.
  bool showsEnvironment() const {
    return background == BackgroundKind::environment || background == BackgroundKind::blur;
  }
};

/// Where `stands` says so, the light comes from a ground unless from another proxy, and the camera holds the shadow
/// too.
void standOnGround(FrameSettings& settings);

/// Lets the camera of a model that stands hold its shadow too (CameraOptions::ground_light), which a sun throws.
///
/// sun   towards it, in the environment (strongSun()); nothing: soft shadows lie beside the model's foot
void holdShadow(FrameSettings& settings, std::optional<glm::vec3> sun);

/// How many lobes make up what a rough surface reflects: of prefiltered light as many as the settings say, else one.
int lobesOf(const FrameSettings& settings);

/// The table of these settings.
std::span<const Option<FrameSettings>> frameOptions();

}  // namespace mirrorball
