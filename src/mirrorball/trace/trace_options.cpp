// The table of how a picture is path-traced.

#include <array>

#include "mirrorball/trace/path_tracer.h"

namespace mirrorball {
namespace {

const auto kOptions = std::to_array<Option<TraceSettings>>({
    {{.name = "bounces",
      .value = "N",
      .minimum = 1,
      .maximum = 1024,
      .help =
          "number of surfaces that light may meet on its way to the eye; with 1 the environment lights each surface, "
          "and objects that block it cast shadows",
      .group = "Reference"},
     &TraceSettings::bounces},
    {{.name = "unoccluded",
      .help = "light reaches each surface as if there were nothing else: with --bounces 1, all that an environment map "
              "can know",
      .group = "Reference"},
     &TraceSettings::is_unoccluded},
    {{.name = "noise",
      .value = "X",
      .minimum = 1e-5,
      .maximum = 1,
      .help = "stop when the mean standard error of the picture is below X; 0.004 is one step of an 8-bit picture",
      .group = "Reference"},
     &TraceSettings::noise},
    {{.name = "time",
      .value = "S",
      .unit = "seconds",
      .minimum = 0.01,
      .maximum = 1e6,
      .help = "stop at the first pass over the picture that ends after S",
      .group = "Reference"},
     &TraceSettings::time_s},
});

}  // namespace

std::span<const Option<TraceSettings>> traceOptions() { return kOptions; }

}  // namespace mirrorball
