#include "mirrorball/scene/animation/animation_choice.h"

#include <array>
#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {
namespace {

constexpr ParsedField<AnimationChoice> kAnimation{
    [](const AnimationChoice& choice) {
      return choice.name + (choice.seconds ? "@" + formatNumber(double(*choice.seconds)) : "");
    },
    [](const OptionText& text, std::string_view written, AnimationChoice& choice) -> Result<void> {
      const std::size_t at = written.rfind('@');
      // A name may have an @ of its own.
      const auto seconds = at == std::string_view::npos ? std::nullopt : parseNumber(written.substr(at + 1));
      const std::string_view name = seconds ? written.substr(0, at) : written;
      constexpr double kLongest = 1e9;
      if (name.empty() || name.ends_with('@') || (seconds && !(*seconds >= 0.0 && *seconds <= kLongest)))
        return misused(text, "the name or number of an animation, and behind an @ seconds from 0 on", written);
      choice.name = name;
      choice.seconds = seconds ? std::optional(static_cast<float>(*seconds)) : std::nullopt;
      return {};
    }};

const auto kAnimationOptions = std::to_array<Option<AnimationChoice>>({
    {{.name = "animation",
      .value = "NAME|N[@SECONDS]",
      .help = "show the model as this one of its own animations has it, by name or number, at that time or at the "
              "start; a wrong name lists them, and so does `mirrorball info`",
      .group = "Picture"},
     kAnimation},
});

}  // namespace

std::span<const Option<AnimationChoice>> animationOptions() { return kAnimationOptions; }

Result<std::size_t> chosenAnimation(const Scene& scene, const AnimationChoice& choice) {
  std::vector<std::string_view> names;
  for (const Animation& animation : scene.rig.animations) names.emplace_back(animation.name);
  if (names.empty())
    return fail(ErrorCode::usage, "the model has no animations, so none is named '" + excerpt(choice.name) + "'");
  if (const auto index = indexOfName(choice.name, names)) return *index;
  const auto number = parseNumber(choice.name);
  if (number && *number >= 1.0 && *number <= double(names.size()) && *number == double(std::size_t(*number)))
    return std::size_t(*number) - 1;
  return tl::unexpected<Error>(unknownName("animation", choice.name, names));
}

}  // namespace mirrorball
