#include "mirrorball/contact/contact_settings.h"

#include <array>
#include <string_view>

#include "mirrorball/base/text.h"
#include "mirrorball/codec/color/hex_color.h"
#include "mirrorball/codec/image_format.h"
#include "mirrorball/environment/builtin/builtin.h"
#include "mirrorball/environment/projection/projection.h"

namespace mirrorball {
namespace {

using Field = ParsedField<ContactSettings>;

constexpr std::string_view kAutomatic = "auto";

constexpr Field kExposure{
    [](const ContactSettings& settings) {
      return settings.exposure_ev ? formatNumber(double(*settings.exposure_ev)) : std::string(kAutomatic);
    },
    [](const OptionText& text, std::string_view written, ContactSettings& settings) -> Result<void> {
      settings.exposure_ev.reset();
      if (indexOfName(written, {&kAutomatic, 1})) return {};
      if (!parseNumber(written)) return misused(text, "a number or auto", written);
      MIRRORBALL_TRY(numbers, parseNumbers(text, written));
      settings.exposure_ev = numbers[0];
      return {};
    }};

constexpr Field kBackground{
    [](const ContactSettings& settings) { return hexColor(settings.background); },
    [](const OptionText& text, std::string_view written, ContactSettings& settings) -> Result<void> {
      const auto color = parseHexColor(written);
      if (!color) return misused(text, "a colour, '#rrggbb'", written);
      settings.background = *color;
      return {};
    }};

constexpr OptionText kExposureText{
    .name = "exposure",
    .value = "auto|EV",
    .unit = "stops",
    .minimum = -30,
    .maximum = 30,
    .help =
        "exposure of all maps and models, applied before the tone map; auto exposes each map so that the geometric "
        "mean of its light becomes a middle grey, and leaves models as `render` shows them",
    .group = "Picture",
    .is_daily = true};

const std::string kEnvironmentHelp = "the environment that models are shown in: a map (" +
                                     std::string(readExtensions()) +
                                     ") or a built-in: " + join(builtinEnvironmentNames());

const auto kOptions = std::to_array<Option<ContactSettings>>({
    {{.name = "columns",
      .value = "N",
      .minimum = 0,
      .maximum = 1000,
      .help = "number of cells side by side; 0: as many as bring the sheet's shape nearest to 16:10",
      .group = "Picture",
      .is_daily = true},
     &ContactSettings::columns},
    {{.name = "size",
      .value = "W",
      .unit = "pixels",
      .minimum = 32,
      .maximum = 4096,
      .help = "width of a cell",
      .group = "Picture",
      .is_daily = true},
     &ContactSettings::width_px},
    {environmentText(kEnvironmentHelp), &ContactSettings::environment},
    {formText("form of the maps, where it is not recognised (see convert --from)", "Files"), &ContactSettings::from},
    {kExposureText, kExposure},
    {{.name = "background",
      .value = "COLOR",
      .help = "colour of the sheet, and behind models, as '#rrggbb'",
      .group = "Picture"},
     kBackground},
});

}  // namespace

std::span<const Option<ContactSettings>> contactOptions() { return kOptions; }

}  // namespace mirrorball
