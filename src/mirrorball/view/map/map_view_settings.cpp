#include "mirrorball/view/map/map_view_settings.h"

#include <array>
#include <string>

namespace mirrorball {
namespace {

/// "all|inside|equirect|…": pages, and in place of the last of them the projections by their names.
std::string_view pictureChoices() {
  static const std::string choices = "all|inside|" + join(projectionNames(), "|");
  return choices;
}

constexpr ChoiceField<MapViewSettings> kPicture{
    [](const MapViewSettings& settings) {
      const int page = static_cast<int>(settings.page);
      return settings.page == MapPage::one ? page + static_cast<int>(settings.projection) : page;
    },
    [](MapViewSettings& settings, int index) {
      constexpr int kFirst = static_cast<int>(MapPage::one);
      settings.page = index < kFirst ? static_cast<MapPage>(index) : MapPage::one;
      if (index >= kFirst) settings.projection = static_cast<Projection::Kind>(index - kFirst);
    }};

const auto kMapViewOptions = std::to_array<Option<MapViewSettings>>({
    {{.name = "picture",
      .choices = pictureChoices(),
      .help = "every projection at once, what is seen from inside, or one projection",
      .group = "Map",
      .is_daily = true},
     kPicture},
    {{.name = "yaw",
      .value = "DEG",
      .unit = "degrees",
      .help = "where one looks from inside: 0 is +Z, 90 is +X",
      .group = "Map",
      .soft_minimum = -180,
      .soft_maximum = 180,
      .step = 1},
     &MapViewSettings::yaw_deg},
    {{.name = "pitch",
      .value = "DEG",
      .unit = "degrees",
      .minimum = -90,
      .maximum = 90,
      .help = "how far one looks up from inside",
      .group = "Map",
      .step = 1},
     &MapViewSettings::pitch_deg},
    {{.name = "fov",
      .value = "DEG",
      .unit = "degrees",
      .minimum = double(MapViewSettings::kMinFov_deg),
      .maximum = double(MapViewSettings::kMaxFov_deg),
      .help = "vertical field of view from inside",
      .group = "Map",
      .is_daily = true,
      .soft_minimum = 10,
      .soft_maximum = 120,
      .step = 1},
     &MapViewSettings::fov_deg},
    {{.name = "ball-distance",
      .value = "RADII",
      .unit = "ball radii",
      .minimum = double(Projection::kMinBallDistance),
      .maximum = 1e6,
      .help = "from the camera to the middle of the ball that is photographed",
      .group = "Map",
      .soft_maximum = 40,
      .step = 0.1},
     &MapViewSettings::ball_distance},

    {{.name = "light",
      .choices = "map|mip|prefiltered|irradiance|harmonics",
      .help = "the map's own, a {option:level} of mip levels, what a surface of a {option:roughness} reflects, what a "
              "white diffuse surface does, or what harmonics of a {option:degree} keep of the map",
      .group = "Light",
      .is_daily = true},
     choiceField<&MapViewSettings::light>},
    {{.name = "level",
      .value = "N",
      .minimum = 0,
      .maximum = 20,
      .help = "mip level, each half as wide as the one before; past the last it is the last",
      .group = "Light",
      .step = 1},
     &MapViewSettings::level},
    {{.name = "roughness",
      .value = "R",
      .minimum = 0,
      .maximum = 1,
      .help = "perceptual roughness of the surface whose reflections are shown",
      .group = "Light",
      .step = 0.01},
     &MapViewSettings::perceptual_roughness},
    {{.name = "degree",
      .value = "L",
      .minimum = 0,
      .maximum = MapViewSettings::kMaxDegree,
      .help = "highest band of the harmonics",
      .group = "Light",
      .step = 1},
     &MapViewSettings::degree},

    {exposureText(), numberField<&MapViewSettings::display, &Display::exposure_ev>},
    {toneMapText(), choiceField<&MapViewSettings::display, &Display::tone_map>},
    {{.name = "false-colors",
      .help = "colours for luminance in stops, in place of the tone map",
      .group = "Picture",
      .is_daily = true},
     &MapViewSettings::false_colors},
    {{.name = "stops",
      .value = "N",
      .unit = "stops",
      .minimum = 1,
      .maximum = 30,
      .help = "how far {option:false-colors} and the {option:waveform} reach below and above 1, after the exposure",
      .group = "Picture",
      .soft_maximum = 16,
      .step = 1},
     &MapViewSettings::stops},

    {{.name = "bad-texels",
      .help = "mark texels that are NaN, infinite, negative or too bright to be summed",
      .group = "Marks"},
     &MapViewSettings::marks_bad},
    {{.name = "lamps", .help = "mark the brightest lamps", .group = "Marks", .is_daily = true},
     &MapViewSettings::marks_lamps},
    {{.name = "waveform",
      .help = "show how luminance is spread in each column of the panorama",
      .group = "Marks",
      .is_daily = true},
     &MapViewSettings::waveform},
});

}  // namespace

Projection projectionOf(const MapViewSettings& settings, Projection::Kind kind) {
  return kind == Projection::ball ? Projection::ballFrom(settings.ball_distance) : Projection(kind);
}

std::span<const Option<MapViewSettings>> mapViewOptions() { return kMapViewOptions; }

}  // namespace mirrorball
