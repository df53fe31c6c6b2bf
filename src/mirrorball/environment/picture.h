#pragma once

#include <string>

#include "mirrorball/environment/cube_layout.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The form of a map in one picture.
struct MapForm {
  Projection projection = Projection::equirect;
  CubeLayout layout = CubeLayout::hcross;  ///< of a cube only
};

/// A map's form as text: "equirect", "cube, hcross", "ball:distance=20".
std::string textOf(const MapForm& form);

/// A map as one picture: its one image, a cube's faces in their layout, or the two discs of a paraboloid map side by
/// side, front left.
///
/// form     the map's projection; for a cube any layout but `faces`
Image pictureOf(const EnvironmentMap& map, const MapForm& form);

/// The map in one picture.
///
/// picture  in the form's proportion, as `recognize` has checked
/// errors   bad_shape: of a cube, when it is not
Result<EnvironmentMap> mapOfPicture(Image picture, const MapForm& form);

}  // namespace mirrorball
