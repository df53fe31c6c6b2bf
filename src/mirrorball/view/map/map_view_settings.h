#pragma once

#include <span>

#include "mirrorball/base/option.h"
#include "mirrorball/codec/color/display.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {

/// Which pictures of a map are shown.
enum class MapPage {
  all,     ///< every projection on one sheet
  inside,  ///< what an eye in the middle sees
  one,     ///< MapViewSettings::projection
};

/// Which light of a map is shown.
enum class MapLight {
  map,          ///< its own
  mip,          ///< a mip level of the cube that smooth mirrors read
  prefiltered,  ///< the mean under the lobe of a rough surface, as `--blur exact` reads it
  irradiance,   ///< divided by π: of a white diffuse surface, from harmonics
  harmonics,    ///< what harmonics keep of the radiance itself
};

/// All that says how a map is looked at without a model: a value. Two that are equal show the same.
struct MapViewSettings {
  static constexpr float kMinFov_deg = 1.0f;
  static constexpr float kMaxFov_deg = 150.0f;
  static constexpr int kMaxDegree = 4;

  MapPage page = MapPage::all;
  Projection::Kind projection = Projection::equirect;    ///< of MapPage::one
  float ball_distance = Projection::kUsualBallDistance;  ///< of every ball, in ball radii
  float yaw_deg = 0.0f;                                  ///< where one looks from inside: 0 is +Z, 90 is +X
  float pitch_deg = 0.0f;                                ///< 90 is +Y
  float fov_deg = 90.0f;                                 ///< vertical
  MapLight light = MapLight::map;
  int level = 1;                      ///< of MapLight::mip; past the last it is the last
  float perceptual_roughness = 0.5f;  ///< of MapLight::prefiltered
  int degree = 2;                     ///< highest band of MapLight::irradiance and harmonics, 0 … kMaxDegree
  Display display{.tone_map = ToneMap::neutral, .dither = Dither::pattern};
  bool false_colors = false;  ///< of the luminance, in place of the tone map
  float stops = 8.0f;         ///< above 0: how far false colours and the waveform reach from 1, after the exposure
  bool marks_bad = true;      ///< texels that are no light: FaultyTexels
  bool marks_lamps = false;
  bool waveform = false;

  bool operator==(const MapViewSettings&) const = default;
};

/// A projection as those settings show it.
Projection projectionOf(const MapViewSettings& settings, Projection::Kind kind);

/// The table of these settings.
std::span<const Option<MapViewSettings>> mapViewOptions();

}  // namespace mirrorball
