#pragma once

#include <string>

#include "mirrorball/environment/cube/cube_arrangement.h"
#include "mirrorball/environment/cube/cube_layout.h"
#include "mirrorball/environment/environment_map.h"

namespace mirrorball {

/// The form of a map in files: its projection, and the arrangement of its images if that is not our own.
struct MapForm {
  Projection projection = Projection::equirect;
  CubeLayout layout = CubeLayout::hcross;  ///< of a cube
  CubeArrangement arrangement = {};        ///< of a cube
  SignedAxis centre = SignedAxis::plus_z;  ///< of a panorama: our direction in its middle, ±X or ±Z; +Y is up
  bool has_texels_on_edges = false;        ///< of a cube or a panorama: OpenEXR's registration (openexr_registration.h)
};

/// A map's form as text: "equirect", "cube, hcross", "cube, faces, as-seen", "equirect, centred on +x",
/// "ball:distance=20".
std::string textOf(const MapForm& form);

/// The images of a map in a form, as they are in files: one, a cube's six by slots, or a paraboloid's two. Texels are
/// only moved, except for two forms that are resampled: OpenEXR's registration, and a panorama of odd height about ±X.
///
/// map      in our conventions, of the form's projection
ImageSet imagesOf(EnvironmentMap map, const MapForm& form);
/// The same for each level of a map. A level may have a size that no map has: 15 x 7 for a panorama of 30 x 15.
///
/// form     without OpenEXR's registration
ImageSet imagesOf(ImageSet levels, const MapForm& form);

/// The map that such images hold, in our conventions.
///
/// images   of the form's projection
EnvironmentMap mapOfImages(ImageSet images, const MapForm& form);
/// The levels that such images hold, in our conventions.
///
/// form     without OpenEXR's registration
ImageSet levelsOfImages(ImageSet images, const MapForm& form);

/// A map as one picture: that of its images.
///
/// form     the map's projection; for a cube any layout but `faces`
Image pictureOf(EnvironmentMap map, const MapForm& form);

/// Puts the images of a form, of one level, into one picture: the one image, a cube's images in their layout, or the
/// two discs of a paraboloid map side by side, front left. In the crosses, mirrored images of ±X or ±Y exchange their
/// cells, so that they meet their neighbours.
Image pictureOfImages(ImageSet images, const MapForm& form);

/// The images in one picture, as the form has them.
///
/// picture  in the form's proportion, as `recognize` has checked
/// errors   bad_shape: of a cube that is not in proportion
Result<ImageSet> imagesInPicture(Image picture, const MapForm& form);

/// The map in one picture: the map of its images.
Result<EnvironmentMap> mapOfPicture(Image picture, const MapForm& form);

}  // namespace mirrorball
