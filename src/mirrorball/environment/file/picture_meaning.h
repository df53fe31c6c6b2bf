#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mirrorball/codec/image_file.h"
#include "mirrorball/environment/file/photo_sphere.h"
#include "mirrorball/environment/file/recognize.h"

namespace mirrorball {

/// How the camera stood that took a panorama, as in CompassHeading.
struct CameraTilt {
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
};

/// What a picture is meant as: which map, and of a panorama which part of it, taken how.
struct PictureMeaning {
  Recognition recognition;
  std::optional<PanoramaPart> part = {};    ///< of a panorama, where its picture is not the whole in 2:1
  std::optional<CameraTilt> tilt = {};      ///< that is to be undone
  std::optional<DualFisheye> fisheye = {};  ///< the picture is two circles, of which the panorama is stitched
  std::vector<std::string> oddities = {};   ///< DecodedImage's, of what was decided here

  /// Whether the map is another picture than the file's.
  bool changesPicture() const { return part || tilt || fisheye; }
};

/// Whether a form is a panorama whose texels are ours: one that may be a part, tilted or nearly 2:1.
bool isPlainPanorama(const MapForm& form);

/// Which half of a stereo picture is read.
struct StereoEye {
  std::optional<PictureHalf> half = {};  ///< nothing: the picture is one map
  bool is_squeezed = false;              ///< the half has to be stretched to 2:1
  std::string oddity = {};               ///< DecodedImage's: that it was decided here
};

/// Decides by the hint, then by what the file says, then by the picture's light, whether a picture holds two panoramas,
/// one for each eye. Two panoramas in the frame of one are squeezed to half their width or height, as video has them.
///
/// picture  as decoded
StereoEye chooseEye(const Image& picture, const Metadata& metadata, const std::optional<PhotoSphere>& sphere,
                    const FormHint& hint);

/// Whether chooseEye() needs the picture's light.
bool mayBeStereo(glm::ivec2 size, const std::optional<PhotoSphere>& sphere, const FormHint& hint);

/// The size of the panorama, 2:1, of which a squeezed half loses nothing.
glm::ivec2 stretchedSize(glm::ivec2 half);

/// Decides by the hint, then by the file's own metadata, then by the Photo Sphere that the file says it is, then by the
/// picture's shape.
///
/// sphere   of the file, if it is one
/// errors   as recognize's; bad_shape: it is a Photo Sphere in another projection
Result<PictureMeaning> readMeaning(glm::ivec2 size, const Metadata& metadata, const std::optional<PhotoSphere>& sphere,
                                   const FormHint& hint);

/// Adds to the remark on a panorama's window (windowText), wherever among its file's it is, what the empty rest means
/// and how to fill it.
///
/// window   in which the picture lies already: OpenEXR's
void adviseOnRest(const PictureWindow& window, std::vector<std::string>& oddities);

/// Makes the picture of a panorama that of the whole one: in its place, with what the hint says around it, or
/// stitched.
///
/// decoded  gets `window` where it was a part
/// errors   as placedInPanorama's and fillAround's
Result<void> completePanorama(const PictureMeaning& meaning, const FormHint& hint, DecodedImage& decoded);

}  // namespace mirrorball
