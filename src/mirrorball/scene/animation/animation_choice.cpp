#include "mirrorball/scene/animation/animation_choice.h"

#include <string_view>
#include <vector>

#include "mirrorball/base/text.h"
#include "mirrorball/scene/scene.h"

namespace mirrorball {

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
