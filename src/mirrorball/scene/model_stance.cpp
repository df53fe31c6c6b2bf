#include "mirrorball/scene/model_stance.h"

#include <array>
#include <string_view>

#include "mirrorball/base/text.h"

namespace mirrorball {
namespace {

constexpr ParsedField<ModelStance> kAnimation{
    [](const ModelStance& stance) {
      const AnimationChoice& choice = stance.animation;
      return choice.name + (choice.seconds ? "@" + formatNumber(double(*choice.seconds)) : "");
    },
    [](const OptionText& text, std::string_view written, ModelStance& stance) -> Result<void> {
      const std::size_t at = written.rfind('@');
      // A name may have an @ of its own.
      const auto seconds = at == std::string_view::npos ? std::nullopt : parseNumber(written.substr(at + 1));
      const std::string_view name = seconds ? written.substr(0, at) : written;
      constexpr double kLongest = 1e9;
      if (name.empty() || name.ends_with('@') || (seconds && !(*seconds >= 0.0 && *seconds <= kLongest)))
        return misused(text, "the name or number of an animation, and behind an @ seconds from 0 on", written);
      stance.animation.name = name;
      stance.animation.seconds = seconds ? std::optional(static_cast<float>(*seconds)) : std::nullopt;
      return {};
    }};

const auto kStanceOptions = std::to_array<Option<ModelStance>>({
    {{.name = "up",
      .choices = "y|z",
      .aliases = "+y=y|+z=z",
      .help = "axis of the model that points up: z in many .stl and CAD files, which lie on their side without it",
      .group = "Model",
      .is_daily = true},
     choiceField<&ModelStance::up>},
    {{.name = "animation",
      .value = "NAME|N[@SECONDS]",
      .help = "show the model as this one of its own animations has it, by name or number, at that time or at the "
              "start; a wrong name lists them, and so does `mirrorball info`",
      .group = "Model"},
     kAnimation},
});

}  // namespace

std::span<const Option<ModelStance>> stanceOptions() { return kStanceOptions; }

}  // namespace mirrorball
