#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "mirrorball/base/result.h"
#include "mirrorball/photo/ball_photo.h"
#include "mirrorball/view/workspace/workspace.h"

namespace mirrorball {

/// A map as it is asked for. Two that are equal are the same map, as long as their files stay as they are.
struct AskedMap {
  std::string name;                      ///< loadEnvironment's, or a photograph's
  std::optional<GivenTexts> photo = {};  ///< Workspace::photos' of it; nothing: it is no photograph

  bool operator==(const AskedMap&) const = default;
};

/// The map of a half, or of a name.
AskedMap askedMap(const Workspace& workspace, std::size_t side);
AskedMap askedMap(const Workspace& workspace, const std::string& name);

/// Settings that hold all of some texts.
///
/// errors   usage: an option that there is not, a text that it refuses, or as checkBallPhoto's
Result<BallPhotoSettings> ballPhotoOf(const GivenTexts& given);

/// Takes the map of the half that is edited for a photograph of a mirror ball, or for a map again. What is built in is
/// none.
Workspace withPhotograph(Workspace workspace, bool is_photograph);

/// Gives the ball's circle in the photograph of the half that is edited, in hundredths of pixels; of a map that is no
/// photograph nothing changes.
Workspace withBallCircle(Workspace workspace, const Circle& circle);

}  // namespace mirrorball
