// The table of how a picture is path-traced.

#include <array>

#include "mirrorball/trace/trace_settings.h"

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
      .help = "light reaches each surface as if there were nothing else: with {option:bounces} 1, all that an "
              "environment map "
              "can know; with {option:refraction} traced, glass has its inner surfaces, as many as "
              "{option:inner-bounces} says, and with "
              "image-space one",
      .group = "Reference"},
     &TraceSettings::is_unoccluded},
    {{.name = "strategy",
      .choices = "both|light|surface",
      .help = "how paths find the environment's light and that of lamps in the model: in directions that the light "
              "chooses, "
              "that the surfaces choose, or both, "
              "weighed against each other; all show the same with more or less noise",
      .group = "Reference"},
     choiceField<&TraceSettings::strategy>},
    {{.name = "noise",
      .value = "X",
      .minimum = 1e-5,
      .maximum = 1,
      .help =
          "stop when the mean standard error of the picture is below X, with more paths where it is high; 0.004 is one "
          "step of an 8-bit picture",
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
    {{.name = "layers",
      .help = "also write what denoisers ask for, as layers of an .exr file: albedo, normal and variance",
      .group = "Reference"},
     &TraceSettings::wants_layers},
});

}  // namespace

std::span<const Option<TraceSettings>> traceOptions() { return kOptions; }

}  // namespace mirrorball
