#include "mirrorball/view/workspace/asked_map.h"

#include <array>
#include <cmath>
#include <utility>

#include "mirrorball/base/range.h"
#include "mirrorball/base/text.h"
#include "mirrorball/environment/builtin/builtin.h"

namespace mirrorball {

AskedMap askedMap(const Workspace& workspace, std::size_t side) { return askedMap(workspace, mapOf(workspace, side)); }

AskedMap askedMap(const Workspace& workspace, const std::string& name) {
  AskedMap map{name};
  if (const auto found = workspace.photos.find(name); found != workspace.photos.end()) map.photo = found->second;
  return map;
}

Result<BallPhotoSettings> ballPhotoOf(const GivenTexts& given) {
  BallPhotoSettings settings;
  for (const auto& [name, texts] : given) {
    const auto option = findBy(ballPhotoOptions(), name, [](const auto& each) { return each.text.name; });
    if (option == ballPhotoOptions().end())
      return fail(ErrorCode::usage, "a photograph has no option '" + excerpt(name) + "'");
    for (const std::string& text : texts) MIRRORBALL_TRY_VOID(assign(*option, settings, text));
  }
  if (auto checked = checkBallPhoto(settings); !checked) {
    Error error = std::move(checked).error();
    error.message = filledIn(error.message, [](std::string_view name) { return std::string(name); });
    return tl::unexpected<Error>(std::move(error));
  }
  return settings;
}

Workspace withPhotograph(Workspace workspace, bool is_photograph) {
  const std::string name = mapOf(workspace, editedSide(workspace));
  if (isBuiltinEnvironment(name)) return workspace;
  if (is_photograph)
    workspace.photos.try_emplace(name);
  else
    workspace.photos.erase(name);
  return workspace;
}

Workspace withBallCircle(Workspace workspace, const Circle& circle) {
  const auto found = workspace.photos.find(mapOf(workspace, editedSide(workspace)));
  if (found == workspace.photos.end()) return workspace;
  const auto rounded = [](double pixels) { return static_cast<float>(std::round(100.0 * pixels) / 100.0); };
  const std::array<float, 3> numbers{rounded(circle.center_px.x), rounded(circle.center_px.y),
                                     rounded(circle.radius_px)};
  found->second["circle"] = {writeNumbers(numbers)};
  return workspace;
}

}  // namespace mirrorball
