#include "mirrorball/light_edit/lamp_settings.h"

#include <array>

namespace mirrorball {
namespace {

const auto kLampOptions = std::to_array<Option<LampSettings>>({
    {{.name = "max",
      .value = "N",
      .minimum = 1,
      .maximum = 1000,
      .help = "how many lamps at most, the strongest first",
      .group = "Lamps"},
     &LampSettings::max},
    {{.name = "min-share",
      .value = "X",
      .minimum = 0,
      .maximum = 1,
      .help = "share of all light of the map that a lamp has at least",
      .group = "Lamps"},
     &LampSettings::min_share},
    {{.name = "max-size",
      .value = "DEG",
      .unit = "degrees",
      .minimum = 0,
      .maximum = 20,
      .help = "with {option:split}, angular size of the lamps that are taken out of the map; wider ones stay in it",
      .group = "Lamps"},
     &LampSettings::max_size_deg},
});

}  // namespace

std::span<const Option<LampSettings>> lampOptions() { return kLampOptions; }

}  // namespace mirrorball
