#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/scene/point_light.h"
#include "mirrorball/scene/proxy/proxy.h"
#include "mirrorball/scene/relief/relief.h"

namespace mirrorball {

/// How the light of the environment and of what shines in the scene is found. All find the same, with more or less
/// noise.
enum class LightStrategy {
  both,     ///< weighed against each other (Veach & Guibas 1995)
  light,    ///< in directions that the light chooses: noisy on what is nearly smooth
  surface,  ///< in directions that the surfaces choose: noisy where the sun is small
};

/// What a path-traced picture shows, and when it is good enough.
struct TraceSettings {
  glm::ivec2 size{1280, 720};  ///< pixels
  int samples = 256;           ///< paths of each pixel, at most; at least 1
  float noise = 0.0f;          ///< mean standard error of the displayed picture, in [0, 1], that is enough; 0: none is
  float time_s = 0.0f;         ///< after which no further pass over the picture is begun; 0: no limit
  Display display = {};        ///< that `noise` is about
  /// Surfaces that light may meet on its way to the eye. 1: the environment lights each surface, and what blocks it is
  /// dark; with `is_unoccluded`, nothing blocks it, which is all that an environment map can know.
  int bounces = 16;
  /// Light reaches each surface as if there were nothing else.
  bool is_unoccluded = false;
  /// With is_unoccluded, in place of `bounces`: how many surfaces light still meets once it is in a body, those of
  /// other bodies too. What goes on after that is the light from far away along its last direction.
  int inner_bounces = 0;
  /// Each material has its index at this wavelength [nm], and light keeps its three channels; 0: light is of all
  /// wavelengths.
  float wavelength_nm = 0.0f;
  /// How heights are shown, in a scene that was prepared for it (prepareRelief). All kinds that move the place of the
  /// surface are exact.
  ReliefKind relief = ReliefKind::bump;
  LightStrategy strategy = LightStrategy::both;
  glm::mat3 environment_from_world{1.0f};    ///< turns the environment
  float environment_intensity = 1.0f;        ///< scales its light
  ProxyOptions proxy = {};                   ///< what the environment's light comes from
  bool shows_environment = true;             ///< behind the scene; of its ground else the shadow alone
  std::optional<glm::vec3> background = {};  ///< radiance there if the environment is not shown; nothing: transparent
  std::vector<PointLight> lights = {};       ///< by Phong's model, as the renderer has them, but with shadows
  float light_intensity = 1.0f;              ///< scales the scene's own lights
  bool wants_layers = false;                 ///< also what denoisers ask for (TraceLayers)
};

/// The table of those settings that only a path tracer has.
std::span<const Option<TraceSettings>> traceOptions();

}  // namespace mirrorball
